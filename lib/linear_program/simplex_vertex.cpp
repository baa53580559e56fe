#include "linear_program/simplex_vertex.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "linear_program/simplex_kernel.h"

namespace gcslab {
namespace {

/// A constraint whose normal has less than this of any edge's direction depends on the others.
constexpr double kDependent = 1e-8;

double value_at(const ConstraintSides& sides, std::size_t constraint, double inward) {
  return inward < 0 ? sides.upper[constraint] : sides.lower[constraint];
}

}  // namespace

void SimplexVertex::start_at_corner(const SimplexProgram& program) {
  edges_.reset(program.columns());
  constraint_.assign(program.columns(), 0);
  inward_.assign(edges_.stride(), 0.0);
  slot_of_.assign(program.constraints(), kFree);
  value_.assign(program.stride(), 0.0);
  wanted_.assign(program.columns(), 0);
  along_.assign(edges_.stride(), 0.0);
  edge_.assign(edges_.stride(), 0.0);
  offset_.assign(edges_.stride(), 0.0);
  exchanges_ = 0;
  for (std::size_t j = 0; j < program.columns(); ++j) hold(j, j, program.is_equation(j) ? 0 : 1);
}

void SimplexVertex::hold(std::size_t slot, std::size_t constraint, double inward) {
  constraint_[slot] = constraint;
  inward_[slot] = inward;
  slot_of_[constraint] = static_cast<int>(slot);
}

void SimplexVertex::rebuild(const SimplexProgram& program) {
  std::vector<std::size_t> rows;
  std::vector<double> row_inward;
  std::vector<double> column_inward(program.columns(), 1.0);
  std::fill(wanted_.begin(), wanted_.end(), char{0});
  for (std::size_t slot = 0; slot < slots(); ++slot) {
    const std::size_t constraint = constraint_[slot];
    if (constraint < program.columns()) {
      wanted_[constraint] = 1;
      column_inward[constraint] = inward_[slot];
    } else {
      rows.push_back(constraint - program.columns());
      row_inward.push_back(inward_[slot]);
    }
  }
  edges_.reset(program.columns());
  exchanges_ = 0;
  std::fill(slot_of_.begin(), slot_of_.end(), kFree);
  for (std::size_t j = 0; j < program.columns(); ++j) hold(j, j, column_inward[j]);
  bring_in_rows(program, rows, row_inward);
  settle_columns(program);
}

/// Rows with few coefficients first: they leave the edges sparse for longer.
void SimplexVertex::bring_in_rows(const SimplexProgram& program, std::span<const std::size_t> rows,
                                  std::span<const double> inward) {
  std::vector<std::size_t> order(rows.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return program.row_columns(rows[a]).size() < program.row_columns(rows[b]).size();
  });
  for (const std::size_t place : order) {
    const std::size_t constraint = program.columns() + rows[place];
    along_edges(program, constraint, along_.data());
    const std::size_t slot = best_slot_for(along_.data());
    if (slot == slots() || std::abs(along_[slot]) < kDependent) continue;
    edges_.copy_edge(slot, edge_.data());
    edges_.exchange(slot, along_.data(), edge_.data());
    slot_of_[constraint_[slot]] = kFree;
    hold(slot, constraint, inward[place]);
  }
}

/// The slot of an unwanted column that the constraint depends on most.
std::size_t SimplexVertex::best_slot_for(const double* along) const {
  std::size_t best = slots();
  for (std::size_t slot = 0; slot < slots(); ++slot) {
    if (constraint_[slot] >= wanted_.size() || wanted_[constraint_[slot]]) continue;
    if (best == slots() || std::abs(along[slot]) > std::abs(along[best])) best = slot;
  }
  return best;
}

/// Sides may have changed since the directions were noted: equations have none, everything else has one.
void SimplexVertex::settle_columns(const SimplexProgram& program) {
  for (std::size_t slot = 0; slot < slots(); ++slot) {
    const std::size_t constraint = constraint_[slot];
    const ConstraintSides& sides = program.sides();
    if (program.is_equation(constraint)) {
      inward_[slot] = 0;
    } else if (inward_[slot] == 0 || !std::isfinite(value_at(sides, constraint, inward_[slot]))) {
      inward_[slot] = std::isfinite(sides.lower[constraint]) ? 1 : -1;
    }
  }
}

void SimplexVertex::place(const SimplexProgram& program, const ConstraintSides& sides) {
  for (std::size_t slot = 0; slot < slots(); ++slot) {
    offset_[slot] = value_at(sides, constraint_[slot], inward_[slot]);
  }
  edges_.vertex(offset_.data(), value_.data());
  program.fill_rows(value_.data());
  for (std::size_t slot = 0; slot < slots(); ++slot) value_[constraint_[slot]] = offset_[slot];
}

void SimplexVertex::along_edges(const SimplexProgram& program, std::size_t constraint, double* result) const {
  if (constraint < program.columns()) {
    std::copy_n(edges_.coordinate(constraint), edges_.stride(), result);
  } else {
    const std::size_t row = constraint - program.columns();
    edges_.along_edges(program.row_columns(row), program.row_values(row), result);
  }
}

void SimplexVertex::follow_edge(const SimplexProgram& program, std::size_t slot, double* rate) const {
  edges_.copy_edge(slot, rate);
  program.fill_rows_of_sparse(rate);
  for (const std::size_t constraint : constraint_) rate[constraint] = 0;
  rate[constraint_[slot]] = 1;
}

void SimplexVertex::advance(const double* rate, double step) {
  simplex_kernel::advance(value_.data(), rate, step, value_.size());
}

void SimplexVertex::flip(std::size_t slot, const ConstraintSides& sides) {
  inward_[slot] = -inward_[slot];
  value_[constraint_[slot]] = value_at(sides, constraint_[slot], inward_[slot]);
}

void SimplexVertex::exchange(const SimplexProgram& program, std::size_t slot, std::size_t constraint,
                             double inward, const ConstraintSides& sides, const double* along,
                             const double* edge) {
  edges_.exchange(slot, along, edge);
  ++exchanges_;
  slot_of_[constraint_[slot]] = kFree;
  hold(slot, constraint, program.is_equation(constraint) ? 0 : inward);
  value_[constraint] = value_at(sides, constraint, inward_[slot]);
}

}  // namespace gcslab
