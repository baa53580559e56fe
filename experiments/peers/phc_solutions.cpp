#include "experiments/peers/phc_solutions.h"

#include <cmath>
#include <sstream>

#include "experiments/peers/peer_run.h"

namespace gcslab {
namespace {

constexpr const char* kHeading = "THE SOLUTIONS :";

class Reader {
 public:
  Reader(const std::string& text, std::size_t variables) : stream_(text), variables_(variables) {}

  std::vector<PhcSolution> run() {
    next_line();
    const std::size_t count = whole_number("the number of solutions");
    if (whole_number("the number of coordinates") != variables_)
      fail("solutions in another number of variables");
    end_line();
    next_line();
    if (line_.find_first_not_of('=') != std::string::npos) fail("no line of = under the number of solutions");
    std::vector<PhcSolution> solutions;
    for (std::size_t i = 1; i <= count; ++i) solutions.push_back(solution(i));
    return solutions;
  }

 private:
  [[noreturn]] static void fail(const std::string& what) { throw GarbledAnswer("its solutions: " + what); }

  void next_line() {
    if (!std::getline(stream_, line_)) fail("the file ends early");
    words_ = std::istringstream(line_);
  }

  std::string word(const char* what) {
    std::string text;
    if (!(words_ >> text)) fail(std::string("no ") + what + " in \"" + line_.substr(0, 80) + "\"");
    return text;
  }

  void expect(const std::string& expected) {
    if (word(expected.c_str()) != expected) fail("no " + expected + " in \"" + line_.substr(0, 80) + "\"");
  }

  void end_line() {
    std::string rest;
    if (words_ >> rest) fail("one word too many in \"" + line_.substr(0, 80) + "\"");
  }

  std::size_t whole_number(const char* what) {
    const std::string text = word(what);
    if (text.size() > 9 || text.find_first_not_of("0123456789") != std::string::npos)
      fail(std::string(what) + " is \"" + text.substr(0, 40) + "\"");
    return static_cast<std::size_t>(std::stoul(text));
  }

  double number(const char* what) {
    const std::string text = word(what);
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (*end != '\0' || !std::isfinite(value)) fail(std::string(what) + " is \"" + text.substr(0, 40) + "\"");
    return value;
  }

  PhcSolution solution(std::size_t number_of_solution) {
    next_line();
    expect("solution");
    if (whole_number("the number of a solution") != number_of_solution) fail("solutions out of order");
    next_line();
    expect("t");
    next_line();
    expect("m");
    expect(":");
    PhcSolution result{static_cast<int>(whole_number("a multiplicity")), {}};
    next_line();
    if (line_.find("the solution for t") == std::string::npos) fail("no \"the solution for t\"");
    for (std::size_t i = 0; i < variables_; ++i) result.point.push_back(coordinate());
    next_line();
    if (!line_.starts_with("== err")) fail("no \"== err\" after a point");
    return result;
  }

  std::complex<double> coordinate() {
    next_line();
    word("a variable");
    expect(":");
    const double real = number("a real part");
    const double imaginary = number("an imaginary part");
    end_line();
    return {real, imaginary};
  }

  std::istringstream stream_;
  std::size_t variables_;
  std::string line_;
  std::istringstream words_;
};

}  // namespace

std::vector<PhcSolution> read_phc_solutions(const std::string& text, std::size_t variables) {
  const std::size_t heading = text.rfind(kHeading);
  if (heading == std::string::npos) return {};
  const std::size_t line_end = text.find('\n', heading);
  if (line_end == std::string::npos) throw GarbledAnswer("its solutions: the file ends at their heading");
  return Reader(text.substr(line_end + 1), variables).run();
}

}  // namespace gcslab
