#pragma once

// The proof that a search lost nothing, as a text that can be checked without searching.
//
// One line an event, numbers as hexadecimal floats, variables and functions by number from 0:
//   gcslab-proof 1
//   box LO HI ...                 the search box, one pair a variable
//   term equation K I ...         or inequality: term number 0, 1, .. is an expression of that function,
//   found
//                                 from it by the numbers of operands I; it stands for a variable that follows
//                                 those of the system, wherever it occurs (lifted_system.h)
//   start ID LO HI ...            a box that the search starts from
//   root R LO HI ... U LO HI ...  root number R: its box and its uniqueness box, proved on their own
//   node ID                       what was done with box ID, in this order:
//     hull_equation K V LO HI        forward-backward propagation through equation K narrows variable V
//     hull_inequality K V LO HI
//     expansion LO HI ...            expansions are about the midpoint of the box as it is now; with a side
//                                    for each term or none
//     expansion_row V LO HI C ...    the combination with multipliers C, one an equation, solved for V; more
//                                    summands may follow: "q K I : M", M times equation K divided by
//                                    variable I, which all its terms contain but for a constant, and "m K A
//                                    : M", M times equation K times at most 16 variables A, joined by *
//     square_row V LO HI C ...       the same, solved for the square of z_V
//     polytope V LO HI C ... ; P ... with f_k about the midpoint at `expansion`, in z of [-1, 1]^n, first of
//                                    equations, then of inequalities, whose C are <= 0: +-z_V - sum C_k f_k
//                                    - sum of products, bounded monomial by monomial, gives the end moved:
//                                    + for LO, - for HI; without z_V, a positive bound shows "empty".
//                                    P is "p SA ... : M", M times the product of all 1 + S z^A, or "s SA ...
//                                    : M", M times the square of the sum of S z^A, with S a sign and A the
//                                    variables of a monomial, joined by *. After an `expansion` with terms
//                                    V, C, P are about the lifted system, and strips may follow: "g T S : M",
//                                    |M| times lower <= t_T - S x, or t_T - S x <= upper where M < 0, over
//                                    the side of the argument x of t_T
//     mean_value_row V LO HI C ...   0 = C f(m) + C J (x - m), with m and J of the box at `expansion`
//     bernstein_row V LO HI C ...    C f has no zero with x_V outside [LO, HI] in the box at `expansion`: its
//                                    Bernstein form there, seen along V, is positive or negative
//                                    "empty" in place of LO HI: no root in the box
//     cases V POINT                  what follows is about the part of the box with x_V <= POINT,
//     otherwise                      from here on about the part with x_V >= POINT,
//     join                           and now about the hull of what is left of the two, empty when nothing
//                                    is left. Cases nest; a part ends early when a step shows that it is
//                                    empty. An `expansion` in a part is forgotten at the end of that part
//   and how it ended:
//     end empty | covered R | undecided | pending | cut V POINT LOWER UPPER   (the numbers of the two parts)
//     end counted LO HI ...          one polynomial in one variable: the boxes of the result and the ones
//                                    that follow, where an inequality fails, contain as many distinct roots
//                                    as there are in the search box; the verifier counts them
//   theorem NAME                  in place of starts and nodes: by a theorem about this kind of system the
//                                 search box has no solution beside the listed ones. circle_packing:
//                                 packing/packing_problem.h
//   theorem loci_intersection N V ... K ...   likewise: blocks of N variables and as many equations each,
//                                 of which the variables of a block are found where planes and spheres meet
//   end
//   hash XXH3                      of all lines before
// Every line says what holds because of it; proof_step.h says why.

#include <cstdint>
#include <iosfwd>
#include <string>
#include <string_view>

#include "base/content_hash.h"
#include "box_solver/lifted_system.h"
#include "box_solver/proof_step.h"
#include "certification/root_certificate.h"

namespace gcslab {

class ProofLog {
 public:
  /// Writes to `out`, which must outlive it.
  explicit ProofLog(std::ostream& out) : out_(&out) {}

  void begin(const Box& search_box);
  void term(const ExpressionPlace& place);
  void start(std::uint64_t id, const Box& box);
  void root(std::size_t number, const CertifiedRoot& root);
  void node(std::uint64_t id, const ProofTrace& trace);
  void theorem(std::string_view name);
  void end_empty();
  void end_covered(std::size_t root);
  void end_undecided();
  void end_pending();
  void end_counted(const std::vector<Interval>& excluded);
  void end_cut(std::size_t variable, double point, std::uint64_t lower, std::uint64_t upper);
  void finish();

 private:
  void write(std::string_view line);
  void step(const ProofStep& step);

  std::ostream* out_;
  std::string line_;  ///< memory to build lines in
  ContentHasher hasher_;
};

}  // namespace gcslab
