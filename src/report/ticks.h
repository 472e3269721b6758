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

/// Where a value lies between the limits: 0 at the lower one, 1 at the upper one.
double share(double value, const Range& limits, Scale scale);

/// Returns about `wanted` round numbers on a linear axis. Axes of whole numbers get no fractions.
std::vector<Tick> linear_ticks(const Range& limits, int wanted, bool whole_numbers);

/// About `wanted` labels on a logarithmic axis, and minor ticks.
std::vector<Tick> logarithmic_ticks(const Range& limits, int wanted);

/// A number as a reader writes it, with up to ten digits: −0.5, 2000000, 3×10⁻⁷.
std::string number_label(double number);

}  // namespace ricochet::report
