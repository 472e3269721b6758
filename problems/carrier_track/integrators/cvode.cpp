#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_version.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <array>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>

#include "problems/carrier_track/integrators/located_events.h"
#include "problems/carrier_track/integrators/methods.h"

namespace ricochet::carrier_track {
namespace {

/// Owns a C object that is freed through a pointer to its handle.
template <class Handle, auto free>
class Owned {
 public:
  Owned() = default;
  Owned(const Owned&) = delete;
  Owned& operator=(const Owned&) = delete;
  ~Owned() {
    if (handle_) release(handle_);
  }
  Owned& operator=(Handle handle) {
    handle_ = handle;
    return *this;
  }
  operator Handle() const { return handle_; }
  Handle* address() { return &handle_; }

 private:
  static void release(Handle& handle) {
    if constexpr (std::is_invocable_v<decltype(free), Handle*>) {
      free(&handle);
    } else {
      free(handle);
    }
  }
  Handle handle_ = nullptr;
};

void require(bool done, const char* what) {
  if (!done) throw std::runtime_error(std::string("CVODE: ") + what);
}

/// A return flag below zero is an error.
void require_flag(int flag) {
  if (flag >= 0) return;
  char* name = CVodeGetReturnFlagName(flag);
  const std::string text = name;
  std::free(name);
  require(false, text.c_str());
}

/// Walls and turns are CVODE's own root functions. It looks for sign changes over its steps: what
/// starts and ends within one is missed. Turns are watched without friction too, where nothing
/// happens at them: with the walls alone whole impacts, beyond a wall and back in one step, are
/// lost.
class CvodeFlight : public FlightMethod {
 public:
  CvodeFlight(const FlightSetting& setting, double tolerance, int method) : setting_(setting) {
    require_flag(SUNContext_Create(nullptr, context_.address()));
    vector_ = N_VMake_Serial(2, state_.data(), context_);
    require(vector_ != nullptr, "no memory for the state");
    memory_ = CVodeCreate(method, context_);
    require(memory_ != nullptr, "no memory for the integrator");
    require_flag(CVodeSetErrHandlerFn(
        memory_, [](int, const char*, const char*, char*, void*) {}, nullptr));
    require_flag(CVodeInit(memory_, slope, 0.0, vector_));
    require_flag(CVodeSetUserData(memory_, this));
    require_flag(CVodeSStolerances(memory_, tolerance, tolerance * setting.length));
    require_flag(CVodeSetMaxNumSteps(memory_, most_steps));
    // NOTE: the forces do not depend on the state, so a fixed-point iteration settles at once and
    // saves the linear algebra of Newton's, for BDF too.
    solver_ = SUNNonlinSol_FixedPoint(vector_, 0, context_);
    require(solver_ != nullptr, "no memory for the iteration");
    require_flag(CVodeSetNonlinearSolver(memory_, solver_));
    require_flag(CVodeRootInit(memory_, 3, walls_and_turn));
    std::array<int, 3> inwards = {-1, -1, 0};
    require_flag(CVodeSetRootDirection(memory_, inwards.data()));
    require_flag(CVodeSetNoInactiveRootWarn(memory_));
  }

  Landing fly(const Leg& leg) override {
    start_ = leg.start;
    friction_ = leg.direction * setting_.forces.friction;
    state_ = {leg.state.position, leg.state.velocity};
    require_flag(CVodeReInit(memory_, 0.0, vector_));
    double time = 0;
    for (;;) {
      const int flag = CVode(memory_, leg.longest, vector_, &time, CV_NORMAL);
      if (flag == CV_TOO_CLOSE) {  // what is left of the window is lost in rounding
        const double position = leg.state.position + leg.longest * leg.state.velocity;
        return {Finish::limit, leg.longest, {position, leg.state.velocity}};
      }
      require_flag(flag);
      // NOTE: CVODE's own limit is for one call, and every turn returns.
      long steps = 0;
      require_flag(CVodeGetNumSteps(memory_, &steps));
      require(steps_ + steps <= most_steps, "more than 1000000 steps");
      std::array<int, 3> found{};
      if (flag == CV_ROOT_RETURN) require_flag(CVodeGetRootInfo(memory_, found.data()));
      const bool wall = found[0] != 0 || found[1] != 0;
      const bool turn = found[2] != 0 && setting_.forces.friction > 0;
      if (flag == CV_ROOT_RETURN && !wall && !turn) continue;
      steps_ += steps;
      const Finish finish = found[0] != 0   ? Finish::lower_wall
                            : found[1] != 0 ? Finish::upper_wall
                            : turn          ? Finish::turn
                                            : Finish::limit;
      return {finish, finish == Finish::limit ? leg.longest : time, {state_[0], state_[1]}};
    }
  }

  std::int64_t evaluations() const override { return evaluations_; }

 private:
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

  static void free_memory(void** memory) { CVodeFree(memory); }

  FlightSetting setting_;
  std::array<double, 2> state_{};
  // NOTE: freed from the last to the first; the context has to outlive the others.
  Owned<SUNContext, SUNContext_Free> context_;
  Owned<N_Vector, N_VDestroy> vector_;
  Owned<SUNNonlinearSolver, SUNNonlinSolFree> solver_;
  Owned<void*, free_memory> memory_;
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
            } catch (const std::runtime_error& error) {  // of the set-up
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

}  // namespace ricochet::carrier_track
