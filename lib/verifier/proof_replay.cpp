#include "verifier/proof_replay.h"

#include <algorithm>

#include "verifier/box_relations.h"
#include "verifier/loci_theorem.h"
#include "verifier/packing_theorem.h"

namespace gcslab::verifier {

bool ListedResult::holds_all_roots(const Interval& search, const std::vector<Interval>& others) const {
  std::vector<Interval> all;
  for (const Interval& x : parts) all.push_back(intersection(x, search));
  for (const Interval& x : others) all.push_back(intersection(x, search));
  return counter->count_in_union(std::move(all)) == counter->count(search);
}

ProofReplay::ProofReplay(JudgedSystem& system, const Box& search_box, const ListedResult& listed,
                         ProofReader& reader)
    : system_(&system),
      search_box_(&search_box),
      listed_(&listed),
      reader_(&reader),
      prover_(system),
      judge_(system),
      undecided_(listed.undecided) {
  std::ranges::sort(undecided_, is_before);
}

ReplaySummary ProofReplay::run() {
  read_header();
  for (bool goes_on = true; goes_on;) {
    if (!reader_->next_line()) reader_->refuse("the file ends before its line 'end'");
    goes_on = read_event(reader_->word());
  }
  read_hash();
  if (!open_.empty()) {
    summary_.gap = std::to_string(open_.size()) + " boxes, one of them number " +
                   std::to_string(open_.begin()->first) + ", are not followed to an end";
  } else if (!theorem_covers_ && !is_covered(*search_box_, starts_)) {
    summary_.gap = "the boxes that the search starts from do not cover the search box, as after a resumption";
  }
  summary_.is_complete = summary_.gap.empty();
  return summary_;
}

void ProofReplay::read_header() {
  if (!reader_->next_line() || reader_->word() != "gcslab-proof" || reader_->integer() != 1)
    reader_->refuse("expected 'gcslab-proof 1'");
  reader_->end_line();
  if (!reader_->next_line() || reader_->word() != "box") reader_->refuse("expected the search box");
  if (reader_->box(system_->variables()) != *search_box_)
    reader_->refuse("this is not the search box of the result");
  reader_->end_line();
}

/// One event; false after the last one.
bool ProofReplay::read_event(std::string_view word) {
  if (word == "term") {
    read_term();
  } else if (word == "start") {
    read_start();
  } else if (word == "root") {
    read_root();
  } else if (word == "node") {
    read_node();
  } else if (word == "theorem") {
    read_theorem();
  } else if (word == "end") {
    reader_->end_line();
    return false;
  } else {
    reader_->refuse("'" + std::string(word) + "' is no event of a proof");
  }
  return true;
}

void ProofReplay::read_term() {
  const std::string kind(reader_->word());
  if (kind != "equation" && kind != "inequality")
    reader_->refuse("'" + kind + "' is neither equation nor inequality");
  const bool is_equation = kind == "equation";
  const std::size_t count = (is_equation ? system_->equations() : system_->inequalities()).size();
  const std::size_t function = reader_->index(count, kind.c_str());
  std::vector<std::size_t> operands;
  while (!reader_->at_end_of_line()) operands.push_back(reader_->index(2, "operand"));
  reader_->end_line();
  if (next_id_ != 0) reader_->refuse("terms are named before the boxes");
  if (!judge_.terms().add(is_equation, function, operands))
    reader_->refuse("there is no such expression, or it is a term already");
}

void ProofReplay::read_hash() {
  if (!reader_->next_line()) reader_->refuse("expected the line 'hash', the file ends");
  const std::string expected = reader_->hash_before();
  if (reader_->word() != "hash" || reader_->word() != expected)
    reader_->refuse("the content hash is not that of the lines before: the file was edited");
  reader_->end_line();
  if (reader_->next_line()) reader_->refuse("nothing may follow the content hash");
}

void ProofReplay::open_box(std::uint64_t id, const Box& box) {
  if (id < next_id_) reader_->refuse("box " + std::to_string(id) + " was named before");
  next_id_ = id + 1;
  open_.emplace(id, box);
}

void ProofReplay::read_start() {
  const std::uint64_t id = reader_->integer();
  starts_.push_back(reader_->box(system_->variables()));
  reader_->end_line();
  open_box(id, starts_.back());
}

bool ProofReplay::violates_inequality(const RangeBox& root) {
  for (JudgedFunction& inequality : system_->inequalities()) {
    const Range& value = inequality.program.evaluate(root);
    if (value.is_empty() || mpfr_sgn(value.lower()) > 0) return true;
  }
  return false;
}

bool ProofReplay::satisfies_inequalities(const RangeBox& root) {
  return std::ranges::all_of(system_->inequalities(), [&](JudgedFunction& inequality) {
    const Range& value = inequality.program.evaluate(root);
    return !value.is_empty() && mpfr_sgn(value.upper()) <= 0 && inequality.program.is_defined_everywhere();
  });
}

void ProofReplay::read_theorem() {
  const std::string name(reader_->word());
  if (name == "circle_packing") {
    read_packing_theorem();
  } else if (name == "loci_intersection") {
    read_loci_theorem();
  } else {
    reader_->refuse("expected 'circle_packing' or 'loci_intersection'");
  }
  ++summary_.counts["theorems"];
}

/// At most one solution by the theorem, and one that is listed: it is the only one.
void ProofReplay::read_packing_theorem() {
  reader_->end_line();
  if (const auto gap = packing_theorem_gap(*system_, *search_box_))
    reader_->refuse("does not apply: " + *gap);
  theorem_covers_ = std::ranges::any_of(listed_->roots, [&](const ListedRoot& listed) {
    return is_within(listed.root.enclosure, *search_box_) && satisfies_inequalities(listed.root.enclosure);
  });
  if (!theorem_covers_) reader_->refuse("no listed root is proved to be a solution in the search box");
}

/// Every figure of the blocks lies in the uniqueness box of a listed root or in an undecided box.
void ProofReplay::read_loci_theorem() {
  std::vector<LociBlock> blocks;
  while (!reader_->at_end_of_line()) {
    LociBlock& block = blocks.emplace_back();
    const std::size_t size = reader_->index(system_->variables() + 1, "block");
    for (std::size_t i = 0; i < size; ++i)
      block.variables.push_back(reader_->index(system_->variables(), "variable"));
    for (std::size_t i = 0; i < size; ++i)
      block.equations.push_back(reader_->index(system_->equations().size(), "equation"));
  }
  reader_->end_line();
  const auto gap = loci_theorem_gap(*system_, *search_box_, blocks, [&](const RangeBox& figure) {
    const auto holds = [&](const Box& box) { return is_within(figure, box); };
    return std::ranges::any_of(listed_->roots,
                               [&](const ListedRoot& root) { return holds(root.uniqueness_box); }) ||
           std::ranges::any_of(listed_->undecided, holds);
  });
  if (gap) reader_->refuse("does not show that nothing is missing: " + *gap);
  theorem_covers_ = true;
}

/// Whether a known root needs not be looked for any more: it is listed, or no solution in the search box.
bool ProofReplay::is_accounted_for(const KnownRoot& known) {
  const RangeBox& where = known.root.enclosure;
  if (are_apart(where, ranges_of(*search_box_)) || violates_inequality(where)) return true;
  // One root in the uniqueness box of the other: there is no second one.
  return std::ranges::any_of(listed_->roots, [&](const ListedRoot& other) {
    return is_within(where, other.uniqueness_box) || lies_in_any(other.root, known.uniqueness_boxes);
  });
}

bool ProofReplay::lies_in_any(const EnclosedRoot& root, const std::vector<Box>& boxes) {
  return std::ranges::any_of(boxes, [&](const Box& box) { return is_within(root.enclosure, box); });
}

/// A root, or further boxes for a known one.
void ProofReplay::read_root() {
  const std::uint64_t number = reader_->integer();
  const Box box = reader_->box(system_->variables());
  if (reader_->word() != "U") reader_->refuse("expected U and the uniqueness box");
  const Box uniqueness_box = reader_->box(system_->variables());
  reader_->end_line();
  if (!is_subset(box, uniqueness_box)) reader_->refuse("the uniqueness box does not contain the box");
  judge_.forget_propagation();
  KnownRoot& known = roots_[number];
  const bool is_new = known.uniqueness_boxes.empty();
  EnclosedRoot root = known.root;
  if (is_new || !is_within(root.enclosure, box)) root = enclosed_root(box);
  if (!prover_.has_no_other(uniqueness_box, root))
    reader_->refuse("the uniqueness box is not proved to contain this root and no other");
  if (is_new) {
    known.root = std::move(root);
  } else if (!lies_in_any(root, known.uniqueness_boxes) && !is_within(known.root.enclosure, uniqueness_box)) {
    reader_->refuse("this is not proved to be the root of that number");
  }
  known.uniqueness_boxes.push_back(uniqueness_box);
  known.is_accounted_for = known.is_accounted_for || is_accounted_for(known);
  ++summary_.counts["roots and their uniqueness boxes"];
}

EnclosedRoot ProofReplay::enclosed_root(const Box& box) {
  std::optional<EnclosedRoot> root = prover_.enclose(box);
  if (!root) reader_->refuse("no root is proved to lie in this box");
  return std::move(*root);
}

void ProofReplay::read_node() {
  const std::uint64_t id = reader_->integer();
  reader_->end_line();
  const auto box = open_.find(id);
  if (box == open_.end()) reader_->refuse("there is no open box " + std::to_string(id));
  part_ = {std::move(box->second), false, {}};
  open_.erase(box);
  cases_.clear();
  judge_.forget_propagation();
  do {
    if (!reader_->next_line()) reader_->refuse("the file ends inside a node");
  } while (read_step(reader_->word()));
  ++summary_.counts["boxes followed to their end"];
}

void ProofReplay::end_node() {
  if (!cases_.empty()) reader_->refuse("a case distinction is not joined");
  const std::string_view end = reader_->word();
  if (end == "empty") {
    reader_->end_line();
    if (!part_.is_empty) reader_->refuse("the box is not proved to be empty");
  } else if (part_.is_empty) {
    reader_->refuse("the box was proved to be empty; expected 'end empty'");
  } else if (end == "covered") {
    end_covered();
  } else if (end == "undecided" || end == "pending") {
    end_undecided();
  } else if (end == "cut") {
    end_cut();
  } else if (end == "counted") {
    end_counted();
  } else {
    reader_->refuse("'" + std::string(end) + "' is no end of a node");
  }
}

void ProofReplay::end_covered() {
  const std::uint64_t number = reader_->integer();
  reader_->end_line();
  const auto known = roots_.find(number);
  if (known == roots_.end()) reader_->refuse("there is no root " + std::to_string(number));
  const auto& boxes = known->second.uniqueness_boxes;
  if (std::ranges::none_of(boxes, [&](const Box& u) { return is_subset(part_.box, u); }))
    reader_->refuse("the box lies in no uniqueness box of root " + std::to_string(number));
  if (!known->second.is_accounted_for) {
    reader_->refuse("root " + std::to_string(number) +
                    " is not listed in the result, and not proved to be no solution");
  }
}

void ProofReplay::end_undecided() {
  reader_->end_line();
  if (std::ranges::binary_search(undecided_, part_.box, is_before)) return;
  if (std::ranges::none_of(undecided_, [&](const Box& other) { return is_subset(part_.box, other); }))
    reader_->refuse("the box lies in no undecided box of the result");
}

void ProofReplay::end_counted() {
  if (listed_->counter == nullptr || part_.box != *search_box_)
    reader_->refuse("only roots of one polynomial in one variable, in the search box, are counted");
  std::vector<Interval> excluded;
  while (!reader_->at_end_of_line()) {
    excluded.push_back(reader_->interval());
    if (!violates_inequality(ranges_of({excluded.back()})))
      reader_->refuse("no inequality is proved to fail everywhere in " + to_string(excluded.back()));
  }
  if (!listed_->holds_all_roots(search_box_->front(), excluded))
    reader_->refuse("by counting, the boxes listed do not contain every root");
  reader_->end_line();
}

void ProofReplay::end_cut() {
  const std::size_t variable = reader_->index(system_->variables(), "variable");
  const double point = reader_->number();
  const std::uint64_t lower = reader_->integer();
  const std::uint64_t upper = reader_->integer();
  reader_->end_line();
  const Interval side = part_.box[variable];
  if (!contains(side, point)) reader_->refuse("the box is cut outside of itself");
  Box half = part_.box;
  half[variable] = {side.lower, point};
  open_box(lower, half);
  half[variable] = {point, side.upper};
  open_box(upper, half);
}

}  // namespace gcslab::verifier
