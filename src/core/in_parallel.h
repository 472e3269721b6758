#pragma once

#include <tbb/parallel_for.h>

#include <atomic>
#include <cstddef>
#include <utility>

#include "src/core/time_limit.h"

namespace ricochet {

/// Puts a part of parallel work under a time limit.
class UnderTimeLimit {
 public:
  explicit UnderTimeLimit(TimeLimit* limit)
      : before_(std::exchange(work_time_of_this_thread(), {limit, nullptr})) {}
  ~UnderTimeLimit() { work_time_of_this_thread() = before_; }
  UnderTimeLimit(const UnderTimeLimit&) = delete;
  UnderTimeLimit& operator=(const UnderTimeLimit&) = delete;

 private:
  WorkTime before_;
};

/// Calls body(0), ..., body(size - 1) in parallel, begun in this order, under the time limit of
/// this thread, and reports the share that is done as `stage`: of these, or of `all`, of which
/// `before` were done before. Throws what a body throws.
template <class Body>
void in_parallel(const char* stage, std::size_t size, const Body& body, std::size_t before = 0,
                 std::size_t all = 0) {
  const WorkTime shared = work_time_of_this_thread();
  std::atomic<std::size_t> next = 0;
  std::atomic<std::size_t> done = 0;
  tbb::parallel_for(std::size_t{0}, size, [&](std::size_t /*in any order*/) {
    {
      const UnderTimeLimit same(shared.limit);
      body(next++);
    }
    const double share =
        static_cast<double>(before + ++done) / static_cast<double>(all > 0 ? all : size);
    if (shared.listener != nullptr) shared.listener->report(stage, share);
  });
}

}  // namespace ricochet
