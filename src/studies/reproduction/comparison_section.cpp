#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "problems/carrier_track/questions/speed_problem.h"
#include "src/report/text.h"
#include "src/statistics/bootstrap.h"
#include "src/studies/reproduction/sections.h"

namespace ricochet::studies::reproduction {
namespace {

using report::lower_case;
using report::text_or_dash;

enum class Goal { count, top_speed };

Goal goal_of(const ContestResult& contest) {
  return contest.question.stated.constraints == 0 ? Goal::count : Goal::top_speed;
}

/// All runs of one solver with one goal, over all cases.
Standing total_of(const Study& study, const std::string& solver, Goal goal) {
  Standing total;
  total.solver = solver;
  for (const ContestResult& contest : study.contests) {
    if (goal_of(contest) != goal) continue;
    for (const Standing& s : contest.standings) {
      if (s.solver != solver) continue;
      total.form = s.form;
      total.failed += s.failed;
      total.regrets.insert(total.regrets.end(), s.regrets.begin(), s.regrets.end());
      total.evaluations.insert(total.evaluations.end(), s.evaluations.begin(), s.evaluations.end());
      total.seconds.insert(total.seconds.end(), s.seconds.begin(), s.seconds.end());
    }
  }
  return total;
}

double share_solved(const Standing& standing) {
  const auto solved = std::count_if(standing.evaluations.begin(), standing.evaluations.end(),
                                    [](const Effort& e) { return e.reached; });
  return static_cast<double>(solved) / static_cast<double>(standing.evaluations.size());
}

const char* name_of(Goal goal) {
  return goal == Goal::count ? "fewest collisions" : "fastest quiet speed";
}

/// The question's best value, where a run found a better one than was known, and who did.
std::string better_than_known(const ContestResult& contest) {
  double lowest = 0;
  std::string finder;
  for (const Standing& s : contest.standings) {
    for (const double regret : s.regrets) {
      if (regret < lowest) finder = s.solver;
      lowest = std::min(lowest, regret);
    }
  }
  return finder.empty()
             ? ""
             : fmt::format("{} by {:.3g} ({})", contest.question.name(), -lowest, finder);
}

report::Table table_of(const Study& study, Goal goal) {
  const std::string unit = goal == Goal::count ? "collisions" : "rad/s";
  report::Table table{
      fmt::format("Goal: {}, over all cases. Solved: runs that reached the best that an exhaustive "
                  "scan knows{}. To solve: expected evaluations, and milliseconds of processor "
                  "time, with restarts until solved. Median gap: to the best known, after {} "
                  "evaluations.",
                  name_of(goal), goal == Goal::count ? "" : ", within 0.01 rad/s",
                  study.plan.comparison.budget.evaluations),
      {{"solver", report::Alignment::left},
       {"is shown", report::Alignment::left},
       {"runs"},
       {"solved"},
       {"evaluations to solve"},
       {"ms to solve"},
       {fmt::format("median gap [{}]", unit)},
       {"failed"}},
      {}};
  for (const Solver& solver : study.solvers) {
    const Standing t = total_of(study, solver.name, goal);
    if (t.regrets.empty()) continue;
    auto milliseconds = expected_running_time(t.seconds);
    if (milliseconds) *milliseconds *= 1e3;
    const double gap = quantile(t.regrets, 0.5);
    table.rows.push_back({{solver.name},
                          {t.form},
                          {fmt::format("{}", t.regrets.size())},
                          {fmt::format("{:.0f} %", 100 * share_solved(t))},
                          {text_or_dash(expected_running_time(t.evaluations), "{:.0f}")},
                          {text_or_dash(milliseconds, "{:.3g}")},
                          {std::isfinite(gap) ? fmt::format("{:.3g}", gap) : "nothing quiet found"},
                          {fmt::format("{}", t.failed)}});
  }
  return table;
}

report::Figure map_of(const Study& study, Goal goal) {
  report::Chart chart;
  chart.name = goal == Goal::count ? "solved-count" : "solved-top-speed";
  chart.title = fmt::format("Runs solved [%]: {}", name_of(goal));
  chart.x.label = "case";
  report::HeatMap map{"solved [%]", {}, report::Range{0, 100}};
  for (const Solver& solver : study.solvers) {
    std::vector<std::optional<double>> row;
    for (const ContestResult& contest : study.contests) {
      if (goal_of(contest) != goal) continue;
      for (const Standing& s : contest.standings) {
        if (s.solver == solver.name) row.emplace_back(100 * share_solved(s));
      }
    }
    if (row.empty()) continue;
    map.rows.push_back(std::move(row));
    chart.y.categories.push_back(solver.name);
  }
  for (const ContestResult& contest : study.contests) {
    if (goal_of(contest) == goal) chart.x.categories.push_back(contest.question.machine);
  }
  chart.heat_map = std::move(map);
  chart.width = 640;
  chart.height = 460;
  return {chart, ""};
}

/// The cases whose progress is drawn: the paper's first at either restitution, and one disturbed.
bool is_charted(const std::string& case_id) {
  return case_id == "C1" || case_id == "C2" || case_id == "C9";
}

struct Price {
  const char* name;
  const char* label;
  std::vector<Progression> ContestResult::*of;
};

const Price evaluations{"evaluations", "evaluations", &ContestResult::by_evaluations};
const Price seconds{"seconds", "processor time [s]", &ContestResult::by_seconds};

/// Solvers that share a chart: more than seven lines with bands cannot be told apart.
struct Group {
  const char* name;  ///< part of the file's name
  const char* title;
  bool (*holds)(const Standing&);
};

bool is_smooth(const Standing& standing) {
  return standing.form.ends_with("surrogate");
}

bool is_nlopt(const Standing& standing) {
  return standing.solver.starts_with("nlopt");
}

const std::array<Group, 3> groups{
    {{"fireworks", "fireworks, evolution and chance",
      [](const Standing& s) { return !is_smooth(s) && !is_nlopt(s); }},
     {"count", "NLopt, shown the count",
      [](const Standing& s) { return !is_smooth(s) && is_nlopt(s); }},
     {"surrogate", "shown the surrogate", [](const Standing& s) { return is_smooth(s); }}}};

/// Below this gap [rad/s] the exhaustive scan cannot tell; the logarithmic axis ends here.
constexpr double smallest_gap = 1e-3;

report::Series series_of(const Progression& progression, const ContestResult& contest) {
  const auto shown = [&](double reached) {
    return goal_of(contest) == Goal::count
               ? reached
               : std::max(smallest_gap, reached - *contest.question.stated.best_known);
  };
  report::Series series{progression.solver, report::Mark::line, {}};
  for (std::size_t k = 0; k < progression.price.size(); ++k) {
    const double lower = shown(progression.lower[k]);
    const double upper = shown(progression.upper[k]);
    const bool bounded = std::isfinite(lower) && std::isfinite(upper);
    series.samples.push_back({progression.price[k], shown(progression.median[k]),
                              bounded ? std::optional(report::Range{lower, upper}) : std::nullopt});
  }
  return series;
}

report::Figure progress_of(const ContestResult& contest, const Price& price, const Group& group) {
  report::Chart chart;
  const bool count = goal_of(contest) == Goal::count;
  chart.name = fmt::format("{}-{}-{}-{}", count ? "fewest" : "fastest",
                           lower_case(contest.question.machine), group.name, price.name);
  chart.title = fmt::format("{}, {}: {}", contest.question.machine, count ? "fewest" : "fastest",
                            group.title);
  chart.x = {price.label, report::Scale::logarithmic};
  if (count) {
    chart.y.label = "true count";
    chart.lines = {
        {report::Direction::horizontal, *contest.question.stated.best_known, "best known"}};
  } else {
    chart.y = {"gap to the fastest [rad/s]", report::Scale::logarithmic,
               report::Range{smallest_gap, 20}};
  }
  const auto& progressions = contest.*price.of;
  for (std::size_t i = 0; i < progressions.size(); ++i) {
    if (group.holds(contest.standings[i])) {
      chart.series.push_back(series_of(progressions[i], contest));
    }
  }
  chart.height = 360;
  return {chart, ""};
}

}  // namespace

report::Section comparison_section(const Study& study) {
  report::Section section{"solvers", "Which solver finds it"};
  const ComparisonPlan& plan = study.plan.comparison;
  section.paragraphs = {
      fmt::format(
          "Two questions for every case: at which speed are the collisions fewest, and how "
          "fast may the machine turn and be quiet? Solvers without derivatives are shown "
          "the true count; those with derivatives the smooth surrogate and its exact "
          "gradient, in the limit half a collision above the highest quiet count. Those that take "
          "no constraints pay {} rad/s for each collision too many. "
          "All are judged by the true count at the points that they asked for. "
          "An evaluation is a simulation; a gradient costs another one. Each solver runs on "
          "{} instances of each question, the same for all: the box moved and reflected, a "
          "random start. A solver that ends early starts anew elsewhere, until {} "
          "evaluations are spent.",
          carrier_track::speed_penalty, plan.instances, plan.budget.evaluations),
      "In the charts a line is the median over the instances, its band the 95 % bootstrap interval "
      "of that median; gaps below 0.001 rad/s are drawn there. Lines begin where half of the runs "
      "have found something quiet. Charts show "
      "C1, C2 and C9; the tables and maps count every case compared."};
  std::string new_bests;
  for (const ContestResult& contest : study.contests) {
    const std::string found = better_than_known(contest);
    if (!found.empty()) new_bests += (new_bests.empty() ? "" : ", ") + found;
  }
  if (!new_bests.empty()) {
    section.paragraphs.push_back(fmt::format(
        "Better than the best values known: {}. A gap below 0 is one of these.", new_bests));
  }
  for (const Goal goal : {Goal::top_speed, Goal::count}) {
    section.tables.push_back(table_of(study, goal));
    section.figures.push_back(map_of(study, goal));
  }
  for (const ContestResult& contest : study.contests) {
    if (!is_charted(contest.question.machine)) continue;
    for (const Group& group : groups) {
      for (const Price& price : {evaluations, seconds}) {
        section.figures.push_back(progress_of(contest, price, group));
      }
    }
  }
  return section;
}

}  // namespace ricochet::studies::reproduction
