#pragma once

// The binary "COV" file that ibexsolve writes, as `ibexsolve --format` of IBEX 2.8 and 2.9 describes it:
// unsigned integers of 32 bits and doubles, in the byte order of the machine:
//   20 bytes "IBEX COVERING FILE " and a zero; format level 5; six format numbers; six versions;
//   n variables; N boxes of 2 n doubles;
//   numbers of inner boxes; type and numbers of boundary boxes;
//   equalities m, inequalities, type of boundaries; for m > 0 the solutions, each as its box's number, n - m
//   parameters when m < n, and its unicity box; boundary boxes, with parameters when 0 < m < n;
//   n names ended by zeros; status of the search; seconds; cells; numbers of pending boxes.

#include <cstdint>
#include <string>
#include <vector>

#include "interval/interval.h"

namespace gcslab {

struct IbexCover {
  /// 0 all boxes validated, 1 infeasible, 2 a box reached the least width, 3 time out, 4 buffer overflow, 5
  /// interrupted.
  std::uint32_t status = 0;
  std::vector<Box> solutions;  ///< that IBEX holds for proved
  std::vector<Box> others;     ///< boundary and unknown ones
  std::vector<Box> pending;
  double seconds = 0;
  std::uint32_t cells = 0;
};

/// Throws GarbledAnswer where the bytes are not as above, or about another number of variables or equations.
IbexCover read_ibex_cover(const std::string& bytes, std::size_t variables, std::size_t equations);

}  // namespace gcslab
