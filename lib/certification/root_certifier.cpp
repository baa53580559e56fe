#include "certification/root_certifier.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "base/error.h"
#include "base/nearest_name.h"
#include "certification/inclusion_test.h"
#include "certification/krawczyk_certifier.h"
#include "interval/fast_interval.h"
#include "interval/mpfr_interval.h"

namespace gcslab {
namespace {

constexpr const char* kSlopes = "krawczyk_slopes";
constexpr int kDoubleBits = 53;

bool shows_existence(Claim claim) { return claim == Claim::unique || claim == Claim::exists; }
bool shows_uniqueness(Claim claim) { return claim == Claim::unique || claim == Claim::at_most_one; }

bool is_bounded_box(const Box& box) { return std::ranges::all_of(box, is_bounded); }

Box hull_of(const Box& a, const Box& b) {
  Box result;
  for (std::size_t i = 0; i < a.size(); ++i) result.push_back(hull(a[i], b[i]));
  return result;
}

template <class T>
class SlopeCertifier final : public RootCertifier {
 public:
  SlopeCertifier(const SystemFunctions& functions, const std::vector<double>& scales, int bits)
      : certifier_(functions, scales, bits) {}

  std::optional<CertifiedRoot> certify(const ApproximateRoot& approximate, const Box& wanted) override {
    std::optional<CertifiedRoot> root = certifier_.certify(approximate);
    if (root) certifier_.enlarge_uniqueness(*root, approximate, wanted);
    return root;
  }

  std::optional<CertifiedRoot> certify_box(const Box& box) override {
    ApproximateRoot approximate;
    std::optional<CertifiedRoot> root = certifier_.certify_box(box, approximate);
    if (root) certifier_.enlarge_uniqueness(*root, approximate, box);
    return root;
  }

  std::optional<Evidence> prove_existence(const Box&) override { return std::nullopt; }

 private:
  KrawczykCertifier<T> certifier_;
};

/// Asks inclusion tests about boxes of its choice.
template <class T>
class TestCertifier final : public RootCertifier {
 public:
  /// `is_alone`: no other test is asked.
  TestCertifier(const SystemFunctions& functions, const std::vector<std::string>& names, bool is_alone,
                std::vector<double> scales, int bits)
      : scales_(std::move(scales)), bits_(bits), evaluator_(made(functions, bits)) {
    const InclusionTestSettings settings{bits > kDoubleBits ? Arithmetic::mpfr : Arithmetic::fast, bits};
    for (const std::string& name : names) {
      const InclusionTestVariant& variant = inclusion_test_registry().at(name);
      try {
        tests_.push_back({variant.claim, variant.make(functions, settings)});
      } catch (const NotApplicable&) {
        if (is_alone) throw;  // in a composition, the others do what they can
      }
    }
  }

  /// Boxes around the guess grow until one is proved to contain a root: the guess is as near as the rounding
  /// errors of an iteration allow, which nobody knows.
  std::optional<CertifiedRoot> certify(const ApproximateRoot& approximate, const Box& wanted) override {
    constexpr int kAttempts = 8;
    constexpr double kFirst = 0x1p-50;
    double size = kFirst;
    for (int attempt = 0; attempt < kAttempts; ++attempt, size *= 8) {
      const Box x = around(approximate.point, size);
      if (auto evidence = prove(&shows_existence, x, approximate))
        return alone(std::move(*evidence), approximate, wanted);
    }
    return std::nullopt;
  }

  std::optional<CertifiedRoot> certify_box(const Box& box) override {
    constexpr int kAttempts = 3;
    Box x = box;
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
      x = inflated(x, 0.3);
      const std::optional<ApproximateRoot> approximate = middle_of(x);
      if (!approximate) return std::nullopt;
      if (auto evidence = prove(&shows_existence, x, *approximate))
        return alone(std::move(*evidence), *approximate, box);
    }
    return std::nullopt;
  }

