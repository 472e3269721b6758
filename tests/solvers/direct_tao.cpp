// A caller of TAO, in a shared library of its own: PETSc's MPI and the MPI stub of sequential Ipopt
// must not see each other's symbols. ricochet's adapter has initialised PETSc before.

#include "tests/solvers/direct_tao.h"

#include <petsctao.h>

#include <limits>
#include <vector>

namespace {

const DirectTao& of(void* context) {
  return *static_cast<const DirectTao*>(context);
}

PetscErrorCode objective(Tao, Vec x, PetscReal* value, void* context) {
  const PetscScalar* at = nullptr;
  VecGetArrayRead(x, &at);
  *value = of(context).value(of(context).data, at);
  return VecRestoreArrayRead(x, &at);
}

PetscErrorCode slope(Tao, Vec x, PetscReal* value, Vec gradient, void* context) {
  const PetscScalar* at = nullptr;
  PetscScalar* told = nullptr;
  VecGetArrayRead(x, &at);
  VecGetArray(gradient, &told);
  *value = of(context).gradient(of(context).data, at, told);
  VecRestoreArray(gradient, &told);
  return VecRestoreArrayRead(x, &at);
}

PetscErrorCode residuals(Tao, Vec x, Vec values, void* context) {
  const PetscScalar* at = nullptr;
  PetscScalar* told = nullptr;
  VecGetArrayRead(x, &at);
  VecGetArray(values, &told);
  of(context).residuals(of(context).data, at, told);
  VecRestoreArray(values, &told);
  return VecRestoreArrayRead(x, &at);
}

PetscErrorCode jacobian(Tao, Vec x, Mat slopes, Mat, void* context) {
  const PetscScalar* at = nullptr;
  PetscScalar* told = nullptr;
  VecGetArrayRead(x, &at);
  MatDenseGetArrayWrite(slopes, &told);
  of(context).jacobian(of(context).data, at, told);  // by columns
  MatDenseRestoreArrayWrite(slopes, &told);
  MatAssemblyBegin(slopes, MAT_FINAL_ASSEMBLY);
  MatAssemblyEnd(slopes, MAT_FINAL_ASSEMBLY);
  return VecRestoreArrayRead(x, &at);
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
