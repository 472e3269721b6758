#include "problems/carrier_track/scene/scene_doubts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "problems/carrier_track/scene/release.h"
#include "problems/carrier_track/scene/window.h"

namespace ricochet::carrier_track::inline scene {
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
