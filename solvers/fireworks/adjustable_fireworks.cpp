#include "solvers/fireworks/adjustable_fireworks.h"

#include <string>

#include "solvers/fireworks/bare_bones_fireworks.h"
#include "solvers/fireworks/dynamic_fireworks.h"
#include "solvers/fireworks/fireworks.h"
#include "solvers/fireworks/loser_out_fireworks.h"
#include "solvers/fireworks/partitioned_fireworks.h"

namespace ricochet::fireworks {
namespace {

constexpr double largest_amplitude = 1e9;

SolverOption growth(const AmplitudeSteps& own) {
  return real_option("growth", 1, 1e3, own.growth);
}

SolverOption decline(const AmplitudeSteps& own) {
  return real_option("decline", 1e-3, 1, own.decline);
}

AmplitudeSteps steps_of(const GivenOptions& given, const AmplitudeSteps& own) {
  return {number_of(given, "growth", own.growth), number_of(given, "decline", own.decline)};
}

AdjustableSolver bare_bones() {
  const BareBonesFireworksOptions own;
  return {"bbfwa",
          {whole_option("sparks", 1, own.sparks), growth(own.steps), decline(own.steps)},
          [own](const GivenOptions& given) {
            BareBonesFireworksOptions options = own;
            options.sparks = whole_of(given, "sparks", own.sparks);
            options.steps = steps_of(given, own.steps);
            return bare_bones_fireworks("bbfwa", options);
          }};
}

AdjustableSolver dynamic() {
  const DynamicFireworksOptions own;
  return {"dynfwa",
          {whole_option("fireworks", 1, own.fireworks),
           whole_option("sparks", 1, static_cast<int>(own.counts.sparks)),
           real_option("amplitude", 0, largest_amplitude, own.amplitude), growth(own.steps),
           decline(own.steps)},
          [own](const GivenOptions& given) {
            DynamicFireworksOptions options = own;
            options.fireworks = whole_of(given, "fireworks", own.fireworks);
            options.counts.sparks = number_of(given, "sparks", own.counts.sparks);
            options.amplitude = number_of(given, "amplitude", own.amplitude);
            options.steps = steps_of(given, own.steps);
            return dynamic_fireworks("dynfwa", options);
          }};
}

AdjustableSolver loser_out(const std::string& name, const LoserOutFireworksOptions& own) {
  return {name,
          {whole_option("fireworks", 1, own.fireworks), whole_option("sparks", 1, own.sparks),
           real_option("guiding_share", 1e-3, 1, own.guiding_share),
           whole_option("guiding_sparks", 1, own.guiding_sparks), growth(own.steps),
           decline(own.steps)},
          [name, own](const GivenOptions& given) {
            LoserOutFireworksOptions options = own;
            options.fireworks = whole_of(given, "fireworks", own.fireworks);
            options.sparks = whole_of(given, "sparks", own.sparks);
            options.guiding_share = number_of(given, "guiding_share", own.guiding_share);
            options.guiding_sparks = whole_of(given, "guiding_sparks", own.guiding_sparks);
            options.steps = steps_of(given, own.steps);
            return loser_out_fireworks(name, options);
          }};
}

AdjustableSolver partitioned() {
  const PartitionedFireworksOptions own;
  return {"fwassp",
          {whole_option("fireworks", 1, own.fireworks), whole_option("sparks", 1, own.sparks),
           real_option("initial_scale", 1e-6, 1, own.initial_scale),
           whole_option("patience", 1, own.patience)},
          [own](const GivenOptions& given) {
            PartitionedFireworksOptions options = own;
            options.fireworks = whole_of(given, "fireworks", own.fireworks);
            options.sparks = whole_of(given, "sparks", own.sparks);
            options.initial_scale = number_of(given, "initial_scale", own.initial_scale);
            options.patience = whole_of(given, "patience", own.patience);
            return partitioned_fireworks("fwassp", options);
          }};
}

AdjustableSolver original(const std::string& name, const FireworksOptions& own) {
  return {name,
          {whole_option("fireworks", 1, own.fireworks),
           whole_option("sparks", 1, static_cast<int>(own.counts.sparks)),
           whole_option("gaussian_sparks", 0, own.gaussian_sparks),
           real_option("amplitude", 0, largest_amplitude, own.amplitude)},
          [name, own](const GivenOptions& given) {
            FireworksOptions options = own;
            options.fireworks = whole_of(given, "fireworks", own.fireworks);
            options.counts.sparks = number_of(given, "sparks", own.counts.sparks);
            options.gaussian_sparks = whole_of(given, "gaussian_sparks", own.gaussian_sparks);
            options.amplitude = number_of(given, "amplitude", own.amplitude);
            return fireworks(name, options);
          }};
}

}  // namespace

std::vector<AdjustableSolver> adjustable_family() {
  return {original("fireworks", paper_options()),
          original("fireworks-authors", authors_options()),
          original("fireworks-corrected", corrected_options()),
          original("efwa", enhanced_options()),
          dynamic(),
          bare_bones(),
          loser_out("lotfwa", {}),
          loser_out("mgfwa", multi_guiding_options()),
          partitioned()};
}

}  // namespace ricochet::fireworks
