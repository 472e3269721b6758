#include "src/analysis/comparison/leaders.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "src/analysis/comparison/reported_part.h"
#include "src/analysis/comparison/shares.h"
#include "src/analysis/comparison/solver_pages.h"
#include "src/analysis/results.h"
#include "src/analysis/statistics/intervals.h"
#include "src/core/instance.h"

namespace ricochet::studies::comparison {

namespace {

constexpr double easy_for_random_search = 20;  // evaluations

/// The ranked entry with the largest success rate; null if none solved a run.
const Rating* solves_most(const std::vector<Rating>& ratings) {
  const Rating* most = nullptr;
  for (const Rating& rating : ratings) {
    if (!rating.rank || rating.returned == 0) continue;
    if (most == nullptr || rating.returned > most->returned) most = &rating;
  }
  return most;
}

std::string marked_name(const Rating& rating) {
  return entry(rating.solver, rating.formulation) + tuned_mark(rating.solver);
}

/// The median over the problems of a group; nothing without random search.
std::optional<double> random_search_time(const Comparison& comparison, const Group& group) {
  std::vector<double> times;
  for (const std::size_t q : group.problems) {
    if (const auto time = comparison::random_search_time(comparison, q)) times.push_back(*time);
  }
  return times.empty() ? std::optional<double>() : quantile(std::move(times), 0.5);
}

/// What the runs with the largest budget say of a problem, and whether it tells nothing.
struct Telling {
  Tries tries;
  std::optional<double> random;      ///< evaluations of random search
  std::optional<Silence> silence{};  ///< nothing for a problem that tells something
};

Telling telling_of(const Comparison& comparison, std::size_t problem) {
  Telling told{tries_on(comparison, problem), comparison::random_search_time(comparison, problem)};
  if (told.tries.solved == 0) {
    told.silence = Silence::unsolved;
  } else if (told.random && *told.random <= easy_for_random_search) {
    told.silence = Silence::easy;
  }
  return told;
}

std::vector<std::string> cluster_names(const Campaign& campaign,
                                       const std::vector<std::size_t>& problems) {
  std::vector<std::string> names;
  for (const std::size_t q : problems) names.push_back(cluster_of(campaign.problems()[q]));
  return names;
}

std::size_t clusters_in(const Campaign& campaign, const std::vector<std::size_t>& problems) {
  return places_by_cluster(cluster_names(campaign, problems)).size();
}

const std::vector<Column> columns_by_differences = {
    {"differences_first", "first with gradients by differences"},
    {"differences_returned", "success rate [%]", ".0%", 3},
    {"differences_best", "P(best)", ".2f", 3}};

}  // namespace

Tries tries_on(const Comparison& comparison, std::size_t problem) {
  Tries tries;
  for (const CellResult& result : comparison.results) {
    if (result.cell->problem != problem || !comparison.has_largest_budget(result)) continue;
    std::size_t solved = 0;
    for (const Outcome& outcome : result.outcomes) {
      solved += outcome.solved() ? 1 : 0;
      tries.gap = std::min(tries.gap, outcome.optimality_gap());
    }
    ++tries.entries;
    tries.runs += result.outcomes.size();
    tries.solved += solved;
    tries.solving += 2 * solved >= result.outcomes.size() ? 1 : 0;
  }
  return tries;
}

std::optional<double> random_search_time(const Comparison& comparison, std::size_t problem) {
  std::optional<double> least;
  for (const CellResult& result : comparison.results) {
    const PlannedCell& cell = *result.cell;
    if (cell.problem != problem || cell.cell.solver != "random-search" ||
        cell.formulation.smoothing > 0 || !comparison.has_largest_budget(result))
      continue;
    const auto time = result_of(result.outcomes).returned_running_time;
    const double value = time ? time->value : std::numeric_limits<double>::infinity();
    least = std::min(least.value_or(value), value);
  }
  return least;
}

void set_silent(const Campaign& campaign, const std::vector<CellResult>& results,
                std::vector<ReportedPart>& parts) {
  for (ReportedPart& part : parts) {
    const Comparison comparison = comparison_of(campaign, results, part.usual);
    for (const Group& group : groups_of(comparison)) {
      std::map<std::size_t, Silence> silent;
      for (const std::size_t q : group.problems) {
        if (const auto silence = telling_of(comparison, q).silence) silent[q] = *silence;
      }
      if (silent.size() < group.problems.size()) part.silent.merge(silent);
    }
  }
}

Table silent_table(const Campaign& campaign, const std::vector<CellResult>& results,
                   const std::vector<ReportedPart>& parts) {
  Table table{"silent",
              {{"family"},
               {"problem"},
               {"variables"},
               {"entries"},
               {"runs"},
               {"unsolved", "nobody solved it", "mark"},
               {"random", "evaluations of random search", ".2g", 3},
               {"gap", "least gap [tolerances]", ".3g", 3},
               {"left_out", "left out", "mark"}}};
  for (const ReportedPart& part : parts) {
    const Comparison comparison = comparison_of(campaign, results, part.usual);
    for (const Group& group : groups_of(comparison)) {
      if (part.asked_again.contains(group.family)) continue;
      for (const std::size_t q : group.problems) {
        const Telling told = telling_of(comparison, q);
        if (!told.silence) continue;
        const Problem& problem = campaign.problems()[q];
        table.add(part.families.at(group.family), problem.name, problem.dimension(),
                  told.tries.entries, told.tries.runs, told.silence == Silence::unsolved,
                  told.random, told.tries.gap / std::max(problem.tolerance, 1e-12),
                  part.silent.contains(q));
      }
    }
  }
  return table;
}

Table leader_table(const std::vector<RatedPart>& parts) {
  Table table{"leaders",
              {{"family"},
               {"budget", "evaluations a variable"},
               {"largest"},
               {"first", "first by mean rank"},
               {"solver"},
               {"formulation"},
               {"tuned"},
               {"returned", "success rate [%]", ".0%", 3},
               {"best", "P(best)", ".2f", 3},
               {"takes"},
               {"problems"},
               {"clusters"},
               {"ranked"},
               {"entries"},
               {"most", "solves most"},
               {"unsolved", "problems that nobody solved"},
               {"left_out", "problems left out"},
               {"random", "evaluations of random search", ".2g", 3}}};
  table.columns.insert(table.columns.end(), columns_by_differences.begin(),
                       columns_by_differences.end());
  each_group(parts, [&](const RatedPart& part, std::size_t g) {
    const Group& group = part.groups[g];
    const std::vector<std::int64_t>& budgets = part.comparison.part->budgets;
    const auto random = random_search_time(part.comparison, group);
    const bool easy = random && *random <= easy_for_random_search;
    auto unsolved = std::ranges::count_if(
        group.problems, [&](std::size_t q) { return tries_on(part.comparison, q).solved == 0; });
    std::int64_t left_out = 0;
    for (const auto& [q, silence] : part.part->silent) {
      if (part.part->families.at(part.comparison.campaign->family_of(q)) != group.family) continue;
      ++left_out;
      unsolved += silence == Silence::unsolved ? 1 : 0;
    }
    for (std::size_t b = 0; b < budgets.size(); ++b) {
      const std::vector<Rating>& ratings = part.ratings[g][b];
      const Rating* first = easy ? nullptr : leader_of(ratings);
      const Rating* most = easy ? nullptr : solves_most(ratings);
      if (first != nullptr && most->returned <= first->returned) most = nullptr;
      const Rating* by_differences =
          easy || !part.by_differences ? nullptr : leader_of(part.ratings_by_differences[g][b]);
      const bool is_largest = b + 1 == budgets.size();
      table.add(group.family, budgets[b], is_largest,
                first  ? entry(first->solver, first->formulation)
                : easy ? fmt::format("none named: random search needs {:.2g} evaluations", *random)
                       : "none (the least mean rank solved no run)",
                value_of(first, &Rating::solver), value_of(first, &Rating::formulation),
                first ? tuned_mark(first->solver) : "", value_of(first, &Rating::returned),
                value_of(first, &Rating::probability_of_being_best),
                value_of(first, &Rating::problems), group.problems.size(),
                clusters_in(*part.comparison.campaign, group.problems),
                std::ranges::count_if(ratings, [](const Rating& r) { return r.rank.has_value(); }),
                ratings.size(),
                value_of(most,
                         [](const Rating& r) {
                           return fmt::format("{}: {:.0f} %", entry(r.solver, r.formulation),
                                              100 * r.returned);
                         }),
                is_largest ? value_of(unsolved) : Value(), left_out, random,
                value_of(by_differences, marked_name), value_of(by_differences, &Rating::returned),
                value_of(by_differences, &Rating::probability_of_being_best));
    }
  });
  return table;
}

namespace {

/// Some problems or instances of a family.
struct Subset {
  std::string name;
  std::vector<std::size_t> problems;
  /// Of the instances of each problem every `step`-th from `first` on.
  std::size_t step = 1, first = 0;
};

/// A way to divide a family.
using Division = std::vector<Subset>;

/// Every number of variables apart, or, of many, ranges that double: 2, 3 to 4, 5 to 8 and so on.
Division by_variables(const Campaign& campaign, const Group& group) {
  constexpr std::size_t few = 4;
  std::map<Eigen::Index, std::vector<std::size_t>> by_number;
  for (const std::size_t q : group.problems) {
    by_number[campaign.problems()[q].dimension()].push_back(q);
  }
  Division division;
  Eigen::Index end = 0;
  for (const auto& [variables, of_number] : by_number) {
    if (by_number.size() <= few || variables > end) {
      end = 1;
      while (end < variables) end *= 2;
      division.emplace_back();
    }
    auto& problems = division.back().problems;
    problems.insert(problems.end(), of_number.begin(), of_number.end());
  }
  for (Subset& subset : division) subset.name = variables_of(campaign, subset.problems);
  return division;
}

Division by_constraints(const std::vector<Problem>& problems, const Group& group) {
  Division division{{"without constraints", {}}, {"with constraints", {}}};
  for (const std::size_t q : group.problems) {
    division[problems[q].constraints > 0 ? 1 : 0].problems.push_back(q);
  }
  return division;
}

/// Those problems whose starts are at several distances, by the distance.
Division by_start(const std::vector<Problem>& problems, const Group& group, int first_instance) {
  std::vector<double> scales;
  std::vector<std::size_t> started;
  for (const std::size_t q : group.problems) {
    const std::vector<double>& own = problems[q].start_scales;
    if (own.size() < 2 || (!scales.empty() && own != scales)) continue;
    scales = own;
    started.push_back(q);
  }
  Division division;
  for (std::size_t k = 0; k < scales.size(); ++k) {
    // Instance i has the scale of place i - 1.
    const std::size_t size = scales.size();
    const auto shift = static_cast<std::size_t>(first_instance - 1) % size;
    division.push_back({scales[k] == 1 ? "from the published start"
                                       : fmt::format("from {:g} times the start", scales[k]),
                        started, size, (k + size - shift) % size});
  }
  return division;
}

Comparison only(const Comparison& comparison, const Subset& subset) {
  Comparison some = comparison;
  std::erase_if(some.results, [&](const CellResult& result) {
    return std::ranges::find(subset.problems, result.cell->problem) == subset.problems.end();
  });
  if (subset.step == 1) return some;
  for (CellResult& result : some.results) {
    const std::size_t all = result.outcomes.size();
    const std::size_t left = all > subset.first ? (all - subset.first - 1) / subset.step + 1 : 0;
    result.outcomes = result.outcomes.every(subset.step, subset.first, left);
  }
  std::erase_if(some.results, [](const CellResult& result) { return result.outcomes.empty(); });
  return some;
}

std::vector<Rating> rated(const std::optional<Comparison>& comparison, const Subset& subset) {
  if (!comparison) return {};
  const Comparison some = only(*comparison, subset);
  return rate(some, some.problems(), some.part->budgets.size() - 1);
}

std::string first_solver(const std::vector<Rating>& ratings) {
  const Rating* first = leader_of(ratings);
  return first ? first->solver : "";
}

/// Adds a division if one of its parts has another first solver than the family.
void add_division(Table& table, const RatedPart& part, std::size_t g, const Division& division) {
  struct Rated {
    const Subset* subset;
    std::vector<Rating> usual, by_differences;
  };
  const std::string first = first_solver(part.most(g));
  const std::string first_by_differences =
      part.by_differences ? first_solver(part.ratings_by_differences[g].back()) : "";
  std::vector<Rated> all;
  bool differs = false;
  for (const Subset& subset : division) {
    if (subset.problems.empty()) return;
    all.push_back({&subset, rated(part.comparison, subset), rated(part.by_differences, subset)});
    if (all.back().usual.empty()) return;  // it has too few instances for this division
    differs |=
        first_solver(all.back().usual) != first ||
        (part.by_differences && first_solver(all.back().by_differences) != first_by_differences);
  }
  if (!differs || all.size() < 2) return;
  for (const Rated& one : all) {
    const Rating* leader = leader_of(one.usual);
    const Rating* other = leader_of(one.by_differences);
    table.add(part.groups[g].family, one.subset->name, one.subset->problems.size(),
              clusters_in(*part.comparison.campaign, one.subset->problems),
              leader ? entry(leader->solver, leader->formulation) : std::string("none"),
              leader ? tuned_mark(leader->solver) : "", value_of(leader, &Rating::returned),
              value_of(leader, &Rating::probability_of_being_best), value_of(other, marked_name),
              value_of(other, &Rating::returned),
              value_of(other, &Rating::probability_of_being_best));
  }
}

}  // namespace

Table subset_table(const std::vector<RatedPart>& parts) {
  Table table{"subsets",
              {{"family"},
               {"subset", "which of its problems"},
               {"problems"},
               {"clusters"},
               {"first", "first by mean rank"},
               {"tuned"},
               {"returned", "success rate [%]", ".0%", 3},
               {"best", "P(best)", ".2f", 3}}};
  table.columns.insert(table.columns.end(), columns_by_differences.begin(),
                       columns_by_differences.end());
  each_group(parts, [&](const RatedPart& part, std::size_t g) {
    const Campaign& campaign = *part.comparison.campaign;
    const Group& group = part.groups[g];
    add_division(table, part, g, by_variables(campaign, group));
    add_division(table, part, g, by_constraints(campaign.problems(), group));
    add_division(table, part, g,
                 by_start(campaign.problems(), group, campaign.plan().first_instance));
  });
  return table;
}

Table coverage_table(const std::vector<RatedPart>& parts) {
  Table table{"coverage",
              {{"family"},
               {"problems"},
               {"clusters"},
               {"effective", "effective number of problems", ".0f", 3},
               {"coverage", "coverage of the intervals [%]", ".0%", 3},
               {"ignoring", "if clusters were ignored [%]", ".0%", 3}}};
  each_group(parts, [&](const RatedPart& part, std::size_t g) {
    const Campaign& campaign = *part.comparison.campaign;
    const Group& group = part.groups[g];
    std::map<std::string, std::map<std::size_t, double>> shares;
    for (const CellResult& result : part.comparison.results) {
      if (!group.has(result) || !part.comparison.has_largest_budget(result)) continue;
      shares[entry(result.cell->cell.solver, result.cell->cell.formulation)][result.cell->problem] =
          result_of(result.outcomes).returned.share;
    }
    std::vector<std::vector<double>> entries;
    for (const auto& [name, of_problem] : shares) {
      if (of_problem.size() < group.problems.size()) continue;
      auto& mine = entries.emplace_back();
      for (const std::size_t q : group.problems) mine.push_back(of_problem.at(q));
    }
    const std::vector<std::string> clusters = cluster_names(campaign, group.problems);
    const std::size_t number = places_by_cluster(clusters).size();
    if (number < 2 || entries.empty()) return;
    const std::uint64_t seed = seed_of("coverage", group.family, 0, 0);
    table.add(group.family, group.problems.size(), number, effective_problems(entries, clusters),
              coverage_of_mean_share(entries, clusters, true, seed),
              coverage_of_mean_share(entries, clusters, false, seed));
  });
  return table;
}

}  // namespace ricochet::studies::comparison
