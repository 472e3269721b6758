#pragma once

#include <string>
#include <vector>

#include "problems/family.h"
#include "src/contest/rating.h"
#include "src/contest/stored_contest.h"
#include "src/report/json.h"

namespace ricochet::studies::contest {

using namespace ricochet::contest;

/// Questions of one family, which are rated together.
struct Group {
  std::string family;
  std::vector<std::size_t> questions;  ///< indices in the plan
};

/// The families of the plan's questions, in its order.
std::vector<Group> groups_of(const ContestPlan& plan, const std::vector<Family>& families);

/// The same of a stored contest.
std::vector<Group> groups_of(const StoredContest& contest);

/// Of each group, for each budget of the plan: the best first.
using Ratings = std::vector<std::vector<std::vector<Rating>>>;
Ratings ratings_of(const ContestPlan& plan, const std::vector<Standing>& standings,
                   const std::vector<Group>& groups);

/// What the plan's runs say: of each group the ratings for each budget, its questions, and, where
/// they are few, all the standings on them.
report::Json group_data(const ContestPlan& plan, const std::vector<Standing>& standings,
                        const std::vector<Group>& groups, const Ratings& ratings);

}  // namespace ricochet::studies::contest
