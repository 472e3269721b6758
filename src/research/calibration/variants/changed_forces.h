#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "problems/carrier_track/events/event.h"
#include "problems/carrier_track/flight/applied_forces.h"
#include "src/studies/trials/what_if.h"

namespace ricochet::studies::trials {

/// The applied forces of a scene at constant speed with what a WhatIf adds: as those of
/// AppliedForces on each of the pieces of time in which the further force is held and the press of
/// y keeps its sign. For HardWallMotion.
class WhatIfForces {
 public:
  using Path = carrier_track::Flight<double>;

  /// Both must outlive it.
  WhatIfForces(const carrier_track::Scene& scene, const WhatIf& what_if);

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

  /// The size of the force along y over the mass, as a path whose forces it is until reach().
  Path press() const;

 private:
  void tick(double time);
  void begin_piece();
  double until_across_turns() const;

  const WhatIf& what_if_;
  double mass_;
  carrier_track::AppliedForces<double> plate_;
  std::optional<carrier_track::AppliedForces<double>> across_;
  double time_ = 0;
  double until_ = std::numeric_limits<double>::infinity();  // [s], the end of the piece
  std::size_t interval_ = 0;
  double held_ = 0;         // [m/s^2]
  double across_sign_ = 1;  // of the force along y
};

/// Coulomb friction on a steady normal force, and on the press of y. For HardWallMotion.
struct WhatIfFriction {
  using Path = WhatIfForces::Path;

  double steady;                         ///< [m/s^2]
  double coefficient = 0;                ///< of the press
  const WhatIfForces* forces = nullptr;  ///< that press, where the coefficient is not 0

  double bound() const;
  double size(double of_forces) const;
  double reach(double of_forces) const { return of_forces; }
  Path flight(const WhatIfForces& applied, double position, double velocity, int direction) const;
  carrier_track::Event release(const Path& held, bool may_rise, bool may_fall, double horizon,
                               std::int64_t& evaluations) const;
  bool varies() const { return coefficient > 0; }
};

}  // namespace ricochet::studies::trials
