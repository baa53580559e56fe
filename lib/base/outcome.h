#pragma once

// The words in which every method reports what it achieved.

#include <string>
#include <string_view>

namespace gcslab {

/// What became of a run. Mathematics has named outcomes; none of them is an exception.
enum class Status {
  complete,          ///< completeness is proved and nothing is undecided
  partial,           ///< the method ran its course, but something is undecided or unproved
  budget_exhausted,  ///< time, memory or work ran out
  not_applicable,    ///< the method does not take this problem; the reason says why
  failed,            ///< the method gave up; the reason says why
  out_of_memory,     ///< a job's process was stopped at its memory limit
  crashed            ///< a job's process died of a signal, which the reason names
};

std::string_view name_of(Status status);
/// The inverse of name_of. Throws InputError for a word that is no status.
Status status_from_name(std::string_view name);

/// What a variant promises. Certificates and completeness never rest on a baseline.
enum class Promise {
  rigorous,  ///< every result holds for the real numbers, whatever the rounding
  baseline   ///< kept for comparison only: known to be wrong sometimes
};

std::string_view name_of(Promise promise);

}  // namespace gcslab
