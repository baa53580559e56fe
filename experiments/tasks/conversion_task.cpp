#include "experiments/tasks/conversion_task.h"

#include <fmt/format.h>

#include "base/random.h"
#include "base/registry.h"
#include "experiments/corpus/corpus.h"
#include "experiments/corpus/problem.h"
#include "experiments/tasks/job_result.h"
#include "experiments/tasks/stopwatch.h"
#include "interval/fast_interval.h"
#include "interval/mpfr_interval.h"
#include "interval/point_numbers.h"
#include "polynomial/bernstein.h"

namespace gcslab {
namespace {

const RationalBox kUnitInterval = {{0, 1}};

std::vector<Rational> random_coefficients(int degree, std::uint64_t seed) {
  Random random(seed, "conversion_task");
  std::vector<Rational> coefficients;
  for (int i = 0; i <= degree; ++i) coefficients.emplace_back(random.integer(-(1 << 20), 1 << 20), 1 << 20);
  for (Rational& coefficient : coefficients) coefficient.canonicalize();
  return coefficients;
}

/// a_k = binomial(d, k) sum_(j <= k) (-1)^(k - j) binomial(k, j) b_j (Farouki, Rajan 1987).
Polynomial from_bernstein(const std::vector<Rational>& b) {
  const unsigned long d = b.size() - 1;
  Polynomial polynomial(1);
  for (unsigned long k = 0; k <= d; ++k) {
    Rational sum = 0;
    for (unsigned long j = 0; j <= k; ++j) {
      mpz_class binomial;
      mpz_bin_uiui(binomial.get_mpz_t(), k, j);
      if ((k - j) % 2 == 0) {
        sum += binomial * b[j];
      } else {
        sum -= binomial * b[j];
      }
    }
    mpz_class binomial;
    mpz_bin_uiui(binomial.get_mpz_t(), d, k);
    polynomial.add_term({static_cast<int>(k)}, binomial * sum);
  }
  return polynomial;
}

/// The distance from an exact number to the farthest member of an enclosure, or to a point.
template <class T>
Rational distance(const T& value, const Rational& exact) {
  if constexpr (std::is_floating_point_v<T>) {
    return abs(rational_from_double(static_cast<double>(value)) - exact);
  } else {
    const Interval enclosure = NumberTraits<T>::enclosure(value);
    return std::max<Rational>(abs(rational_from_double(enclosure.lower) - exact),
                              abs(rational_from_double(enclosure.upper) - exact));
  }
}

/// Largest error of a coefficient, relative to the largest coefficient.
template <class T>
double conversion_error(const Polynomial& polynomial, const std::vector<Rational>& exact, int bits) {
  const typename NumberTraits<T>::Scope scope(bits);
  const Exponents degree = {static_cast<int>(exact.size()) - 1};
  const auto converted = bernstein_computed_in<T>(polynomial, kUnitInterval, degree);
  Rational error = 0, size = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    error = std::max<Rational>(error, distance(converted.coefficients()[i], exact[i]));
    size = std::max<Rational>(size, abs(exact[i]));
  }
  return Rational(error / size).get_d();
}

/// A number type that conversions are tried in.
struct ConversionVariant {
  std::string name;
  std::string summary;
  Promise promise;
  double (*error)(const Polynomial&, const std::vector<Rational>&, int bits);
  std::vector<OptionSpec> options{};
};

const Registry<ConversionVariant>& variants() {
  static const Registry<ConversionVariant> registry(
      "method", {{"float", "single precision, 24 bits", Promise::baseline, conversion_error<float>},
                 {"double", "double precision, 53 bits", Promise::baseline, conversion_error<double>},
                 {"interval", "double intervals with outward rounding: error of the farther end",
                  Promise::rigorous, conversion_error<FastInterval>},
                 {"mpfr",
                  "MPFR intervals: error of the farther end of the enclosing double interval",
                  Promise::rigorous,
                  conversion_error<MpfrInterval>,
                  {integer_option("bits", "precision", "bits", 113, 2, 100000)}}});
  return registry;
}

int bits_of(const Options& options) {
  return options.values().contains("bits") ? static_cast<int>(options.integer("bits")) : 53;
}

}  // namespace

std::string ConversionTask::summary() const {
  return "error of the conversion from powers to the Bernstein basis in an arithmetic";
}

std::vector<MethodInfo> ConversionTask::methods() const {
  std::vector<MethodInfo> methods;
  for (const ConversionVariant& variant : variants().entries()) {
    methods.push_back({variant.name, variant.summary, variant.promise, 1, variant.options});
  }
  return methods;
}

std::vector<OptionSpec> ConversionTask::parameters() const {
  return {integer_option("degree", "degree of the polynomial", "", 10, 1, 200)};
}

std::vector<ValueInfo> ConversionTask::values() const {
  return {{"relative_error", "largest error of a coefficient over the largest coefficient"}};
}

void ConversionTask::check(const Job& job) const {
  const auto path = Corpus::standard().problem_path(job.problem);
  if (kind_of_file(path) != "bernstein_family") {
    throw InputError(path.string() + ": the task conversion takes problems of kind bernstein_family");
  }
}

JobResult ConversionTask::run(const Job& job, const std::stop_token&) const {
  const ConversionVariant& variant = variants().at(job.method);
  const auto exact = random_coefficients(static_cast<int>(job.parameters.integer("degree")), job.seed);
  const Polynomial polynomial = from_bernstein(exact);
  JobResult result;
  const Stopwatch watch;
  const double error = variant.error(polynomial, exact, bits_of(job.options));
  result.timings["wall_s"] = watch.wall_s();
  result.timings["cpu_s"] = watch.cpu_s();
  result.values["relative_error"] = fmt::format("{:.3e}", error);
  result.status = variant.promise == Promise::rigorous ? Status::complete : Status::partial;
  return result;
}

}  // namespace gcslab
