#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <span>

#include "problems/carrier_track/suite/design.h"
#include "problems/carrier_track/suite/machine.h"
#include "problems/carrier_track/suite/profile.h"
#include "problems/carrier_track/suite/robust.h"
#include "problems/carrier_track/suite/speed_problems.h"

namespace ricochet::carrier_track::inline problems {

namespace {

/// One problem for each machine.
template <class Ask>
std::vector<Problem> of_each(const std::vector<Machine>& machines, Ask ask) {
  std::vector<Problem> problems;
  for (const Machine& machine : machines) problems.push_back(ask(machine));
  return problems;
}

/// One problem for each machine and number of knots.
std::vector<Problem> of_each_size(const std::vector<Machine>& machines,
                                  Problem (*ask)(const Machine&, std::size_t),
                                  std::span<const std::size_t> sizes = profile_sizes) {
  std::vector<Problem> problems;
  for (const Machine& machine : machines) {
    for (const std::size_t n : sizes) problems.push_back(ask(machine, n));
  }
  return problems;
}

/// Two machines have problems with many more knots, which the plan many_variables asks for.
std::vector<Problem> profile_counts(const std::vector<Machine>& machines) {
  std::vector<Machine> with_many;
  std::ranges::copy_if(machines, std::back_inserter(with_many), [](const Machine& machine) {
    return machine.id == "C1" || machine.id == "C4";
  });
  auto problems = of_each_size(machines, profile_count_problem);
  std::ranges::move(of_each_size(with_many, profile_count_problem, large_profile_sizes),
                    std::back_inserter(problems));
  return problems;
}

Family robust_family(const std::vector<Machine>& machines, RiskMeasure risk) {
  return {fmt::format("robust-{}", name_of(risk)),
          of_each(machines, [risk](const Machine& m) { return robust_problem(m, risk); })};
}

std::map<std::string, double> factors_of(const Scene& scene) {
  return {{"restitution", scene.restitution_lower},
          {"friction", scene.friction},
          {"disturbance", scene.disturbance}};
}

/// A disturbance of less than a tenth of the friction leaves a machine's problems alike: success
/// rates of entries on C1 and C5, C2 and C6, C3 and C7, C4 and C8 correlate by 0.73 to 0.96.
std::string cluster_of(const std::string& family, const Scene& scene) {
  const bool is_weak = scene.disturbance < 0.1 * scene.friction * scene.normal_force;
  return fmt::format("{}, restitution {:g}, friction {:g}{}", family, scene.restitution_lower,
                     scene.friction,
                     is_weak ? "" : fmt::format(", disturbance {:g}", scene.disturbance));
}

}  // namespace

std::vector<Family> families_of(const std::vector<Machine>& machines) {
  std::vector<Machine> with_clearance;
  std::copy_if(machines.begin(), machines.end(), std::back_inserter(with_clearance), has_clearance);
  std::vector<Family> families = {
      {"count", of_each(machines, count_problem)},
      {"top-speed", of_each(machines, top_speed_problem)},
      {"profile-count", profile_counts(machines)},
      {"profile-wear", of_each_size(machines, profile_wear_problem)},
      {"design-count", of_each(with_clearance, design_count_problem)},
      robust_family(machines, RiskMeasure::mean),
      robust_family(machines, RiskMeasure::worst),
      robust_family(machines, RiskMeasure::cvar),
  };
  for (Family& family : families) {
    for (Problem& problem : family.problems) {
      const auto machine = std::ranges::find(machines, problem.machine, &Machine::id);
      if (machine != machines.end()) {
        problem.factors = factors_of(machine->scene);
        problem.cluster = cluster_of(family.name, machine->scene);
      }
      if (problem.gradient_cost) continue;
      problem.gradient_cost = gradient_cost(problem.dimension());
    }
  }
  return families;
}

std::vector<Family> case_families() {
  return families_of(all_machines());
}

}  // namespace ricochet::carrier_track::inline problems
