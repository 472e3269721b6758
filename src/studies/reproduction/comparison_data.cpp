#include "problems/families.h"
#include "src/studies/contest/group.h"
#include "src/studies/reproduction/data.h"

namespace ricochet::studies::reproduction {

report::Json comparison_data(const Results& results) {
  const auto groups = contest::groups_of(results.contest, all_families());
  return {{"questions", results.contest.questions.size()},
          {"groups", contest::group_data(results.contest, results.standings, groups)}};
}

}  // namespace ricochet::studies::reproduction
