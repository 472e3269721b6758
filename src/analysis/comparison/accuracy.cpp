#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "src/analysis/comparison/profiles.h"
#include "src/analysis/comparison/solver_pages.h"
#include "src/analysis/statistics/intervals.h"
#include "src/core/instance.h"

namespace ricochet::studies::comparison {

namespace {

using report::Chart;
using report::Mark;
using report::Range;
using report::Scale;
using report::Series;

/// Moré and Wild's tau (2009, doi:10.1137/080724083).
struct Precision {
  double tau;
  const char* id;
};
constexpr Precision precisions[] = {{1e-1, "1e-1"}, {1e-3, "1e-3"}, {1e-5, "1e-5"}, {1e-7, "1e-7"}};

/// The optimality gap of an instance's start; that of a random point if the start is infeasible or
/// solves the problem already.
double start_gap(const Problem& problem, int number, const Targets& targets) {
  const double usual = std::max(targets.back(), std::numeric_limits<double>::min());
  try {
    const Problem seen = instance(problem, number);
    const TrueValues start = true_values_at(seen, seen.start);
    const double gap = start.objective - problem.best_known.value();
    const bool counts = start.violation <= 0 && std::isfinite(gap) && gap > problem.tolerance;
    return counts ? gap : usual;
  } catch (const std::exception&) {
    return usual;
  }
}

/// The runs of an entry on a problem, relative to the gaps of their starts.
struct Runs {
  std::vector<double> gaps;  ///< of the returned points
  /// For each precision, the evaluations a variable until it was reached, of each run; infinite if
  /// the returned point does not reach it.
  std::vector<std::vector<double>> times;
};

Runs runs_of(const Problem& problem, const CellResult& result, int first_instance,
             std::vector<double>& start_gaps) {
  Runs runs;
  runs.times.resize(std::size(precisions));
  for (std::size_t k = 0; k < result.outcomes.size(); ++k) {
    const Outcome& outcome = result.outcomes[k];
    while (start_gaps.size() <= k) {
      const int number = first_instance + static_cast<int>(start_gaps.size());
      start_gaps.push_back(start_gap(problem, number, *result.targets));
    }
    const double gap = merit_gap(problem, outcome) / start_gaps[k];
    runs.gaps.push_back(gap);
    const std::vector<Step> steps = steps_of(outcome);
    for (std::size_t p = 0; p < std::size(precisions); ++p) {
      double time = std::numeric_limits<double>::infinity();
      if (gap <= precisions[p].tau) {
        const auto step = std::ranges::find_if(steps, [&](const Step& one) {
          return one.optimality_gap <= precisions[p].tau * start_gaps[k];
        });
        time = static_cast<double>(step == steps.end() ? outcome.evaluations : step->evaluations) /
               static_cast<double>(problem.dimension());
      }
      runs.times[p].push_back(time);
    }
  }
  return runs;
}

/// The runs of an entry, problem by problem.
struct EntryRuns {
  std::string solver, formulation;
  std::vector<std::string> clusters;
  std::vector<Runs> problems;

