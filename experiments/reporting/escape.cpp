#include "experiments/reporting/escape.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

namespace gcslab {
namespace {

using Spelling = std::pair<std::string_view, std::string_view>;

/// Superscript characters and the characters they raise.
constexpr std::array<Spelling, 12> kSuperscripts = {{{"⁰", "0"},
                                                     {"¹", "1"},
                                                     {"²", "2"},
                                                     {"³", "3"},
                                                     {"⁴", "4"},
                                                     {"⁵", "5"},
                                                     {"⁶", "6"},
                                                     {"⁷", "7"},
                                                     {"⁸", "8"},
                                                     {"⁹", "9"},
                                                     {"⁻", "-"},
                                                     {"⁺", "+"}}};

constexpr std::array<Spelling, 30> kLatex = {{{"\\", "\\textbackslash{}"},
                                              {"{", "\\{"},
                                              {"}", "\\}"},
                                              {"$", "\\$"},
                                              {"&", "\\&"},
                                              {"#", "\\#"},
                                              {"%", "\\%"},
                                              {"_", "\\_"},
                                              {"^", "\\textasciicircum{}"},
                                              {"~", "\\textasciitilde{}"},
                                              {"<", "\\textless{}"},
                                              {">", "\\textgreater{}"},
                                              {"|", "\\textbar{}"},
                                              {"\"", "''"},
                                              {"–", "--"},
                                              {"—", "---"},
                                              {"−", "$-$"},
                                              {"×", "$\\times$"},
                                              {"÷", "$\\div$"},
                                              {"·", "$\\cdot$"},
                                              {"±", "$\\pm$"},
                                              {"≤", "$\\leq$"},
                                              {"≥", "$\\geq$"},
                                              {"∞", "$\\infty$"},
                                              {"µ", "\\textmu{}"},
                                              {"…", "\\ldots{}"},
                                              {"’", "'"},
                                              {"π", "$\\pi$"},
                                              {"°", "\\textdegree{}"},
                                              {"\n", " "}}};

template <std::size_t n>
const Spelling* spelling_at(const std::array<Spelling, n>& spellings, std::string_view rest) {
  const auto found =
      std::ranges::find_if(spellings, [&](const Spelling& s) { return rest.starts_with(s.first); });
  return found == spellings.end() ? nullptr : &*found;
}

/// Takes a run of superscripts from the front of `rest`; empty when there is none.
std::string take_superscript(std::string_view& rest) {
  std::string raised;
  while (const Spelling* digit = spelling_at(kSuperscripts, rest)) {
    raised += digit->second;
    rest.remove_prefix(digit->first.size());
  }
  return raised;
}

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }

/// An underscore between letters is no emphasis in Markdown, and names stay readable without the backslash.
bool is_inside_word(std::string_view text, std::size_t at) {
  return at > 0 && at + 1 < text.size() && is_word(text[at - 1]) && is_word(text[at + 1]);
}

}  // namespace

std::string escape_markdown(std::string_view text) {
  constexpr std::string_view kMarkup = "\\`*|[]";
  std::string result;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    if (kMarkup.find(c) != std::string_view::npos || (c == '_' && !is_inside_word(text, at))) result += '\\';
    if (c == '<') {
      result += "&lt;";
    } else if (c == '>') {
      result += "&gt;";
    } else if (c == '&') {
      result += "&amp;";
    } else {
      result += c == '\n' || c == '\r' ? ' ' : c;
    }
  }
  return result;
}

std::string escape_latex(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    if (const std::string raised = take_superscript(text); !raised.empty()) {
      result += "$^{" + raised + "}$";
    } else if (const Spelling* spelling = spelling_at(kLatex, text)) {
      result += spelling->second;
      text.remove_prefix(spelling->first.size());
    } else {
      result += text.front();
      text.remove_prefix(1);
    }
  }
  return result;
}

std::string escape_html(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string escape_csv(std::string_view text) {
  if (text.find_first_of(",\"\n\r") == std::string_view::npos) return std::string(text);
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"') result += '"';
    result += c;
  }
  return result + "\"";
}

std::string gnuplot_string(std::string_view text) {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\'') result += '\'';
    result += c == '\n' || c == '\r' ? ' ' : c;
  }
  return result + "'";
}

}  // namespace gcslab
