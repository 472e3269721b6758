#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sundials/sundials_version.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <array>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>

#include "problems/carrier_track/check/walls.h"

namespace ricochet::carrier_track::inline reference_integrators {

namespace {

/// Throws std::runtime_error with the name of a negative return flag.
void require(int flag) {
  if (flag >= 0) return;
  const std::unique_ptr<char, decltype(&std::free)> name(CVodeGetReturnFlagName(flag), std::free);
  throw std::runtime_error(std::string("CVODE: ") + name.get());
}

/// A C object that is freed by its handle. Throws std::runtime_error if there is none.
template <class Object, auto free>
struct Owned {
  struct Free {
    void operator()(Object* object) const { free(object); }
  };
  Owned() = default;
  explicit Owned(Object* object) : owner(object) {
    if (!owner) throw std::runtime_error("CVODE: no memory");
  }
  operator Object*() const { return owner.get(); }

  std::unique_ptr<Object, Free> owner;
};

void free_cvode(void* memory) {
  CVodeFree(&memory);
}

/// CVODE's integrator of a position and a velocity. Walls and velocity zeros are its own root
/// functions. It looks for sign changes over its steps and misses an event that starts and ends
/// within one. Velocity zeros are roots without friction too, where they change nothing: with the
/// walls alone, impacts that go beyond a wall and back in one step are lost.
class Cvode : public Method {
 public:
  /// `method` is CV_ADAMS or CV_BDF.
  Cvode(System& system, double tolerance, int method)
      : Method(system), cvode_(CVodeCreate(method, context_)) {
    require(CVodeSetErrHandlerFn(
        cvode_, [](int, const char*, const char*, char*, void*) {}, nullptr));
    require(CVodeInit(cvode_, slope, 0.0, vector_));
    require(CVodeSetUserData(cvode_, this));
    require(CVodeSStolerances(cvode_, tolerance, tolerance * system.length));
    if (system.wall) {
      require(CVodeSetMaxStep(cvode_, system.longest_step()));
      require(CVodeSetStopTime(cvode_, system.window));
    } else {
      require(CVodeSetMaxNumSteps(cvode_, most_steps));
      require(CVodeRootInit(cvode_, 3, walls_and_turn));
      std::array<int, 3> inwards = {-1, -1, 0};
      require(CVodeSetRootDirection(cvode_, inwards.data()));
      require(CVodeSetNoInactiveRootWarn(cvode_));
    }
    // NOTE: in a flight the forces do not depend on the state, so a fixed-point iteration converges
    // at once and saves the linear algebra of Newton's method, for BDF too.
    if (system.wall && method == CV_BDF) {
      matrix_ = Owned<_generic_SUNMatrix, SUNMatDestroy>(SUNDenseMatrix(2, 2, context_));
      linear_ = Owned<_generic_SUNLinearSolver, SUNLinSolFree>(
          SUNLinSol_Dense(vector_, matrix_, context_));
      require(CVodeSetLinearSolver(cvode_, linear_, matrix_));
      require(CVodeSetJacFn(cvode_, jacobian));
    } else {
      iteration_ = Owned<_generic_SUNNonlinearSolver, SUNNonlinSolFree>(
          SUNNonlinSol_FixedPoint(vector_, 0, context_));
      require(CVodeSetNonlinearSolver(cvode_, iteration_));
    }
  }

  void start(const State& state) override {
    state_ = {state.position, state.velocity};
    time_ = 0;
    require(CVodeReInit(cvode_, 0.0, vector_));
  }

  double step() override {
    require(CVode(cvode_, system_.window, vector_, &time_, CV_ONE_STEP));
    return time_;
  }

  State at(double /*time*/) override { return {state_[0], state_[1]}; }

  Landing fly(const Leg& leg) override {
    system_.start = leg.start;
    system_.direction = leg.direction;
    return fly(leg, 0);
  }

