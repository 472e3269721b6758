#include "src/research/limits/front_data.h"

#include <algorithm>
#include <array>
#include <map>

namespace ricochet::studies::limits {
namespace {

using namespace carrier_track;
using report::Json;
using report::list_of;

/// Evaluated points of one interpretation with the same number of fitted parameters.
struct Group {
  Interpretation interpretation;
  std::size_t constants;
  std::vector<const Judged*> points;
};

std::vector<Group> groups_of(const std::vector<Judged>& points) {
  std::vector<Group> groups;
  for (const Judged& point : points) {
    const auto same = [&](const Group& g) {
      return g.interpretation == point.fit.interpretation && g.constants == point.fit.free.size();
    };
    auto group = std::ranges::find_if(groups, same);
    if (group == groups.end()) {
      groups.push_back({point.fit.interpretation, point.fit.free.size(), {}});
      group = groups.end() - 1;
    }
    group->points.push_back(&point);
  }
  return groups;
}

/// The minimum by several numbers in lexicographic order.
template <class Order>
const Judged* first_by(const Group& group, Order order) {
  const Judged* best = nullptr;
  for (const Judged* point : group.points) {
    if (best == nullptr || order(*point) < order(*best)) best = point;
  }
  return best;
}

void add_corners(Json& rows, const Group& group) {
  using Key = std::array<double, 3>;
  const auto add = [&](const char* corner, auto order) {
    Json& row = rows.emplace_back(*first_by(group, order));
    row["corner"] = corner;
  };
  add("least error", [](const Judged& p) {
    return Key{double(p.examples_missed()), p.fine.threshold_error, 0};
  });
  add("most counts", [](const Judged& p) {
    return Key{double(p.examples_missed()), double(p.counts_missed()), p.fine.threshold_error};
  });
  add("purest", [](const Judged& p) {
    return Key{double(p.examples_missed()), -p.fine.purity, p.fine.threshold_error};
  });
  add("compromise", [](const Judged& p) { return Key{p.claims, 0, 0}; });
}

/// The Pareto front of two numbers, among points with all examples right.
template <class First, class Second>
Json pairs_of(const Group& group, First first, Second second) {
  std::vector<Pair> pairs;
  for (const Judged* p : group.points) {
    if (p->examples_missed() == 0) pairs.emplace_back(first(*p), second(*p));
  }
  return list_of(best_pairs(pairs), [](const Pair& pair) -> Json {
    return {{"x", pair.first}, {"y", pair.second}};
  });
}

Json curves_of(const Group& group) {
  const auto error = [](const Judged& p) { return p.fine.threshold_error; };
  const auto counts = [](const Judged& p) { return double(p.counts_missed()); };
  const auto impurity = [](const Judged& p) { return 1 - p.fine.purity; };
  return {{"constants", group.constants},
          {"interpretation", name_of(group.interpretation)},
          {"error_by_counts", pairs_of(group, counts, error)},
          {"error_by_impurity", pairs_of(group, impurity, error)},
          {"impurity_by_counts", pairs_of(group, counts, impurity)}};
}

/// Similarity of the fronts of several seeds.
Json seeds_of(const Results& results) {
  std::map<std::size_t, std::vector<double>> shares;
  for (const ChainedFront& front : results.fronts) {
    if (front.parameterisation.interpretation != results.plan.main) continue;
    shares[front.parameterisation.free.size()].push_back(front.dominated_share());
  }
  Json rows = Json::array();
  for (const auto& [constants, of_seeds] : shares) {
    const auto [lowest, highest] = std::minmax_element(of_seeds.begin(), of_seeds.end());
    rows.push_back({{"constants", constants},
                    {"shares", of_seeds},
                    {"apart", *highest > 0 ? (*highest - *lowest) / *highest : 0}});
  }
  return rows;
}

}  // namespace

Json front_data(const Results& results) {
  Json data = {{"corners", Json::array()},
               {"other_corners", Json::array()},
               {"fronts", Json::array()},
               {"other_fronts", Json::array()},
               {"front_seeds", seeds_of(results)}};
  for (const Group& group : groups_of(results.points)) {
    const bool main = group.interpretation == results.plan.main;
    add_corners(data[main ? "corners" : "other_corners"], group);
    data[main ? "fronts" : "other_fronts"].push_back(curves_of(group));
  }
  return data;
}

}  // namespace ricochet::studies::limits
