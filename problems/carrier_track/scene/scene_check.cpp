#include "problems/carrier_track/scene/scene_check.h"

#include <fmt/format.h>

#include <cmath>

#include "src/core/error.h"

namespace ricochet::carrier_track::inline scene {
namespace {

class Checker {
 public:
  explicit Checker(const std::string& origin) : origin_(origin) {}

  void require(bool holds, const std::string& key, double value, const std::string& allowed) const {
    if (!holds)
      throw InputError(fmt::format("{}: {} = {}: must be {}", origin_, key, value, allowed));
  }
  void finite(const std::string& key, double value, const char* unit) const {
    require(std::isfinite(value), key, value, fmt::format("a finite number [{}]", unit));
  }
  void positive(const std::string& key, double value, const char* unit) const {
    require(std::isfinite(value) && value > 0, key, value,
            fmt::format("a finite number > 0 [{}]", unit));
  }
  void not_negative(const std::string& key, double value, const char* unit) const {
    require(std::isfinite(value) && value >= 0, key, value,
            fmt::format("a finite number >= 0 [{}]", unit));
  }
  const std::string& origin() const { return origin_; }
  void fraction(const std::string& key, double value) const {
    require(value >= 0 && value <= 1, key, value, "within 0..1");
  }

 private:
  const std::string& origin_;
};

void check_walls(const Checker& checker, const std::string& table, double lower, double upper,
                 double start) {
  const auto key = [&](const char* name) { return fmt::format("{}.{}", table, name); };
  checker.finite(key("wall_lower"), lower, "m");
  checker.require(upper > lower, key("wall_upper"), upper,
                  fmt::format("> wall_lower = {} [m], or inf", lower));
  checker.require(start >= lower && start <= upper && std::isfinite(start), key("start_position"),
                  start, fmt::format("within the walls, {}..{} [m]", lower, upper));
}

void check_across(const Scene& scene, const Checker& checker) {
  if (!scene.across) {
    if (scene.fidelity != Fidelity::planar) return;
    throw InputError(checker.origin() +
                     ": model.fidelity = planar: must have the table [across], for y");
  }
  const Across<double>& y = *scene.across;
  checker.require(!scene.contact_friction, "scene.contact_friction", 1,
                  "false, because [across] has friction in contact of its own");
  checker.finite("across.pull", y.pull, "N");
  checker.require(y.pull == 0 || !scene.pull_rotates, "across.pull", y.pull,
                  "0, because scene.pull_rotates turns scene.pull into this direction");
  check_walls(checker, "across", y.wall_lower, y.wall_upper, y.start_position);
  checker.fraction("across.restitution", y.restitution_lower);
  checker.fraction("across.restitution", y.restitution_upper);
  checker.finite("across.start_velocity", y.start_velocity, "m/s");
}

void check_profile(const Scene& scene, const Checker& checker) {
  double before = -1;
  for (const auto& knot : scene.profile) {
    checker.require(std::isfinite(knot.time) && knot.time >= 0 && knot.time > before,
                    "scene.omega's time", knot.time,
                    "a finite number >= 0 [s], later than the one before");
    checker.not_negative("scene.omega", knot.omega, "rad/s");
    before = knot.time;
  }
}

void check_contact_law(const Scene& scene, const Checker& checker) {
  if (scene.fidelity == Fidelity::impact || scene.fidelity == Fidelity::planar) return;
  checker.require(scene.contact_law != ContactLaw::kelvin_voigt || scene.contact_exponent == 1,
                  "model.contact_exponent", scene.contact_exponent,
                  "1, because kelvin-voigt is linear");
  for (const double restitution : {scene.restitution_lower, scene.restitution_upper}) {
    checker.require(restitution > 0 || !needs_restitution(scene.contact_law), "scene.restitution",
                    restitution,
                    "> 0, because the damping of this model.contact_law is infinite at 0");
  }
}

}  // namespace

void check_omega(const Scene& scene, const std::string& origin, const std::string& name) {
  const Checker checker(origin);
  if (std::holds_alternative<Revolutions>(scene.window)) {
    checker.require(std::isfinite(scene.omega) && scene.omega > 0, name, scene.omega,
                    "a finite number > 0 [rad/s], because the window is in revolutions");
  } else {
    checker.not_negative(name, scene.omega, "rad/s");
  }
}

void check(const Scene& scene, const std::string& origin) {
  const Checker checker(origin);
  checker.positive("scene.mass", scene.mass, "kg");
  check_walls(checker, "scene", scene.wall_lower, scene.wall_upper, scene.start_position);
  checker.fraction("scene.restitution", scene.restitution_lower);
  checker.fraction("scene.restitution", scene.restitution_upper);
  checker.not_negative("scene.friction", scene.friction, "1");
  checker.require(!scene.contact_friction || scene.friction <= 1, "scene.friction", scene.friction,
                  "within 0..1, because scene.contact_friction");
  checker.not_negative("scene.normal_force", scene.normal_force, "N");
  checker.finite("scene.pull", scene.pull, "N");
  checker.finite("scene.pull_phase", scene.pull_phase, "rad");
  checker.not_negative("scene.centrifugal_mass_radius", scene.centrifugal_mass_radius, "kg m");
  checker.not_negative("scene.slider_mass_radius", scene.slider_mass_radius, "kg m");
  checker.finite("scene.phase", scene.phase, "rad");
  checker.finite("scene.disturbance", scene.disturbance, "N");
  checker.not_negative("scene.disturbance_frequency", scene.disturbance_frequency, "rad/s");
  checker.finite("scene.disturbance_phase", scene.disturbance_phase, "rad");
  checker.finite("scene.start_velocity", scene.start_velocity, "m/s");
  check_profile(scene, checker);
  check_omega(at_speed(scene, scene.profile.empty() ? scene.omega : scene.profile.back().omega),
              origin, "scene.omega");
  check_across(scene, checker);
  if (const auto* turns = std::get_if<Revolutions>(&scene.window)) {
    checker.positive("window.revolutions", turns->count, "1");
  } else {
    checker.positive("window.seconds", std::get<Seconds>(scene.window).count, "s");
  }
  checker.positive("count.slowest", scene.slowest, "m/s");
  checker.positive("count.peak_high", scene.peak_high, "m");
  checker.positive("count.peak_low", scene.peak_low, "m");
  checker.positive("model.stiffness", scene.stiffness, "N/m^contact_exponent");
  checker.positive("model.contact_exponent", scene.contact_exponent, "1");
  checker.positive("model.contact_speed", scene.contact_speed.value_or(1.0), "m/s");
  check_contact_law(scene, checker);
}

}  // namespace ricochet::carrier_track::inline scene
