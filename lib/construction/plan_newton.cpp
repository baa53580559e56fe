#include "construction/plan_newton.h"

#include <Eigen/Dense>
#include <cmath>

#include "base/error.h"

namespace gcslab {
namespace {

/// All branches, mirror images included.
std::vector<Branch> branches_of(const BranchMap& map) {
  constexpr std::size_t kMost = 20;
  if (map.choices() > kMost)
    throw NotApplicable("the construction plan has 2^" + std::to_string(map.choices()) + " branches");
  std::vector<Branch> result;
  for (std::size_t number = 0; number < (std::size_t{1} << map.choices()); ++number) {
    Branch branch;
    for (std::size_t c = 0; c < map.choices(); ++c) branch.push_back((number >> c & 1U) != 0);
    result.push_back(std::move(branch));
  }
  return result;
}

class NewtonSearch {
 public:
  NewtonSearch(BranchMap& map, const std::vector<double>& guides)
      : map_(&map), start_(guides), values_(map.guides()), derivatives_(map.guides(), map.guides() + 1) {
    start_.push_back(1);
  }

  BranchSearch run() {
    for (const Branch& branch : branches_of(*map_)) search(branch);
    return std::move(result_);
  }

 private:
  static constexpr int kIterations = 60;
  static constexpr int kHalvings = 30;
  static constexpr double kExact = 1e-13;

  std::optional<double> size_at(const Branch& branch, const std::vector<double>& v) {
    ++result_.evaluations;
    if (!map_->values(branch, v, values_).is_inside) return std::nullopt;
    double sum = 0;
    for (const double value : values_) sum += value * value;
    return std::sqrt(sum);
  }

  void search(const Branch& branch) {
    std::vector<double> v = start_;
    std::optional<double> size = size_at(branch, v);
    if (!size) {
      ++result_.outside;
      if (const auto border = map_->values(branch, v, values_).border) result_.negative.insert(*border);
      return;
    }
    const std::size_t m = map_->guides();
    for (int k = 0; k < kIterations; ++k) {
      ++result_.evaluations;
      map_->jacobian(branch, v, values_, derivatives_);
      Eigen::MatrixXd matrix(static_cast<Eigen::Index>(m), static_cast<Eigen::Index>(m));
      for (std::size_t i = 0; i < m; ++i) {
        for (std::size_t j = 0; j < m; ++j)
          matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = derivatives_(i, j);
      }
      const Eigen::VectorXd change = matrix.partialPivLu().solve(
          Eigen::Map<const Eigen::VectorXd>(values_.data(), static_cast<Eigen::Index>(m)));
      if (!change.allFinite()) break;
      double part = 1;
      bool is_shorter = false;
      for (int h = 0; h < kHalvings && !is_shorter; ++h, part /= 2) {
        std::vector<double> moved = v;
        for (std::size_t i = 0; i < m; ++i) moved[i] -= part * change[static_cast<Eigen::Index>(i)];
        const std::optional<double> there = size_at(branch, moved);
        is_shorter = there && (*there < *size || change.norm() <= kExact);
        if (!is_shorter) continue;
        v = moved;
        size = there;
      }
      if (change.norm() <= kExact) {
        v.pop_back();
        result_.solutions.push_back({v, branch});
        return;
      }
      if (!is_shorter) {
        ++result_.stuck;
        return;
      }
    }
    ++result_.unfinished;
  }

  BranchMap* map_;
  std::vector<double> start_, values_;
  Matrix<double> derivatives_;
  BranchSearch result_;
};

}  // namespace

BranchSearch newton_on_branches(BranchMap& map, const std::vector<double>& guides) {
  return NewtonSearch(map, guides).run();
}

BranchSearch sample_branches(BranchMap& map, double largest, std::size_t samples) {
  if (map.guides() != 1)
    throw NotApplicable("one guide parameter is sampled, and the construction plan has " +
                        std::to_string(map.guides()));
  constexpr int kHalvings = 60;
  BranchSearch result;
  std::vector<double> value(1);
  const auto at = [&](const Branch& branch, double guide) -> std::optional<double> {
    ++result.evaluations;
    const std::vector<double> v = {guide, 1};
    return map.values(branch, v, value).is_inside ? std::optional(value[0]) : std::nullopt;
  };
  for (const Branch& branch : branches_of(map)) {
    bool is_ever_inside = false;
    std::optional<double> before = at(branch, 0);
    for (std::size_t k = 1; k <= samples; ++k) {
      const double low_end = largest * static_cast<double>(k - 1) / static_cast<double>(samples);
      const double high_end = largest * static_cast<double>(k) / static_cast<double>(samples);
      const std::optional<double> after = at(branch, high_end);
      is_ever_inside = is_ever_inside || after;
      if (before && after && *before * *after <= 0 && *after != 0) {
        double low = low_end, high = high_end, left = *before;
        for (int h = 0; h < kHalvings; ++h) {
          const double middle = (low + high) / 2;
          const std::optional<double> there = at(branch, middle);
          if (!there) break;
          (*there * left > 0 ? low : high) = middle;
        }
        if (high - low <= 1e-12 * largest) result.solutions.push_back({{(low + high) / 2}, branch});
      }
      before = after;
    }
    if (!is_ever_inside) ++result.outside;
  }
  return result;
}

}  // namespace gcslab
