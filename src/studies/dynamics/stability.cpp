#include "src/studies/dynamics/stability.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
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
  const Outcome outcome = penalty_integrators().front().run(scene, 0);
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

/// A body of 1 kg that approaches the wall at 0, of 1 N/m^n, with 1 m/s from `distance` [m].
Scene one_impact(ContactLaw law, double exponent, double restitution, double distance) {
  Scene scene;
  scene.wall_upper = 100;
  scene.start_position = distance;
  scene.start_velocity = -1;
  scene.restitution_lower = scene.restitution_upper = restitution;
  scene.fidelity = Fidelity::compliant;
  scene.contact_law = law;
  scene.contact_exponent = exponent;
  scene.contact_speed = 1;
  scene.stiffness = 1;
  return scene;
}

/// Runs a method through `one_impact` with a step of about `length` [s], whose phase at the wall is
/// the i-th of `phases` that fill a step evenly. The steps vary by 10 %, so that the phase at the
/// end of the contact varies too: otherwise errors of both edges could cancel, or add up.
Outcome pass(const Integrator& method, ContactLaw law, double exponent, double restitution,
             double length, int i, int phases) {
  const double golden = std::fmod(i * std::numbers::phi, 1.0);
  const double step = length * (0.95 + 0.1 * golden);
  Scene scene = one_impact(law, exponent, restitution, 0.2 + step * (1 + (i + 0.5) / phases));
  scene.window = Seconds{std::ceil((8 + 4 * length) / step) * step};
  return method.run(scene, step * (1 + 1e-12));
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
                     powers_of_ten(-3, -12, -1), 64};
  plan.steps.push_back(1e-8);
  return plan;
}

