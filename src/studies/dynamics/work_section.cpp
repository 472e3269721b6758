#include <fmt/format.h>

#include <cmath>

#include "src/report/text.h"
#include "src/studies/dynamics/sections.h"

namespace ricochet::studies::dynamics {
namespace {

using report::Alignment;
using report::Cell;
using report::State;

struct Limit {
  double value;
  std::string words;
};

std::vector<Limit> limits_of(const SceneWork& work) {
  if (work.arena.chaotic) {
    return {
        {work.rate_spread, fmt::format("the rate right within {:.2g} %", 100 * work.rate_spread)}};
  }
  return {{1e-6, "an error below 1e-6 s"}, {1e-9, "an error below 1e-9 s"}};
}

/// Time of the loosest trial within a limit over that of the reference.
std::optional<double> slowdown(const SceneWork& work, const MethodWork& method, double limit) {
  const auto trial = loosest_within(method, limit);
  if (!trial) return std::nullopt;
  return trial->seconds / work.methods.front().trials.front().seconds;
}

/// The same of the evaluations of the forces.
std::optional<double> evaluations_ratio(const SceneWork& work, const MethodWork& method,
                                        double limit) {
  const auto trial = loosest_within(method, limit);
  const auto own = work.methods.front().trials.front().force_evaluations;
  if (!trial || own == 0) return std::nullopt;
  return static_cast<double>(trial->force_evaluations) / static_cast<double>(own);
}

std::string text_of(const std::optional<double>& ratio) {
  return report::text_or_dash(ratio, ratio && *ratio < 10 ? "{:.1f}" : "{:.0f}");
}

bool fails(const Trial& trial, bool chaotic) {
  return !trial.finished || (!chaotic && trial.accuracy.missed + trial.accuracy.spurious > 0);
}

report::Table table_of(const SceneWork& work) {
  report::Table table{
      work.arena.chaotic
          ? "Every method at its tightest control, and its processor time over the reference's at "
            "the loosest control from which on the rate of impacts is right; – where none is."
          : "Every method at its tightest control, and its processor time over the reference's at "
            "the loosest control from which on the error is that small; – where it never is.",
      {{"method", Alignment::left},
       {"tightest tolerance or step"},
       {"count difference"},
       {"missed"},
       {"spurious"},
       {work.arena.chaotic ? "relative error of the rate" : "impact-time error [s]"}},
      {}};
  const auto limits = limits_of(work);
  for (const Limit& limit : limits) table.columns.push_back({"time ratio with " + limit.words});
  for (const MethodWork& method : work.methods) {
    const Trial& tightest = method.trials.back();
    const bool matched = tightest.finished && !work.arena.chaotic;
    const auto count = [&](bool shown, int value, const char* form) {
      return shown ? Cell{fmt::format(fmt::runtime(form), value)} : Cell{"–"};
    };
    std::vector<Cell> row = {
        {method.method},
        {method.control == "none"
             ? "none"
             : fmt::format("{:.1e}{}", tightest.control, method.control == "step [s]" ? " s" : "")},
        count(tightest.finished, tightest.accuracy.count_difference, "{:+}"),
        count(matched, tightest.accuracy.missed, "{}"),
        count(matched, tightest.accuracy.spurious, "{}"),
        {tightest.finished ? report::text_or_dash(tightest.error, "{:.1e}") : "not finished",
         fails(tightest, work.arena.chaotic) ? State::bad : State::neutral}};
    for (const Limit& limit : limits) row.push_back({text_of(slowdown(work, method, limit.value))});
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::string failures(const SceneWork& work) {
  std::string names;
  for (const MethodWork& method : work.methods) {
    if (fails(method.trials.back(), work.arena.chaotic)) {
      names += (names.empty() ? "" : ", ") + method.method;
    }
  }
  if (names.empty()) {
    return work.arena.chaotic ? "Every method finishes at its tightest control."
                              : "At its tightest control every method has each impact.";
  }
  return fmt::format(
      "Even at the tightest control {} {}.",
      work.arena.chaotic ? "these do not finish:" : "these miss or invent impacts:", names);
}

std::string finding(const SceneWork& work) {
  const double microseconds = 1e6 * work.methods.front().trials.front().seconds / work.impacts;
  std::string text = fmt::format(
      "Found: the event-driven simulator takes {:.2g} µs per impact, {} impact{} in all.",
      microseconds, work.impacts, work.impacts == 1 ? "" : "s");
  for (const Limit& limit : limits_of(work)) {
    const MethodWork* best = nullptr;
    int reached = 0;
    for (std::size_t m = 1; m < work.methods.size(); ++m) {
      const auto ratio = slowdown(work, work.methods[m], limit.value);
      if (!ratio) continue;
      ++reached;
      if (!best || *ratio < *slowdown(work, *best, limit.value)) best = &work.methods[m];
    }
    text += best ? fmt::format(
                       " With {} the fastest other method is {}, at {} times that; {} of "
                       "{} others get there.",
                       limit.words, best->method, text_of(slowdown(work, *best, limit.value)),
                       reached, work.methods.size() - 1)
                 : fmt::format(" No other method gets to {}.", limit.words);
  }
  return text + " " + failures(work);
}

}  // namespace

report::Section work_section(const SceneWork& work) {
  report::Section section{"work-" + work.arena.id, work.arena.name};
  section.paragraphs = {finding(work), work.arena.description};
  if (work.arena.chaotic) {
    section.paragraphs.push_back(fmt::format(
        "32 references whose start velocity differs by parts in 1e12 have {:.1f} impacts on "
        "average, "
        "and three standard deviations are {:.2g} % of that. A method that is no further off is as "
        "good as exact. A rate asks little: it does not tell whether a single impact was right.",
        work.mean_impacts, 100 * work.rate_spread));
  }
  section.tables = {table_of(work)};
  section.figures = {work_chart(work)};
  return section;
}

report::Section speed_section(const std::vector<SceneWork>& works) {
  report::Section section{"speed", "What accuracy costs"};
  report::Table table{
      "Processor time over that of the event-driven simulator, at the loosest control from "
      "which on the impact-time error is below 1e-6 s, or, in the chaotic scene, the rate of "
      "impacts is right; – where no control is tight enough.",
      {{"method", Alignment::left}},
      {}};
  report::Table evaluations{"The same for evaluations of the forces, which no machine changes.",
                            {{"method", Alignment::left}},
                            {}};
  for (const SceneWork& work : works) {
    table.columns.push_back({work.arena.id});
    evaluations.columns.push_back({work.arena.id});
  }
  std::optional<double> least, most;
  int failed = 0, compared = 0;
  for (std::size_t m = 1; m < works.front().methods.size(); ++m) {
    auto& row = table.rows.emplace_back();
    auto& counted = evaluations.rows.emplace_back();
    row.push_back({works.front().methods[m].method});
    counted.push_back({works.front().methods[m].method});
    for (const SceneWork& work : works) {
      const double limit = limits_of(work).front().value;
      counted.push_back({text_of(evaluations_ratio(work, work.methods[m], limit))});
      const auto ratio = slowdown(work, work.methods[m], limit);
      row.push_back({text_of(ratio)});
      if (work.arena.chaotic) continue;
      ++compared;
      failed += ratio ? 0 : 1;
      if (ratio && (!least || *ratio < *least)) least = ratio;
      if (ratio && (!most || *ratio > *most)) most = ratio;
    }
  }
  section.paragraphs = {
      fmt::format("Found: where paths can be compared, impact times right to a microsecond cost "
                  "other methods {} to {} times the processor time of the event-driven simulator; "
                  "in {} of {} pairs of method and scene no control gets there.",
                  text_of(least), text_of(most), failed, compared),
      "The event-driven simulator knows the flight between two impacts in closed form and looks "
      "only for its ends, by steps that provably skip no wall. The others integrate numerically: "
      "Dormand-Prince and Rosenbrock (Boost.Odeint) and CVODE (SUNDIALS) with variable steps and "
      "a search for the impact within a step; semi-implicit Euler, Runge-Kutta of order 4 and "
      "Moreau-Jean with fixed steps, at whose end a wall is noticed. Each is run over a range of "
      "its control: relative tolerance or length of step.",
      "Impacts are matched with the reference's in order, by wall and time; the error is the "
      "largest difference in time. A run that misses an impact, has one too many or does not "
      "finish has failed. The reference is the project's own: that it is right is shown by closed "
      "forms and exact arithmetic in the tests, not here. Times are of one thread, the least of "
      "three measurements; of runs longer than 30 ms there is one.",
      "The sections after this one take a scene each. In their charts a point is a control: left "
      "is "
      "cheap, low is accurate. Points on the line \"failed\" are runs that failed. The vertical "
      "line "
      "is the event-driven simulator."};
  section.tables = {std::move(table), std::move(evaluations)};
  return section;
}

}  // namespace ricochet::studies::dynamics
