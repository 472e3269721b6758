#pragma once

#include <ricochet/ricochet.h>

#include "ricochet/problem.h"
#include "src/studies/suite/suite.h"
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

/// The problems that the library is made of.
inline const std::vector<Problem>& problems() {
  static const std::vector<Problem> all = every_problem(suite_families());
  return all;
}

inline const Problem& problem_named(const std::string& name) {
  const auto found = std::ranges::find(problems(), name, &Problem::name);
  if (found == problems().end()) throw std::out_of_range(name);
  return *found;
}

/// The reason of the last refusal in this thread.
inline void expect_reason(const std::string& reason) {
  EXPECT_THAT(ricochet_error(), testing::HasSubstr(reason));
}

template <class Handle>
void expect_refusal(const Handle& opened, const std::string& reason) {
  EXPECT_FALSE(opened);
  expect_reason(reason);
}

/// Calls work(0), work(1), ..., each in a thread of its own.
template <class Work>
void in_threads(std::size_t count, const Work& work) {
  std::vector<std::thread> threads;
  for (std::size_t k = 0; k < count; ++k) threads.emplace_back([&work, k] { work(k); });
  for (std::thread& thread : threads) thread.join();
}

}  // namespace ricochet::interface
