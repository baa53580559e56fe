// Our own simplex method behind the interface.

#include "linear_program/lp_registry.h"
#include "linear_program/simplex.h"

namespace gcslab {
namespace {

class SimplexBackend final : public LpBackend {
 public:
  explicit SimplexBackend(const Options& options)
      : simplex_({starts_cold(options), static_cast<long>(options.integer("iteration_limit"))}) {}

 protected:
  void load_model(const LpModel& model) override { simplex_.load(model); }
  void solve(std::span<const LinearTerm> objective, LpSolution& solution) override {
    simplex_.minimise(objective, solution);
  }

 private:
  Simplex simplex_;
};

}  // namespace

LpBackendVariant simplex_backend() {
  return {"simplex",
          "own simplex method on explicit edges, for many objectives over one polytope",
          Promise::baseline,
          {start_option(),
           integer_option("iteration_limit", "steps an objective may take", "steps", 20000, 1, 2000000000)},
          [](const Options& options) { return std::make_unique<SimplexBackend>(options); }};
}

}  // namespace gcslab
