#include "ricochet/solvers.h"
#include "solvers/varied.h"
#include "src/research/limits/results.h"
#include "src/research/paper/fitted_interpretation.h"

namespace ricochet::studies::limits {
namespace {

using namespace carrier_track;

/// From the highest to the lowest cost of fixing it at its natural value, in the order of the
/// calibration that made interpretation.toml.
const std::vector<Unknown> by_cost = {Unknown::counting_limit, Unknown::centrifugal_mass_radius,
                                      Unknown::start_velocity, Unknown::revolutions,
                                      Unknown::clearance,      Unknown::pull,
                                      Unknown::normal_force,   Unknown::start_share,
                                      Unknown::phase};

/// The interpretations with the lowest losses after long searches, without the default one.
std::vector<Interpretation> other_interpretations(const Interpretation& main) {
  std::vector<Interpretation> others(4);
  others[0].normal_force = NormalForce::contact;
  others[2].base = Base::spindle;
  others[3].disturbance = DisturbanceKind::acceleration;
  std::erase(others, main);
  return others;
}

}  // namespace

Plan full_plan() {
  const Interpretation& main = default_interpretation().interpretation;
  const Solver near = varied("pagmo-cmaes", "pagmo-cmaes, small steps", {{"initial_step", 0.05}});
  const Solver cmaes = solver_named("pagmo-cmaes-ipop");
  return {.main = main,
          .others = other_interpretations(main),
          .order = by_cost,
          .first_constants = 3,
          .seeds = {1, 2, 3},
          .population = 80,
          .generations = 99,
          .solvers = {cmaes, solver_named("pagmo-sade")},
          .long_evaluations = 6000,
          .near = near,
          .near_evaluations = 3000,
          .asked_evaluations = 6000,
          .exclusion = {near, 1500, {1, 2, 3}},
          .worth = {1, 0.25},
          .grid_steps = 20,
          .symmetry_draws = 250,
          .step = 0.01};
}

Plan quick_plan() {
  Plan plan = full_plan();
  plan.others.resize(1);
  plan.first_constants = 8;
  plan.seeds = {1, 2};
  plan.population = 16;
  plan.generations = 4;
  plan.long_evaluations = 60;
  plan.near_evaluations = 30;
  plan.asked_evaluations = 60;
  plan.exclusion.evaluations = 20;
  plan.exclusion.control_seeds = {1, 2};
  plan.worth = {10, 1};
  plan.grid_steps = 4;
  plan.symmetry_draws = 10;
  plan.step = 0.1;
  return plan;
}

}  // namespace ricochet::studies::limits
