#include "src/benchmark/experiment/campaign/problem_hash.h"

#include <fmt/format.h>

#include <string_view>

#include "src/core/fnv_hash.h"
#include "src/core/instance.h"

namespace ricochet {
namespace {

void add(FnvHash& hash, double number) {
  hash.add({reinterpret_cast<const char*>(&number), sizeof number});
}

void add(FnvHash& hash, const Vector& x) {
  for (const double coordinate : x) add(hash, coordinate);
  hash.add("\xFF");
}

void add_true_values(FnvHash& hash, const Problem& problem, const Vector& x) {
  try {
    const TrueValues true_values = true_values_at(problem, x);
    add(hash, true_values.objective);
    add(hash, true_values.violation);
  } catch (const std::exception& error) {
    hash.add(error.what());
  }
}

}  // namespace

std::string problem_hash(const Problem& problem) {
  FnvHash hash;
  hash.add(problem.name);
  for (const Formulation& formulation : problem.formulations()) {
    hash.add(problem.name_of(formulation));
  }
  for (const double number : {problem.tolerance, problem.penalty_weight, problem.smoothing}) {
    add(hash, number);
  }
  for (const int number : {0, 1}) {
    const Problem seen = instance(problem, number);
    for (const Vector* x : {&seen.lower, &seen.upper, &seen.start}) add(hash, *x);
    if (seen.best_point) add(hash, *seen.best_point);
  }
  add_true_values(hash, problem, problem.start);
  if (problem.best_known) add(hash, *problem.best_known);
  if (problem.best_point) add_true_values(hash, problem, *problem.best_point);
  return fmt::format("{:016x}", hash.value());
}

}  // namespace ricochet
