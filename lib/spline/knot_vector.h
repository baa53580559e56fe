#pragma once

// Knot vectors: what a B-spline basis is made of.
//
// Knots u_0 <= ... <= u_m of degree d carry n + 1 = m - d basis functions N_0, ..., N_n, where N_i lives on
// [u_i, u_{i+d+1}] and is C^(d - s) at a knot of multiplicity s. The domain is [u_d, u_{n+1}]: there the
// functions sum to 1. Span k is [u_k, u_{k+1}[ inside the domain; on it N_{k-d}, ..., N_k are not zero. A
// multiplicity of d + 1 inside the domain is a jump. Sources: de Boor 1978; Piegl, Tiller 1997, chapter 2;
// Celikbas 2003, section 1.2.
//
// Over a set-valued number type knots are enclosures, in the order of knot_order.h.

#include <algorithm>
#include <string>
#include <vector>

#include "base/error.h"
#include "spline/knot_order.h"

namespace gcslab {

/// One value of a knot vector.
template <class T>
struct DistinctKnot {
  T value;
  int multiplicity;
  std::size_t first;  ///< index of its first copy
};

/// Spans first, first + 1, ..., last, of which empty ones do not count.
struct SpanRange {
  std::size_t first;
  std::size_t last;
};

template <class T>
class KnotVector {
 public:
  /// Throws InputError, which names the knot, unless the knots are finite, do not decrease, occur d + 1 times
  /// at most, are 2d + 2 at least, and the domain is longer than a point.
  KnotVector(int degree, std::vector<T> knots);

  int degree() const { return degree_; }
  /// The number n + 1 of basis functions.
  std::size_t size() const { return knots_.size() - order(); }
  const std::vector<T>& knots() const { return knots_; }
  const T& operator[](std::size_t i) const { return knots_[i]; }

  /// The ends of the domain.
  const T& lower() const { return knots_[order() - 1]; }
  const T& upper() const { return knots_[size()]; }
  /// Both ends of the domain have multiplicity d + 1 and are the outermost knots.
  bool is_clamped() const;

  /// All values with their multiplicities, ascending.
  std::vector<DistinctKnot<T>> distinct() const;
  /// Those strictly inside the domain.
  std::vector<DistinctKnot<T>> interior() const;
  /// How often the value occurs.
  int multiplicity(const T& value) const;
  /// The non-empty spans, ascending.
  std::vector<std::size_t> spans() const;
  bool is_span(std::size_t k) const { return surely_less(knots_[k], knots_[k + 1]); }

  /// The span of a parameter; the right end of the domain belongs to the last non-empty span. Binary search.
  /// Throws InputError for a parameter outside of the domain, and for a set that meets several spans.
  std::size_t find_span(const T& u) const;
  /// The spans that members of u may belong to; the part of a set outside of the domain is left out. Throws
  /// InputError when u is outside of the domain.
  SpanRange find_spans(const T& u) const;

  /// (u_{i+1} + ... + u_{i+d}) / d, one a basis function: sum_i N_i(u) greville_i = u. For degree 0 the
  /// middles of the spans.
  std::vector<T> greville() const;

 private:
  std::size_t order() const { return static_cast<std::size_t>(degree_) + 1; }
  void check_shape() const;
  void check_order() const;
  std::string allowed_multiplicity() const;

