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

/// Distance of about `wanted` round ticks of a linear axis. Whole numbers get none between them.
double tick_step(const Range& limits, int wanted, bool whole_numbers);

/// About `wanted` labels of a logarithmic axis, and minor ticks. gnuplot's own label powers of ten
/// alone, and could write their exponents only where it reads markup in every text.
std::vector<Tick> logarithmic_ticks(const Range& limits, int wanted);

}  // namespace ricochet::report
