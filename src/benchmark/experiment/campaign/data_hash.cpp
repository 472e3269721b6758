#include "src/benchmark/experiment/campaign/data_hash.h"

#include <fmt/format.h>

#include <string_view>

#include "src/core/fnv_hash.h"

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

std::string data_hash(const std::vector<Problem>& problems) {
  FnvHash hash;
  for (const Problem& problem : problems) {
    hash.add(problem.name);
    for (const Vector* x : {&problem.lower, &problem.upper, &problem.start}) add(hash, *x);
    for (const double number : {problem.tolerance, problem.penalty_weight, problem.smoothing}) {
      add(hash, number);
    }
    add_true_values(hash, problem, problem.start);
    if (problem.best_known) add(hash, *problem.best_known);
    if (!problem.best_point) continue;
    add(hash, *problem.best_point);
    add_true_values(hash, problem, *problem.best_point);
  }
  return fmt::format("{:016x}", hash.value());
}

}  // namespace ricochet
