#include "problems/carrier_track/scene/scene_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>

#include "problems/carrier_track/scene/contact_law.h"
#include "problems/carrier_track/scene/scene_fields.h"
#include "problems/carrier_track/scene/scene_values.h"
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
  void operator()(const SceneField& field, double x) const {
    if (contains(field.range, x)) return;
    require(false, field.key, x, in_words(field.range, field.unit));
  }
  void operator()(const SceneField& field, Walls<const double> x) const {
    (*this)(field, x.lower);
    (*this)(field, x.upper);
  }
  void operator()(const SceneField& field, const std::optional<double>& x) const {
    if (x) (*this)(field, *x);
  }
  template <class Other>
  void operator()(const SceneField& /*field*/, const Other& /*x*/) const {}

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

SceneField speed_field(std::string_view name) {
  return {name, "rad/s", "", ranges::frequency};
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
  const auto check_field = [&](const SceneField& field, const auto& x) {
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
  const auto check_field = [&](const SceneField& field, const auto& x) {
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
    window(SceneField{"revolutions", "1", "", ranges::positive}, turns->count);
  } else {
    window(SceneField{"seconds", "s", "", ranges::positive}, std::get<Seconds>(scene.window).count);
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

namespace {

constexpr double gravity = 9.81;               // [m/s^2]
constexpr double rpm = 30 / std::numbers::pi;  // per rad/s
constexpr double usual_end = 18;               // [rad/s], of the speeds that are looked through
constexpr double few_turns = 5;                // a start matters in fewer

/// Collects the sentences whose condition holds.
class Doubts {
 public:
  template <class... Values>
  void add_if(bool doubtful, fmt::format_string<const Values&...> sentence,
              const Values&... values) {
    if (doubtful) sentences_.push_back(fmt::format(sentence, values...));
  }

  std::vector<std::string> sentences() const { return sentences_; }

 private:
  std::vector<std::string> sentences_;
};

void doubt_the_masses(const Scene& scene, Doubts& doubts) {
  doubts.add_if(scene.mass > 50, "scene.mass = {} kg: a carrier so heavy; are these grams?",
                scene.mass);
  doubts.add_if(scene.mass < 1e-3, "scene.mass = {} kg: a carrier so light", scene.mass);
  const double radius = scene.centrifugal_mass_radius / scene.mass;
  doubts.add_if(radius != 0 && (radius < 0.01 || radius > 1),
                "scene.centrifugal_mass_radius = {} kg m: divided by scene.mass = {} kg it is a "
                "path radius of {:.3g} m, not within 0.01..1 m",
                scene.centrifugal_mass_radius, scene.mass, radius);
  const double clearance = scene.wall_upper - scene.wall_lower;
  const bool wide = std::isfinite(clearance) && clearance > 0.05;
  doubts.add_if(wide,
                "scene.wall_upper - scene.wall_lower = {} m: walls so far apart; are these "
                "millimetres?",
                clearance);
  doubts.add_if(clearance < 1e-6, "scene.wall_upper - scene.wall_lower = {} m: hardly any play",
                clearance);
  doubts.add_if(!wide && radius >= 0.01 && std::isfinite(clearance) && clearance > radius / 5,
                "scene.wall_upper - scene.wall_lower = {} m: more than a fifth of the path radius, "
                "{:.3g} m",
                clearance, radius);
}

void doubt_the_friction(const Scene& scene, Doubts& doubts) {
  const double weight = scene.mass * gravity;
  doubts.add_if(scene.friction > 0 && scene.normal_force == 0,
                "scene.normal_force = 0 N: the friction of {} has nothing to multiply",
                scene.friction);
  doubts.add_if(scene.friction > 0 && scene.normal_force > 0 &&
                    (scene.normal_force > 10 * weight || scene.normal_force < weight / 10),
                "scene.normal_force = {} N: the weight is {:.4g} N", scene.normal_force, weight);
  doubts.add_if(scene.friction > 1, "scene.friction = {}: dry steel on steel has 0.8 at most",
                scene.friction);
  doubts.add_if(scene.restitution_lower > 0.98 || scene.restitution_upper > 0.98,
                "scene.restitution = [{}, {}]: hardened steel on steel returns 0.95",
                scene.restitution_lower, scene.restitution_upper);
  doubts.add_if(scene.disturbance != 0 && scene.disturbance_frequency == 0,
                "scene.disturbance_frequency = 0 rad/s: the disturbance of {} N never changes",
                scene.disturbance);
  const double held = scene.friction * scene.normal_force;
  const std::optional<double> release = release_speed(scene);
  doubts.add_if(scene.centrifugal_mass_radius > 0 && held > 0 && (!release || *release > usual_end),
                "scene.friction * scene.normal_force = {:.3g} N: holds the carrier at every speed "
                "up to {} rad/s",
                held, usual_end);
  doubts.add_if(held > 0 && release && *release > 0 && *release < 0.1,
                "scene.friction * scene.normal_force = {:.3g} N: holds the carrier up to {:.3g} "
                "rad/s ({:.3g} rpm) only",
                held, release.value_or(0), release.value_or(0) * rpm);
}

/// Compares the counting limit and the start with the speeds that the forces cause.
void doubt_the_speeds(const Scene& scene, Doubts& doubts) {
  const bool high = scene.counting_limit > 0.5;
  doubts.add_if(high,
                "count.counting_limit = {} m/s: few impacts are that fast, and no other counts",
                scene.counting_limit);
  const double start = std::abs(scene.start_velocity);
  doubts.add_if(start > 5, "scene.start_velocity = {} m/s: so fast a start", scene.start_velocity);
  if (!scene.profile.empty()) return;
  doubts.add_if(scene.omega > 100, "scene.omega = {} rad/s: {:.4g} turns a minute; are these rpm?",
                scene.omega, scene.omega * rpm);
  const double fast = std::max(scene.omega, usual_end);
  const double thrown = thrown_speed(scene, fast);
  doubts.add_if(
      !high && thrown > 0 && scene.counting_limit > thrown,
      "count.counting_limit = {} m/s: at {} rad/s the forces give the carrier only {:.3g} "
      "m/s across the clearance, so hardly an impact counts",
      scene.counting_limit, fast, thrown);
  doubts.add_if(std::isfinite(thrown) && scene.counting_limit < 1e-5 * thrown,
                "count.counting_limit = {} m/s: at {} rad/s the forces give the carrier {:.3g} m/s "
                "across the clearance, so rebounds count that nobody hears",
                scene.counting_limit, fast, thrown);
  const double here = thrown_speed(scene, scene.omega);
  doubts.add_if(start <= 5 && start > 3 * here,
                "scene.start_velocity = {:.4g} m/s: at scene.omega = {:.4g} rad/s the forces give "
                "the carrier {:.3g} m/s across the clearance, so the first impacts are the start's",
                scene.start_velocity, scene.omega, here);
}

void doubt_the_window(const Scene& scene, Doubts& doubts) {
  if (!scene.profile.empty()) return;
  const double turns = turns_of(scene);
  doubts.add_if(turns < 1, "window: {:.3g} turns at scene.omega: less than one", turns);
  doubts.add_if(turns >= 1 && turns < few_turns,
                "window: {:.3g} turns at scene.omega: the first impacts are the start's; from {} "
                "turns on they matter less",
                turns, few_turns);
}

}  // namespace

std::vector<std::string> doubts_about(const Scene& scene) {
  Doubts doubts;
  doubt_the_masses(scene, doubts);
  doubt_the_friction(scene, doubts);
  doubt_the_speeds(scene, doubts);
  doubt_the_window(scene, doubts);
  return doubts.sentences();
}

}  // namespace ricochet::carrier_track::inline scene
