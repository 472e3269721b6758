// A caller of TAO, in a shared library of its own: PETSc's MPI and the MPI stub of sequential Ipopt
// must not see each other's symbols. ricochet's adapter has initialised PETSc before.

#include "tests/solvers/direct_tao.h"

#include <petsctao.h>

#include <limits>

namespace {

/// Tells the numbers at x of what is not null.
PetscErrorCode tell(Vec x, PetscReal* value, Vec told, Mat jacobian, void* context) {
  const auto& asked = *static_cast<const DirectTao*>(context);
  const PetscScalar* at = nullptr;
  PetscScalar *numbers = nullptr, *slopes = nullptr;
  VecGetArrayRead(x, &at);
  if (told) VecGetArray(told, &numbers);
  if (jacobian) MatDenseGetArrayWrite(jacobian, &slopes);
  const double result = asked.tell(asked, at, numbers, slopes);
  if (value) *value = result;
  if (told) VecRestoreArray(told, &numbers);
  if (jacobian) {
    MatDenseRestoreArrayWrite(jacobian, &slopes);
    MatAssemblyBegin(jacobian, MAT_FINAL_ASSEMBLY);
    MatAssemblyEnd(jacobian, MAT_FINAL_ASSEMBLY);
  }
  return VecRestoreArrayRead(x, &at);
}

PetscErrorCode objective(Tao, Vec x, PetscReal* value, void* context) {
  return tell(x, value, nullptr, nullptr, context);
}

PetscErrorCode slope(Tao, Vec x, PetscReal* value, Vec gradient, void* context) {
  return tell(x, value, gradient, nullptr, context);
}

PetscErrorCode residuals(Tao, Vec x, Vec values, void* context) {
  return tell(x, nullptr, values, nullptr, context);
}

PetscErrorCode jacobian(Tao, Vec x, Mat slopes, Mat, void* context) {
  return tell(x, nullptr, nullptr, slopes, context);
}

/// A vector whose numbers are those of an array.
Vec vector_of(int n, const double* values) {
  Vec vec = nullptr;
  VecCreateSeqWithArray(PETSC_COMM_SELF, 1, n, values, &vec);
  return vec;
}

}  // namespace

extern "C" __attribute__((visibility("default"))) void direct_tao(const DirectTao* asked,
                                                                  const char* type, double* x) {
  void* context = const_cast<DirectTao*>(asked);
  Vec u = vector_of(asked->n, x), lower = vector_of(asked->n, asked->lower);
  Vec upper = vector_of(asked->n, asked->upper), values = nullptr;
  Mat slopes = nullptr;
  Tao tao = nullptr;
  TaoCreate(PETSC_COMM_SELF, &tao);
  TaoSetType(tao, type);
  TaoSetSolution(tao, u);
  TaoSetVariableBounds(tao, lower, upper);
  TaoSetMaximumIterations(tao, std::numeric_limits<PetscInt>::max());
  TaoSetMaximumFunctionEvaluations(tao, asked->limit);
  if (asked->m > 0) {
    VecCreateSeq(PETSC_COMM_SELF, asked->m, &values);
    MatCreateSeqDense(PETSC_COMM_SELF, asked->m, asked->n, nullptr, &slopes);
    TaoSetResidualRoutine(tao, values, residuals, context);
    TaoSetJacobianResidualRoutine(tao, slopes, slopes, jacobian, context);
  } else {
    TaoSetObjective(tao, objective, context);
    TaoSetObjectiveAndGradient(tao, nullptr, slope, context);
  }
  TaoSolve(tao);
  TaoDestroy(&tao);
  MatDestroy(&slopes);
  for (Vec* each : {&u, &lower, &upper, &values}) VecDestroy(each);
}
