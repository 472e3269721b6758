#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <array>
#include <stdexcept>
#include <string>

#include "problems/carrier_track/check/reference_integrators/cvode_memory.h"
#include "problems/carrier_track/check/reference_integrators/located_events.h"
#include "problems/carrier_track/check/reference_integrators/methods.h"

namespace ricochet::carrier_track::inline reference_integrators {
namespace {

/// Walls and velocity zeros are CVODE's own root functions. It looks for sign changes over its
/// steps and misses an event that starts and ends within one. Velocity zeros are roots without
/// friction too, where they change nothing: with the walls alone, impacts that go beyond a wall and
/// back in one step are lost.
class CvodeFlight : public FlightMethod {
 public:
  CvodeFlight(const FlightSetting& setting, double tolerance, int method)
      : setting_(setting), memory_(method, slope, this, tolerance, tolerance * setting.length) {
    require_cvode_flag(CVodeSetMaxNumSteps(memory_.get(), most_steps));
    // NOTE: the forces do not depend on the state, so a fixed-point iteration converges at once and
    // saves the linear algebra of Newton's method, for BDF too.
    solver_ = SUNNonlinSol_FixedPoint(memory_.vector(), 0, memory_.context());
    require_cvode(solver_ != nullptr, "no memory for the iteration");
    require_cvode_flag(CVodeSetNonlinearSolver(memory_.get(), solver_));
    require_cvode_flag(CVodeRootInit(memory_.get(), 3, walls_and_turn));
    std::array<int, 3> inwards = {-1, -1, 0};
    require_cvode_flag(CVodeSetRootDirection(memory_.get(), inwards.data()));
    require_cvode_flag(CVodeSetNoInactiveRootWarn(memory_.get()));
  }

  Landing fly(const Leg& leg) override { return fly(leg, 0); }

  std::int64_t evaluations() const override { return evaluations_; }

 private:
  /// The first step has that length [s]; if it is 0, CVODE chooses it.
  Landing fly(const Leg& leg, double first_step) {
    start_ = leg.start;
    friction_ = leg.direction * setting_.forces.friction;
    memory_.state() = {leg.state.position, leg.state.velocity};
    require_cvode_flag(CVodeReInit(memory_.get(), 0.0, memory_.vector()));
    require_cvode_flag(CVodeSetInitStep(memory_.get(), first_step));
    double time = 0;
    for (;;) {
      const int flag = CVode(memory_.get(), leg.longest, memory_.vector(), &time, CV_NORMAL);
      if (flag == CV_TOO_CLOSE) {  // the rest of the window is below rounding
        const double position = leg.state.position + leg.longest * leg.state.velocity;
        return {Finish::limit, leg.longest, {position, leg.state.velocity}};
      }
      require_cvode_flag(flag);
      // NOTE: CVODE's own limit is per call, and every velocity zero returns.
      long steps = 0;
      require_cvode_flag(CVodeGetNumSteps(memory_.get(), &steps));
      require_cvode(steps_ + steps <= most_steps, "more than 1000000 steps");
      std::array<int, 3> found{};
      if (flag == CV_ROOT_RETURN) require_cvode_flag(CVodeGetRootInfo(memory_.get(), found.data()));
      const bool wall = found[0] != 0 || found[1] != 0;
      const bool turn = found[2] != 0 && setting_.forces.friction > 0;
      if (flag == CV_ROOT_RETURN && !wall && !turn) continue;
      steps_ += steps;
      if (turn && !wall && steps == 1 && pushes_on(leg, time)) return fly(leg, next_first_step());
      const Finish finish = found[0] != 0   ? Finish::lower_wall
                            : found[1] != 0 ? Finish::upper_wall
                            : turn          ? Finish::turn
                                            : Finish::limit;
      return {finish,
              finish == Finish::limit ? leg.longest : time,
              {memory_.state()[0], memory_.state()[1]}};
    }
  }

  /// Returns true if the forces exceed friction in the leg's direction. Velocity cannot be zero
  /// there.
  //
  // NOTE: the first step is of first order. If the excess over friction ends within it, it ends at
  // a negative velocity. Its linear interpolation puts the velocity zero at the very start, from
  // where the body would start again, forever. A step that ends before the excess does is correct.
  bool pushes_on(const Leg& leg, double time) const {
    return leg.direction * (setting_.forces.applied(leg.start + time) - friction_) > 0;
  }

  double next_first_step() const {
    double step = 0;
    require_cvode_flag(CVodeGetActualInitStep(memory_.get(), &step));
    return 0.1 * step;
  }

  static int slope(double time, N_Vector state, N_Vector rate, void* data) {
    auto& self = *static_cast<CvodeFlight*>(data);
    ++self.evaluations_;
    NV_Ith_S(rate, 0) = NV_Ith_S(state, 1);
    NV_Ith_S(rate, 1) = self.setting_.forces.applied(self.start_ + time) - self.friction_;
    return 0;
  }

  static int walls_and_turn(double /*time*/, N_Vector state, double* value, void* data) {
    const auto& self = *static_cast<CvodeFlight*>(data);
    value[0] = NV_Ith_S(state, 0) - self.setting_.gap.lower;
    value[1] = self.setting_.gap.upper - NV_Ith_S(state, 0);
    value[2] = NV_Ith_S(state, 1);
    return 0;
  }

  FlightSetting setting_;
  CvodeMemory memory_;
  // NOTE: freed before the context of the memory.
  Owned<SUNNonlinearSolver, SUNNonlinSolFree> solver_;
  double start_ = 0;     // [s], of the leg
  double friction_ = 0;  // [m/s^2], signed
  std::int64_t steps_ = 0;
  std::int64_t evaluations_ = 0;
};

Integrator cvode(const std::string& name, int method) {
  return {name, "SUNDIALS " SUNDIALS_VERSION, "relative tolerance",
          [method](const Scene& scene, double tolerance) {
            Outcome outcome;
            try {
              CvodeFlight flight(flight_setting(scene), tolerance, method);
              outcome = run_with_located_events(scene, flight);
            } catch (const std::runtime_error& error) {  // in the set-up
              outcome.failure = error.what();
            }
            return outcome;
          }};
}

}  // namespace

Integrator cvode_adams() {
  return cvode("cvode-adams", CV_ADAMS);
}

Integrator cvode_bdf() {
  return cvode("cvode-bdf", CV_BDF);
}

}  // namespace ricochet::carrier_track::inline reference_integrators
