#include <dlfcn.h>

#include <stdexcept>
#include <string>

#include "ricochet/run.h"
#include "solvers/library_solvers.h"
#include "tests/solvers/direct_calls.h"
#include "tests/solvers/direct_tao.h"
#include "tests/support/problems.h"

namespace ricochet {
namespace {

const DirectCall& of(void* data) {
  return *static_cast<const DirectCall*>(data);
}

Vector at(void* data, const double* u) {
  return of(data).x(Eigen::Map<const Vector>(u, of(data).problem.dimension()));
}

double value(void* data, const double* u) {
  return of(data).evaluator.values(at(data, u))->objective;
}

double gradient(void* data, const double* u, double* told) {
  const Derivatives seen = *of(data).evaluator.derivatives(at(data, u));
  const Vector slope = seen.gradient.cwiseProduct(of(data).scale());
  std::copy(slope.begin(), slope.end(), told);
  return seen.values.objective;
}

void residuals(void* data, const double* u, double* told) {
  const Vector seen = *of(data).evaluator.residual_values(at(data, u));
  std::copy(seen.begin(), seen.end(), told);
}

void jacobian(void* data, const double* u, double* told) {
  const Matrix seen = of(data).evaluator.residuals(at(data, u), Part::jacobian)->jacobian *
                      of(data).scale().asDiagonal();
  Eigen::Map<Matrix>(told, seen.rows(), seen.cols()) = seen;
}

using Call = void (*)(const DirectTao*, const char*, double*);

Call loaded() {
  for (const Solver& solver : tao_solvers()) run(sphere(2, 3), solver, {5}, 0);  // starts PETSc
  void* library = dlopen(RICOCHET_DIRECT_TAO, RTLD_NOW | RTLD_LOCAL | RTLD_DEEPBIND);
  void* call = library ? dlsym(library, "direct_tao") : nullptr;
  if (!call) throw std::runtime_error(dlerror());
  return reinterpret_cast<Call>(call);
}

}  // namespace

Vector call_tao(const std::string& solver, const DirectCall& call) {
  static const Call directly = loaded();
  const bool of_residuals = solver == "tao-pounders" || solver == "tao-brgn";
  const Problem& problem = call.problem;
  const auto n = static_cast<int>(problem.dimension());
  const Vector lower = call.u(problem.lower), upper = call.u(problem.upper);
  const int m = of_residuals ? static_cast<int>(problem.residuals(problem.start).values.size()) : 0;
  const DirectTao asked{n,     m,        call.limit, lower.data(), upper.data(),
                        value, gradient, residuals,  jacobian,     const_cast<DirectCall*>(&call)};
  Vector u = call.u(problem.start).cwiseMax(lower).cwiseMin(upper);
  directly(&asked, solver.substr(4).c_str(), u.data());
  return call.x(u);
}

}  // namespace ricochet
