#include "src/report/polyline.h"

namespace ricochet::report {

std::vector<std::vector<Sample>> polylines(const Series& series) {
  std::vector<std::vector<Sample>> parts;
  bool joined = false;
  for (const Sample& sample : series.samples) {
    if (joined && series.mark == Mark::steps) {
      // The last value holds up to here, even if the value is unknown from here on.
      const Sample last = parts.back().back();
      parts.back().push_back({sample.position, last.value, last.spread});
    }
    if (!sample.value) {
      joined = false;
      continue;
    }
    if (!joined) parts.emplace_back();
    parts.back().push_back(sample);
    joined = true;
  }
  return parts;
}

}  // namespace ricochet::report
