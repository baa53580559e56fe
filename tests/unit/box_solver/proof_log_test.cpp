// The text of a proof, line by line.

#include "box_solver/proof_log.h"

#include <gtest/gtest.h>
#include <sstream>

namespace gcslab {
namespace {

TEST(ProofLog, WritesEveryKindOfStepAsTheHeaderSays) {
  ProofTrace trace(true);
  trace.add({Argument::hull_of_equation, 2, 1, {0.5, 1}});
  trace.add({Argument::hull_of_inequality, 0, 1, {-0.5, 1}});
  trace.add({Argument::expansion});
  trace.add({Argument::mean_value_row, 0, 1, {0, 1}, {1, -2}});
  trace.add({Argument::cases, 0, 3, Interval(0.25)});
  trace.add({Argument::expansion_row, 0, 0, Interval::empty(), {1, 0}});
  trace.add(
      {Argument::square_row, 0, 1, {0, 1}, {2, 0}, {{{1, {0}, true}, 0.5}, {{1, {0, 0, 2}, false}, -1}}});
  trace.add({Argument::otherwise});
  trace.add({Argument::bernstein_row, 0, 0, {1, 1}, {0, 3}});
  trace.add({Argument::join});
  std::ostringstream out;
  ProofLog log(out);
  log.node(7, trace);
  log.end_cut(1, 0.5, 8, 9);
  EXPECT_EQ(out.str(),
            "node 7\n"
            "hull_equation 2 1 0x1p-1 0x1p+0\n"
            "hull_inequality 0 1 -0x1p-1 0x1p+0\n"
            "expansion\n"
            "mean_value_row 1 0x0p+0 0x1p+0 0x1p+0 -0x1p+1\n"
            "cases 3 0x1p-2\n"
            "expansion_row 0 empty 0x1p+0 0x0p+0\n"
            "square_row 1 0x0p+0 0x1p+0 0x1p+1 0x0p+0 q 1 0 : 0x1p-1 m 1 0*0*2 : -0x1p+0\n"
            "otherwise\n"
            "bernstein_row 0 0x1p+0 0x1p+0 0x0p+0 0x1.8p+1\n"
            "join\n"
            "end cut 1 0x1p-1 8 9\n");
}

}  // namespace
}  // namespace gcslab
