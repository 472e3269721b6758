#include "src/studies/paper/theory.h"

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "src/core/bracketed_root.h"

namespace ricochet::carrier_track::inline paper {

namespace {

using Points = std::vector<ThresholdPoint>;
using Solved = std::optional<std::vector<double>>;

double log_loss(const ThresholdPoint& point) {
  return std::log((1 - point.restitution) / (1 + point.restitution));
}

/// The factor of a parameter of a formula in ln w.
using Factor = double (*)(const ThresholdPoint&);

double one(const ThresholdPoint&) {
  return 1;
}

double friction(const ThresholdPoint& point) {
  return point.friction;
}

double disturbance(const ThresholdPoint& point) {
  return point.disturbance;
}

/// ln w = power ln R + ln c + constants times factors. The first constant is c.
Formula linear_formula(std::string words, std::vector<std::string> names, double power,
                       std::vector<Factor> factors) {
  factors.insert(factors.begin(), one);
  const auto fit = [power, factors](const Points& points) -> Solved {
    const auto rows = static_cast<Eigen::Index>(points.size());
    const auto columns = static_cast<Eigen::Index>(factors.size());
    Eigen::MatrixXd matrix(rows, columns);
    Eigen::VectorXd right(rows);
    for (Eigen::Index i = 0; i < rows; ++i) {
      const ThresholdPoint& point = points[static_cast<std::size_t>(i)];
      right[i] = std::log(point.threshold) - power * log_loss(point);
      for (Eigen::Index j = 0; j < columns; ++j) {
        matrix(i, j) = factors[static_cast<std::size_t>(j)](point);
      }
    }
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(matrix);
    if (qr.rank() < columns) return std::nullopt;
    const Eigen::VectorXd solution = qr.solve(right);
    std::vector<double> constants(solution.begin(), solution.end());
    constants[0] = std::exp(constants[0]);
    return constants;
  };
  const auto threshold = [power, factors](const std::vector<double>& constants,
                                          const ThresholdPoint& point) {
    double logarithm = power * log_loss(point) + std::log(constants[0]);
    for (std::size_t j = 1; j < factors.size(); ++j) logarithm += constants[j] * factors[j](point);
    return std::exp(logarithm);
  };
  return {std::move(words), std::move(names), fit, threshold};
}

/// Half the logarithm of the least drive over the pull, for a normal force of `ratio` times the
/// pull. Not finite if that limit does not exist.
double log_bouncing(double ratio, const ThresholdPoint& point) {
  const auto limit = sustained_bouncing(1.0, ratio * point.friction, point.restitution);
  return limit ? 0.5 * std::log(limit->force) : std::numeric_limits<double>::infinity();
}

/// Sum of squares at the best c, and its logarithm.
struct BouncingFit {
  double squares, log_factor;
};

BouncingFit bouncing_fit(double ratio, const Points& points) {
  std::vector<double> differences;
  double sum = 0;
  for (const ThresholdPoint& point : points) {
    differences.push_back(std::log(point.threshold) - log_bouncing(ratio, point));
    sum += differences.back();
  }
  const double mean = sum / static_cast<double>(points.size());
  double squares = 0;
  for (const double difference : differences) squares += std::pow(difference - mean, 2);
  return {std::isfinite(mean) ? squares : std::numeric_limits<double>::max(), mean};
}

/// The best ratio of a coarse scan, refined between its neighbours. Friction must be smaller than
/// the pull, which bounds the ratio.
Solved fit_bouncing(const Points& points) {
  double highest = 0;
  for (const ThresholdPoint& point : points) highest = std::max(highest, point.friction);
  if (!(highest > 0)) return std::nullopt;
  constexpr int parts = 40;
  const double bound = (1 - 1e-9) / highest;
  const auto squares = [&](double ratio) { return bouncing_fit(ratio, points).squares; };
  int best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k <= parts; ++k) {
    const double here = squares(bound * k / parts);
    if (here < least) {
      least = here;
      best = k;
    }
  }
  const double refined =
      boost::math::tools::brent_find_minima(squares, bound * std::max(best - 1, 0) / parts,
                                            bound * std::min(best + 1, parts) / parts,
                                            std::numeric_limits<double>::digits / 2)
          .first;
  const double ratio = squares(refined) < squares(0) ? refined : 0;
  const double log_factor = bouncing_fit(ratio, points).log_factor;
  if (!std::isfinite(log_factor)) return std::nullopt;
  return std::vector<double>{std::exp(log_factor), ratio};
}

Formula bouncing_formula() {
  return {"w = c √S(r μ)",
          {"c", "r"},
          fit_bouncing,
          [](const std::vector<double>& constants, const ThresholdPoint& point) {
            return constants[0] * std::exp(log_bouncing(constants[1], point));
          }};
}

std::vector<double> predictions(const Formula& formula, const std::vector<double>& constants,
                                const Points& points) {
  std::vector<double> predicted;
  for (const ThresholdPoint& point : points) {
    predicted.push_back(formula.threshold(constants, point));
  }
  return predicted;
}

std::optional<double> left_out_error(const Formula& formula, const Points& points) {
  double squares = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    Points others = points;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    const Solved constants = formula.fit(others);
    if (!constants) return std::nullopt;
    const double predicted = formula.threshold(*constants, points[i]);
    if (!std::isfinite(predicted)) return std::nullopt;
    squares += std::pow(std::log(predicted / points[i].threshold), 2);
  }
  return std::sqrt(squares / static_cast<double>(points.size()));
}

}  // namespace

