#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "problems/carrier_track/check/integrator.h"
#include "src/report/results.h"

/// Errors of numerical methods where hard walls and dry friction are hard to compute, against exact
/// solutions in closed form.
namespace ricochet::studies::dynamics {

/// Setting of a method. Loose: relative tolerance 1e-4 or 30 steps per swing or flight; tight:
/// 1e-10 or 1000 steps.
enum class Strictness { loose, tight };

/// Returns the tolerance or step size of a method if a swing or flight takes `once` [s].
double control_of(const carrier_track::Integrator& integrator, Strictness strictness, double once);

/// A ball dropped on a floor, restitution 0.8: infinitely many impacts up to a known time.
struct Zeno {
  bool finished;
  std::size_t impacts;          ///< detected
  std::optional<double> rest;   ///< [s], its last impact; nothing if it never comes to rest
  double rest_late;             ///< [s], its last impact minus the true end of all impacts
  std::optional<double> error;  ///< [s], largest of the first twenty impact times
  double end_of_impacts;        ///< [s], the true one
};
Zeno zeno_of(const carrier_track::Integrator& integrator, Strictness strictness);

/// Returns the share of swings, started at evenly spaced angles, for which a method decides
/// correctly if a wall at the summit is touched: the wall is `overshoot` swings below the summit,
/// or above if < 0.
double grazes_right(const carrier_track::Integrator& integrator, Strictness strictness,
                    double overshoot);

/// A block under dry friction and forces next to it.
struct Sticking {
  double creep;  ///< [m/s], of a block pushed with 0.9999 of its friction
  /// Least excess, of 1e-1, 1e-2, ..., of a peak of the force over friction for which (and for all
  /// larger ones) a block always breaks loose, whatever the time of the peak.
  std::optional<double> noticed;
  bool breaks_loose_early;        ///< for any peak short of friction by one of these
  std::optional<double> gave_up;  ///< first excess at which a run did not finish; the last tried
};
/// With this number of excesses, from 1e-1 on by decades.
Sticking sticking_of(const carrier_track::Integrator& integrator, Strictness strictness,
                     int decades);

/// A ball that bounces with restitution 1 - loss, down to energy e^(2 impacts).
struct Elastic {
  std::size_t impacts;  ///< requested
  std::size_t seen;     ///< in the time of these impacts, at most `impacts`
  double energy_ratio;  ///< energy at the last of these over the true energy
};
Elastic elastic_of(const carrier_track::Integrator& integrator, Strictness strictness, double loss,
                   std::size_t impacts);

/// Impacts per second in the scene "chaotic".
struct ChaoticRate {
  double error;        ///< relative to the mean of many exact runs
  double uncertainty;  ///< three standard errors: a limit for every method
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
  std::vector<MethodFailures> loose, tight;  ///< one for each method, the event-driven one first
};

FailureModeStudy study_failure_modes(const FailureModePlan& plan,
                                     const std::vector<carrier_track::Integrator>& integrators);

/// Adds the errors of every method in every failure mode, with the tight and with the loose
/// setting.
void add_to(report::Results& results, const FailureModeStudy& study);

}  // namespace ricochet::studies::dynamics
