#include "experiments/reporting/escape.h"

#include <gtest/gtest.h>

namespace gcslab {
namespace {

TEST(EscapeMarkdown, MarkupBecomesText) {
  EXPECT_EQ(escape_markdown("a|b*c`d"), "a\\|b\\*c\\`d");
  EXPECT_EQ(escape_markdown("x<y & z"), "x&lt;y &amp; z");
  EXPECT_EQ(escape_markdown("two\nlines"), "two lines");
}

TEST(EscapeMarkdown, NamesStayReadable) {
  EXPECT_EQ(escape_markdown("affine_min_range"), "affine_min_range");
  EXPECT_EQ(escape_markdown("_x_"), "\\_x\\_");
}

TEST(EscapeLatex, SpecialCharactersBecomeCommands) {
  EXPECT_EQ(escape_latex("50% of $x_1 & {y}#"), "50\\% of \\$x\\_1 \\& \\{y\\}\\#");
  EXPECT_EQ(escape_latex("a\\b~c^d"), "a\\textbackslash{}b\\textasciitilde{}c\\textasciicircum{}d");
}

TEST(EscapeLatex, TypographyBecomesCommands) {
  EXPECT_EQ(escape_latex("1.2×10⁻¹²"), "1.2$\\times$10$^{-12}$");
  EXPECT_EQ(escape_latex("3–4 µs"), "3--4 \\textmu{}s");
}

TEST(EscapeHtml, MarkupBecomesText) {
  EXPECT_EQ(escape_html("<a b=\"c\">&"), "&lt;a b=&quot;c&quot;&gt;&amp;");
}

TEST(EscapeCsv, OnlyWhatMustBeIsQuoted) {
  EXPECT_EQ(escape_csv("plain text"), "plain text");
  EXPECT_EQ(escape_csv("a,b"), "\"a,b\"");
  EXPECT_EQ(escape_csv("say \"x\""), "\"say \"\"x\"\"\"");
}

TEST(GnuplotString, QuotesAreDoubled) { EXPECT_EQ(gnuplot_string("it's\n%x"), "'it''s %x'"); }

}  // namespace
}  // namespace gcslab
