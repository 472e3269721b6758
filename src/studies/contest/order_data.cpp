#include "src/studies/contest/order_data.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <set>
#include <utility>

#include "src/studies/contest/order.h"

namespace ricochet::studies::contest {
namespace {

using report::Json;

/// Only every second instance, from the first or the second on.
std::vector<Standing> half(std::vector<Standing> standings, std::size_t from) {
  for (Standing& standing : standings) {
    standing.outcomes = standing.outcomes.every(2, from, (standing.outcomes.size() + 1 - from) / 2);
  }
  return standings;
}

/// A row of two orders; null where they cannot be compared.
Json compared(const std::string& family, const std::string& what, const Order& a, const Order& b) {
  Json row = agreement_of(a, b);
  if (row.is_null()) return row;
  row.update({{"family", family},
              {"what", what},
              {"leader", a.leader},
              {"other_leader", b.leader},
              {"same_leader", a.leader == b.leader}});
  return row;
}

}  // namespace

Json order_data(const ContestPlan& plan, const std::vector<Standing>& standings,
                const std::vector<Standing>& again, const ContestPlan& drawn,
                const std::vector<Group>& groups, const Ratings& ratings) {
  const std::size_t last = plan.budgets.size() - 1;
  ContestPlan halved = plan;
  halved.instances = plan.instances / 2;
  Json rows = Json::array();
  const auto add = [&rows](Json row) {
    if (!row.is_null()) rows.push_back(std::move(row));
  };
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const Group& group = groups[g];
    const auto of = [&](const ContestPlan& p, const std::vector<Standing>& all,
                        std::size_t budget) { return rate(p, all, group.questions, budget); };
    const std::vector<Rating>& first = ratings[g].front();
    const std::vector<Rating>& most = ratings[g].back();
    if (!again.empty()) {
      add(compared(group.family, "other seeds", order_of(first), order_of(of(plan, again, 0))));
    }
    if (halved.instances > 0) {
      add(compared(group.family, "the other half of the instances",
                   order_of(of(halved, half(standings, 0), last)),
                   order_of(of(halved, half(standings, 1), last))));
    }
    if (last > 0) add(compared(group.family, "more evaluations", order_of(first), order_of(most)));
    if (group.family == "top-speed" && !drawn.questions.empty()) {
      std::vector<std::size_t> all(drawn.questions.size());
      std::iota(all.begin(), all.end(), std::size_t{0});
      add(compared(group.family, "machines drawn around the cases", order_of(most),
                   order_of(rate(drawn, hold(drawn), all, 0))));
    }
    std::set<std::string> forms;
    for (const Rating& rating : most) forms.insert(rating.form);
    for (auto a = forms.begin(); a != forms.end(); ++a) {
      for (auto b = std::next(a); b != forms.end(); ++b) {
        add(compared(group.family, *a + " or " + *b, order_in(most, *a), order_in(most, *b)));
      }
    }
  }
  return rows;
}

}  // namespace ricochet::studies::contest
