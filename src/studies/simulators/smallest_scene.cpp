#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include "problems/carrier_track/scene/scene_check.h"
#include "problems/carrier_track/scene/scene_fields.h"
#include "ricochet/error.h"
#include "src/studies/simulators/suite.h"

namespace ricochet::studies::simulators {

namespace {

using namespace carrier_track;

using report::Json;

using Step = std::function<void(Scene&)>;

double& seconds_of(Scene& machine) {
  return std::get<Seconds>(machine.window).count;
}

void drop_profile(Scene& machine) {
  if (machine.profile.empty()) return;
  machine.omega = machine.profile.front().omega;
  machine.profile.clear();
}

/// Divides all forces by the mass: the motion stays.
void set_mass_to_one(Scene& machine) {
  for (double* force : {&machine.normal_force, &machine.pull, &machine.centrifugal_mass_radius,
                        &machine.slider_mass_radius, &machine.disturbance}) {
    *force /= machine.mass;
  }
  machine.mass = 1;
}

void set_lower_wall_to_zero(Scene& machine) {
  machine.wall_upper -= machine.wall_lower;
  machine.start_position -= machine.wall_lower;
  machine.wall_lower = 0;
}

/// What may be left out, the largest first.
std::vector<Step> drops() {
  const auto open = std::numeric_limits<double>::infinity();
  return {[=](Scene& s) { s.wall_upper = open; },
          [](Scene& s) { s.disturbance = 0; },
          [](Scene& s) { s.centrifugal_mass_radius = s.slider_mass_radius = 0; },
          [](Scene& s) { s.slider_mass_radius = 0; },
          [](Scene& s) { s.friction = s.normal_force = 0; },
          [](Scene& s) { s.pull = 0; },
          drop_profile,
          [](Scene& s) {
            if (s.profile.size() > 1) s.profile.pop_back();
          },
          [](Scene& s) { s.pull_rotates = false; },
          [](Scene& s) { s.phase = 0; },
          [](Scene& s) { s.disturbance_phase = 0; },
          [](Scene& s) { s.start_velocity = 0; },
          [](Scene& s) { s.start_position = s.wall_lower; },
          [](Scene& s) { s.restitution_lower = s.restitution_upper; },
          [](Scene& s) { s.restitution_upper = s.restitution_lower; },
          [](Scene& s) { s.restitution_lower = s.restitution_upper = 0.5; },
          set_lower_wall_to_zero,
          set_mass_to_one};
}

/// Shorter windows, which end before one of the impacts.
std::vector<Step> cuts(const ScoredScene& scored) {
  std::vector<Step> steps;
  const Truth& truth = scored.truth;
  for (std::size_t k = 1; k < truth.size(); ++k) {
    // Of many, those that leave 1/2, 3/4, 7/8 ... of them.
    const bool chosen = truth.size() <= 12 || k == 1 || std::has_single_bit(truth.size() - k);
    const double end = (truth[k - 1].time + truth[k].time) / 2;
    if (chosen) steps.push_back([=](Scene& s) { seconds_of(s) = end; });
  }
  return steps;
}

double rounded_to(double x, int digits) {
  if (x == 0 || !std::isfinite(x)) return x;
  const double unit = std::pow(10, std::floor(std::log10(std::abs(x))) + 1 - digits);
  // A division by a power of ten gives the nearest number with so many digits.
  return unit < 1 ? std::round(x / unit) / std::round(1 / unit) : std::round(x / unit) * unit;
}

/// Calls visit(number) for every number of a scene and its window.
void visit_numbers(Scene& machine, const std::function<void(double&)>& visit) {
  struct Visitor {
    const std::function<void(double&)>& visit;
    void operator()(const SceneField& /*field*/, double& x) const { visit(x); }
    void operator()(const SceneField& /*field*/, Walls<double> walls) const {
      visit(walls.lower);
      visit(walls.upper);
    }
    void operator()(const SceneField& /*field*/,
                    PlateSpeed<double, std::vector<SpeedKnot<double>>> speed) const {
      visit(speed.omega);
      for (auto& knot : speed.profile) {
        visit(knot.time);
        visit(knot.omega);
      }
    }
    void operator()(const SceneField& /*field*/, bool& /*flag*/) const {}
    void operator()(const SceneField& /*field*/, Centrifugal& /*rule*/) const {}
  };
  visit_scene_fields(Visitor{visit}, machine);
  visit(seconds_of(machine));
  visit(machine.counting_limit);
}

/// All numbers to so many digits at once, and then each alone.
std::vector<Step> roundings(Scene machine) {
  std::vector<Step> steps;
  for (const int digits : {1, 2, 3}) {
    steps.push_back(
        [=](Scene& s) { visit_numbers(s, [=](double& x) { x = rounded_to(x, digits); }); });
  }
  int numbers = 0;
  visit_numbers(machine, [&](double&) { ++numbers; });
  for (int k = 0; k < numbers; ++k) {
    for (const int digits : {1, 2, 3}) {
      steps.push_back([=](Scene& s) {
        int at = 0;
        visit_numbers(s, [&](double& x) {
          if (at++ == k) x = rounded_to(x, digits);
        });
      });
    }
  }
  return steps;
}

/// The shrinking of one scene.
class Shrinking {
 public:
  Shrinking(const ScoredScene& broken, const std::function<bool(const ScoredScene&)>& breaks,
            int most_asks)
      : best_(broken), breaks_(breaks), left_(most_asks) {}

