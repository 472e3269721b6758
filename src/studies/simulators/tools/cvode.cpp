// SUNDIALS CVODE, Adams or BDF, with its rootfinding. As its manual advises: roots have a
// direction, the stop time is the next jump of the force, and every event is followed by
// CVodeReInit.
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include "motion.h"

using namespace impact_test;

static int rates(double t, N_Vector y, N_Vector dy, void* motion) {
  static_cast<Motion*>(motion)->rates(t, N_VGetArrayPointer(y), N_VGetArrayPointer(dy));
  return 0;
}

static int values(double t, N_Vector y, double* values, void* motion) {
  const auto all = static_cast<Motion*>(motion)->values(t, N_VGetArrayPointer(y));
  std::copy(all.begin(), all.end(), values);
  return 0;
}

// One for all scenes.
struct Solver {
  explicit Solver(bool adams) : cvode(CVodeCreate(adams ? CV_ADAMS : CV_BDF, context)) {
    const SUNMatrix matrix = SUNDenseMatrix(2, 2, context);
    CVodeInit(cvode, rates, 0, y);
    if (adams) CVodeSetNonlinearSolver(cvode, SUNNonlinSol_FixedPoint(y, 0, context));
    if (!adams) CVodeSetLinearSolver(cvode, SUNLinSol_Dense(y, matrix, context), matrix);
    CVodeRootInit(cvode, Motion::values_count, values);
    CVodeSetRootDirection(cvode, std::array{-1, -1, -1}.data());
    CVodeSetNoInactiveRootWarn(cvode);
    CVodeSetMaxNumSteps(cvode, 1000000);
  }
  sundials::Context context;
  N_Vector y = N_VNew_Serial(2, context);
  void* cvode;
};

static Result simulate(const Scene& scene, const Call& call) {
  static const Solver solver(call.method == "adams");
  const double tolerance = call.pick(1e-4, 1e-6, 1e-12);
  Motion motion(scene, tolerance);
  CVodeSStolerances(solver.cvode, tolerance, tolerance * scene.length());
  CVodeSetUserData(solver.cvode, &motion);
  double* const y = N_VGetArrayPointer(solver.y);
  for (double t = 0; !motion.over();) {
    std::copy(motion.state.begin(), motion.state.end(), y);
    CVodeReInit(solver.cvode, motion.time, solver.y);
    CVodeSetStopTime(solver.cvode, motion.end());
    CVodeSetMaxStep(solver.cvode, motion.longest_step());
    const int flag = CVode(solver.cvode, motion.end(), solver.y, &t, CV_NORMAL);
    if (flag < 0) throw std::runtime_error(CVodeGetReturnFlagName(flag));
    std::array<int, Motion::values_count> found = {};
    if (flag == CV_ROOT_RETURN) CVodeGetRootInfo(solver.cvode, found.data());
    const auto event = std::find(found.begin(), found.end(), -1) - found.begin();
    motion.proceed(t, y, flag == CV_ROOT_RETURN ? static_cast<int>(event) : -1);
  }
  return motion.result;
}

int main(int argc, char** argv) {
  return run(argc, argv, simulate);
}
