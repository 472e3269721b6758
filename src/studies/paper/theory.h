#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ricochet/scene.h"

/// How much of a list of thresholds simple formulas explain.
namespace ricochet::carrier_track::inline paper {

/// The threshold of a case, of the paper or computed.
struct ThresholdPoint {
  std::string id;
  double restitution;  ///< e, in [0, 1)
  double friction;     ///< mu, >= 0
  double disturbance;  ///< D [N]
  double threshold;    ///< w [rad/s], > 0
};

/// Errors of predicted thresholds, all as ln(predicted / threshold).
struct PredictionErrors {
  double rms;                       ///< root mean square
  std::optional<double> explained;  ///< share of the variance of ln w, <= 1; none if all are equal
  double worst;                     ///< the largest in size, with its sign
  std::string worst_id;             ///< the case it belongs to
};

/// `predicted` [rad/s] > 0, one for each point; at least one.
PredictionErrors errors_of(const std::vector<ThresholdPoint>& points,
                           const std::vector<double>& predicted);

/// A family of thresholds with parameters to fit, by least squares of ln w.
struct Formula {
  std::string words;
  std::vector<std::string> constants;  ///< their names
  /// The best parameters; nothing if the points do not determine them.
  std::function<std::optional<std::vector<double>>(const std::vector<ThresholdPoint>&)> fit;
  /// w [rad/s] at a point, whose threshold is not used.
  std::function<double(const std::vector<double>& constants, const ThresholdPoint&)> threshold;
};

/// With R = (1 - e) / (1 + e), from one parameter to four; in the last, S(F / P) is the least drive
/// over the pull P that sustains bouncing with friction F, and r stands for normal force over pull
/// (problems/carrier_track/sustained_bouncing.h). Friction and disturbance enter as exp(k μ) and
/// exp(d D), which are linear in ln w; if the points have only two frictions, (1 + k μ) would fit
/// equally well.
std::vector<Formula> all_formulas();

/// Of the above, w = c √R.
Formula square_root_formula();

/// Of the above, w = c √R exp(k μ).
Formula friction_formula();

struct FormulaFit {
  std::vector<double> constants;
  PredictionErrors errors;
  /// Root mean square of the errors at points left out of the fit, one at a time; nothing if the
  /// others do not determine the parameters, or if the formula gives no threshold there.
  std::optional<double> left_out;
};

/// Nothing unless there are more points than parameters and they determine these.
std::optional<FormulaFit> fitted(const Formula& formula, const std::vector<ThresholdPoint>& points);

// The least drive that keeps a body bouncing on one wall, in closed form. A body that is pulled
// onto a wall and driven by a force A cos(angle), whose angle turns evenly, can hit the wall once
// a turn, always at the same angle and speed. The drive must replace the losses at impacts and by
// friction, so there is a least amplitude A, below which this motion does not exist.
//
// Without friction A = pi pull (1 - e) / (1 + e), where e is the restitution. Over one turn the
// momentum of the pull equals the change at the impact, so that the body departs at 2 pi e pull /
// ((1 + e) mass omega). The condition that it is back on the wall after the turn gives A sin(angle
// of departure) = -pi pull (1 - e) / (1 + e), and a sine is at least -1.
//
// Coulomb friction adds to the pull on the way up and subtracts from it on the way down, so both
// balances depend on the angle by which the drive turns until the body is at the top. The velocity
// is zero there, which is a third equation. The three give A as a function of that turning angle,
// in closed form; the least A is where its derivative, also in closed form, is zero.
//
// Assumptions: friction smaller than the pull, no halt on the way up or down, and a flight that
// stays below the other wall. Below the limit a body comes to rest if the drive cannot lift it
// (pull and friction); otherwise it is thrown again every turn, with halts on the wall or in the
// air.

/// The motion at its limit. `omega` [rad/s] is the speed at which the drive turns.
struct SustainedBouncing {
  double force;            ///< [N], the least amplitude of the drive
  double departure_angle;  ///< [rad], of the drive when the body leaves the wall, in [-pi, pi]
  double turning_angle;    ///< [rad], by which it has turned since, when the body is at the top
  double departure_speed;  ///< [N], mass omega times the speed at departure [m/s]
  double height;           ///< [N], mass omega^2 times the height [m]
};

/// For a body pulled [N] onto a wall with friction_force [N] in flight. Nothing unless 0 <=
/// friction_force < pull and 0 < restitution < 1, or if the restitution is so low (below about
/// 0.03) that the drive would turn more than once per flight.
std::optional<SustainedBouncing> sustained_bouncing(double pull, double friction_force,
                                                    double restitution);

/// For the scene's parameters on its lower wall; its speed, upper wall and disturbance have no
/// effect. Also nothing if pull or centrifugal force are not as assumed (a pull that rotates, a
/// centrifugal force that does not).
std::optional<SustainedBouncing> sustained_bouncing(const Scene& scene);

/// The speed [rad/s] from which the scene's drive sustains bouncing, without an upper wall. Nothing
/// if sustained_bouncing returns nothing or if there is no drive.
std::optional<double> sustained_bouncing_speed(const Scene& scene);

/// Speed and acceleration prescribed by the track, equations (1)-(5), Figure 3.
struct TheoreticalMotion {
  double speed;         ///< [m/s]
  double acceleration;  ///< [m/s^2]
};

/// On the circular arcs BE and FD, equations (1)-(2): r w and r w^2.
TheoreticalMotion on_arc(double radius, double omega);

/// On the straight crossing EF, equations (3)-(5). `angle` = phi_2 - phi_1 in (-pi/2, pi/2) [rad]
/// is the angle of the driving plate from the point where the crossing is tangent to its arc: it
/// rises from 0 until the next plate takes over half way, and then runs from the negative back to
/// 0. Equation (5) agrees with (4) only if the normal and tangential parts enclose 90 degrees +
/// angle; this reading is used here.
TheoreticalMotion on_crossing(double radius, double omega, double angle);

/// The speed [rad/s] of a carrier about its plate's axis, V / r of equations (1) and (3), while the
/// plate turns steadily at `omega` [rad/s] > 0: the middle of every half turn of the plate has a
/// crossing, where the plate turns from -`angle` to +`angle` in (0, pi/4) [rad]; there the speed
/// rises to omega / cos^2(angle) half way. Five knots per crossing approximate that curve. The
/// profile covers `turns`.
std::vector<SpeedKnot<double>> crossing_profile(double omega, double angle, double turns);

}  // namespace ricochet::carrier_track::inline paper
