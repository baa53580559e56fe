#include "verifier/miranda.h"

#include <algorithm>

namespace gcslab::verifier {

/// False where the equations may be undefined or discontinuous, and where no regular C is found.
bool Miranda::precondition(const RangeBox& box) {
  const std::size_t n = box.size();
  RangeMatrix slopes;
  if (!system_->slopes(box, box, slopes)) return false;
  const RealMatrix middle = middles(slopes);
  if (!invert(middle, multipliers_) || !is_regular(middle, multipliers_)) return false;
  slopes_.assign(n, RangeBox(n));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < n; ++k) {
      for (std::size_t j = 0; j < n; ++j)
        slopes_[i][j] = slopes_[i][j] + Range(multipliers_[i][k]) * slopes[k][j];
    }
  }
  return true;
}

/// Encloses g_row over a box or at a point.
Range Miranda::combined(std::size_t row, const RangeBox& where) {
  Range sum;
  for (std::size_t k = 0; k < where.size(); ++k) {
    const Range& value = system_->equations()[k].program.evaluate(where);
    if (value.is_empty() || !value.is_bounded()) return Range::entire();
    sum = sum + Range(multipliers_[row][k]) * value;
  }
  return sum;
}

Range Miranda::on_face(std::size_t variable, double end, const RangeBox& box, const RangeBox& centre) {
  RangeBox face = box;
  RangeBox middle = centre;
  face[variable] = middle[variable] = Range(end);
  Range centred = combined(variable, middle);
  for (std::size_t j = 0; j < box.size(); ++j) {
    if (j != variable) centred = centred + slopes_[variable][j] * (box[j] - centre[j]);
  }
  return intersection(centred, combined(variable, face));
}

bool Miranda::contains_root(const Box& box) {
  if (!system_->is_square() || !std::ranges::all_of(box, is_bounded)) return false;
  const RangeBox whole = ranges_of(box);
  if (!precondition(whole)) return false;
  RangeBox centre;
  for (const Interval& side : box) centre.emplace_back(midpoint(side));
  for (std::size_t i = 0; i < box.size(); ++i) {
    const Range below = on_face(i, box[i].lower, whole, centre);
    const Range above = on_face(i, box[i].upper, whole, centre);
    if (below.is_empty() || above.is_empty()) return false;
    const bool rises = mpfr_sgn(below.upper()) <= 0 && mpfr_sgn(above.lower()) >= 0;
    const bool falls = mpfr_sgn(below.lower()) >= 0 && mpfr_sgn(above.upper()) <= 0;
    if (!rises && !falls) return false;
  }
  return true;
}

}  // namespace gcslab::verifier
