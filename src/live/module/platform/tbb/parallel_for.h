#pragma once

/// oneTBB's loop, for a machine of one thread.
namespace tbb {

template <class Range, class Body>
void parallel_for(const Range& range, const Body& body) {
  body(range);
}

}  // namespace tbb
