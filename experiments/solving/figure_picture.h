#pragma once

// The figures of a solved constraint system, one a congruence class, as the JSON that a row of a run carries
// to the drawings.

#include <nlohmann/json.hpp>

#include "box_solver/search.h"
#include "experiments/corpus/problem.h"
#include "experiments/solving/wireframe.h"

namespace gcslab {

struct PicturedFigure {
  Figure places;              ///< coordinates of points, then of the other objects
  std::size_t solutions = 1;  ///< how many are the same figure up to isometry
  bool is_certified = true;   ///< at least one of them
};

struct FigurePicture {
  Wireframe wires;  ///< without coordinates
  std::vector<PicturedFigure> figures;
  Figure sketch{};  ///< places of a sketch in the frame; empty: none
  /// Sketches that the branches of a plan give from the first solution.
  struct NewSketch {
    std::string origin;
    Figure places;
  };
  std::vector<NewSketch> new_sketches{};
};

/// The solutions by number, grouped up to isometry. Those that nothing proves are known to seven digits.
std::vector<std::vector<std::size_t>> classes_of(const GeometricSource& source, const SearchResult& found);

FigurePicture figure_picture(const GeometricSource& source, const SearchResult& found);

/// Whether the points of a figure of space lie in the plane z = 0, as flat figures in a frame do, and there
/// is no other object.
bool is_flat(const Figure& figure);

/// {"figures": {"names", "edges": [{"from", "to", "label", "guide"}], "faces", "angles", "objects": [{"name",
/// "sort"}], "measures": [{"kind", "objects", "label"}], "classes": [{"points", "solutions", "certified"}],
/// "sketch", "new_sketches": [{"origin", "points"}]}}; "points" and "sketch" are the places; "new_sketches"
/// where there are any.
nlohmann::ordered_json to_json(const FigurePicture& picture);
/// The inverse. Throws InputError when the JSON is no such thing.
FigurePicture figure_picture_from_json(const nlohmann::ordered_json& json);

}  // namespace gcslab
