#include "problems/carrier_track/scene/scene_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>

#include "problems/carrier_track/scene/contact_law.h"
#include "problems/carrier_track/scene/scene_fields.h"
#include "problems/carrier_track/scene/window.h"
#include "ricochet/error.h"

namespace ricochet::carrier_track::inline scene {
namespace {

/// Lower limit of the restitution for a law whose damping grows as 1 / restitution.
constexpr double smallest_restitution = 1e-6;

/// Checks the fields of one table; throws InputError for an invalid one.
class Checker {
 public:
  Checker(const std::string& origin, std::string_view table) : origin_(origin), table_(table) {}

  void require(bool holds, std::string_view key, double value, std::string_view allowed) const {
    if (holds) return;
    throw InputError(
        fmt::format("{}: {}{} = {}: must be {}", origin_, table_, key, value, allowed));
  }

  /// Checks that a field is within its range in the list.
  void operator()(const Field& field, double x) const {
    const auto number = [&](bool holds, std::string_view bound, std::string_view limits) {
      require(holds, field.key, x,
              fmt::format("a finite number{} [{}], {}", bound, field.unit, limits));
    };
    const bool is_small = std::abs(x) <= largest_number;  // and not NaN
    switch (field.range) {
      case Range::finite:
        return number(is_small, "", "within -1e15..1e15");
      case Range::not_negative:
        return number(is_small && x >= 0, " >= 0", "at most 1e15");
      case Range::positive:
        return number(is_small && x >= smallest_number, " > 0", "within 1e-15..1e15");
      case Range::frequency:
        return number(x >= 0 && x <= fastest_frequency, " >= 0", "at most 1e9");
      case Range::fraction:
        return require(x >= 0 && x <= 1, field.key, x, "within 0..1");
      case Range::any:
      case Range::by_rule:
        return;
    }
  }
  void operator()(const Field& field, Walls<const double> x) const {
    (*this)(field, x.lower);
    (*this)(field, x.upper);
  }
  void operator()(const Field& field, const std::optional<double>& x) const {
    if (x) (*this)(field, *x);
  }
  template <class Other>
  void operator()(const Field& /*field*/, const Other& /*x*/) const {}

  /// Checks the walls of a scene or of its second direction, and the start between them.
  template <class Track>
  void walls(const Track& track) const {
    const double lower = track.wall_lower;
    const double upper = track.wall_upper;
    const double start = track.start_position;
    require(upper > lower && (upper <= largest_number || std::isinf(upper)), "wall_upper", upper,
            fmt::format("> wall_lower = {} [m] and at most 1e15, or inf", lower));
    require(start >= lower && start <= upper && std::isfinite(start), "start_position", start,
            fmt::format("within the walls, {}..{} [m]", lower, upper));
  }

