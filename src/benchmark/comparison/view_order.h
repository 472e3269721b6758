#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "src/benchmark/statistics/ranking.h"

namespace ricochet::studies::comparison {

/// Runs that are ranked with each other: problem, number of the run in its cell, and targets that
/// the returned point misses. Between two targets the gaps differ, and the view has no gaps.
using RankedTogether = std::tuple<std::size_t, std::size_t, std::int64_t>;

/// The order of runs by what they reached, as text, for ranks that are those of the gaps
/// themselves. A run is written as its position among those before it that are ranked with it: 2 i
/// + 1 if it is equal to the i-th best of their k different values, 2 i if it comes just before
/// that one, 2 k after all. That is a number below 2 k + 1, in as many bits as the largest needs,
/// the lowest first; none for the first run. Six bits are a digit of base64.
class ViewOrderWriter {
 public:
  void add(const RankedTogether& together, const Reached& reached);

  /// Of the runs so far.
  std::string text() const;

 private:
  using Value = std::pair<double, double>;

  std::map<RankedTogether, std::vector<Value>> values_;  ///< different ones, the best first
  std::vector<bool> bits_;
};

}  // namespace ricochet::studies::comparison
