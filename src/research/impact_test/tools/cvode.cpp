// SUNDIALS CVODE, Adams or BDF, with its rootfinding. As its manual advises: roots have a
// direction, the stop time is the next jump of the force, and every impact is followed by
// CVodeReInit.
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <memory>

#include "motion.h"

namespace {

using namespace impact_test;

int rates(double t, N_Vector y, N_Vector dy, void* motion) {
  static_cast<Motion*>(motion)->rates(t, N_VGetArrayPointer(y), N_VGetArrayPointer(dy));
  return 0;
}

int values(double t, N_Vector y, double* values, void* motion) {
  const auto all = static_cast<Motion*>(motion)->values(t, N_VGetArrayPointer(y));
  std::copy(all.begin(), all.end(), values);
  return 0;
}

void check(int flag) {
  const auto name = std::unique_ptr<char, void (*)(void*)>(CVodeGetReturnFlagName(flag), free);
  if (flag < 0) throw std::runtime_error(name.get());
}

Result simulate(const Scene& scene, const Call& call) {
  static const sundials::Context context;
  const bool adams = call.method == "adams";
  const double tolerance = call.pick(1e-4, 1e-6, 1e-12);
  Motion motion(scene, tolerance);
  void* cvode = CVodeCreate(adams ? CV_ADAMS : CV_BDF, context);
  const N_Vector y = N_VMake_Serial(2, motion.state.data(), context);
  const N_Vector absolute = N_VNew_Serial(2, context);
  N_VGetArrayPointer(absolute)[0] = tolerance * scene.length();
  N_VGetArrayPointer(absolute)[1] = tolerance * scene.speed();
  const SUNMatrix matrix = SUNDenseMatrix(2, 2, context);
  const SUNLinearSolver linear = SUNLinSol_Dense(y, matrix, context);
  const SUNNonlinearSolver fixed_point = SUNNonlinSol_FixedPoint(y, 0, context);
  std::unique_ptr<void, std::function<void(void*)>> release(cvode, [&](void* memory) {
    CVodeFree(&memory);
    SUNNonlinSolFree(fixed_point);
    SUNLinSolFree(linear);
    SUNMatDestroy(matrix);
    N_VDestroy(absolute);
    N_VDestroy(y);
  });
  std::array<int, Motion::values_count> falling = {-1, -1, -1}, found = {};
  CVodeInit(cvode, rates, 0, y);
  CVodeSVtolerances(cvode, tolerance, absolute);
  CVodeSetUserData(cvode, &motion);
  if (adams) CVodeSetNonlinearSolver(cvode, fixed_point);
  if (!adams) CVodeSetLinearSolver(cvode, linear, matrix);
  CVodeSetMaxNumSteps(cvode, 1000000);
  CVodeSetMaxStep(cvode, scene.longest_step());
  CVodeRootInit(cvode, Motion::values_count, values);
  CVodeSetRootDirection(cvode, falling.data());
  CVodeSetNoInactiveRootWarn(cvode);
  while (!motion.over()) {
    double t = motion.time;
    check(CVodeReInit(cvode, t, y));
    check(CVodeSetStopTime(cvode, motion.end()));
    const int flag = CVode(cvode, motion.end(), y, &t, CV_NORMAL);
    check(flag);
    int event = -1;
    if (flag == CV_ROOT_RETURN) CVodeGetRootInfo(cvode, found.data());
    if (flag == CV_ROOT_RETURN) event = std::find(found.begin(), found.end(), -1) - found.begin();
    motion.proceed(t, N_VGetArrayPointer(y), event);
  }
  return motion.result;
}

}  // namespace

int main(int argc, char** argv) {
  return impact_test::run(argc, argv, simulate);
}
