#include "src/research/paper/sustained_bouncing.h"

#include <cmath>
#include <numbers>

#include "src/core/bracketed_root.h"

namespace ricochet::carrier_track::inline paper {
namespace {

using std::numbers::pi;

/// A motion with one impact per turn whose velocity is zero at the angle t after departure, in
/// units of the pull: forces by pull, speeds by pull / (mass omega), time by 1 / omega.
class Orbit {
 public:
  Orbit(double turning_angle, double friction, double restitution)
      : t_(turning_angle), friction_(friction), share_(restitution / (1 + restitution)) {}

  /// Momentum over one turn: the impact turns speed / e into speed.
  double speed() const { return share_ * 2 * (pi - friction_ * (pi - t_)); }

  /// A sin(angle of departure): back on the wall after one turn.
  double sine() const { return speed() - pi - friction_ * (2 * t_ - t_ * t_ / (2 * pi) - pi); }

  /// A cos(angle of departure).
  double cosine() const { return numerator() / std::sin(t_); }

  /// sin^3 t times half the derivative of A^2 with respect to t. In [pi, 2 pi] it falls from
  /// positive to negative, and A is infinite at both ends.
  double decline() const {
    const double sine_slope = speed_slope() - friction_ * (2 - t_ / pi);
    const double at_top_slope = sine_slope + (1 + friction_) - speed_slope();
    const double s = std::sin(t_);
    const double c = std::cos(t_);
    const double n = numerator();
    const double slope = at_top_slope - sine_slope * c + sine() * s;
    return sine() * sine_slope * s * s * s + n * (slope * s - n * c);
  }

 private:
  double speed_slope() const { return 2 * share_ * friction_; }

  /// A sin(angle at the top), where the velocity is zero.
  double at_top() const { return sine() + (1 + friction_) * t_ - speed(); }

  double numerator() const { return at_top() - sine() * std::cos(t_); }

  double t_;
  double friction_;
  double share_;
};

/// Returns true if a body that departs so rises without a halt up to its summit: its velocity is
/// positive where the drive first overcomes pull and friction, which is its minimum on the way.
bool rises_at_once(double force, double angle, double speed, double friction) {
  if (force <= 1 + friction) return true;
  const double later = -std::acos((1 + friction) / force);
  if (later <= angle) return true;
  return speed - (1 + friction) * (later - angle) + force * (std::sin(later) - std::sin(angle)) > 0;
}

/// Amplitude of the drive over omega^2 [kg m]; nothing if the scene's forces are not a steady pull
/// onto the lower wall and a drive.
std::optional<double> drive_of(const Scene& scene) {
  if (scene.pull_rotates || scene.centrifugal != Centrifugal::projected) return std::nullopt;
  const double drive = std::abs(scene.centrifugal_mass_radius - scene.slider_mass_radius);
  if (!(drive > 0) || !(scene.pull > 0)) return std::nullopt;
  return drive;
}

double friction_force(const Scene& scene) {
  return scene.friction * scene.normal_force;
}

}  // namespace

std::optional<SustainedBouncing> sustained_bouncing(double pull, double friction_force,
                                                    double restitution) {
  if (!(friction_force >= 0 && friction_force < pull)) return std::nullopt;
  if (!(restitution > 0 && restitution < 1)) return std::nullopt;
  const double friction = friction_force / pull;
  const auto orbit = [&](double t) { return Orbit(t, friction, restitution); };
  const auto decline = [&](double t) { return orbit(t).decline(); };
  const auto bracket = bracketed_root(decline, pi, 2 * pi, decline(pi), decline(2 * pi),
                                      boost::math::tools::eps_tolerance<double>());
  const double t = (bracket.first + bracket.second) / 2;
  const double sine = orbit(t).sine();
  const double cosine = orbit(t).cosine();
  const double force = std::hypot(sine, cosine);
  const double angle = std::atan2(sine, cosine);
  const double speed = orbit(t).speed();
  if (!rises_at_once(force, angle, speed, friction)) return std::nullopt;
  const double height =
      (speed - sine) * t - (1 + friction) * t * t / 2 + cosine - force * std::cos(angle + t);
  return SustainedBouncing{pull * force, angle, t, pull * speed, pull * height};
}

std::optional<SustainedBouncing> sustained_bouncing(const Scene& scene) {
  if (!drive_of(scene)) return std::nullopt;
  return sustained_bouncing(scene.pull, friction_force(scene), scene.restitution_lower);
}

std::optional<double> sustained_bouncing_speed(const Scene& scene) {
  const auto limit = sustained_bouncing(scene);
  if (!limit) return std::nullopt;
  return std::sqrt(limit->force / *drive_of(scene));
}

std::optional<double> sustained_bouncing_height(const Scene& scene) {
  const auto limit = sustained_bouncing(scene);
  if (!limit) return std::nullopt;
  return limit->height / limit->force * *drive_of(scene) / scene.mass;
}

std::optional<double> lift_off_speed(const Scene& scene) {
  const auto drive = drive_of(scene);
  if (!drive) return std::nullopt;
  return std::sqrt((scene.pull + friction_force(scene)) / *drive);
}

}  // namespace ricochet::carrier_track::inline paper