  std::optional<Evidence> prove_existence(const Box& box) override {
    constexpr int kAttempts = 6;
    const auto is_asked = [](Claim claim) { return claim == Claim::exists; };
    if (!is_bounded_box(box) || std::ranges::none_of(tests_, is_asked, &Part::claim)) return std::nullopt;
    Box x = box;
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
      x = inflated(x, 0.5);
      const std::optional<ApproximateRoot> approximate = middle_of(x);
      if (!approximate) return std::nullopt;
      if (auto evidence = prove(is_asked, x, *approximate)) return evidence;
    }
    return std::nullopt;
  }

 private:
  struct Part {
    Claim claim;
    std::unique_ptr<InclusionTest> test;
  };

  static SystemEvaluator<T> made(const SystemFunctions& functions, int bits) {
    const typename NumberTraits<T>::Scope scope(bits);
    return SystemEvaluator<T>(functions);
  }

  /// The first test whose claim is wanted and that proves it.
  template <class Wanted>
  std::optional<Evidence> prove(const Wanted& is_wanted, const Box& box, const ApproximateRoot& approximate) {
    if (!is_bounded_box(box)) return std::nullopt;
    for (const Part& part : tests_) {
      if (!is_wanted(part.claim)) continue;
      if (auto evidence = part.test->prove(box, approximate)) return evidence;
    }
    return std::nullopt;
  }

  /// The root that `existence` shows, when it is shown to be alone.
  std::optional<CertifiedRoot> alone(Evidence existence, const ApproximateRoot& approximate,
                                     const Box& wanted) {
    const Box box = existence.box;
    std::optional<Evidence> uniqueness = widest_uniqueness(box, approximate, wanted);
    if (!uniqueness && existence.claim != Claim::unique) return std::nullopt;
    CertifiedRoot root{box, uniqueness ? uniqueness->box : box, {std::move(existence)}};
    if (uniqueness) root.evidence.push_back(std::move(*uniqueness));
    return root;
  }

  /// Evidence of uniqueness in a box around `box`: a cube in the scales of the variables, as large as can be
  /// shown, and beside that what is wanted.
  std::optional<Evidence> widest_uniqueness(const Box& box, const ApproximateRoot& approximate,
                                            const Box& wanted) {
    constexpr int kAttempts = 10;
    std::optional<Evidence> best;
    double size = 1;
    for (int attempt = 0; attempt < kAttempts && !best; ++attempt, size /= 4)
      best = prove(&shows_uniqueness, hull_of(box, cube(box, size)), approximate);
    if (!best) best = prove(&shows_uniqueness, box, approximate);
    const Box both = hull_of(best ? best->box : box, wanted);
    if (best && both == best->box) return best;
    if (auto wider = prove(&shows_uniqueness, both, approximate)) return wider;
    return best;
  }

  Box cube(const Box& box, double size) const {
    Box result;
    for (std::size_t i = 0; i < box.size(); ++i)
      result.emplace_back(box[i].lower - size * scales_[i], box[i].upper + size * scales_[i]);
    return result;
  }

  double size_of(std::size_t variable, double at) const {
    return std::max(std::fabs(at), 1e-3 * scales_[variable]);
  }

  Box around(const std::vector<double>& point, double part) const {
    Box result;
    for (std::size_t i = 0; i < point.size(); ++i) {
      const double reach = part * size_of(i, point[i]);
      result.emplace_back(point[i] - reach, point[i] + reach);
    }
    return result;
  }

  Box inflated(const Box& box, double part) const {
    Box result;
    for (std::size_t i = 0; i < box.size(); ++i) {
      const double grow = part * width(box[i]) + 1e-15 * size_of(i, magnitude(box[i]));
      result.emplace_back(box[i].lower - grow, box[i].upper + grow);
    }
    return result;
  }

  /// The middle of the box with the inverse of the middle of its slopes, which may be regular where the
  /// Jacobian at every root is not.
  std::optional<ApproximateRoot> middle_of(const Box& box) {
    const typename NumberTraits<T>::Scope scope(bits_);
    std::vector<T> numbers;
    ApproximateRoot result;
    for (const Interval& side : box) {
      numbers.push_back(NumberTraits<T>::from_interval(side));
      result.point.push_back(midpoint(side));
    }
    Matrix<T> slopes(box.size(), box.size(), NumberTraits<T>::from_interval(Interval(0)));
    if (!evaluator_.jacobian(numbers, slopes)) return std::nullopt;
    Matrix<double> middle(box.size(), box.size());
    for (std::size_t i = 0; i < box.size(); ++i) {
      for (std::size_t j = 0; j < box.size(); ++j)
        middle(i, j) = midpoint(NumberTraits<T>::enclosure(slopes(i, j)));
    }
    std::optional<Matrix<double>> inverse = approximate_inverse(middle);
    if (!inverse) return std::nullopt;
    result.inverse = std::move(*inverse);
    return result;
  }

