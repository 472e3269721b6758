#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

/// What ricochet uses of TBB, on plain threads. The build under ThreadSanitizer has it in place of
/// TBB's own headers: Debian's libtbb is not instrumented, so that every value handed to a task
/// would look like a race. Here nothing orders two iterations, and every race between them shows.
namespace tbb {

template <class Index>
class blocked_range {
 public:
  blocked_range(Index begin, Index end, std::size_t grain = 1)
      : begin_(begin), end_(end), grain_(static_cast<Index>(grain)) {}

  Index begin() const { return begin_; }
  Index end() const { return end_; }
  Index grain() const { return grain_; }

 private:
  Index begin_, end_, grain_;
};

struct simple_partitioner {};

template <class Index, class Body>
void parallel_for(const blocked_range<Index>& range, const Body& body, simple_partitioner = {}) {
  std::atomic<Index> next{range.begin()};
  std::exception_ptr failure;
  std::mutex mutex;
  const auto work = [&] {
    for (;;) {
      const Index begin = next.fetch_add(range.grain(), std::memory_order_relaxed);
      if (begin >= range.end()) return;
      try {
        body(blocked_range<Index>(begin, std::min<Index>(range.end(), begin + range.grain())));
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (!failure) failure = std::current_exception();
      }
    }
  };
  {
    std::vector<std::jthread> threads;
    for (int i = 0; i < 4; ++i) threads.emplace_back(work);
  }
  if (failure) std::rethrow_exception(failure);
}

template <class Index, class Body>
void parallel_for(Index begin, Index end, const Body& body, simple_partitioner = {}) {
  parallel_for(blocked_range<Index>(begin, end), [&](const blocked_range<Index>& range) {
    for (Index i = range.begin(); i < range.end(); ++i) body(i);
  });
}

namespace this_task_arena {

template <class Work>
auto isolate(const Work& work) {
  return work();
}

}  // namespace this_task_arena
}  // namespace tbb
