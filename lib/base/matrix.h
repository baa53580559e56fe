#pragma once

// A dense matrix, row by row in one array.

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace gcslab {

template <class T>
class Matrix {
 public:
  Matrix() = default;
  Matrix(std::size_t rows, std::size_t columns, const T& value = T())
      : rows_(rows), columns_(columns), entries_(rows * columns, value) {}

  std::size_t rows() const { return rows_; }
  std::size_t columns() const { return columns_; }

  T& operator()(std::size_t row, std::size_t column) { return entries_[row * columns_ + column]; }
  const T& operator()(std::size_t row, std::size_t column) const { return entries_[row * columns_ + column]; }
  std::span<T> row(std::size_t row) { return {entries_.data() + row * columns_, columns_}; }
  std::span<const T> row(std::size_t row) const { return {entries_.data() + row * columns_, columns_}; }
  T* data() { return entries_.data(); }
  const T* data() const { return entries_.data(); }

  void fill(const T& value) { entries_.assign(entries_.size(), value); }

 private:
  std::size_t rows_ = 0;
  std::size_t columns_ = 0;
  std::vector<T> entries_;
};

}  // namespace gcslab
