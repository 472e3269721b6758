#pragma once

#include <ricochet/ricochet.h>

#include "tests/support/test.h"

namespace ricochet::interface {

struct Closer {
  void operator()(ricochet_problem* problem) const { ricochet_close(problem); }
  void operator()(ricochet_machine* machine) const { ricochet_close_machine(machine); }
};
using Opened = std::unique_ptr<ricochet_problem, Closer>;
using OpenedMachine = std::unique_ptr<ricochet_machine, Closer>;

/// A problem of libricochet.so; null if it refuses.
inline Opened open(const std::string& problem, const std::string& formulation = "",
                   int instance = 0, std::int64_t budget = 1000, std::uint64_t seed = 0) {
  return Opened(ricochet_open(problem.c_str(), formulation.c_str(), instance, budget, seed));
}

/// NaN where it cannot be asked.
inline double objective_at(const Opened& opened, const std::vector<double>& x) {
  double objective = 0;
  const bool over = opened->values(opened.get(), x.data(), &objective, nullptr) != 0;
  return over ? NAN : objective;
}

/// The reason of the last refusal in this thread.
inline void expect_reason(const std::string& reason) {
  EXPECT_THAT(ricochet_error(), HasSubstr(reason));
}

}  // namespace ricochet::interface
