#pragma once

#include <vector>

#include "src/report/chart.h"
#include "src/report/site/front.h"

namespace ricochet::site {

/// Returns the static charts of a front page, for paper and for readers without scripts, from the
/// same data as the interactive ones: speed against accuracy of each family with its largest
/// budget, and the first of the reports' charts. Empty charts are omitted.
std::vector<report::Chart> front_charts(const Front& front);

/// Shows for each simulation the pair with its fastest solver, and all pairs on the Pareto front;
/// the other pairs would lie to the right.
report::Chart pairs_chart(const Pairs& pairs);

}  // namespace ricochet::site
