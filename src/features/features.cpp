#include "src/features/constraints.h"
#include "src/features/coordinates.h"
#include "src/features/failures.h"
#include "src/features/feature.h"
#include "src/features/noise.h"
#include "src/features/rounding.h"
#include "src/features/start.h"

namespace ricochet {
namespace {

Feature plain() {
  return {"plain", "as it is", [](const Problem&) { return true; },
          [](const Problem& shown, std::uint64_t) { return shown; }};
}

}  // namespace

const std::vector<Feature>& all_features() {
  static const std::vector<Feature> features = {plain(),
                                                perturbed_start(),
                                                noisy(),
                                                frozen_noise(),
                                                outliers(),
                                                truncated(),
                                                not_a_number(),
                                                infinite_where_infeasible(),
                                                yes_or_no_constraints(),
                                                quantised(),
                                                permuted(),
                                                reflected(),
                                                rotated(),
                                                throwing(),
                                                slow()};
  return features;
}

std::string shown_as(const std::string& form, const std::string& feature) {
  return feature == "plain" ? form : form + "/" + feature;
}

}  // namespace ricochet
