#include "geometry/bipartite_matching.h"

namespace gcslab {
namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

Incidence transposed(const Incidence& rows, std::size_t columns) {
  Incidence result(columns);
  for (std::size_t row = 0; row < rows.size(); ++row) {
    for (const std::size_t column : rows[row]) result[column].push_back(row);
  }
  return result;
}

/// Rows matched with columns by augmenting paths (Kuhn 1955).
class Matching {
 public:
  Matching(const Incidence& rows, std::size_t columns)
      : rows_(rows), row_of_(columns, kNone), column_of_(rows.size(), kNone) {
    for (std::size_t row = 0; row < rows.size(); ++row) {
      std::vector<bool> is_seen(columns, false);
      if (augment(row, is_seen)) ++size_;
    }
  }

  std::size_t size() const { return size_; }
  const std::vector<std::size_t>& row_of() const { return row_of_; }
  const std::vector<std::size_t>& column_of() const { return column_of_; }

 private:
  bool augment(std::size_t row, std::vector<bool>& is_seen) {
    for (const std::size_t column : rows_[row]) {
      if (is_seen[column]) continue;
      is_seen[column] = true;
      if (row_of_[column] != kNone && !augment(row_of_[column], is_seen)) continue;
      row_of_[column] = row;
      column_of_[row] = column;
      return true;
    }
    return false;
  }

  const Incidence& rows_;
  std::vector<std::size_t> row_of_, column_of_;
  std::size_t size_ = 0;
};

/// The nodes that alternating paths reach from the unmatched ones of their side: along any edge across, and
/// back along the matching.
std::vector<std::size_t> reached(const Incidence& edges, const std::vector<std::size_t>& partner,
                                 const std::vector<std::size_t>& partner_of_other) {
  std::vector<bool> is_reached(edges.size(), false);
  std::vector<std::size_t> pending;
  const auto visit = [&](std::size_t node) {
    if (node == kNone || is_reached[node]) return;
    is_reached[node] = true;
    pending.push_back(node);
  };
  for (std::size_t node = 0; node < edges.size(); ++node) {
    if (partner[node] == kNone) visit(node);
  }
  while (!pending.empty()) {
    const std::size_t node = pending.back();
    pending.pop_back();
    for (const std::size_t other : edges[node]) visit(partner_of_other[other]);
  }
  std::vector<std::size_t> result;
  for (std::size_t node = 0; node < edges.size(); ++node) {
    if (is_reached[node]) result.push_back(node);
  }
  return result;
}

}  // namespace

StructuralParts structural_parts(const Incidence& rows, std::size_t columns) {
  const Matching matching(rows, columns);
  return {matching.size(), reached(rows, matching.column_of(), matching.row_of()),
          reached(transposed(rows, columns), matching.row_of(), matching.column_of())};
}

}  // namespace gcslab
