#include "src/studies/dynamics/stability.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "problems/carrier_track/check/integrator.h"
#include "problems/carrier_track/scene/contact_law.h"
#include "ricochet/machine.h"
#include "src/core/progress.h"
#include "src/studies/dynamics/work.h"

namespace ricochet::studies::dynamics {

namespace {

using namespace carrier_track;

std::vector<double> powers_of_ten(double first, double last, double step) {
  const auto count = static_cast<int>(std::lround((last - first) / step));
  std::vector<double> powers;
  for (int i = 0; i <= count; ++i) powers.push_back(std::pow(10.0, first + i * step));
  return powers;
}

bool is_bad(Behaviour behaviour) {
  return behaviour == Behaviour::gains_energy || behaviour == Behaviour::leaves_the_walls;
}

Outcome reference_of(const Scene& scene) {
  const Outcome outcome = through_walls().front().run(scene, 0);
  if (!outcome.finished) throw std::runtime_error("the reference failed: " + outcome.failure);
  return outcome;
}

StabilityCell cell_of(const Integrator& integrator, const Scene& scene, double control,
                      const Outcome& reference) {
  const Outcome outcome = integrator.run(scene, control);
  const double impacts = std::max(collisions(scene, reference), 1);
  return {behaviour_of(scene, outcome, reference),
          static_cast<double>(outcome.force_evaluations) / impacts};
}

Integrator find(const std::vector<Integrator>& integrators, const std::string& name) {
  const auto found =
      std::ranges::find_if(integrators, [&](const Integrator& i) { return i.name == name; });
  if (found == integrators.end()) throw std::invalid_argument("no integrator " + name);
  return *found;
}

/// A body of 1 kg on the surface of the lower wall, in a gap of 1 mm, pressed with 10 N.
Scene resting_body(double stiffness) {
  Scene scene;
  scene.wall_upper = 1e-3;
  scene.start_position = 0;
  scene.pull = 10;
  scene.restitution_lower = scene.restitution_upper = 0.5;
  scene.fidelity = Fidelity::compliant;
  scene.contact_law = ContactLaw::exact_restitution;
  scene.contact_speed = 0.03;
  scene.stiffness = stiffness;
  scene.window = Seconds{rest_seconds};
  return scene;
}

}  // namespace

StabilityPlan full_stability_plan() {
  StabilityPlan plan{powers_of_ten(6, 16, 1), powers_of_ten(-3, -7, -0.25),
                     powers_of_ten(-3, -12, -1)};
  plan.steps.push_back(1e-8);
  return plan;
}

StabilityPlan quick_stability_plan() {
  return {powers_of_ten(6, 16, 2), powers_of_ten(-3, -6, -0.5), powers_of_ten(-3, -9, -3)};
}

Behaviour behaviour_of(const Scene& scene, const Outcome& outcome, const Outcome& reference) {
  if (std::isinf(outcome.deepest)) return Behaviour::leaves_the_walls;
  if (!outcome.finished) return Behaviour::gives_up;
  if (outcome.gained.value_or(0) > 0) return Behaviour::gains_energy;
  const int difference = collisions(scene, outcome) - collisions(scene, reference);
  if (difference == 0) return Behaviour::right_count;
  return difference < 0 ? Behaviour::too_few : Behaviour::too_many;
}

std::optional<double> spring_bound(const std::string& method) {
  if (method == "semi-implicit-euler") return 2;
  if (method == "runge-kutta-4") return std::sqrt(8.0);
  return std::nullopt;
}

double peak_frequency(const Scene& scene, double speed) {
  const double d = dissipation(scene.contact_law, scene.restitution_lower);
  const double n = scene.contact_exponent;
  const double depth = peak_penetration(scene.stiffness, n, scene.mass, speed, d);
  return std::sqrt(n * scene.stiffness * std::pow(depth, n - 1) / scene.mass);
}

StabilityMap map_of(const Integrator& integrator, const StabilityPlan& plan) {
  StabilityMap map{integrator.name,
                   integrator.setting,
                   integrator.setting == "step [s]" ? plan.steps : plan.tolerances,
                   {}};
  for (const double stiffness : plan.stiffnesses) {
    const Scene scene = stiff_gap(stiffness);
    const Outcome reference = reference_of(scene);
    auto& row = map.cells.emplace_back();
    for (const double control : map.controls) {
      row.push_back(cell_of(integrator, scene, control, reference));
    }
  }
  return map;
}

Border border_of(const StabilityMap& map, const std::vector<double>& frequencies) {
  Border border{0, std::numeric_limits<double>::infinity()};
  for (std::size_t s = 0; s < map.cells.size(); ++s) {
    for (std::size_t c = 0; c < map.controls.size(); ++c) {
      const double scaled = map.controls[c] * frequencies[s];
      if (is_bad(map.cells[s][c].behaviour)) {
        border.lowest_bad = std::min(border.lowest_bad, scaled);
      } else {
        border.highest_good = std::max(border.highest_good, scaled);
      }
    }
  }
  return border;
}

RestCost rest_cost(const Integrator& integrator, const std::vector<double>& stiffnesses) {
  RestCost cost{integrator.name, {}};
  for (const double stiffness : stiffnesses) {
    const Scene scene = resting_body(stiffness);
    const Outcome outcome = integrator.run(scene, rest_tolerance);
    Rest rest{static_cast<double>(outcome.force_evaluations), std::nullopt};
    const double depth = std::pow(scene.pull / stiffness, 1 / scene.contact_exponent);
    if (outcome.finished) rest.depth_error = std::abs(-outcome.end.position / depth - 1);
    cost.rests.push_back(rest);
  }
  return cost;
}

std::optional<StabilityCell> cheapest_right(const std::vector<StabilityCell>& row) {
  std::optional<StabilityCell> cheapest;
  for (auto cell = row.rbegin(); cell != row.rend(); ++cell) {
    if (cell->behaviour != Behaviour::right_count) break;
    cheapest = *cell;
  }
  return cheapest;
}

StabilityStudy study_stability(const StabilityPlan& plan) {
  StabilityStudy study;
  study.plan = plan;
  for (const double stiffness : plan.stiffnesses) {
    const Scene scene = stiff_gap(stiffness);
    double fastest = 0;
    for (const Impact& impact : reference_of(scene).impacts) {
      fastest = std::max(fastest, impact.speed);
    }
    study.frequencies.push_back(peak_frequency(scene, fastest));
  }
  const std::vector<Integrator> integrators = through_walls();
  Progress progress("stiff walls", static_cast<double>(integrators.size()));
  // The first is the reference.
  for (std::size_t i = 1; i < integrators.size(); ++i) {
    study.maps.push_back(map_of(integrators[i], plan));
    if (integrators[i].setting == "relative tolerance") {
      study.rests.push_back(rest_cost(integrators[i], plan.stiffnesses));
    }
    progress.advance(1);
  }
  const Integrator moreau_jean = find(all_integrators(), "moreau-jean");
  Scene scene = stiff_gap(1);
  scene.fidelity = Fidelity::impact;
  const Outcome reference = reference_of(scene);
  study.hard = {moreau_jean.name, moreau_jean.setting, plan.steps, {{}}};
  for (const double step : plan.steps) {
    study.hard.cells[0].push_back(cell_of(moreau_jean, scene, step, reference));
  }
  progress.advance(1);
  return study;
}

namespace {

using report::Chart;
using report::Mark;
using report::Scale;
using report::Series;

/// The words of a legend, and its order.
constexpr std::pair<Behaviour, const char*> behaviours[] = {
    {Behaviour::right_count, "right number of impacts"},
    {Behaviour::leaves_the_walls, "flies out through a wall"},
    {Behaviour::too_few, "impacts missed"},
    {Behaviour::gains_energy, "walls give energy"},
    {Behaviour::too_many, "too many impacts"},
    {Behaviour::gives_up, "gives up"}};

int runs_of(const StabilityMap& map) {
  return static_cast<int>(map.cells.size() * map.controls.size());
}

int wrong_runs(const StabilityMap& map) {
  int wrong = 0;
  for (const auto& row : map.cells) {
    for (const StabilityCell& cell : row) wrong += cell.behaviour != Behaviour::right_count;
  }
  return wrong;
}

/// Ratio of the cost of a method's cheapest right count on the stiffest and on the softest walls;
/// nothing if there is none.
std::optional<double> growth(const StabilityMap& map) {
  const auto soft = cheapest_right(map.cells.front());
  const auto stiff = cheapest_right(map.cells.back());
  if (!soft || !stiff) return std::nullopt;
  return stiff->evaluations / soft->evaluations;
}

/// The runs by behaviour, and the stability limit of linear theory.
Chart map_chart(const StabilityStudy& study, const StabilityMap& map) {
  const auto& stiffnesses = study.plan.stiffnesses;
  const double top = map.controls.front() * 2;
  Chart chart{.name = "stability",
              .title = fmt::format("{} on compliant walls: {} of {} runs miss or invent impacts, "
                                   "or fail",
                                   map.method, wrong_runs(map), runs_of(map)),
              .x = {"stiffness of the walls [N/m^1.5]", Scale::logarithmic,
                    report::Range{stiffnesses.front() / 3, stiffnesses.back() * 3}},
              .y = {map.control, Scale::logarithmic, report::Range{map.controls.back() / 2, top}},
              .width = 640,
              .height = 400};
  for (const auto& [behaviour, words] : behaviours) {
    Series series{words, Mark::points, {}};
    for (std::size_t s = 0; s < stiffnesses.size(); ++s) {
      for (std::size_t c = 0; c < map.controls.size(); ++c) {
        if (map.cells[s][c].behaviour == behaviour)
          series.samples.push_back({stiffnesses[s], map.controls[c]});
      }
    }
    if (!series.samples.empty()) chart.series.push_back(std::move(series));
  }
  if (const auto bound = spring_bound(map.method)) {
    Series border{fmt::format("h w = {:.3g}", *bound), Mark::line, {}};
    for (std::size_t s = 0; s < stiffnesses.size(); ++s) {
      const double step = *bound / study.frequencies[s];
      if (step < top) border.samples.push_back({stiffnesses[s], step});
    }
    chart.series.push_back(std::move(border));
  }
  return chart;
}

Chart cost_chart(const StabilityStudy& study) {
  Chart chart{.name = "stability-cost",
              .x = {"stiffness of the walls [N/m^1.5]", Scale::logarithmic},
              .y = {"evaluations of the force per impact", Scale::logarithmic},
              .width = 640,
              .height = 360};
  for (const StabilityMap& map : study.maps) {
    Series& series = chart.series.emplace_back(Series{map.method, Mark::line, {}});
    for (std::size_t s = 0; s < map.cells.size(); ++s) {
      const auto cell = cheapest_right(map.cells[s]);
      series.samples.push_back(
          {study.plan.stiffnesses[s], cell ? std::optional(cell->evaluations) : std::nullopt});
    }
  }
  const auto dearest = std::ranges::max_element(
      study.maps, {}, [](const StabilityMap& map) { return growth(map).value_or(0); });
  chart.title = fmt::format(
      "A right count costs {} {:.0f} times as much on the stiffest walls as on the softest",
      dearest->method, growth(*dearest).value_or(0));
  return chart;
}

std::string finding_of(const StabilityStudy& study) {
  std::vector<std::string> borders, failing;
  int wrong = 0, runs = 0;
  for (const StabilityMap& map : study.maps) {
    if (spring_bound(map.method)) {
      borders.push_back(
          fmt::format("{:.2f}/w by {}", border_of(map, study.frequencies).lowest_bad, map.method));
      continue;
    }
    runs += runs_of(map);
    const int failed = wrong_runs(map);
    wrong += failed;
    if (failed > 0) failing.push_back(fmt::format("{} {}", map.method, failed));
  }
  return fmt::format(
      "With fixed steps a stiff wall throws a body back faster than it came, or lets it through, "
      "from a step of {} on, with w the frequency of the body on the wall. Methods that control "
      "their error count right in {} of {} runs and wrong in {}{}.",
      fmt::join(borders, " and "), runs - wrong, runs, wrong,
      failing.empty() ? "" : fmt::format(" ({})", fmt::join(failing, ", ")));
}

}  // namespace

void add_to(report::Results& results, const StabilityStudy& study) {
  Table table{"stability",
              {{"method"},
               {"wrong", "runs wrong"},
               {"runs", "of"},
               {"growth", "cost of a right count, stiffest over softest", ".0f"},
               {"highest_good", "largest h w without gain", ".2f"},
               {"lowest_bad", "smallest with gain", ".2f"},
               {"bound", "bound of theory", ".2f"},
               {"rest_soft", "evaluations at rest, softest", ".0f"},
               {"rest_stiff", "stiffest", ".0f"},
               {"depth_error", "error of the depth there", ".0e"}}};
  for (const StabilityMap& map : study.maps) {
    const auto bound = spring_bound(map.method);
    const auto border = bound ? std::optional(border_of(map, study.frequencies)) : std::nullopt;
    const auto cost = std::ranges::find(study.rests, map.method, &RestCost::method);
    const bool rests = cost != study.rests.end();
    table.add(map.method, wrong_runs(map), runs_of(map), growth(map),
              value_of(border, &Border::highest_good), value_of(border, &Border::lowest_bad), bound,
              rests ? std::optional(cost->rests.front().evaluations) : std::nullopt,
              rests ? std::optional(cost->rests.back().evaluations) : std::nullopt,
              rests ? cost->rests.back().depth_error : std::nullopt);
    report::Part part{map.method, map.method, {}};
    part.results.add(map_chart(study, map));
    results.add("penalty", std::move(part));
  }
  results.set("stiff-finding", finding_of(study));
  results.set("rest-seconds", rest_seconds);
  results.set("hard-method", study.hard.method);
  results.set("hard-right", runs_of(study.hard) - wrong_runs(study.hard));
  results.set("hard-steps", runs_of(study.hard));
  results.add(std::move(table));
  results.add(cost_chart(study));
}

}  // namespace ricochet::studies::dynamics