  std::vector<double> scales_;
  int bits_;
  SystemEvaluator<T> evaluator_;
  std::vector<Part> tests_;
};

/// What the slopes cannot prove the tests may, which are made when they are first asked: second derivatives
/// take longer to prepare than most roots to certify.
template <class T>
class SlopesThenTests final : public RootCertifier {
 public:
  SlopesThenTests(const SystemFunctions& functions, std::vector<std::string> names,
                  std::vector<double> scales, int bits)
      : functions_(&functions),
        names_(std::move(names)),
        scales_(std::move(scales)),
        bits_(bits),
        slopes_(functions, scales_, bits) {}

  std::optional<CertifiedRoot> certify(const ApproximateRoot& approximate, const Box& wanted) override {
    if (auto root = slopes_.certify(approximate, wanted)) return root;
    return tests().certify(approximate, wanted);
  }
  std::optional<CertifiedRoot> certify_box(const Box& box) override {
    if (auto root = slopes_.certify_box(box)) return root;
    return tests().certify_box(box);
  }
  std::optional<Evidence> prove_existence(const Box& box) override { return tests().prove_existence(box); }

 private:
  TestCertifier<T>& tests() {
    if (!tests_) tests_ = std::make_unique<TestCertifier<T>>(*functions_, names_, false, scales_, bits_);
    return *tests_;
  }

  const SystemFunctions* functions_;
  std::vector<std::string> names_;
  std::vector<double> scales_;
  int bits_;
  SlopeCertifier<T> slopes_;
  std::unique_ptr<TestCertifier<T>> tests_;
};

std::vector<std::string> names_in(const std::string& composition) {
  std::vector<std::string> known, names;
  for (const CertifierName& entry : certifier_names()) known.push_back(entry.name);
  std::size_t start = 0;
  while (start <= composition.size()) {
    const std::size_t end = std::min(composition.find('+', start), composition.size());
    names.push_back(composition.substr(start, end - start));
    start = end + 1;
    if (std::ranges::find(known, names.back()) == known.end())
      throw InputError(unknown_name_message("certifier", names.back(), known));
    if (std::ranges::count(names, names.back()) > 1)
      throw InputError("certifier '" + names.back() + "' is named twice in '" + composition + "'");
  }
  return names;
}

template <class T>
std::unique_ptr<RootCertifier> made(std::vector<std::string> names, const SystemFunctions& functions,
                                    const std::vector<double>& scales, int bits) {
  const bool is_alone = names.size() == 1;
  const bool has_slopes = std::erase(names, kSlopes) > 0;
  if (!has_slopes) return std::make_unique<TestCertifier<T>>(functions, names, is_alone, scales, bits);
  if (is_alone) return std::make_unique<SlopeCertifier<T>>(functions, scales, bits);
  return std::make_unique<SlopesThenTests<T>>(functions, std::move(names), scales, bits);
}

}  // namespace

std::vector<CertifierName> certifier_names() {
  std::vector<CertifierName> result = {
      {kSlopes,
       "Krawczyk's operator with slopes, in as large a uniqueness box as regular slopes give (Neumaier "
       "1990)"}};
  for (const InclusionTestVariant& variant : inclusion_test_registry().entries())
    result.push_back({variant.name, variant.summary});
  return result;
}

void check_certifier(const std::string& composition) { static_cast<void>(names_in(composition)); }

std::unique_ptr<RootCertifier> make_root_certifier(const std::string& composition,
                                                   const SystemFunctions& functions,
                                                   const std::vector<double>& scales, int bits) {
  const std::vector<std::string> names = names_in(composition);
  return bits > kDoubleBits ? made<MpfrInterval>(names, functions, scales, bits)
                            : made<FastInterval>(names, functions, scales, bits);
}

}  // namespace gcslab
