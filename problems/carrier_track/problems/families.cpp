#include "problems/carrier_track/questions/families.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "problems/carrier_track/paper/fitted_reading.h"
#include "problems/carrier_track/questions/calibration.h"
#include "problems/carrier_track/questions/count.h"
#include "problems/carrier_track/questions/design.h"
#include "problems/carrier_track/questions/gradient_cost.h"
#include "problems/carrier_track/questions/profile.h"
#include "problems/carrier_track/questions/robust.h"
#include "problems/carrier_track/questions/top_speed.h"

namespace ricochet::carrier_track::inline questions {

namespace {

/// One question for each machine.
template <class Ask>
std::vector<Question> of_each(const std::vector<Machine>& machines, Ask ask) {
  std::vector<Question> questions;
  for (const Machine& machine : machines) questions.push_back(ask(machine));
  return questions;
}

/// One for each machine and size of a profile.
std::vector<Question> of_each_size(const std::vector<Machine>& machines,
                                   Question (*ask)(const Machine&, std::size_t)) {
  std::vector<Question> questions;
  for (const Machine& machine : machines) {
    for (const std::size_t n : profile_sizes) questions.push_back(ask(machine, n));
  }
  return questions;
}

Family robust_family(const std::vector<Machine>& machines, RiskMeasure risk) {
  return {fmt::format("robust-{}", name_of(risk)),
          of_each(machines, [risk](const Machine& m) { return robust_question(m, risk); })};
}

/// Of the machine that a question is asked of.
std::map<std::string, double> factors_of(const std::vector<Machine>& machines,
                                         const std::string& id) {
  const auto machine =
      std::find_if(machines.begin(), machines.end(), [&](const Machine& m) { return m.id == id; });
  if (machine == machines.end()) return {};
  const Scene& scene = machine->scene;
  return {{"restitution", scene.restitution_lower},
          {"friction", scene.friction},
          {"disturbance", scene.disturbance}};
}

}  // namespace

std::vector<Family> families_of(const std::vector<Machine>& machines) {
  std::vector<Machine> with_clearance;
  std::copy_if(machines.begin(), machines.end(), std::back_inserter(with_clearance), has_clearance);
  std::vector<Family> families = {
      {"count", of_each(machines, count_question)},
      {"top-speed", of_each(machines, top_speed_question)},
      {"profile-count", of_each_size(machines, profile_count_question)},
      {"profile-wear", of_each_size(machines, profile_wear_question)},
      {"design-count", of_each(with_clearance, design_count_question)},
      robust_family(machines, RiskMeasure::mean),
      robust_family(machines, RiskMeasure::worst),
      robust_family(machines, RiskMeasure::cvar),
  };
  for (Family& family : families) {
    for (Question& question : family.questions) {
      question.factors = factors_of(machines, question.machine);
      if (question.gradient_cost) continue;
      question.gradient_cost = gradient_cost(question.stated.dimension());
    }
  }
  return families;
}

std::vector<Family> case_families() {
  std::vector<Family> families = families_of(all_machines());
  families.push_back({"calibration", {calibration_question(default_reading())}});
  return families;
}

}  // namespace ricochet::carrier_track::inline questions
