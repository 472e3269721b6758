#pragma once

/// oneTBB's range, for a machine of one thread.
namespace tbb {

template <class Index>
class blocked_range {
 public:
  blocked_range(Index begin, Index end, Index /*grain*/) : begin_(begin), end_(end) {}

  Index begin() const { return begin_; }
  Index end() const { return end_; }

 private:
  Index begin_, end_;
};

}  // namespace tbb
