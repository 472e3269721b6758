#include "src/studies/contest/order_data.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <numeric>
#include <utility>

#include "src/statistics/rank_correlation.h"

namespace ricochet::studies::contest {
namespace {

using report::Json;

/// Who is first, and the mean ranks by competitor.
struct Order {
  std::string leader;
  std::map<std::string, double> ranks;
};

/// Of ratings with the best first.
Order order_of(const std::vector<Rating>& ratings) {
  Order order;
  for (const Rating& r : ratings) {
    const std::string name = competitor(r.solver, r.form);
    if (order.leader.empty()) order.leader = name;
    order.ranks[name] = r.rank;
  }
  return order;
}

/// The order of the solvers that are shown this form.
Order order_in(const std::vector<Rating>& ratings, const std::string& form) {
  Order order;
  for (const Rating& r : ratings) {
    if (r.form != form) continue;
    if (order.leader.empty()) order.leader = r.solver;
    order.ranks[r.solver] = r.rank;
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

/// How alike two orders are, of those that are in both; nothing of fewer than five.
Json compared(const std::string& family, const std::string& what, const Order& a, const Order& b) {
  std::vector<double> ranks_a;
  std::vector<double> ranks_b;
  for (const auto& [name, rank] : a.ranks) {
    const auto other = b.ranks.find(name);
    if (other == b.ranks.end()) continue;
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
          {"leader", a.leader},
          {"other_leader", b.leader},
          {"same_leader", a.leader == b.leader}};
}

}  // namespace

Json order_data(const ContestPlan& plan, const std::vector<Standing>& standings,
                const std::vector<Standing>& again, const ContestPlan& drawn,
                const std::vector<Group>& groups) {
  const std::size_t last = plan.budgets.size() - 1;
  ContestPlan halved = plan;
  halved.instances = plan.instances / 2;
  Json rows = Json::array();
  const auto add = [&rows](Json row) {
    if (!row.is_null()) rows.push_back(std::move(row));
  };
  for (const Group& group : groups) {
    const auto of = [&](const ContestPlan& p, const std::vector<Standing>& all,
                        std::size_t budget) { return rate(p, all, group.questions, budget); };
    const std::vector<Rating> first = of(plan, standings, 0);
    const std::vector<Rating> most = of(plan, standings, last);
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