PredictionErrors errors_of(const Points& points, const std::vector<double>& predicted) {
  const auto size = static_cast<double>(points.size());
  double mean = 0;
  for (const ThresholdPoint& point : points) mean += std::log(point.threshold) / size;
  PredictionErrors errors{};
  double squares = 0;
  double variation = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double error = std::log(predicted[i] / points[i].threshold);
    squares += error * error;
    variation += std::pow(std::log(points[i].threshold) - mean, 2);
    if (i == 0 || std::abs(error) > std::abs(errors.worst)) {
      errors.worst = error;
      errors.worst_id = points[i].id;
    }
  }
  errors.rms = std::sqrt(squares / size);
  if (variation > 0) errors.explained = 1 - squares / variation;
  return errors;
}

std::vector<Formula> all_formulas() {
  return {linear_formula("w = c", {"c"}, 0, {}),
          square_root_formula(),
          linear_formula("w = c Rᵖ", {"c", "p"}, 0, {log_loss}),
          friction_formula(),
          linear_formula("w = c √R exp(k μ + d D)", {"c", "k", "d"}, 0.5, {friction, disturbance}),
          linear_formula("w = c Rᵖ exp(k μ + d D)", {"c", "p", "k", "d"}, 0,
                         {log_loss, friction, disturbance}),
          bouncing_formula()};
}

Formula square_root_formula() {
  return linear_formula("w = c √R", {"c"}, 0.5, {});
}

Formula friction_formula() {
  return linear_formula("w = c √R exp(k μ)", {"c", "k"}, 0.5, {friction});
}

std::optional<FormulaFit> fitted(const Formula& formula, const Points& points) {
  if (points.size() <= formula.constants.size()) return std::nullopt;
  const Solved constants = formula.fit(points);
  if (!constants) return std::nullopt;
  return FormulaFit{*constants, errors_of(points, predictions(formula, *constants, points)),
                    left_out_error(formula, points)};
}

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

TheoreticalMotion on_arc(double radius, double omega) {
  return {radius * omega, radius * omega * omega};
}

TheoreticalMotion on_crossing(double radius, double omega, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {radius * omega / (c * c),
          radius * omega * omega / (c * c * c) * std::sqrt(c * c * c * c + 4 * s * s * s * s)};
}

std::vector<SpeedKnot<double>> crossing_profile(double omega, double angle, double turns) {
  std::vector<SpeedKnot<double>> knots;
  for (int half = 0; half < std::ceil(2 * turns); ++half) {
    const double middle = std::numbers::pi * (half + 0.5);
    // The leading plate has turned by `driven` from the tangent, or has as far to go.
    for (const double share : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
      const double driven = angle * (1 - std::abs(share));
      knots.push_back({(middle + share * angle) / omega, on_crossing(1.0, omega, driven).speed});
    }
  }
  return knots;
}

}  // namespace ricochet::carrier_track::inline paper
