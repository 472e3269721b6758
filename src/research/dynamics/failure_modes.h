#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "problems/carrier_track/reference_integrators/integrator.h"
#include "src/report/json.h"

/// What numerical methods do where hard walls and dry friction are hard to compute, against truths
/// in closed form.
namespace ricochet::studies::dynamics {

/// How a method is set. Loose: relative tolerance 1e-4 or 30 steps in the time that the
/// motion takes to swing or fly once; tight: 1e-10 or 1000 steps.
enum class Strictness { loose, tight };

/// The control to run a method with where the motion swings or flies once in `once` [s].
double control_of(const carrier_track::Integrator& integrator, Strictness strictness, double once);

/// A ball dropped on a floor, restitution 0.8: infinitely many impacts up to a known time.
struct Zeno {
  bool finished;
  std::size_t impacts;          ///< seen
  std::optional<double> rest;   ///< [s], its last impact; nothing if it never comes to rest
  double rest_late;             ///< [s], last impact after the true end of all impacts, or before
  std::optional<double> error;  ///< [s], largest of the first twenty impact times
  double end_of_impacts;        ///< [s], the true one
};
Zeno zeno_of(const carrier_track::Integrator& integrator, Strictness strictness);

/// Share of swings, started at evenly spaced angles, of which a method says rightly whether a wall
/// at the summit is touched: the wall is `overshoot` swings below the summit, or above if < 0.
double grazes_right(const carrier_track::Integrator& integrator, Strictness strictness,
                    double overshoot);

/// A block under dry friction and forces next to it.
struct Sticking {
  double stop_error;  ///< share of its way by which a sliding block stops wrongly
  double creep;       ///< [m/s], of a block that 0.9999 of its friction pushes at
  /// Least excess, of 1e-1, 1e-2, ..., of a peak of the force over friction from which on a block
  /// always breaks loose, whatever the time of the peak.
  std::optional<double> noticed;
  bool breaks_loose_early;        ///< ever, with a peak short of friction by one of these
  std::optional<double> gave_up;  ///< the first excess at which it did not finish, its last
};
/// With excesses from 1e-1 over as many decades.
Sticking sticking_of(const carrier_track::Integrator& integrator, Strictness strictness,
                     int decades);

/// A ball that bounces with restitution 1 - loss, to energy e^(2 impacts).
struct Elastic {
  std::size_t impacts;  ///< asked for
  std::size_t seen;     ///< in the time in which it has those, no more than `impacts`
  double energy_ratio;  ///< energy at the last of these over the true one there
};
Elastic elastic_of(const carrier_track::Integrator& integrator, Strictness strictness, double loss,
                   std::size_t impacts);

/// Impacts per second in the scene "chaotic".
struct ChaoticRate {
  double error;        ///< relative to the mean of many exact runs
  double uncertainty;  ///< three standard errors: no method can be held to more
  bool finished;
};
ChaoticRate rate_of(const carrier_track::Integrator& integrator, Strictness strictness,
                    double seconds, int starts);

struct FailureModePlan {
  int decades;          ///< of the excess over friction
  std::size_t impacts;  ///< of the elastic ball
  double seconds;       ///< of the chaotic scene
  int starts;           ///< there
};

struct MethodFailures {
  std::string method;
  Zeno zeno;
  std::vector<double> touched, missed;  ///< shares right, by overshoot
  Sticking sticking;
  std::vector<Elastic> elastic;  ///< by loss
  ChaoticRate rate;
};

struct FailureModeStudy {
  FailureModePlan plan;
  std::vector<double> overshoots;  ///< from 1e-3 to 1e-15 swings
  std::vector<double> losses;
  std::vector<MethodFailures> loose, tight;  ///< a method each, the event-driven one first
};

FailureModeStudy study_failure_modes(const FailureModePlan& plan,
                                     const std::vector<carrier_track::Integrator>& integrators);

/// How every method does in every failure mode, in the loose control and in the tight one.
report::Json data_of(const FailureModeStudy& study);

}  // namespace ricochet::studies::dynamics
