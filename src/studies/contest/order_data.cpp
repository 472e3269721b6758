#include "src/studies/contest/order_data.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include "src/statistics/rank_correlation.h"

namespace ricochet::studies::contest {
namespace {

using report::Json;

/// Mean ranks by competitor.
using Order = std::map<std::string, double>;

Order order_of(const std::vector<Rating>& ratings) {
  Order order;
  for (const Rating& r : ratings) order[r.solver + ", " + r.form] = r.rank;
  return order;
}

/// The ranks of the solvers that are shown this form.
Order order_in(const std::vector<Rating>& ratings, const std::string& form) {
  Order order;
  for (const Rating& r : ratings) {
    if (r.form == form) order[r.solver] = r.rank;
  }
  return order;
}

/// Only every second instance, from the first or the second on.
std::vector<Standing> half(std::vector<Standing> standings, std::size_t from) {
  for (Standing& standing : standings) {
    std::vector<Outcome> kept;
    for (std::size_t i = from; i < standing.outcomes.size(); i += 2) {
      kept.push_back(std::move(standing.outcomes[i]));
    }
    standing.outcomes = std::move(kept);
  }
  return standings;
}

std::string leader(const Order& order) {
  const auto first = std::min_element(
      order.begin(), order.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  return first == order.end() ? "" : first->first;
}

/// How alike two orders are, of those that are in both; nothing of fewer than five.
Json compared(const std::string& family, const std::string& what, const Order& a, const Order& b) {
  std::vector<double> ranks_a;
  std::vector<double> ranks_b;
  for (const auto& [name, rank] : a) {
    const auto other = b.find(name);
    if (other == b.end()) continue;
    ranks_a.push_back(rank);
    ranks_b.push_back(other->second);
  }
  if (ranks_a.size() < 5) return {};
  const auto correlation = kendall_rank_correlation(ranks_a, ranks_b);
  if (!correlation) return {};
  const Interval interval = kendall_interval(*correlation, ranks_a.size());
  return {{"family", family},
          {"what", what},
          {"competitors", ranks_a.size()},
          {"correlation", *correlation},
          {"lower", interval.lower},
          {"upper", interval.upper},
          {"leader", leader(a)},
          {"other_leader", leader(b)},
          {"same_leader", leader(a) == leader(b)}};
}

}  // namespace

Json order_data(const Plan& plan, const std::vector<Standing>& standings,
                const std::vector<Standing>& again, const std::vector<Group>& groups) {
  const std::size_t last = plan.budgets.size() - 1;
  Plan halved = plan;
  halved.instances = plan.instances / 2;
  Json rows = Json::array();
  const auto add = [&rows](Json row) {
    if (!row.is_null()) rows.push_back(std::move(row));
  };
  for (const Group& group : groups) {
    const auto of = [&](const Plan& p, const std::vector<Standing>& all, std::size_t budget) {
      return rate(p, all, group.questions, budget);
    };
    const std::vector<Rating> first = of(plan, standings, 0);
    const std::vector<Rating> most = of(plan, standings, last);
    add(compared(group.family, "other seeds", order_of(first), order_of(of(plan, again, 0))));
    if (halved.instances > 0) {
      add(compared(group.family, "the other half of the instances",
                   order_of(of(halved, half(standings, 0), last)),
                   order_of(of(halved, half(standings, 1), last))));
    }
    if (last > 0) add(compared(group.family, "more evaluations", order_of(first), order_of(most)));
    std::map<std::string, int> forms;
    for (const Rating& rating : most) ++forms[rating.form];
    for (auto a = forms.begin(); a != forms.end(); ++a) {
      for (auto b = std::next(a); b != forms.end(); ++b) {
        add(compared(group.family, a->first + " or " + b->first, order_in(most, a->first),
                     order_in(most, b->first)));
      }
    }
  }
  return rows;
}

}  // namespace ricochet::studies::contest
