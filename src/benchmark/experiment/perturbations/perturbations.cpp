#include "src/benchmark/experiment/perturbations/constraints.h"
#include "src/benchmark/experiment/perturbations/coordinates.h"
#include "src/benchmark/experiment/perturbations/failures.h"
#include "src/benchmark/experiment/perturbations/noise.h"
#include "src/benchmark/experiment/perturbations/perturbation.h"
#include "src/benchmark/experiment/perturbations/rounding.h"
#include "src/benchmark/experiment/perturbations/start.h"

namespace ricochet {
namespace {

Perturbation plain() {
  return {"plain", "as it is", [](const Problem&) { return true; },
          [](const Problem& shown, std::uint64_t) { return shown; }};
}

}  // namespace

const std::vector<Perturbation>& all_perturbations() {
  static const std::vector<Perturbation> perturbations = {plain(),
                                                          perturbed_start(),
                                                          noisy(),
                                                          frozen_noise(),
                                                          outliers(),
                                                          truncated(),
                                                          not_a_number(),
                                                          infinite_where_infeasible(),
                                                          binary_constraints(),
                                                          quantised(),
                                                          permuted(),
                                                          reflected(),
                                                          rotated(),
                                                          throwing(),
                                                          slow()};
  return perturbations;
}

std::string shown_as(const std::string& formulation, const std::string& perturbation) {
  return perturbation == "plain" ? formulation : formulation + "/" + perturbation;
}

}  // namespace ricochet