 private:
  const std::string& origin_;
  std::string_view table_;
};

Field speed_field(std::string_view name) {
  return {name, "rad/s", "", Range::frequency};
}

void check_speed(const Scene& scene, const Checker& checker, const std::string& name) {
  checker.require(scene.omega > 0 || !std::holds_alternative<Revolutions>(scene.window), name,
                  scene.omega, "a finite number > 0 [rad/s], because the window is in revolutions");
  checker(speed_field(name), scene.omega);
}

/// Checks the length of the window: a longer one would take minutes to simulate.
void check_window(const Scene& scene, const Checker& checker) {
  double fastest = scene.profile.empty() ? scene.omega : 0.0;
  for (const auto& knot : scene.profile) fastest = std::max(fastest, knot.omega);
  if (scene.disturbance != 0) fastest = std::max(fastest, scene.disturbance_frequency);
  const double duration = duration_of(scene);
  const double longest = std::min(largest_number, 2 * std::numbers::pi * longest_window / fastest);
  const auto* turns = std::get_if<Revolutions>(&scene.window);
  const double count = turns != nullptr ? turns->count : std::get<Seconds>(scene.window).count;
  checker.require(duration <= longest * (1 + 1e-12), turns != nullptr ? "revolutions" : "seconds",
                  count,
                  fmt::format("at most {}, for 1e6 periods of the fastest force, of {} rad/s, and "
                              "1e15 s",
                              count * (longest / duration), fastest));
}

void check_profile(const Scene& scene, const Checker& checker) {
  double before = -1;
  for (const auto& knot : scene.profile) {
    checker.require(
        knot.time <= largest_number && knot.time >= 0 && knot.time - before >= shortest_leg,
        "omega's time", knot.time,
        "a finite number >= 0 [s], at most 1e15, later than the one before by at least 1e-9");
    checker(speed_field("omega"), knot.omega);
    before = knot.time;
  }
}

void check_across(const Scene& scene, const std::string& origin) {
  if (!scene.across) {
    if (scene.fidelity != Fidelity::planar) return;
    throw InputError(origin + ": model.fidelity = planar: must have the table [across], for y");
  }
  Checker(origin, "scene.")
      .require(!scene.contact_friction, "contact_friction", 1,
               "false, because [across] has friction in contact of its own");
  const Checker checker(origin, "across.");
  const auto check_field = [&](const Field& field, const auto& x) {
    checker(field, x);
    if (field.key == "wall_upper") checker.walls(*scene.across);
    if (field.key == "pull") {
      checker.require(scene.across->pull == 0 || !scene.pull_rotates, "pull", scene.across->pull,
                      "0, because scene.pull_rotates turns scene.pull into this direction");
    }
  };
  visit_across_fields(check_field, *scene.across);
}

void check_contact_law(const Scene& scene, const std::string& origin) {
  if (scene.fidelity == Fidelity::impact || scene.fidelity == Fidelity::planar) return;
  const Checker model(origin, "model.");
  model.require(scene.contact_law != ContactLaw::kelvin_voigt || scene.contact_exponent == 1,
                "contact_exponent", scene.contact_exponent, "1, because kelvin-voigt is linear");
  model.require(scene.contact_exponent >= 1, "contact_exponent", scene.contact_exponent,
                "at least 1, because below that a wall is infinitely stiff at its surface");
  if (!needs_restitution(scene.contact_law)) return;
  const Checker checker(origin, "scene.");
  for (const double restitution : {scene.restitution_lower, scene.restitution_upper}) {
    checker.require(
        restitution >= smallest_restitution, "restitution", restitution,
        "at least 1e-6, because the damping of this model.contact_law is infinite at 0");
  }
  checker.require(!scene.contact_friction || scene.friction <= 1 - smallest_restitution, "friction",
                  scene.friction,
                  "at most 0.999999, because with scene.contact_friction it takes the restitution, "
                  "and the damping of this model.contact_law is infinite at 0");
}

}  // namespace

void check_omega(const Scene& scene, const std::string& origin, const std::string& name) {
  const Checker checker(origin, "");
  check_speed(scene, checker, name);
  check_window(scene, Checker(origin, "window."));
}

void check(const Scene& scene, const std::string& origin) {
  const Checker checker(origin, "scene.");
  const auto check_field = [&](const Field& field, const auto& x) {
    checker(field, x);
    if (field.key == "wall_upper") checker.walls(scene);
    if (field.key == "friction") {
      checker.require(!scene.contact_friction || scene.friction <= 1, "friction", scene.friction,
                      "within 0..1, because scene.contact_friction");
    }
    if (field.key == "omega") {
      check_profile(scene, checker);
      const double last = scene.profile.empty() ? scene.omega : scene.profile.back().omega;
      check_speed(at_speed(scene, last), checker, "omega");
    }
  };
  visit_scene_fields(check_field, scene);
  check_across(scene, origin);
  const Checker window(origin, "window.");
  if (const auto* turns = std::get_if<Revolutions>(&scene.window)) {
    window(Field{"revolutions", "1", "", Range::positive}, turns->count);
  } else {
    window(Field{"seconds", "s", "", Range::positive}, std::get<Seconds>(scene.window).count);
  }
  check_window(scene, window);
  visit_count_fields(Checker(origin, "count."), scene);
  visit_model_fields(Checker(origin, "model."), scene);
  check_contact_law(scene, origin);
}

void check_constant_speed(const Scene& scene, const std::string& origin) {
  if (scene.profile.empty()) return;
  throw InputError(origin +
                   ": scene.omega is a profile: must be a number, because a threshold is of "
                   "constant speeds");
}

}  // namespace ricochet::carrier_track::inline scene
