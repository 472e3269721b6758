#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_version.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <array>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "problems/carrier_track/check/integrator.h"
#include "problems/carrier_track/check/penalty.h"

namespace ricochet::carrier_track::inline reference_integrators {

/// Owns a C object that is freed through a pointer to its handle, or by its handle.
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

/// Throws std::runtime_error with `what` unless `done`.
void require_cvode(bool done, const char* what);

/// Throws std::runtime_error with the name of a negative return flag.
void require_cvode_flag(int flag);

/// CVODE's integrator of a position and a velocity, with one relative and one absolute tolerance
/// for both. Its nonlinear solver must still be set. Throws std::runtime_error if CVODE fails.
class CvodeMemory {
 public:
  /// `method` is CV_ADAMS or CV_BDF; `user` is passed to `slope`.
  CvodeMemory(int method, CVRhsFn slope, void* user, double tolerance, double absolute);

  std::array<double, 2>& state() { return state_; }
  SUNContext context() const { return context_; }
  N_Vector vector() const { return vector_; }
  void* get() const { return memory_; }

 private:
  static void free_memory(void** memory) { CVodeFree(memory); }

  std::array<double, 2> state_{};
  // NOTE: freed from the last to the first; the context must outlive the others.
  Owned<SUNContext, SUNContext_Free> context_;
  Owned<N_Vector, N_VDestroy> vector_;
  Owned<void*, free_memory> memory_;
};

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

void require_cvode(bool done, const char* what) {
  if (!done) throw std::runtime_error(std::string("CVODE: ") + what);
}

void require_cvode_flag(int flag) {
  if (flag >= 0) return;
  char* name = CVodeGetReturnFlagName(flag);
  const std::string text = name;
  std::free(name);
  require_cvode(false, text.c_str());
}

CvodeMemory::CvodeMemory(int method, CVRhsFn slope, void* user, double tolerance, double absolute) {
  require_cvode_flag(SUNContext_Create(nullptr, context_.address()));
  vector_ = N_VMake_Serial(2, state_.data(), context_);
  require_cvode(vector_ != nullptr, "no memory for the state");
  memory_ = CVodeCreate(method, context_);
  require_cvode(memory_ != nullptr, "no memory for the integrator");
  require_cvode_flag(CVodeSetErrHandlerFn(
      memory_, [](int, const char*, const char*, char*, void*) {}, nullptr));
  require_cvode_flag(CVodeInit(memory_, slope, 0.0, vector_));
  require_cvode_flag(CVodeSetUserData(memory_, user));
  require_cvode_flag(CVodeSStolerances(memory_, tolerance, absolute));
}

namespace {

class CvodeSteps : public StepMethod {
 public:
  CvodeSteps(const PenaltySystem& system, double tolerance, int method)
      : system_(system), memory_(method, slope, this, tolerance, tolerance * system.length) {
    method == CV_BDF ? solve_by_newton() : solve_by_fixed_point();
    require_cvode_flag(CVodeSetMaxStep(memory_.get(), longest_step(system.forces, system.window)));
    require_cvode_flag(CVodeSetStopTime(memory_.get(), system.window));
  }

  // NOTE: the method keeps its history, so it uses the given state only at the start.
  void step(double& time, State& state) override {
    if (time == 0) {
      memory_.state() = {state.position, state.velocity};
      require_cvode_flag(CVodeReInit(memory_.get(), 0.0, memory_.vector()));
    }
    require_cvode_flag(CVode(memory_.get(), system_.window, memory_.vector(), &time, CV_ONE_STEP));
    state = {memory_.state()[0], memory_.state()[1]};
  }

  std::int64_t evaluations() const override { return evaluations_; }

 private:
  void solve_by_fixed_point() {
    iteration_ = SUNNonlinSol_FixedPoint(memory_.vector(), 0, memory_.context());
    require_cvode(iteration_ != nullptr, "no memory for the iteration");
    require_cvode_flag(CVodeSetNonlinearSolver(memory_.get(), iteration_));
  }

  void solve_by_newton() {
    matrix_ = SUNDenseMatrix(2, 2, memory_.context());
    require_cvode(matrix_ != nullptr, "no memory for the matrix");
    linear_ = SUNLinSol_Dense(memory_.vector(), matrix_, memory_.context());
    require_cvode(linear_ != nullptr, "no memory for the linear solver");
    require_cvode_flag(CVodeSetLinearSolver(memory_.get(), linear_, matrix_));
    require_cvode_flag(CVodeSetJacFn(memory_.get(), jacobian));
  }

  static int slope(double time, N_Vector state, N_Vector rate, void* data) {
    auto& self = *static_cast<CvodeSteps*>(data);
    ++self.evaluations_;
    const State at{NV_Ith_S(state, 0), NV_Ith_S(state, 1)};
    NV_Ith_S(rate, 0) = at.velocity;
    NV_Ith_S(rate, 1) = self.system_.acceleration(time, at);
    return 0;
  }

  static int jacobian(double /*time*/, N_Vector state, N_Vector /*rate*/, SUNMatrix matrix,
                      void* data, N_Vector, N_Vector, N_Vector) {
    const auto& self = *static_cast<CvodeSteps*>(data);
    const auto slopes = self.system_.wall.slopes({NV_Ith_S(state, 0), NV_Ith_S(state, 1)});
    SM_ELEMENT_D(matrix, 0, 0) = 0;
    SM_ELEMENT_D(matrix, 0, 1) = 1;
    SM_ELEMENT_D(matrix, 1, 0) = slopes.by_position;
    SM_ELEMENT_D(matrix, 1, 1) = slopes.by_velocity;
    return 0;
  }

  const PenaltySystem& system_;
  CvodeMemory memory_;
  // NOTE: freed before the context of the memory.
  Owned<SUNNonlinearSolver, SUNNonlinSolFree> iteration_;
  Owned<SUNMatrix, SUNMatDestroy> matrix_;
  Owned<SUNLinearSolver, SUNLinSolFree> linear_;
  std::int64_t evaluations_ = 0;
};

Integrator cvode_through_contacts(std::string name, int method) {
  return penalty_integrator(std::move(name), "SUNDIALS " SUNDIALS_VERSION, "relative tolerance",
                            [method](const PenaltySystem& system, double tolerance) {
                              return std::make_unique<CvodeSteps>(system, tolerance, method);
                            });
}

}  // namespace

Integrator penalty_cvode_adams() {
  return cvode_through_contacts("cvode-adams", CV_ADAMS);
}

Integrator penalty_cvode_bdf() {
  return cvode_through_contacts("cvode-bdf", CV_BDF);
}

}  // namespace ricochet::carrier_track::inline reference_integrators