 private:
  /// The first step has that length [s]; if it is 0, CVODE chooses it.
  Landing fly(const Leg& leg, double first_step) {
    start(leg.state);
    require(CVodeSetInitStep(cvode_, first_step));
    for (;;) {
      const int flag = CVode(cvode_, leg.longest, vector_, &time_, CV_NORMAL);
      if (flag == CV_TOO_CLOSE) {  // the rest of the window is below rounding
        const double position = leg.state.position + leg.longest * leg.state.velocity;
        return {Finish::limit, leg.longest, {position, leg.state.velocity}};
      }
      require(flag);
      // NOTE: CVODE's own limit is per call, and every velocity zero returns.
      long steps = 0;
      require(CVodeGetNumSteps(cvode_, &steps));
      if (steps_ + steps > most_steps) throw std::runtime_error("more than 1000000 steps");
      std::array<int, 3> found{};
      if (flag == CV_ROOT_RETURN) require(CVodeGetRootInfo(cvode_, found.data()));
      const bool wall = found[0] != 0 || found[1] != 0;
      const bool turn = found[2] != 0 && system_.friction > 0;
      if (flag == CV_ROOT_RETURN && !wall && !turn) continue;
      steps_ += steps;
      if (turn && !wall && steps == 1 && pushes_on(leg)) return fly(leg, shorter_first_step());
      const Finish finish = found[0] != 0   ? Finish::lower_wall
                            : found[1] != 0 ? Finish::upper_wall
                            : turn          ? Finish::turn
                                            : Finish::limit;
      return {finish, finish == Finish::limit ? leg.longest : time_, at(time_)};
    }
  }

  /// Returns true if the forces exceed friction in the leg's direction. Velocity cannot be zero
  /// there.
  //
  // NOTE: the first step is of first order. If the excess over friction ends within it, it ends at
  // a negative velocity. Its linear interpolation puts the velocity zero at the very start, from
  // where the body would start again, forever. A step that ends before the excess does is correct.
  bool pushes_on(const Leg& leg) const {
    return leg.direction * system_.acceleration(time_, leg.state) > 0;
  }

  double shorter_first_step() const {
    double step = 0;
    require(CVodeGetActualInitStep(cvode_, &step));
    return 0.1 * step;
  }

  static State state_in(N_Vector state) { return {NV_Ith_S(state, 0), NV_Ith_S(state, 1)}; }

  static int slope(double time, N_Vector state, N_Vector rate, void* data) {
    NV_Ith_S(rate, 0) = NV_Ith_S(state, 1);
    NV_Ith_S(rate, 1) = static_cast<Cvode*>(data)->system_.acceleration(time, state_in(state));
    return 0;
  }

  static int walls_and_turn(double /*time*/, N_Vector state, double* value, void* data) {
    const System& system = static_cast<Cvode*>(data)->system_;
    value[0] = NV_Ith_S(state, 0) - system.lower;
    value[1] = system.upper - NV_Ith_S(state, 0);
    value[2] = NV_Ith_S(state, 1);
    return 0;
  }

  static int jacobian(double /*time*/, N_Vector state, N_Vector /*rate*/, SUNMatrix matrix,
                      void* data, N_Vector, N_Vector, N_Vector) {
    const auto slopes = static_cast<Cvode*>(data)->system_.slopes(state_in(state));
    SM_ELEMENT_D(matrix, 0, 0) = 0;
    SM_ELEMENT_D(matrix, 0, 1) = 1;
    SM_ELEMENT_D(matrix, 1, 0) = slopes.by_position;
    SM_ELEMENT_D(matrix, 1, 1) = slopes.by_velocity;
    return 0;
  }

  // NOTE: freed from the last to the first; the context must outlive the others.
  sundials::Context context_;
  std::array<double, 2> state_{};
  Owned<_generic_N_Vector, N_VDestroy> vector_{N_VMake_Serial(2, state_.data(), context_)};
  Owned<_generic_SUNNonlinearSolver, SUNNonlinSolFree> iteration_;
  Owned<_generic_SUNMatrix, SUNMatDestroy> matrix_;
  Owned<_generic_SUNLinearSolver, SUNLinSolFree> linear_;
  Owned<void, free_cvode> cvode_;
  double time_ = 0;  // [s], reached in the flight
};

Integrator cvode(const char* name, const char* title, int method) {
  return adaptive(name, "SUNDIALS " SUNDIALS_VERSION, title,
                  [method](System& system, double tolerance) {
                    return std::make_unique<Cvode>(system, tolerance, method);
                  });
}

}  // namespace

Integrator cvode_adams() {
  return cvode("cvode-adams", "SUNDIALS CVODE, Adams of order 1 to 12, with rootfinding", CV_ADAMS);
}

Integrator cvode_bdf() {
  return cvode("cvode-bdf", "SUNDIALS CVODE, BDF of order 1 to 5, with rootfinding", CV_BDF);
}

}  // namespace ricochet::carrier_track::inline reference_integrators
