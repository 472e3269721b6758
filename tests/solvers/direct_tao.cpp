// A caller of TAO, in a shared library of its own: PETSc's MPI and the MPI stub of sequential Ipopt
// must not see each other's symbols. ricochet's adapter has initialised PETSc before.

#include "tests/solvers/direct_tao.h"

#include <petsctao.h>

#include <limits>
#include <vector>

namespace {

/// Tells the numbers at x of what is not null.
PetscErrorCode tell(Vec x, PetscReal* value, Vec gradient, Vec residuals, Mat jacobian,
                    void* context) {
  const auto& asked = *static_cast<const DirectTao*>(context);
  const PetscScalar* at = nullptr;
  PetscScalar *slope = nullptr, *rest = nullptr, *slopes = nullptr;
  VecGetArrayRead(x, &at);
  if (gradient) VecGetArray(gradient, &slope);
  if (residuals) VecGetArray(residuals, &rest);
  if (jacobian) MatDenseGetArrayWrite(jacobian, &slopes);
  const double told = asked.tell(asked.data, at, slope, rest, slopes);
  if (value) *value = told;
  if (gradient) VecRestoreArray(gradient, &slope);
  if (residuals) VecRestoreArray(residuals, &rest);
  if (jacobian) {
    MatDenseRestoreArrayWrite(jacobian, &slopes);
    MatAssemblyBegin(jacobian, MAT_FINAL_ASSEMBLY);
    MatAssemblyEnd(jacobian, MAT_FINAL_ASSEMBLY);
  }
  return VecRestoreArrayRead(x, &at);
}

PetscErrorCode objective(Tao, Vec x, PetscReal* value, void* context) {
  return tell(x, value, nullptr, nullptr, nullptr, context);
}

PetscErrorCode slope(Tao, Vec x, PetscReal* value, Vec gradient, void* context) {
  return tell(x, value, gradient, nullptr, nullptr, context);
}

PetscErrorCode residuals(Tao, Vec x, Vec values, void* context) {
  return tell(x, nullptr, nullptr, values, nullptr, context);
}

PetscErrorCode jacobian(Tao, Vec x, Mat slopes, Mat, void* context) {
  return tell(x, nullptr, nullptr, nullptr, slopes, context);
}

Vec vector_of(int n, const double* values) {
  Vec vec = nullptr;
  VecCreateSeq(PETSC_COMM_SELF, n, &vec);
  for (PetscInt i = 0; i < n && values; ++i) VecSetValue(vec, i, values[i], INSERT_VALUES);
  VecAssemblyBegin(vec);
  VecAssemblyEnd(vec);
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
    values = vector_of(asked->m, nullptr);
    MatCreateSeqDense(PETSC_COMM_SELF, asked->m, asked->n, nullptr, &slopes);
    TaoSetResidualRoutine(tao, values, residuals, context);
    TaoSetJacobianResidualRoutine(tao, slopes, slopes, jacobian, context);
  } else {
    TaoSetObjective(tao, objective, context);
    TaoSetObjectiveAndGradient(tao, nullptr, slope, context);
  }
  TaoSolve(tao);
  const PetscScalar* at = nullptr;
  VecGetArrayRead(u, &at);
  for (PetscInt i = 0; i < asked->n; ++i) x[i] = at[i];
  VecRestoreArrayRead(u, &at);
  TaoDestroy(&tao);
  MatDestroy(&slopes);
  for (Vec* each : {&u, &lower, &upper, &values}) VecDestroy(each);
}
