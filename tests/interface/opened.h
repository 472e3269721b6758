#pragma once

#include <ricochet/ricochet.h>

#include <cstdint>
#include <memory>
#include <string>

namespace ricochet::interface {

struct Closer {
  void operator()(ricochet_problem* problem) const { ricochet_close(problem); }
  void operator()(ricochet_machine* machine) const { ricochet_close_machine(machine); }
};
using Opened = std::unique_ptr<ricochet_problem, Closer>;

/// A problem of libricochet.so; null if it refuses.
inline Opened open(const std::string& problem, const std::string& formulation = "",
                   int instance = 0, std::int64_t budget = 1000, std::uint64_t seed = 0) {
  return Opened(ricochet_open(problem.c_str(), formulation.c_str(), instance, budget, seed));
}

}  // namespace ricochet::interface