StabilityPlan quick_stability_plan() {
  return {powers_of_ten(6, 16, 2), powers_of_ten(-3, -6, -0.5), powers_of_ten(-3, -9, -3), 16};
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
                   integrator.control,
                   integrator.control == "step [s]" ? plan.steps : plan.tolerances,
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

ReturnCurve return_curve(const Integrator& integrator, double exponent, int phases) {
  ReturnCurve curve{integrator.name, exponent, {}};
  const double frequency = peak_frequency(one_impact(ContactLaw::hertz, exponent, 1, 1), 1);
  for (int k = 1; k <= 60; ++k) {
    const double scaled = 0.05 * k;
    double ratio = 0;
    for (int i = 0; i < phases; ++i) {
      const Outcome outcome =
          pass(integrator, ContactLaw::hertz, exponent, 1, scaled / frequency, i, phases);
      ratio = std::max(ratio, 1 + outcome.gained.value_or(-1));
    }
    curve.returns.push_back({scaled, ratio});
  }
  return curve;
}

std::optional<double> onset(const ReturnCurve& curve, double ratio) {
  std::optional<double> first;
  for (auto point = curve.returns.rbegin(); point != curve.returns.rend(); ++point) {
    if (!(point->ratio > ratio)) break;
    first = point->scaled_step;
  }
  return first;
}

std::vector<EdgeOrder> edge_orders(int phases) {
  struct Kind {
    const char* wall;
    ContactLaw law;
    double exponent, restitution, onset;
  };
  const std::vector<Kind> kinds = {
      {"Kelvin-Voigt, restitution 0.5", ContactLaw::kelvin_voigt, 1, 0.5, 0},
      {"linear spring, damping from zero on, 0.5", ContactLaw::exact_restitution, 1, 0.5, 1},
      {"Hertz's spring, elastic", ContactLaw::hertz, 1.5, 1, 1.5}};
  const Integrator method = find(penalty_integrators(), "runge-kutta-4");
  constexpr int halvings = 6;
  std::vector<EdgeOrder> orders;
  for (const Kind& kind : kinds) {
    EdgeOrder order{kind.wall, kind.onset + 1, 0, 0};
    double xy = 0, xx = 0;
    for (int k = 0; k < halvings; ++k) {
      const double length = 0.1 * std::pow(0.5, k);
      double error = 0;
      for (int i = 0; i < phases; ++i) {
        const Outcome outcome =
            pass(method, kind.law, kind.exponent, kind.restitution, length, i, phases);
        error += std::abs(outcome.end.velocity - kind.restitution) / phases;
      }
      if (k == 0) order.error = error;
      const double x = k - 0.5 * (halvings - 1);
      xy -= x * std::log2(error);
      xx += x * x;
    }
    order.measured = xy / xx;
    orders.push_back(order);
  }
  return orders;
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
  const std::vector<Integrator> integrators = penalty_integrators();
  Progress progress("stiff walls", static_cast<double>(integrators.size()));
  // The first is the reference.
  for (std::size_t i = 1; i < integrators.size(); ++i) {
    study.maps.push_back(map_of(integrators[i], plan));
    if (integrators[i].control == "relative tolerance") {
      study.rests.push_back(rest_cost(integrators[i], plan.stiffnesses));
    }
    progress.advance(1);
  }
  const Integrator moreau_jean = find(all_integrators(), "moreau-jean");
  Scene scene = stiff_gap(1);
  scene.fidelity = Fidelity::impact;
  const Outcome reference = reference_of(scene);
  study.hard = {moreau_jean.name, moreau_jean.control, plan.steps, {{}}};
  for (const double step : plan.steps) {
    study.hard.cells[0].push_back(cell_of(moreau_jean, scene, step, reference));
  }
  for (const char* name : {"semi-implicit-euler", "runge-kutta-4"}) {
    for (const double exponent : {1.0, 1.5}) {
      study.returns.push_back(return_curve(find(integrators, name), exponent, plan.phases));
    }
  }
  study.orders = edge_orders(plan.phases);
  progress.advance(1);
  return study;
}

namespace {

using report::Json;

/// The words of a legend, and its order.
constexpr std::pair<Behaviour, const char*> behaviours[] = {
    {Behaviour::right_count, "right number of impacts"},
    {Behaviour::leaves_the_walls, "flies out through a wall"},
    {Behaviour::too_few, "impacts missed"},
    {Behaviour::gains_energy, "walls give energy"},
    {Behaviour::too_many, "too many impacts"},
    {Behaviour::gives_up, "gives up"}};

int right_counts(const StabilityMap& map) {
  int right = 0;
  for (const auto& row : map.cells) {
    right += static_cast<int>(
        std::ranges::count(row, Behaviour::right_count, &StabilityCell::behaviour));
  }
  return right;
}

int runs_of(const StabilityMap& map) {
  return static_cast<int>(map.cells.size() * map.controls.size());
}

int wrong_runs(const StabilityMap& map) {
  return runs_of(map) - right_counts(map);
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
Json map_data(const StabilityStudy& study, const StabilityMap& map) {
  const auto& stiffnesses = study.plan.stiffnesses;
  const auto bound = spring_bound(map.method);
  Json data = {{"method", map.method},
               {"control", map.control},
               {"bound", bound},
               {"runs", runs_of(map)},
               {"wrong", wrong_runs(map)},
               {"bottom", map.controls.back() / 2},
               {"top", map.controls.front() * 2},
               {"behaviours", Json::array()},
               {"border", Json::array()}};
  for (const auto& [behaviour, words] : behaviours) {
    Json runs = Json::array();
    for (std::size_t s = 0; s < stiffnesses.size(); ++s) {
      for (std::size_t c = 0; c < map.controls.size(); ++c) {
        if (map.cells[s][c].behaviour != behaviour) continue;
        runs.push_back({{"stiffness", stiffnesses[s]}, {"control", map.controls[c]}});
      }
    }
    data["behaviours"].push_back({{"behaviour", words}, {"runs", std::move(runs)}});
  }
  for (std::size_t s = 0; bound && s < stiffnesses.size(); ++s) {
    const double step = *bound / study.frequencies[s];
    if (step < data["top"])
      data["border"].push_back({{"stiffness", stiffnesses[s]}, {"step", step}});
  }
  return data;
}

/// Cost by stiffness.
template <class Evaluations>
Json costs_of(const StabilityStudy& study, const Evaluations& evaluations_of) {
  Json costs = Json::array();
  for (std::size_t s = 0; s < study.plan.stiffnesses.size(); ++s) {
    costs.push_back({{"stiffness", study.plan.stiffnesses[s]}, {"evaluations", evaluations_of(s)}});
  }
  return costs;
}

Json right_costs(const StabilityStudy& study, const StabilityMap& map) {
  return costs_of(study, [&](std::size_t s) {
    const auto cell = cheapest_right(map.cells[s]);
    return cell ? Json(cell->evaluations) : Json();
  });
}

Json rest_costs(const StabilityStudy& study, const RestCost& cost) {
  return costs_of(study, [&](std::size_t s) {
    return cost.rests[s].depth_error ? Json(cost.rests[s].evaluations) : Json();
  });
}

Json curve_of(const ReturnCurve& curve) {
  const auto point_of = [](const Return& point) -> Json {
    return {{"scaled_step", point.scaled_step}, {"ratio", point.ratio}};
  };
  return {{"method", curve.method},
          {"exponent", curve.exponent},
          {"onset", onset(curve, 1 / 0.9)},
          {"points", report::list_of(curve.returns, point_of)}};
}

Json data_of(const Rest& rest) {
  return {{"evaluations", rest.evaluations}, {"error", rest.depth_error}};
}

}  // namespace

Json data_of(const StabilityStudy& study) {
  const std::vector<double>& stiffnesses = study.plan.stiffnesses;
  Json data = {{"softest", stiffnesses.front()},
               {"stiffest", stiffnesses.back()},
               {"left", stiffnesses.front() / 3},
               {"right", stiffnesses.back() * 3},
               {"phases", study.plan.phases},
               {"rest_seconds", rest_seconds},
               {"rest_tolerance", rest_tolerance},
               {"hard",
                {{"method", study.hard.method},
                 {"right", right_counts(study.hard)},
                 {"steps", study.hard.controls.size()}}}};
  for (const char* list : {"borders", "failing", "growths", "rests", "resting", "restless",
                           "rest_costs", "fixed_maps", "adaptive_maps"}) {
    data[list] = Json::array();
  }
  int wrong = 0, runs = 0;
  for (const StabilityMap& map : study.maps) {
    data["growths"].push_back(
        {{"method", map.method}, {"growth", growth(map)}, {"costs", right_costs(study, map)}});
    if (const auto bound = spring_bound(map.method)) {
      const Border border = border_of(map, study.frequencies);
      data["borders"].push_back({{"method", map.method},
                                 {"highest_good", border.highest_good},
                                 {"lowest_bad", border.lowest_bad},
                                 {"bound", *bound}});
      data["fixed_maps"].push_back(map_data(study, map));
      continue;
    }
    const int failed = wrong_runs(map);
    wrong += failed;
    runs += runs_of(map);
    if (failed > 0) data["failing"].push_back({{"method", map.method}, {"wrong", failed}});
    data["adaptive_maps"].push_back(map_data(study, map));
  }
  data["any_failing"] = wrong > 0;
  data["wrong"] = wrong;
  data["runs"] = runs;
  data["returns"] = report::list_of(study.returns, curve_of);
  data["orders"] = report::list_of(study.orders, [](const EdgeOrder& order) -> Json {
    return {{"wall", order.wall},
            {"expected", order.expected},
            {"measured", order.measured},
            {"error", order.error}};
  });
  for (const RestCost& cost : study.rests) {
    const auto& error = cost.rests.back().depth_error;
    data[error && *error < 1e-9 ? "resting" : "restless"].push_back(cost.method);
    data["rest_costs"].push_back({{"method", cost.method}, {"costs", rest_costs(study, cost)}});
    data["rests"].push_back({{"method", cost.method},
                             {"soft", data_of(cost.rests.front())},
                             {"stiff", data_of(cost.rests.back())}});
  }
  return data;
}

}  // namespace ricochet::studies::dynamics