  ScoredScene run() {
    for (bool smaller = true; smaller;) {
      smaller = any_of(cuts(best_)) || any_of(drops());
    }
    any_of(roundings(best_.machine));
    any_of(drops());
    any_of(cuts(best_));
    return best_;
  }

 private:
  bool any_of(const std::vector<Step>& steps) {
    bool smaller = false;
    for (const Step& step : steps) smaller = takes(step) || smaller;
    return smaller;
  }
  bool takes(const Step& step) {
    Scene machine = best_.machine;
    step(machine);
    if (left_ == 0 || write_scene(machine) == write_scene(best_.machine)) return false;
    auto next = exactly(machine);
    if (!next || next->truth.size() > best_.truth.size()) return false;
    const bool same_motion = Json(next->scene).dump() == Json(test_scene(best_.machine)).dump();
    next->scene.scene = best_.scene.scene;
    next->scene.kind = best_.scene.kind;
    next->scene.difficulty = best_.scene.difficulty;
    if (!same_motion) {
      --left_;
      if (!breaks_(*next)) return false;
    }
    best_ = std::move(*next);
    return true;
  }

  ScoredScene best_;
  const std::function<bool(const ScoredScene&)>& breaks_;
  int left_;
};

}  // namespace

std::optional<ScoredScene> exactly(const Scene& machine) {
  try {
    check(machine, "scene");
  } catch (const InputError&) {
    return std::nullopt;
  }
  Random random(0);
  ScoredScene scored{0, test_scene(machine), machine, {}};
  auto known = conditioned_truth(scored.scene, random);
  if (!known || known->good_until < scored.scene.duration) return std::nullopt;
  scored.truth = std::move(known->impacts);
  const double clear = clear_of_the_end * mean_time_between(scored.scene, scored.truth);
  if (scored_impacts(scored.scene, scored.truth) == 0 ||
      scored.truth.back().time > scored.scene.duration - clear) {
    return std::nullopt;
  }
  return scored;
}

std::string words_of(const Scene& machine) {
  std::string text = fmt::format("{:.4g} kg", machine.mass);
  const auto add = [&](bool there, const std::string& words) {
    if (there) text += ", " + words;
  };
  const bool open = std::isinf(machine.wall_upper);
  add(open, fmt::format("one wall at {:.4g} m", machine.wall_lower));
  add(!open, fmt::format("walls at {:.4g} and {:.4g} m", machine.wall_lower, machine.wall_upper));
  const bool same = open || machine.restitution_lower == machine.restitution_upper;
  add(same, fmt::format("restitution {:.4g}", machine.restitution_lower));
  add(!same, fmt::format("restitution {:.4g} and {:.4g}", machine.restitution_lower,
                         machine.restitution_upper));
  const double friction = machine.friction * machine.normal_force;
  add(friction > 0, fmt::format("friction {:.4g} N", friction));
  add(machine.pull != 0,
      fmt::format("{}pull {:.4g} N", machine.pull_rotates ? "turning " : "", machine.pull));
  const bool turns = machine.centrifugal_mass_radius != 0 || machine.slider_mass_radius != 0;
  add(machine.centrifugal_mass_radius != 0,
      fmt::format("mass radius {:.4g} kg m", machine.centrifugal_mass_radius));
  add(machine.slider_mass_radius != 0,
      fmt::format("slider {:.4g} kg m", machine.slider_mass_radius));
  add(turns && machine.profile.empty(), fmt::format("{:.4g} rad/s", machine.omega));
  add(turns && !machine.profile.empty(), fmt::format("{} knots", machine.profile.size()));
  add(turns && machine.phase != 0, fmt::format("phase {:.4g}", machine.phase));
  add(machine.disturbance != 0, fmt::format("disturbance {:.4g} N at {:.4g} rad/s",
                                            machine.disturbance, machine.disturbance_frequency));
  add(true, fmt::format("from {:.4g} m with {:.4g} m/s, {:.4g} s", machine.start_position,
                        machine.start_velocity, std::get<Seconds>(machine.window).count));
  return text;
}

ScoredScene smallest_scene(const ScoredScene& broken,
                           const std::function<bool(const ScoredScene&)>& breaks, int most_asks) {
  return Shrinking(broken, breaks, most_asks).run();
}

}  // namespace ricochet::studies::simulators