  int degree_;
  std::vector<T> knots_;
  std::size_t first_span_ = 0;
  std::size_t last_span_ = 0;
};

/// Clamped, with equal spans of [lower, upper]. Throws InputError for less than one span.
template <class T>
KnotVector<T> clamped_uniform_knots(int degree, std::size_t spans, const T& lower, const T& upper);
/// Equally spaced simple knots first, first + step, ...; the domain has that many spans.
template <class T>
KnotVector<T> uniform_knots(int degree, std::size_t spans, const T& first, const T& step);

// ---------------------------------------------------------------------------------------------------------

template <class T>
KnotVector<T>::KnotVector(int degree, std::vector<T> knots) : degree_(degree), knots_(std::move(knots)) {
  check_shape();
  check_order();
  if (!surely_less(lower(), upper()))
    throw InputError("knots: the domain [" + number_text(lower()) + ", " + number_text(upper()) +
                     "] from knot " + std::to_string(degree_) + " to knot " + std::to_string(size()) +
                     " is empty: expected an end after its start");
  const std::vector<std::size_t> all = spans();
  first_span_ = all.front();
  last_span_ = all.back();
}

template <class T>
void KnotVector<T>::check_shape() const {
  if (degree_ < 0) throw InputError("degree " + std::to_string(degree_) + ": expected 0 at least");
  const std::size_t least = 2 * order();
  if (knots_.size() < least)
    throw InputError("knots: " + std::to_string(knots_.size()) + " given, expected at least 2d + 2 = " +
                     std::to_string(least) + " for degree " + std::to_string(degree_));
  for (std::size_t i = 0; i < knots_.size(); ++i) {
    if (!is_finite_number(knots_[i]))
      throw InputError("knot " + std::to_string(i) + " is " + number_text(knots_[i]) +
                       ": expected a finite number");
  }
}

template <class T>
void KnotVector<T>::check_order() const {
  std::size_t copies = 1;
  for (std::size_t i = 1; i < knots_.size(); ++i) {
    const bool same = same_knot(knots_[i - 1], knots_[i]);
    if (!same && !surely_less(knots_[i - 1], knots_[i]))
      throw InputError("knot " + std::to_string(i) + " is " + number_text(knots_[i]) + " after " +
                       number_text(knots_[i - 1]) + ": expected knots that do not decrease");
    copies = same ? copies + 1 : 1;
    if (copies > order())
      throw InputError("knot " + std::to_string(i) + ": " + number_text(knots_[i]) + " occurs more than " +
                       allowed_multiplicity());
  }
}

template <class T>
std::string KnotVector<T>::allowed_multiplicity() const {
  return std::to_string(order()) + " times, the most that degree " + std::to_string(degree_) + " allows";
}

template <class T>
bool KnotVector<T>::is_clamped() const {
  return same_knot(knots_.front(), lower()) && same_knot(knots_.back(), upper());
}

template <class T>
std::vector<DistinctKnot<T>> KnotVector<T>::distinct() const {
  std::vector<DistinctKnot<T>> result;
  for (std::size_t i = 0; i < knots_.size(); ++i) {
    if (!result.empty() && same_knot(result.back().value, knots_[i])) {
      ++result.back().multiplicity;
    } else {
      result.push_back({knots_[i], 1, i});
    }
  }
  return result;
}

template <class T>
std::vector<DistinctKnot<T>> KnotVector<T>::interior() const {
  std::vector<DistinctKnot<T>> result = distinct();
  std::erase_if(result, [&](const DistinctKnot<T>& knot) {
    return !surely_less(lower(), knot.value) || !surely_less(knot.value, upper());
  });
  return result;
}

template <class T>
int KnotVector<T>::multiplicity(const T& value) const {
  const auto first = std::partition_point(knots_.begin(), knots_.end(),
                                          [&](const T& knot) { return surely_less(knot, value); });
  const auto last = std::find_if(first, knots_.end(), [&](const T& knot) { return !same_knot(knot, value); });
  return static_cast<int>(last - first);
}

template <class T>
std::vector<std::size_t> KnotVector<T>::spans() const {
  std::vector<std::size_t> result;
  for (std::size_t k = order() - 1; k < size(); ++k) {
    if (is_span(k)) result.push_back(k);
  }
  return result;
}

template <class T>
std::size_t KnotVector<T>::find_span(const T& u) const {
  const SpanRange range = find_spans(u);
  if constexpr (SetNumber<T>) {
    if (range.first != range.last)
      throw InputError("parameter " + number_text(u) + " meets several spans: expected one within a span");
  }
  return range.last;
}

template <class T>
SpanRange KnotVector<T>::find_spans(const T& u) const {
  if (!is_finite_number(u) || surely_less(u, lower()) || surely_less(upper(), u))
    throw InputError("parameter " + number_text(u) + " is outside of the domain [" + number_text(lower()) +
                     ", " + number_text(upper()) + "]");
  const auto begin = knots_.begin() + degree_ + 1;
  const auto end = knots_.begin() + static_cast<std::ptrdiff_t>(size());
  const auto span_before = [&](auto place) {
    const auto span = static_cast<std::size_t>(place - knots_.begin()) - 1;
    return std::clamp(span, first_span_, last_span_);
  };
  const std::size_t last =
      span_before(std::partition_point(begin, end, [&](const T& knot) { return !surely_less(u, knot); }));
  if constexpr (SetNumber<T>) {
    return {
        span_before(std::partition_point(begin, end, [&](const T& knot) { return surely_at_most(knot, u); })),
        last};
  } else {
    return {last, last};
  }
}

template <class T>
std::vector<T> KnotVector<T>::greville() const {
  std::vector<T> result;
  for (std::size_t i = 0; i < size(); ++i) {
    if (degree_ == 0) {
      result.push_back(T((knots_[i] + knots_[i + 1]) / whole_number<T>(2)));
      continue;
    }
    T sum = knots_[i + 1];
    for (std::size_t j = i + 2; j < i + order(); ++j) sum = sum + knots_[j];
    result.push_back(T(sum / whole_number<T>(degree_)));
  }
  return result;
}

template <class T>
KnotVector<T> clamped_uniform_knots(int degree, std::size_t spans, const T& lower, const T& upper) {
  if (spans == 0) throw InputError("knots: 0 spans asked for, expected 1 at least");
  const auto count = static_cast<long>(spans);
  std::vector<T> knots(static_cast<std::size_t>(std::max(degree, 0)), lower);
  for (long i = 0; i < count; ++i)
    knots.push_back(T(lower + (upper - lower) * whole_number<T>(i) / whole_number<T>(count)));
  knots.insert(knots.end(), static_cast<std::size_t>(std::max(degree, 0)) + 1, upper);
  return KnotVector<T>(degree, std::move(knots));
}

template <class T>
KnotVector<T> uniform_knots(int degree, std::size_t spans, const T& first, const T& step) {
  std::vector<T> knots;
  const long last = static_cast<long>(spans) + 2L * std::max(degree, 0);
  for (long i = 0; i <= last; ++i) knots.push_back(T(first + step * whole_number<T>(i)));
  return KnotVector<T>(degree, std::move(knots));
}

/// The same knots in another number type, as converted_number.
template <class To, class From>
KnotVector<To> converted(const KnotVector<From>& knots) {
  std::vector<To> result;
  for (const From& knot : knots.knots()) result.push_back(converted_number<To>(knot));
  return KnotVector<To>(knots.degree(), std::move(result));
}

}  // namespace gcslab
