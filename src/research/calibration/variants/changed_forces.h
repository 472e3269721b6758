#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "problems/carrier_track/events/event.h"
#include "problems/carrier_track/flight/applied_forces.h"
#include "src/research/calibration/variants/motion_change.h"

namespace ricochet::studies::variants {

/// The applied forces of a scene at constant speed with the additions of a MotionChange: like
/// AppliedForces on each interval in which the added force is held and the force along y keeps its
/// sign. For HardWallMotion.
class ChangedForces {
 public:
  using Path = carrier_track::Flight<double>;

  /// Both must outlive it.
  ChangedForces(const carrier_track::Scene& scene, const MotionChange& change);

  double sum() const { return plate_.sum() + held_; }
  double plain_sum() const { return sum(); }
  double rate() const { return plate_.rate(); }
  double size() const { return plate_.size() + std::abs(held_); }
  double jerk_bound() const { return plate_.jerk_bound(); }
  double reach() const { return until_ - time_; }

  Path flight(double position, double velocity, double further) const {
    return plate_.flight(position, velocity, further + held_);
  }

  void pass(double time) {
    plate_.pass(time);
    tick(time);
  }
  void arrive(const Path& there, double time) {
    plate_.arrive(there, time);
    tick(time);
  }

  /// Magnitude of the force along y over the mass, as a path valid until reach().
  Path press() const;

 private:
  void tick(double time);
  void begin_piece();
  double until_across_turns() const;

  const MotionChange& change_;
  double mass_;
  carrier_track::AppliedForces<double> plate_;
  std::optional<carrier_track::AppliedForces<double>> across_;
  double time_ = 0;
  double until_ = std::numeric_limits<double>::infinity();  // [s], the end of the interval
  std::size_t interval_ = 0;
  double held_ = 0;         // [m/s^2]
  double across_sign_ = 1;  // of the force along y
};

/// Coulomb friction with a steady normal force and the one from the force along y. For
/// HardWallMotion.
struct ChangedFriction {
  using Path = ChangedForces::Path;

  double steady;                          ///< [m/s^2]
  double coefficient = 0;                 ///< of the force along y
  const ChangedForces* forces = nullptr;  ///< source of that force, if the coefficient is not 0

  double bound() const;
  double size(double of_forces) const;
  double reach(double of_forces) const { return of_forces; }
  Path flight(const ChangedForces& applied, double position, double velocity, int direction) const;
  carrier_track::Event release(const Path& held, bool may_rise, bool may_fall, double horizon,
                               std::int64_t& evaluations) const;
  bool varies() const { return coefficient > 0; }
};

}  // namespace ricochet::studies::variants
