#pragma once

// The solutions that PHCpack's blackbox solver `phc -b` appends to its input file (PHCpack 2.4, reference
// manual, "phc -b", and the solution format of "phc -z"):
//
//   THE SOLUTIONS :
//   4 2                                    number of solutions, of coordinates
//   ===========...
//   solution 1 :
//   t :  1.0E+00   0.0E+00                 real and imaginary part
//   m : 1                                  multiplicity; 0: no solution, a sign of a linear system without
//   one the solution for t :
//    x :  7.8E-01   0.0E+00                one line a variable, in the order of the polynomials
//    y :  6.1E-01   0.0E+00
//   == err :  8.1E-17 = rco :  4.6E-01 = res :  1.1E-16 ==
//
// Solutions are complex and approximate; PHCpack proves nothing of them.

#include <complex>
#include <string>
#include <vector>

namespace gcslab {

struct PhcSolution {
  int multiplicity;
  std::vector<std::complex<double>> point;
};

/// The solutions in an input file that `phc -b` has worked on; none when it appended none. Throws
/// GarbledAnswer where the text is not as above, or not in that many variables.
std::vector<PhcSolution> read_phc_solutions(const std::string& text, std::size_t variables);

}  // namespace gcslab
