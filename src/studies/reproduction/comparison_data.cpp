#include "src/studies/reproduction/data.h"

namespace ricochet::studies::reproduction {

report::Json comparison_data(const Results& results) {
  return {{"questions", results.contest.questions.size()},
          {"groups", contest::group_data(results.contest, results.standings, results.groups)}};
}

}  // namespace ricochet::studies::reproduction
