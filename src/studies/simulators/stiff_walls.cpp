#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "problems/carrier_track/scene/contact_law.h"
#include "src/core/progress.h"
#include "src/studies/simulators/suite.h"

/// Where methods fail that integrate straight through the contacts of compliant walls.
namespace ricochet::studies::simulators {

namespace {

using namespace carrier_track;

/// 1 kg in a gap of 1 mm that is shaken at 10 Hz with 0.2 mm, in the gap's frame; walls that return
/// 0.9 at every impact's own speed; about seven impacts.
Scene shaken_gap(double stiffness) {
  const double frequency = 2 * std::numbers::pi * 10;  // [rad/s]
  Scene scene;
  scene.wall_upper = 1e-3;
  scene.restitution_lower = scene.restitution_upper = 0.9;
  scene.disturbance = 2e-4 * frequency * frequency;
  scene.disturbance_frequency = frequency;
  scene.start_position = 0.5e-3;
  scene.start_velocity = 0.1;
  scene.window = Seconds{0.1};
  scene.fidelity = Fidelity::compliant;
  scene.contact_law = ContactLaw::exact_restitution;
  scene.stiffness = stiffness;
  return scene;
}

/// h w below which an explicit method stays bounded on a spring of frequency w [rad/s], h [s] the
/// step; nothing for other methods. Hairer, Lubich and Wanner, Geometric Numerical Integration,
/// I.5; Hairer and Wanner, Solving Ordinary Differential Equations II, IV.2.
std::optional<double> spring_bound(const std::string& method) {
  if (method == "semi-implicit-euler") return 2;
  if (method == "runge-kutta-4") return std::sqrt(8.0);
  return std::nullopt;
}

/// [rad/s] of a wall at the deepest point of the fastest impact: sqrt(n K d^(n-1) / m).
double frequency_of(const Scene& scene, const Outcome& reference) {
  const double fastest = std::ranges::max_element(reference.impacts, {}, &Impact::speed)->speed;
  const double n = scene.contact_exponent;
  const double damping = dissipation(scene.contact_law, scene.restitution_lower);
  const double depth = peak_penetration(scene.stiffness, n, scene.mass, fastest, damping);
  return std::sqrt(n * scene.stiffness * std::pow(depth, n - 1) / scene.mass);
}

/// From 10^first down to 10^last, so many a decade.
std::vector<double> powers_of_ten(int first, int last, int per_decade) {
  std::vector<double> powers;
  for (int k = 0; k <= per_decade * (first - last); ++k)
    powers.push_back(std::pow(10.0, first - static_cast<double>(k) / per_decade));
  return powers;
}

/// The runs of a method.
struct Stability {
  int runs = 0, wrong = 0, energetic = 0;
  std::optional<double> lowest_bad = {};  ///< h w with which a wall gives energy or lets through
};

}  // namespace

void add_stiff_walls(report::Results& results, int per_decade) {
  const std::vector<Integrator> methods = all_integrators();
  const std::vector<double> stiffnesses = powers_of_ten(16, 6, 1);
  Table table{"stiff-walls",
              {{"method"},
               {"runs"},
               {"wrong", "wrong number of impacts"},
               {"energetic", "walls give energy, or let through"},
               {"lowest_bad", "from h w", ".2f"},
               {"bound", "bound of theory", ".2f"}}};
  report::Chart chart{.name = "stiff-walls",
                      .x = {"stiffness of the walls [N/m^1.5]"},
                      .y = {""},
                      .heat_map = report::HeatMap{"right [%]", {}, report::Range{0, 100}},
                      .width = 760,
                      .height = 300};
  for (auto k = stiffnesses.rbegin(); k != stiffnesses.rend(); ++k)
    chart.x.categories.push_back(fmt::format("1e{:.0f}", std::log10(*k)));
  std::vector<std::string> borders;
  int adaptive = 0, adaptive_wrong = 0;
  Progress progress("stiff walls", static_cast<double>(methods.size()));
  for (auto method = methods.rbegin(); method != methods.rend(); ++method, progress.advance(1)) {
    if (!method->takes_compliant || method->setting == no_setting) continue;
    const bool fixed = method->setting == by_step;
    const auto settings = fixed ? powers_of_ten(-3, -7, per_decade) : powers_of_ten(-3, -12, 1);
    Stability all;
    chart.y.categories.push_back(method->name);
    auto& row = chart.heat_map->rows.emplace_back();
    for (auto k = stiffnesses.rbegin(); k != stiffnesses.rend(); ++k) {
      const Scene scene = shaken_gap(*k);
      const Outcome reference = methods.front().run(scene, 0);
      if (!reference.finished) throw std::runtime_error("the reference: " + reference.failure);
      int right = 0;
      for (const double setting : settings) {
        const Outcome outcome = method->run(scene, setting);
        const bool energetic = std::isinf(outcome.deepest) || outcome.gained.value_or(0) > 0;
        const bool good = outcome.finished && !energetic &&
                          collisions(scene, outcome) == collisions(scene, reference);
        right += good ? 1 : 0;
        all.energetic += energetic ? 1 : 0;
        if (!energetic || !fixed) continue;
        const double scaled = setting * frequency_of(scene, reference);
        all.lowest_bad = std::min(all.lowest_bad.value_or(scaled), scaled);
      }
      row.emplace_back(std::round(100.0 * right / static_cast<double>(settings.size())));
      all.runs += static_cast<int>(settings.size());
      all.wrong += static_cast<int>(settings.size()) - right;
    }
    table.rows.insert(
        table.rows.begin(),
        {value_of(method->name), value_of(all.runs), value_of(all.wrong), value_of(all.energetic),
         value_of(all.lowest_bad), value_of(spring_bound(method->name))});
    if (all.lowest_bad)
      borders.push_back(fmt::format("{:.2f}/w by {}", *all.lowest_bad, method->name));
    if (fixed) continue;
    adaptive += all.runs;
    adaptive_wrong += all.wrong;
  }
  chart.title = fmt::format("Methods that choose their steps are right in {} of {} runs",
                            adaptive - adaptive_wrong, adaptive);
  results.set(
      "stiff-finding",
      fmt::format("With fixed steps a stiff wall throws a body back faster than it came, or "
                  "lets it through, from a step of {} on, with w the frequency of the body "
                  "on the wall. Methods that control their error count right in {} of {} "
                  "runs.",
                  fmt::join(borders, " and "), adaptive - adaptive_wrong, adaptive));
  results.add(std::move(table));
  results.add(std::move(chart));
}

}  // namespace ricochet::studies::simulators
