#include "problems/carrier_track/scene/scene_doubts.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "problems/carrier_track/scene/window.h"

namespace ricochet::carrier_track::inline scene {
namespace {

constexpr double gravity = 9.81;  // m/s^2

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

}  // namespace

std::vector<std::string> doubts_about(const Scene& scene) {
  Doubts doubts;
  doubts.add_if(scene.mass > 50, "scene.mass = {} kg: a carrier so heavy; are these grams?",
                scene.mass);
  doubts.add_if(scene.mass < 1e-3, "scene.mass = {} kg: a carrier so light", scene.mass);
  const double clearance = scene.wall_upper - scene.wall_lower;
  doubts.add_if(std::isfinite(clearance) && clearance > 0.05,
                "scene.wall_upper - scene.wall_lower = {} m: walls so far apart; are these "
                "millimetres?",
                clearance);
  doubts.add_if(clearance < 1e-6, "scene.wall_upper - scene.wall_lower = {} m: hardly any play",
                clearance);
  const double weight = scene.mass * gravity;
  doubts.add_if(scene.friction > 0 && scene.normal_force == 0,
                "scene.normal_force = 0 N: the friction of {} has nothing to multiply",
                scene.friction);
  doubts.add_if(scene.friction > 0 && scene.normal_force > 0 &&
                    (scene.normal_force > 5 * weight || scene.normal_force < weight / 5),
                "scene.normal_force = {} N: the weight is {:.4g} N", scene.normal_force, weight);
  doubts.add_if(scene.friction > 1.2, "scene.friction = {}: more than rubber on concrete",
                scene.friction);
  doubts.add_if(scene.restitution_lower > 0.98 || scene.restitution_upper > 0.98,
                "scene.restitution = [{}, {}]: hardened steel on steel returns 0.95",
                scene.restitution_lower, scene.restitution_upper);
  doubts.add_if(std::abs(scene.start_velocity) > 5,
                "scene.start_velocity = {} m/s: so fast a start", scene.start_velocity);
  doubts.add_if(scene.disturbance != 0 && scene.disturbance_frequency == 0,
                "scene.disturbance_frequency = 0 rad/s: the disturbance of {} N never changes",
                scene.disturbance);
  doubts.add_if(scene.counting_limit > 0.5,
                "count.counting_limit = {} m/s: few impacts are that fast, and no other counts",
                scene.counting_limit);
  if (!scene.profile.empty()) return doubts.sentences();
  doubts.add_if(scene.omega > 100, "scene.omega = {} rad/s: {:.4g} turns a minute; are these rpm?",
                scene.omega, scene.omega * 30 / std::numbers::pi);
  const double turns = turns_of(scene);
  doubts.add_if(turns < 1, "window: {:.3g} turns at scene.omega: less than one", turns);
  return doubts.sentences();
}

}  // namespace ricochet::carrier_track::inline scene
