#include "problems/carrier_track/counting/exclusion.h"

#include <algorithm>

#include "problems/carrier_track/counting/complete_scan.h"

namespace ricochet::carrier_track::inline counting {
namespace {

constexpr double longest_part = 0.25;     // [rad/s], of a part that is scanned at once
constexpr double shortest_part = 0.0625;  // [rad/s], parts that fail are halved down to this
constexpr CompleteScanOptions part_options{1e-6, 500};

/// Adds a range that touches the last one to it.
void hold(std::vector<CoordinateRange>& ranges, CoordinateRange range) {
  if (!ranges.empty() && range.from <= ranges.back().to + 2 * part_options.resolution) {
    ranges.back().to = range.to;
  } else {
    ranges.push_back(range);
  }
}

void search_part(const Scene& scene, CoordinateRange part, double most,
                 std::vector<CoordinateRange>& ranges) {
  if (const auto scan = scan_completely(scene, part.from, part.to, part_options)) {
    for (const CountPiece& piece : scan->pieces) {
      if (piece.count <= most) hold(ranges, {piece.from, piece.to});
    }
  } else if (part.to - part.from < 1.5 * shortest_part) {
    hold(ranges, part);
  } else {
    const double middle = (part.from + part.to) / 2;
    search_part(scene, {part.from, middle}, most, ranges);
    search_part(scene, {middle, part.to}, most, ranges);
  }
}

}  // namespace

std::vector<CoordinateRange> not_excluded(const Scene& scene, double lowest, double highest,
                                          double most) {
  std::vector<CoordinateRange> ranges;
  for (double from = lowest; from < highest; from += longest_part) {
    search_part(scene, {from, std::min(from + longest_part, highest)}, most, ranges);
  }
  return ranges;
}

}  // namespace ricochet::carrier_track::inline counting
