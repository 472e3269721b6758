#pragma once

#include <array>
#include <cstdint>
#include <functional>

namespace ricochet::studies::variants {

/// Position [m] and velocity [m/s].
using OdeState = std::array<double, 2>;

/// Tolerances of MATLAB's ode45 (MathWorks, odeset: RelTol 1e-3 and AbsTol 1e-6 by default).
struct OdeTolerances {
  double relative = 1e-3;
  double absolute = 1e-6;
};

/// The Dormand-Prince pair (doi:10.1016/0771-050X(80)90013-3) with the step control of ode45
/// (Shampine and Reichelt 1997, doi:10.1137/S1064827594276424): the error, each component's divided
/// by the larger of its magnitude and absolute / relative, is held below the relative tolerance; no
/// step is longer than a tenth of the window or five times the last.
class Ode45 {
 public:
  using Slope = std::function<OdeState(const OdeState& state, double time)>;

  Ode45(Slope slope, const OdeState& start, double window, const OdeTolerances& tolerances);

  double time() const { return time_; }
  const OdeState& state() const { return state_; }

  /// Makes one accepted step, not beyond the end of the window. Throws std::runtime_error if no
  /// step is small enough.
  void step();

  std::int64_t steps() const { return steps_; }  ///< accepted and rejected

 private:
  double longest() const { return 0.1 * window_; }

  Slope slope_;
  double window_;
  OdeTolerances tolerances_;
  double time_ = 0;
  OdeState state_;
  OdeState rate_;  // of the state
  double length_;  // [s], of the next step
  std::int64_t steps_ = 0;
};

}  // namespace ricochet::studies::variants
