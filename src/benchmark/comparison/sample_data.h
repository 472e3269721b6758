#pragma once

#include "src/benchmark/comparison/reported_part.h"
#include "src/report/json.h"

namespace ricochet::studies::comparison {

/// A sample of the problems of a campaign whose runs are complete, drawn within each family from
/// strata of difficulty: the share of its runs, over all entries, that did not solve a problem. A
/// row for each family of each part: the problems drawn (a share of them, but at least `least`),
/// their difficulties, and how far the order of the entries on them agrees with that on all
/// problems: see agreement_of(), null where it cannot be said. `leader`, the first entry on all,
/// with the share of its runs that solved and its P(best); `sample_leader`, the first on the
/// sample.
report::Json sample_data(const Campaign& campaign, const std::vector<CellResult>& results,
                         double share, std::size_t least);

}  // namespace ricochet::studies::comparison