  /// The share of runs, mean over problems, for which this is at most `most`.
  template <class Numbers>
  MeanShare share(const Numbers& numbers_of, double most) const {
    std::vector<double> shares;
    for (const Runs& runs : problems) {
      const std::vector<double>& numbers = numbers_of(runs);
      const auto within = std::ranges::count_if(numbers, [&](double x) { return x <= most; });
      shares.push_back(static_cast<double>(within) / static_cast<double>(numbers.size()));
    }
    return mean_share(shares, clusters);
  }
};

std::vector<EntryRuns> all_runs(const RatedPart& part, std::size_t g) {
  const Comparison& comparison = part.comparison;
  const int first_instance = comparison.campaign->plan().first_instance;
  std::map<std::size_t, std::vector<double>> start_gaps;
  std::map<std::string, EntryRuns> runs;
  for (const CellResult& result : comparison.results) {
    if (!part.groups[g].has(result) || !comparison.has_largest_budget(result)) continue;
    const Problem& problem = comparison.problem_of(result);
    const Cell& cell = result.cell->cell;
    EntryRuns& mine = runs[entry(cell.solver, cell.formulation)];
    mine.solver = cell.solver;
    mine.formulation = cell.formulation;
    mine.clusters.push_back(cluster_of(problem));
    mine.problems.push_back(
        runs_of(problem, result, first_instance, start_gaps[result.cell->problem]));
  }
  std::vector<EntryRuns> ranked;
  for (const Rating& rating : part.most(g)) {
    if (rating.rank) ranked.push_back(runs.at(entry(rating.solver, rating.formulation)));
  }
  return ranked;
}

const std::vector<double>& gaps_of(const Runs& runs) {
  return runs.gaps;
}

/// Lines of the first few entries in this order, and of the paper's algorithm.
std::vector<Series> lines_of(const std::vector<EntryRuns>& entries,
                             const std::vector<std::size_t>& order,
                             const std::vector<double>& positions, const auto& share_at) {
  constexpr std::size_t told = 5;
  std::vector<Series> lines;
  bool has_paper = false;
  for (const std::size_t k : order) {
    const EntryRuns& one = entries[k];
    const bool is_paper = one.solver == paper_solver;
    if (lines.size() >= told && (!is_paper || has_paper)) continue;
    has_paper |= is_paper;
    Series line{
        entry(one.solver, one.formulation) + (is_paper ? " (the paper's)" : ""), Mark::steps, {}};
    line.dark = is_paper;
    for (const double position : positions) {
      line.samples.push_back({position, 100 * share_at(one, position)});
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

/// Quality profiles (Fasano, Piermarini and Roma, arXiv:2607.16798): the share of runs whose
/// returned point leaves at most this share of the start's gap, over all shares.
Chart quality_chart(const std::string& family, const std::vector<EntryRuns>& entries) {
  std::vector<std::size_t> order(entries.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::vector<double> positions;
  for (int k = -24; k <= 0; ++k) positions.push_back(std::pow(10, k / 2.0));
  Chart chart{.name = "quality",
              .title = family + ": how much of the start's optimality gap is left",
              .x = {"gap of the returned point over that of the start", Scale::logarithmic},
              .y = {"runs [%]", Scale::linear, Range{0, 100}},
              .width = 720,
              .height = 380};
  chart.series = lines_of(entries, order, positions, [](const EntryRuns& one, double position) {
    return one.share(gaps_of, position).mean;
  });
  return chart;
}

/// The entries that reach a precision most often, and their data profile.
report::Part precision_part(const std::string& family, std::int64_t budget,
                            const std::vector<EntryRuns>& entries, std::size_t p) {
  const auto times_of = [p](const Runs& runs) -> const std::vector<double>& {
    return runs.times[p];
  };
  std::vector<MeanShare> shares;
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < entries.size(); ++k) {
    shares.push_back(entries[k].share(gaps_of, precisions[p].tau));
    order.push_back(k);
  }
  std::ranges::stable_sort(
      order, [&](std::size_t a, std::size_t b) { return shares[a].mean > shares[b].mean; });
  report::Part part{precisions[p].id, fmt::format("tau = {}", precisions[p].id), {}};
  Table table{"accuracy",
              {{"solver"},
               {"formulation"},
               {"problems"},
               {"share", "runs [%]", ".0%", 3},
               {"lower", "", ".0%", 3},
               {"upper", "", ".0%", 3}}};
  for (const std::size_t k : order) {
    const EntryRuns& one = entries[k];
    table.add(one.solver, one.formulation, one.problems.size(), shares[k].mean,
              shares[k].interval.lower, shares[k].interval.upper);
  }
  const std::vector<double> positions = evaluation_places(static_cast<double>(budget));
  Chart chart{.name = fmt::format("data-profile-{}", precisions[p].id),
              .title = fmt::format("{}: a share of {} of the start's gap is left", family,
                                   precisions[p].id),
              .x = {"evaluations for each variable", Scale::logarithmic},
              .y = {"runs [%]", Scale::linear, Range{0, 100}},
              .width = 720,
              .height = 380};
  chart.series = lines_of(entries, order, positions, [&](const EntryRuns& one, double position) {
    return one.share(times_of, position).mean;
  });
  part.results.add(std::move(chart));
  part.results.add(std::move(table));
  return part;
}

}  // namespace

void add_accuracy(const RatedPart& part, std::size_t group, report::Results& page) {
  const std::vector<EntryRuns> entries = all_runs(part, group);
  if (entries.empty()) return;
  const std::string& family = part.groups[group].family;
  page.add(quality_chart(family, entries));
  for (std::size_t p = 0; p < std::size(precisions); ++p) {
    page.add("precisions",
             precision_part(family, part.comparison.part->budgets.back(), entries, p));
  }
}

}  // namespace ricochet::studies::comparison
