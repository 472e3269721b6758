#include "src/app/own_comparison.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <utility>

#include "ricochet/error.h"
#include "src/analysis/rating.h"
#include "src/app/command_line.h"
#include "src/app/problem_choice.h"
#include "src/core/instance.h"
#include "src/core/names.h"
#include "src/report/results.h"
#include "src/report/text.h"

namespace ricochet::cli {

namespace {

using report::Chart;
using report::counted;
using report::Json;
using report::Results;
using report::Series;

constexpr double never = std::numeric_limits<double>::infinity();
constexpr std::size_t coloured = 5;  // curves of a chart
constexpr int finest_target = 6;     // targets at 1e-1, ..., 1e-6
constexpr std::uint64_t draws = 1;   // seed of the bootstrap

bool is_feasible(const Improvement& step) {
  return step.true_values.violation <= 0;
}

/// The best feasible value of a run within so many evaluations; infinite if there is none.
double value_within(const OwnRun& run, double evaluations = never) {
  double value = never;
  for (const Improvement& step : run.record.trace) {
    if (static_cast<double>(step.evaluations) > evaluations) break;
    if (is_feasible(step)) value = step.true_values.objective;
  }
  return value;
}

/// Evaluations until a feasible value of at most this; infinite if there is none.
double evaluations_until(const OwnRun& run, double value) {
  for (const Improvement& step : run.record.trace) {
    if (is_feasible(step) && step.true_values.objective <= value)
      return static_cast<double>(step.evaluations);
  }
  return never;
}

/// The value of each target from a start, the easiest first: between the median of the runs' first
/// feasible values, which of most is that of the start, and the best of all. Empty if there is
/// none.
std::vector<double> targets_of(const std::vector<OwnRun>& round, double best) {
  std::vector<double> first, targets;
  for (const OwnRun& run : round) {
    const auto& trace = run.record.trace;
    const auto step = std::find_if(trace.begin(), trace.end(), is_feasible);
    if (step != trace.end()) first.push_back(step->true_values.objective);
  }
  if (first.empty()) return targets;
  const double range = std::max(0.0, quantile(first, 0.5) - best);
  for (int digits = 1; digits <= finest_target; ++digits) {
    targets.push_back(best + std::pow(10.0, -digits) * range);
  }
  return targets;
}

/// Values within the tolerance of the best are equal, and fewer evaluations to get there are
/// better. Behind all feasible runs are the others, by their violation.
Ranking ranking_of_runs(const std::vector<OwnRun>& round, double best, double tolerance) {
  std::vector<std::optional<Reached>> reached;
  for (const OwnRun& run : round) {
    const double value = std::max(value_within(run), best + tolerance);
    const Improvement* nearest = run.best();
    if (value < never) {
      reached.push_back({{value, evaluations_until(run, value)}});
    } else {
      reached.push_back({{never, nearest ? nearest->true_values.violation : never}});
    }
  }
  return ranking_of(reached);
}

/// An entry over all starts. Values as they are minimised.
struct EntryScore {
  std::size_t entry = 0;
  std::optional<double> rank = {};   ///< mean over starts
  std::optional<double> first = {};  ///< probability
  double best = never, median = never;
  int feasible = 0;                                ///< runs
  double solver_seconds = 0, program_seconds = 0;  ///< mean of a run
};

/// How the entries did, by the best that any of them found.
struct Scores {
  double best = never;                            ///< feasible value of any run
  std::vector<std::vector<double>> targets = {};  ///< a row for each start
  std::vector<EntryScore> entries = {};           ///< best first
};

/// The share of the pairs of start and target that an entry reached within so many evaluations.
std::optional<double> share_reached(const OwnRuns& all, const Scores& scores, std::size_t entry,
                                    double evaluations) {
  int reached = 0, pairs = 0;
  for (std::size_t k = 0; k < all.runs.size(); ++k) {
    for (const double target : scores.targets[k]) {
      const double until = evaluations_until(all.runs[k][entry], target);
      reached += until < never && until <= evaluations ? 1 : 0;
      ++pairs;
    }
  }
  if (pairs == 0) return std::nullopt;
  return static_cast<double>(reached) / pairs;
}

Scores scores_of(const OwnRuns& all) {
  const std::size_t entries = all.entries.size();
  Scores scores;
  for (const auto& round : all.runs) {
    for (const OwnRun& run : round) scores.best = std::min(scores.best, value_within(run));
  }
  std::vector<RivalsAhead> ahead;
  for (const auto& round : all.runs) {
    scores.targets.push_back(targets_of(round, scores.best));
    if (entries < 2) continue;
    ahead.push_back(rivals_ahead({ranking_of_runs(round, scores.best, all.own.file().tolerance)}));
  }
  const auto means = mean_rivals_ahead(ahead, entries);
  std::vector<double> first;
  if (ahead.size() > 1) first = probabilities_of_being_first(ahead, entries, draws);
  const auto runs = static_cast<double>(all.runs.size());
  for (std::size_t e = 0; e < entries; ++e) {
    EntryScore score;
    score.entry = e;
    if (means[e]) score.rank = 1 + *means[e] * static_cast<double>(entries - 1);
    if (!first.empty()) score.first = first[e];
    std::vector<double> values;
    for (const auto& round : all.runs) {
      values.push_back(value_within(round[e]));
      score.feasible += values.back() < never ? 1 : 0;
      score.solver_seconds += round[e].record.ledger.seconds / runs;
      score.program_seconds += round[e].counts.seconds / runs;
    }
    score.best = *std::min_element(values.begin(), values.end());
    score.median = quantile(values, 0.5);
    scores.entries.push_back(score);
  }
  std::stable_sort(scores.entries.begin(), scores.entries.end(),
                   [](const EntryScore& a, const EntryScore& b) { return a.rank < b.rank; });
  return scores;
}

/// The value as the goal has it; missing if it is not finite.
std::optional<double> said(double value, const OwnRuns& all) {
  if (!std::isfinite(value)) return std::nullopt;
  return all.own.problem().maximises ? 0 - value : value;
}

std::string said_in_words(double value, const OwnRuns& all) {
  const std::string& unit = all.own.file().unit;
  return fmt::format("{:.9g}{}{}", said(value, all).value_or(NAN), unit.empty() ? "" : " ", unit);
}

std::string entry_name(const OwnEntry& entry) {
  return entry.formulation_name == "original"
             ? entry.solver.name
             : comparison::entry(entry.solver.name, entry.formulation_name);
}

Table entry_table(const OwnRuns& all, const Scores& scores) {
  Table table{"entries",
              {{"rank", "mean rank", ".1f"},
               {"solver"},
               {"formulation"},
               {"median", "median best", ".6g", 12},
               {"best", "best", ".6g", 12},
               {"feasible", "feasible runs"},
               {"reached", "targets reached [%]", ".0%"},
               {"first", "P(first)", ".2f"},
               {"program_seconds", "program [s]", ".3g"},
               {"solver_seconds", "solver [s]", ".3g"}}};
  for (const EntryScore& score : scores.entries) {
    const OwnEntry& entry = all.entries[score.entry];
    table.add(score.rank, entry.solver.name, entry.formulation_name, said(score.median, all),
              said(score.best, all), score.feasible, share_reached(all, scores, score.entry, never),
              score.first, score.program_seconds, score.solver_seconds);
  }
  return table;
}

/// Every run, as it can be made again by `solve`.
Table run_table(const OwnRuns& all) {
  Table table{"runs", columns_named("start,solver,formulation,budget,charged,objective,violation,"
                                    "evaluations,solver_seconds,program_seconds,failed_evaluations,"
                                    "failure")};
  for (Column& column : table.columns) column.digits = 17;
  for (std::size_t k = 0; k < all.runs.size(); ++k) {
    for (std::size_t e = 0; e < all.entries.size(); ++e) {
      const OwnRun& run = all.runs[k][e];
      const Improvement* best = run.best();
      table.add(k, all.entries[e].solver.name, all.entries[e].formulation_name, all.budget,
                run.record.ledger.charged,
                best ? said(best->true_values.objective, all) : std::nullopt,
                value_of(best, [](const Improvement& at) { return at.true_values.violation; }),
                value_of(best, [](const Improvement& at) { return at.evaluations; }),
                run.record.ledger.seconds, run.counts.seconds, run.counts.failed,
                one_line(run.record.failure));
    }
  }
  return table;
}

/// A chart with a curve for each entry over evaluations, about twenty points in a decade; the first
/// entries coloured, and on top.
template <class ValueAt>
Chart chart_of(const OwnRuns& all, const Scores& scores, const std::string& name,
               const std::string& title, const ValueAt& value_at) {
  std::set<double> places = {static_cast<double>(all.budget)};
  for (double at = 1; at < static_cast<double>(all.budget); at *= 1.12) {
    places.insert(std::round(at));
  }
  Chart chart{name, all.own.file().name + ": " + title};
  chart.x = {"evaluations", report::Scale::logarithmic};
  chart.width = 760;
  chart.height = 420;
  const auto first = std::min(coloured, scores.entries.size());
  const auto add = [&](std::size_t place) {
    const std::size_t e = scores.entries[place].entry;
    const bool pale = place >= first;
    Series curve{pale ? "" : entry_name(all.entries[e]), report::Mark::steps, {}, pale};
    for (const double at : places) curve.samples.push_back({at, value_at(e, at)});
    chart.series.push_back(std::move(curve));
  };
  for (std::size_t place = first; place < scores.entries.size(); ++place) add(place);
  for (std::size_t place = 0; place < first; ++place) add(place);
  return chart;
}

Chart progress_chart(const OwnRuns& all, const Scores& scores) {
  const auto starts = static_cast<std::int64_t>(all.runs.size());
  Chart chart = chart_of(all, scores, "best-so-far",
                         "best value so far, median over " + counted(starts, "start"),
                         [&](std::size_t e, double at) {
                           std::vector<double> values;
                           for (const auto& round : all.runs) {
                             values.push_back(value_within(round[e], at));
                           }
                           return said(quantile(values, 0.5), all);
                         });
  const std::string& unit = all.own.file().unit;
  chart.y.label = "best so far" + (unit.empty() ? "" : " [" + unit + "]");
  double least = never, most = 0;
  for (const Series& curve : chart.series) {
    for (const report::Sample& sample : curve.samples) {
      least = std::min(least, sample.value.value_or(never));
      most = std::max(most, sample.value.value_or(0));
    }
  }
  constexpr double far = 10;  // a ratio of values that a linear axis does not show
  if (least > 0 && most > far * least) chart.y.scale = report::Scale::logarithmic;
  return chart;
}

Chart target_chart(const OwnRuns& all, const Scores& scores) {
  Chart chart = chart_of(all, scores, "targets-reached", "targets reached",
                         [&](std::size_t e, double at) -> std::optional<double> {
                           const auto share = share_reached(all, scores, e, at);
                           return share ? std::optional(100 * *share) : std::nullopt;
                         });
  chart.y = {"targets reached [%]", report::Scale::linear, report::Range{0, 100}};
  return chart;
}

/// Who is first, and what that rests on.
std::string leader_in_words(const OwnRuns& all, const Scores& scores) {
  const EntryScore& leader = scores.entries.front();
  if (!leader.rank) return "There is one entry: nothing is compared.";
  const std::string starts = counted(static_cast<std::int64_t>(all.runs.size()), "start");
  std::string text =
      fmt::format("Of {} {} has the best mean rank, {:.1f} over {}.",
                  counted(static_cast<std::int64_t>(all.entries.size()), "entry", "entries"),
                  entry_name(all.entries[leader.entry]), *leader.rank, starts);
  if (!leader.first) return text + " One start says nothing about who is first from another.";
  return text + fmt::format(" Drawn again from these {}, it is first with probability {:.2f}.",
                            starts, *leader.first);
}

std::string shares_in_words(const OwnRuns& all) {
  const auto rounds = static_cast<std::int64_t>(all.runs.size());
  const auto entries = static_cast<std::int64_t>(all.entries.size());
  return fmt::format(
      "{} of {} from {}, with {} each: {} in all.{}", counted(rounds * entries, "run"),
      counted(entries, "entry", "entries"), counted(rounds, "start"),
      counted(all.budget, "evaluation"), rounds * entries * all.budget,
      rounds < all.rounds ? " The time was over before all starts had their turn." : "");
}

/// The best evaluated point of all runs.
struct OwnBest {
  std::size_t start, entry;
  Improvement found;
};

/// Of equal points the one that took the fewest evaluations; empty if no evaluation had a value.
std::optional<OwnBest> best_of(const OwnRuns& all) {
  std::optional<OwnBest> best;
  for (std::size_t k = 0; k < all.runs.size(); ++k) {
    for (std::size_t e = 0; e < all.entries.size(); ++e) {
      const Improvement* found = all.runs[k][e].best();
      if (!found || (best && better(best->found.true_values, found->true_values))) continue;
      if (!best || better(found->true_values, best->found.true_values) ||
          found->evaluations < best->found.evaluations) {
        best = {k, e, *found};
      }
    }
  }
  return best;
}

std::string answer_in_words(const OwnRuns& all, const OwnBest& best) {
  const TrueValues& values = best.found.true_values;
  const std::string what =
      values.violation > 0
          ? fmt::format("Nothing feasible found. The nearest point, not feasible by {:.3g}, has ",
                        values.violation)
          : "Best evaluated: ";
  return fmt::format("{}{}, by {} from start {} after {}.", what,
                     said_in_words(values.objective, all), entry_name(all.entries[best.entry]),
                     best.start, counted(best.found.evaluations, "evaluation"));
}

void add_answer(const OwnRuns& all, const OwnAnswer& answer, Results& results) {
  Table point{"point",
              {{"variable"}, {"value", "", ".9g", 17}, {"unit"}, {"bound", "on its bound"}}};
  for (const OwnAnswer::Coordinate& each : answer.point) {
    point.add(each.name, each.value, each.unit, each.bound);
  }
  Table constraints{"constraints", {{"constraint"}, {"value", "", ".3g"}, {"holds"}, {"active"}}};
  for (const OwnAnswer::Constraint& each : answer.constraints) {
    constraints.add(each.name, each.value, each.holds, each.active);
  }
  results.add(std::move(point));
  results.add(std::move(constraints));
  results.set("mean", value_of(answer.mean, [&](double mean) {
                const std::string& unit = all.own.file().unit;
                return fmt::format("{:.9g}{}{} ± {:.2g}", mean, unit.empty() ? "" : " ", unit,
                                   answer.standard_error.value_or(NAN));
              }));
  results.set("repetitions", answer.repetitions);
  results.set("said", in_words(all.own, answer));
}

/// Hash of every bit of the runs' improvements; times are left out.
std::string digest_of(const OwnRuns& all) {
  FnvHash hash;
  for (const auto& round : all.runs) {
    for (const OwnRun& run : round) {
      hash.add(fmt::format("{} {} {}\n", run.record.solver, run.record.ledger.charged,
                           run.record.failure.empty()));
      for (const Improvement& step : run.record.trace) {
        hash.add(fmt::format("{} {:a} {:a} {:a}\n", step.evaluations, step.true_values.objective,
                             step.true_values.violation, fmt::join(step.x, " ")));
      }
    }
  }
  return fmt::format("{:016x}", hash.value());
}

/// What the report own_comparison.md shows.
Results results_of(const OwnRuns& all, const std::optional<OwnBest>& best,
                   const OwnAnswer& answer) {
  const own::ProblemFile& file = all.own.file();
  const Scores scores = scores_of(all);
  Results results;
  results.set("name", file.name);
  results.set("goal", file.goal == own::Goal::maximise ? "maximise" : "minimise");
  results.set("tolerance", file.tolerance);
  results.set("best_known", file.best_known);
  results.set("answer", best ? answer_in_words(all, *best) : "No evaluation had a value.");
  add_answer(all, answer, results);
  results.set("leader", leader_in_words(all, scores));
  results.set("shares", shares_in_words(all));
  results.set("reference",
              scores.best < never ? std::optional(said_in_words(scores.best, all)) : std::nullopt);
  results.set("evaluations", evaluations_in_words(all.own, all.counts));
  results.set("digest", "digest " + digest_of(all));
  results.set("command", all.own.command());
  results.set("computed", all.counts.computed);
  results.set("found", all.counts.found);
  results.set("failed", all.counts.failed);
  Table failures{"failures", {{"evaluations"}, {"reason"}}};
  for (const own::FailureCount& each : all.own.store().failures()) {
    failures.add(each.evaluations, one_line(each.reason));
  }
  results.add(std::move(failures));
  results.add(entry_table(all, scores));
  results.add(run_table(all));
  Table failed =
      where(*results.table("runs"), [](const Row& row) { return !row.text("failure").empty(); });
  failed.name = "failed-runs";
  const auto failures_of_runs = std::ssize(failed.rows);
  results.set("failed_runs", failures_of_runs > 0 ? std::optional(failures_of_runs) : std::nullopt);
  results.add(std::move(failed));
  if (scores.best < never) {
    results.add(progress_chart(all, scores));
    results.add(target_chart(all, scores));
  }
  return results;
}

/// The answer at the best point; empty if there is none.
std::optional<OwnAnswer> answer_of(const OwnRuns& all, const std::optional<OwnBest>& best) {
  constexpr std::int64_t repetitions = 10;
  if (!best) return std::nullopt;
  return answer_at(all.own, best->found.x,
                   said(best->found.true_values.objective, all).value_or(NAN),
                   std::max(repetitions, all.budget / repetitions));
}

/// Compares solvers on one file, writes the report, and prints its end unless it is to be JSON.
/// Returns that.
Json compare_on(const OwnComparisonOptions& options, const std::string& file,
                const std::filesystem::path& folder) {
  Json told;
  const auto compute = [&](bool /*quick*/) {
    const OwnRuns all = own_runs(options, file);
    const std::optional<OwnBest> best = best_of(all);
    const std::optional<OwnAnswer> answer = answer_of(all, best);
    const Results results = results_of(all, best, answer.value_or(OwnAnswer()));
    told = {{"problem", all.own.file().name}, {"budget", all.budget}, {"digest", digest_of(all)}};
    told.update(json_of(all.own, all.counts, answer));
    told["entries"] = json_rows_of(*results.table("entries"));
    told["runs"] = json_rows_of(*results.table("runs"));
    return json_of(results);
  };
  const studies::Finished finished = studies::run({"own_comparison", "", compute}, false, folder);
  if (!options.json) tell(finished);
  report::require_none(finished.failures);
  return told;
}

}  // namespace

int compare_on_files(const OwnComparisonOptions& options) {
  const std::vector<std::string> files = split_patterns(options.compared.problems);
  std::vector<std::string> names;
  for (const std::string& file : files) {
    const std::string name = own::read_problem_file(file).name;
    if (std::find(names.begin(), names.end(), name) != names.end()) {
      throw InputError(file + ": another of the files has the same name, " + name);
    }
    names.push_back(name);
  }
  Json told = Json::array();
  for (std::size_t i = 0; i < files.size(); ++i) {
    const std::filesystem::path folder = options.out.empty() ? "reports/" + names[i]
                                         : files.size() == 1 ? options.out
                                                             : options.out + "/" + names[i];
    told.push_back(compare_on(options, files[i], folder));
  }
  if (options.json) fmt::print("{}\n", (told.size() == 1 ? told[0] : told).dump(2));
  for (const Json& each : told) {
    if (!each.contains("best")) {
      throw std::runtime_error(each["problem"].get<std::string>() + ": no evaluation had a value");
    }
  }
  return 0;
}

}  // namespace ricochet::cli
