#pragma once

// All boxes of a search as the JSON that a row of a run carries to the figures.

#include <nlohmann/json.hpp>
#include <vector>

#include "box_solver/search.h"

namespace gcslab {

/// What a drawing of a search needs.
struct SearchPicture {
  Box domain;                              ///< the search box
  std::vector<RecordedBox> boxes;          ///< the first that were taken
  std::uint64_t told = 0;                  ///< how many there were
  std::vector<std::vector<double>> roots;  ///< midpoints of the solutions' boxes
};

SearchPicture search_picture(const Box& domain, const SearchRecord& record, const SearchResult& result);

/// {"search": {"domain", "told", "roots", "boxes": [{"fate", "stages", "reductions", "reason"}]}}; boxes as
/// [[lower, upper], ...] in plain numbers.
nlohmann::ordered_json to_json(const SearchPicture& picture);
/// The inverse; the reason, which no drawing shows, is left out. Throws InputError when the JSON is no such
/// thing.
SearchPicture search_picture_from_json(const nlohmann::ordered_json& json);

}  // namespace gcslab
