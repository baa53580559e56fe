#include "experiments/peers/ibex_cover.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fmt/format.h>

#include "experiments/peers/peer_run.h"

namespace gcslab {
namespace {

constexpr std::string_view kSignature("IBEX COVERING FILE \0", 20);
constexpr std::uint32_t kLevel = 5;

class Reader {
 public:
  Reader(const std::string& bytes, std::size_t variables, std::size_t equations)
      : bytes_(bytes), variables_(variables), equations_(equations) {}

  IbexCover run() {
    read_head();
    const std::uint32_t count = integer();
    if (count > (bytes_.size() - next_) / (16 * variables_)) fail("more boxes than bytes");
    for (std::uint32_t i = 0; i < count; ++i) boxes_.push_back(box());
    numbers();  // inner boxes: there are none with equations
    integer();
    numbers();  // boundary boxes of the underlying list: the solutions are named again below
    read_manifold();
    read_search();
    sort_boxes();
    if (next_ != bytes_.size()) fail("bytes after the end");
    return std::move(cover_);
  }

 private:
  [[noreturn]] static void fail(const std::string& what) { throw GarbledAnswer("its COV file: " + what); }

  template <class Number>
  Number number() {
    Number value{};
    if (bytes_.size() - next_ < sizeof value) fail("it ends early");
    std::memcpy(&value, bytes_.data() + next_, sizeof value);
    next_ += sizeof value;
    return value;
  }
  std::uint32_t integer() { return number<std::uint32_t>(); }

  void read_head() {
    if (bytes_.size() < kSignature.size() ||
        !std::equal(kSignature.begin(), kSignature.end(), bytes_.begin()))
      fail("it has not the signature of such a file");
    next_ = kSignature.size();
    if (integer() != kLevel) fail("it is not of the format that ibexsolve writes");
    for (std::uint32_t i = 0; i <= kLevel; ++i) {
      if (integer() != 0) fail("it is not of the format that ibexsolve writes");
    }
    for (std::uint32_t i = 0; i <= kLevel; ++i) {
      if (integer() != 1) fail("it is of a version that is not known here");
    }
    if (integer() != variables_) fail("it is about another number of variables");
  }

  Box box() {
    Box result;
    for (std::size_t i = 0; i < variables_; ++i) {
      const auto lower = number<double>();
      const auto upper = number<double>();
      if (!(lower <= upper)) fail("a side of a box is empty");
      result.emplace_back(lower, upper);
    }
    return result;
  }

  /// A list of numbers of boxes, ascending.
  std::vector<std::uint32_t> numbers() {
    const std::uint32_t count = integer();
    if (count > boxes_.size()) fail("a list has more entries than there are boxes");
    std::vector<std::uint32_t> result;
    for (std::uint32_t i = 0; i < count; ++i) result.push_back(number_of_box(result));
    return result;
  }

  std::uint32_t number_of_box(const std::vector<std::uint32_t>& before) {
    const std::uint32_t value = integer();
    if (value >= boxes_.size() || (!before.empty() && value <= before.back()))
      fail(fmt::format("a list names box {}, of {}", value, boxes_.size()));
    return value;
  }

  void skip_parameters() {
    for (std::size_t i = equations_; i < variables_; ++i) integer();
  }

  void read_manifold() {
    if (integer() != equations_) fail("it is about another number of equations");
    integer();  // inequalities
    integer();  // type of boundaries
    const std::uint32_t count = integer();
    if (count > boxes_.size()) fail("more solutions than boxes");
    for (std::uint32_t i = 0; i < count; ++i) {
      solutions_.push_back(number_of_box(solutions_));
      skip_parameters();
      box();  // of unicity: nothing here rests on it
    }
    std::vector<std::uint32_t> boundary;
    const std::uint32_t boundaries = integer();
    if (boundaries > boxes_.size()) fail("more boundary boxes than boxes");
    for (std::uint32_t i = 0; i < boundaries; ++i) {
      boundary.push_back(number_of_box(boundary));
      skip_parameters();
    }
  }

  void read_search() {
    for (std::size_t i = 0; i < variables_; ++i) {
      const std::size_t end = bytes_.find('\0', next_);
      if (end == std::string::npos) fail("it ends inside a name");
      next_ = end + 1;
    }
    cover_.status = integer();
    if (cover_.status > 5) fail("its status is not one of 0 to 5");
    cover_.seconds = number<double>();
    cover_.cells = integer();
    pending_ = numbers();
  }

  void sort_boxes() {
    for (std::uint32_t i = 0; i < boxes_.size(); ++i) {
      const bool is_solution = std::ranges::binary_search(solutions_, i);
      const bool is_pending = std::ranges::binary_search(pending_, i);
      if (is_solution && is_pending) fail("a box is both a solution and pending");
      auto& list = is_solution ? cover_.solutions : is_pending ? cover_.pending : cover_.others;
      list.push_back(std::move(boxes_[i]));
    }
  }

  const std::string& bytes_;
  std::size_t variables_, equations_;
  std::size_t next_ = 0;
  std::vector<Box> boxes_;
  std::vector<std::uint32_t> solutions_, pending_;
  IbexCover cover_;
};

}  // namespace

IbexCover read_ibex_cover(const std::string& bytes, std::size_t variables, std::size_t equations) {
  return Reader(bytes, variables, equations).run();
}

}  // namespace gcslab
