#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include "problems/carrier_track/check/reference_integrators/cvode_memory.h"
#include "problems/carrier_track/check/reference_integrators/dense_flight.h"
#include "problems/carrier_track/check/reference_integrators/methods.h"
#include "problems/carrier_track/check/reference_integrators/penalty.h"

namespace ricochet::carrier_track::inline reference_integrators {
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

Integrator cvode(std::string name, int method) {
  return penalty_integrator(std::move(name), "SUNDIALS " SUNDIALS_VERSION, "relative tolerance",
                            [method](const PenaltySystem& system, double tolerance) {
                              return std::make_unique<CvodeSteps>(system, tolerance, method);
                            });
}

}  // namespace

Integrator penalty_cvode_adams() {
  return cvode("cvode-adams", CV_ADAMS);
}

Integrator penalty_cvode_bdf() {
  return cvode("cvode-bdf", CV_BDF);
}

}  // namespace ricochet::carrier_track::inline reference_integrators
