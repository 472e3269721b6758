#include "src/studies/reproduction/data.h"

namespace ricochet::studies::reproduction {

report::Json comparison_data(const Results& results) {
  const contest::Ratings ratings =
      contest::ratings_of(results.contest, results.standings, results.groups);
  return {
      {"questions", results.contest.questions.size()},
      {"groups", contest::group_data(results.contest, results.standings, results.groups, ratings)}};
}

}  // namespace ricochet::studies::reproduction
