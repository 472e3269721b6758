#pragma once

#include <string>
#include <vector>

#include "src/report/chart.h"

namespace ricochet::report {

struct Tick {
  double position;
  std::string label;  ///< empty: a minor tick
};

/// Limits that leave a little room around the values; all of them if there are none.
Range limits(const std::vector<double>& values, Scale scale);

/// Round positions within the limits, about `wanted` of them labelled. Whole numbers get no
/// fractions between them.
std::vector<Tick> ticks(const Range& limits, Scale scale, int wanted, bool whole_numbers);

}  // namespace ricochet::report
