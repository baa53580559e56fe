#include "box_solver/disjunction_contractor.h"

#include <numeric>

#include "box_solver/bisection.h"

namespace gcslab {
namespace {

Box hull_of(const Box& a, const Box& b) {
  Box result;
  for (std::size_t i = 0; i < a.size(); ++i) result.push_back(hull(a[i], b[i]));
  return result;
}

class DisjunctionContractor final : public Contractor {
 public:
  DisjunctionContractor(const SystemFunctions& functions, std::unique_ptr<Contractor> inner,
                        const DisjunctionOptions& options)
      : variables_(functions.variables()),
        inner_(std::move(inner)),
        options_(options),
        order_(bisection_registry().at("relative_smear_sum").make(functions)) {}

  double cost() const override {
    const std::size_t taken =
        options_.is_adaptive ? static_cast<std::size_t>(2 * options_.patience) : variables_;
    constexpr int kOuterSlices = 2;  // where these leave the whole side, no others are tried
    return static_cast<double>(taken) * kOuterSlices * inner_->cost();
  }

  bool contract(Box& box, ProofTrace& trace) override {
    std::vector<std::size_t> open(box.size());
    std::iota(open.begin(), open.end(), 0);
    int fruitless = 0;
    while (!open.empty() && (!options_.is_adaptive || fruitless < options_.patience)) {
      const std::size_t variable = options_.is_adaptive ? order_->choose(box, open, {box}) : open.front();
      std::erase(open, variable);
      const Box before = box;
      if (!contract_by(variable, box, trace)) return false;
      fruitless = largest_gain(before, box) < options_.least_gain ? fruitless + 1 : 0;
    }
    return true;
  }

 private:
  struct Slice {
    Interval side;
    Box left{};  ///< what contraction leaves of it; empty when it has no root
    ProofTrace trace{};
  };

  /// The borders between slices: increasing, strictly inside.
  std::vector<double> borders(const Interval& side) const {
    std::vector<double> result;
    if (!is_bounded(side)) {
      double point = 0;
      if (cut_point(side, point)) result.push_back(point);
      return result;
    }
    for (int k = 1; k < options_.slices; ++k) {
      const double part = static_cast<double>(k) / options_.slices;
      const double point = side.lower * (1 - part) + side.upper * part;
      const double previous = result.empty() ? side.lower : result.back();
      if (previous < point && point < side.upper) result.push_back(point);
    }
    return result;
  }

  std::vector<Slice> slices(const Interval& side, bool is_traced) const {
    std::vector<Slice> result;
    double lower = side.lower;
    for (const double border : borders(side)) {
      result.push_back({Interval(lower, border), {}, ProofTrace(is_traced)});
      lower = border;
    }
    result.push_back({Interval(lower, side.upper), {}, ProofTrace(is_traced)});
    return result;
  }

  void contract_slice(std::size_t variable, const Box& box, Slice& slice) {
    slice.left = box;
    slice.left[variable] = slice.side;
    if (!inner_->contract(slice.left, slice.trace)) slice.left.clear();
  }

  bool contract_by(std::size_t variable, Box& box, ProofTrace& trace) {
    std::vector<Slice> parts = slices(box[variable], trace.wanted());
    if (parts.size() < 2) return true;
    Box left;
    const auto take = [&](Slice& slice) {
      contract_slice(variable, box, slice);
      if (!slice.left.empty()) left = left.empty() ? slice.left : hull_of(left, slice.left);
    };
    // When the outer slices leave the whole box, no inner one can change that.
    take(parts.front());
    take(parts.back());
    for (std::size_t k = 1; k + 1 < parts.size() && left != box; ++k) take(parts[k]);
    if (left == box) return true;
    tell(variable, parts, 0, trace);
    box = left;
    return !left.empty();
  }

  static void tell(std::size_t variable, const std::vector<Slice>& parts, std::size_t first,
                   ProofTrace& trace) {
    if (!trace.wanted()) return;
    if (first + 1 == parts.size()) {
      trace.append(parts[first].trace);
      return;
    }
    const auto number = static_cast<std::uint32_t>(variable);
    trace.add({Argument::cases, 0, number, Interval(parts[first].side.upper)});
    trace.append(parts[first].trace);
    trace.add({Argument::otherwise});
    tell(variable, parts, first + 1, trace);
    trace.add({Argument::join});
  }

  std::size_t variables_;
  std::unique_ptr<Contractor> inner_;
  DisjunctionOptions options_;
  std::unique_ptr<Bisection> order_;
};

}  // namespace

std::unique_ptr<Contractor> make_disjunction_contractor(const SystemFunctions& functions,
                                                        std::unique_ptr<Contractor> inner,
                                                        const DisjunctionOptions& options) {
  return std::make_unique<DisjunctionContractor>(functions, std::move(inner), options);
}

}  // namespace gcslab
