#include "construction/exploration.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "construction/plan_escapes.h"
#include "geometry/numeric_vector.h"
#include "geometry/sketch.h"

namespace gcslab {
namespace {

/// Distances of all points, which tell figures apart up to isometry.
std::vector<double> distances_of(const Figure& figure) {
  std::vector<double> result;
  for (std::size_t p = 0; p < figure.size(); ++p) {
    for (std::size_t q = 0; q < p; ++q) {
      const Numbers side = difference(figure[p], figure[q]);
      result.push_back(std::sqrt(dot(side, side)));
    }
  }
  return result;
}

/// Figures told apart by their distances.
class FigureClasses {
 public:
  /// The number of the figure's class, and whether it is new.
  std::pair<std::size_t, bool> add(const Figure& figure) {
    constexpr double kSame = 1e-6;
    std::vector<double> distances = distances_of(figure);
    const double size = std::max(*std::ranges::max_element(distances), 1e-300);
    const auto is_same = [&](const std::vector<double>& known) {
      for (std::size_t k = 0; k < known.size(); ++k) {
        if (!(std::abs(known[k] - distances[k]) <= kSame * size)) return false;
      }
      return true;
    };
    const auto known = std::ranges::find_if(known_, is_same);
    const auto number = static_cast<std::size_t>(known - known_.begin());
    if (known != known_.end()) return {number, false};
    known_.push_back(std::move(distances));
    return {number, true};
  }

 private:
  std::vector<std::vector<double>> known_;
};

class Explorer {
 public:
  Explorer(const ConstraintSystem& system, const Frame& frame, const GeometricEquations& equations,
           const std::vector<double>& values, const SystemFunctions& wanted,
           const ExplorationOptions& options, const Figure& sketch)
      : system_(&system),
        frame_(&frame),
        equations_(&equations),
        values_(&values),
        wanted_(&wanted),
        options_(&options),
        program_(system, make_plan(system, options.plan, sketch)),
        escapes_(escapes_of(program_.plan(), system)),
        evaluator_(program_) {
    result_.plan = program_.plan();
    add({sketch, std::nullopt, {}});
  }

  Exploration run(const std::stop_token& stop) {
    while (!sketches_.empty() && result_.paths.size() < options_->maximum_paths && !stop.stop_requested()) {
      const NewSketch next = std::move(sketches_.front());
      sketches_.pop_front();
      follow(next, stop);
    }
    result_.is_finished = sketches_.empty() && !stop.stop_requested();
    return std::move(result_);
  }

 private:
  void add(NewSketch sketch) {
    ++result_.sketches;
    if (seen_.add(sketch.figure).second) {
      sketches_.push_back(std::move(sketch));
    } else {
      ++result_.repeated;
    }
  }

  void follow(const NewSketch& sketch, const std::stop_token& stop) {
    ExploredPath& path = result_.paths.emplace_back();
    path.sketch = sketch;
    try {
      SketchHomotopy homotopy(*system_, *frame_, *equations_, *values_, sketch.figure, options_->homotopy);
      TrackerOptions tracker = options_->tracker;
      tracker.infinity *= homotopy.extent() / homotopy.unit();
      path.found = solve_along_path(homotopy.curve(), homotopy.curve(), homotopy.start(), *wanted_, tracker,
                                    options_->certifier, stop);
      path.explanation = explain(path.found.path, *system_, *equations_, homotopy.curve(), homotopy.extent());
      note_escapes(path, homotopy);
    } catch (const NotApplicable& refused) {
      if (!sketch.solution) throw;
      path.refused = refused.what();
      return;
    } catch (const InputError& refused) {
      if (!sketch.solution) throw;
      path.refused = refused.what();
      return;
    }
    for (const SketchSolution& solution : path.found.solutions) {
      const Figure figure = figure_at(*equations_, solution.unknowns);
      const auto [number, is_new] = solutions_.add(figure);
      path.numbers.push_back(number);
      if (!is_new) continue;
      result_.solutions.push_back(solution);
      if (solution.root) make_sketches(figure, number);
    }
  }

  void note_escapes(ExploredPath& path, const SketchHomotopy& homotopy) const {
    constexpr double kFar = 1e2;
    const auto met = [&](PathEnd end, const std::vector<double>& last) -> std::string {
      if (end != PathEnd::to_infinity || last.empty()) return "";
      const Figure figure = figure_at(*equations_, homotopy.curve().unknowns(last));
      return escape_met(escapes_, program_.plan(), *system_, figure, kFar * homotopy.extent());
    };
    path.escape = met(path.found.path.end, path.found.path.last);
    path.other_escape = met(path.found.path.other_end, path.found.path.other_last);
  }

  /// The figures on all branches but the solution's own.
  void make_sketches(const Figure& solution, std::size_t number) {
    if (is_frame_flat(program_.plan().frame(system_->universe), solution)) {
      ++result_.unread;
      return;
    }
    const Figure figure = in_frame(*system_, program_.plan(), solution);
    const PlanValues read = evaluator_.read(figure, *values_);
    seen_.add(figure);
    evaluator_.each_branch(read, true, [&](const Branch& branch, const Figure& other) {
      const std::string text = text_of(branch);
      const auto& chosen = options_->branches;
      if (!chosen.empty() && std::ranges::find(chosen, text) == chosen.end()) return;
      add({other, number, branch});
    });
  }

  const ConstraintSystem* system_;
  const Frame* frame_;
  const GeometricEquations* equations_;
  const std::vector<double>* values_;
  const SystemFunctions* wanted_;
  const ExplorationOptions* options_;
  PlanProgram program_;
  std::vector<PlanEscape> escapes_;
  PlanEvaluator evaluator_;
  std::deque<NewSketch> sketches_;
  FigureClasses seen_, solutions_;
  Exploration result_;
};

}  // namespace

Exploration explore(const ConstraintSystem& system, const Frame& frame, const GeometricEquations& equations,
                    const std::vector<double>& values, const Figure& sketch, const SystemFunctions& wanted,
                    const ExplorationOptions& options, const std::stop_token& stop) {
  return Explorer(system, frame, equations, values, wanted, options, sketch).run(stop);
}

}  // namespace gcslab
