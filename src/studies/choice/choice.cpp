#include "src/studies/choice/choice.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <memory>
#include <numeric>
#include <set>
#include <utility>

#include "ricochet/error.h"
#include "src/analysis/statistics/intervals.h"

namespace ricochet::studies::choice {

namespace {

double mean_over_problems(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double solved_by_choice(const std::vector<Case>& cases) {
  return mean_over_families(all_of(cases), chosen_shares(cases));
}

/// Interval of 95 % of the mean over families.
Interval interval_of(const std::vector<Sample>& samples, const std::vector<double>& values) {
  std::vector<double> means;
  for (const Sample& sample : samples) means.push_back(mean_over_families(sample, values));
  return {quantile(means, 0.025), quantile(means, 0.975)};
}

/// The share of each case if each line had the entry that is first on that line's problems of the
/// other families, and the rule's own where no other family has such problems.
std::vector<double> left_out(const std::vector<Case>& cases) {
  std::map<std::pair<std::string, const RuleLine*>, std::string> learned;
  return values_of(cases, [&](const Case& held) {
    std::string& entry = learned[{held.family, held.line}];
    if (entry.empty()) {
      const std::vector<Case> others = only(cases, [&](const Case& each) {
        return each.line == held.line && each.family != held.family;
      });
      entry = others.empty() ? held.chosen : standings(others).front().entry;
    }
    return held.share_of(entry);
  });
}

/// The entry of a family that is first there, for each case of it.
std::vector<double> best_of_family(const std::vector<Case>& cases) {
  std::map<std::string, std::string> best;
  return values_of(cases, [&](const Case& each) {
    std::string& entry = best[each.family];
    if (entry.empty()) {
      entry = standings(only(cases, [&](const Case& c) { return c.family == each.family; }))
                  .front()
                  .entry;
    }
    return each.share_of(entry);
  });
}

std::vector<double> less(std::vector<double> a, const std::vector<double>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] -= b[i];
  return a;
}

std::string solver_in(const std::string& entry) {
  return entry.substr(0, entry.find(','));
}

/// The tables of a report. Every row names the runs (`runs`); lines and families are of the first
/// setting.
struct Tables {
  static Column share(const char* name, const char* title) { return {name, title, ".0%", 3}; }

  Table settings{"settings",
                 {{"runs"},
                  {"setting"},
                  {"problems"},
                  {"families"},
                  share("auto", "auto [%]"),
                  share("lower", "from"),
                  share("upper", "to"),
                  share("over_problems", "over problems [%]"),
                  share("left_out", "learned from other families [%]"),
                  {"single", "best single entry"},
                  share("single_share", "its [%]"),
                  share("family_best", "best of each family [%]"),
                  share("difference", "auto less that"),
                  share("difference_lower", "from"),
                  share("difference_upper", "to"),
                  share("problem_best", "best of each problem [%]"),
                  share("random_search", "random search [%]")}};
  Table lines{"lines",
              {{"runs"},
               {"declared"},
               {"solver"},
               {"problems"},
               {"families"},
               share("share", "solved [%]"),
               {"best", "best entry there"},
               share("best_share", "its [%]")}};
  Table families{"families",
                 {{"runs"},
                  {"family"},
                  {"problems"},
                  {"chosen"},
                  share("auto", "auto [%]"),
                  {"best", "best entry"},
                  share("best_share", "its [%]"),
                  share("difference", "auto less that"),
                  share("single", "best single entry [%]")}};

  void add(const std::string& runs, const Setting& setting, const std::vector<Case>& cases) {
    const std::vector<Standing> order = standings(cases);
    const std::vector<double> chosen = chosen_shares(cases);
    const std::vector<double> best = best_of_family(cases);
    const std::vector<double> difference = less(chosen, best);
    const std::vector<double> of_problem = values_of(cases, [](const Case& each) {
      double most = 0;
      for (const auto& [name, solved] : each.shares) most = std::max(most, solved);
      return most;
    });
    const Sample all = all_of(cases);
    const std::vector<Sample> samples = resampled(cases);
    const Interval interval = interval_of(samples, chosen);
    const Interval of_difference = interval_of(samples, difference);
    const auto random_search = std::find_if(order.begin(), order.end(), [](const Standing& each) {
      return solver_in(each.entry) == "random-search";
    });
    settings.add(runs, setting.title, cases.size(), all.size(), mean_over_families(all, chosen),
                 interval.lower, interval.upper, mean_over_problems(chosen),
                 mean_over_families(all, left_out(cases)), order[0].entry, order[0].mean,
                 mean_over_families(all, best), mean_over_families(all, difference),
                 of_difference.lower, of_difference.upper, mean_over_families(all, of_problem),
                 random_search == order.end() ? Value() : Value(random_search->mean));
    if (&setting != all_settings().data()) return;
    for (const RuleLine& line : rule_of_auto()) {
      const std::vector<Case> own =
          only(cases, [&](const Case& each) { return each.line == &line; });
      if (own.empty()) continue;
      const std::vector<Standing> there = standings(own);
      lines.add(runs, line.declared, solver_in(own[0].chosen), own.size(), by_family(own).size(),
                solved_by_choice(own), there[0].entry, there[0].mean);
    }
    for (const auto& [family, places] : by_family(cases)) add_family(runs, cases, places, order[0]);
  }

 private:
  void add_family(const std::string& runs, const std::vector<Case>& cases,
                  const std::vector<std::size_t>& places, const Standing& single) {
    std::vector<Case> own;
    std::set<std::string> chosen;
    double of_single = 0;
    for (const std::size_t i : places) {
      own.push_back(cases[i]);
      chosen.insert(solver_in(cases[i].chosen));
      of_single += single.shares[i] / static_cast<double>(places.size());
    }
    const Standing best = standings(own).front();
    const double share = solved_by_choice(own);
    families.add(runs, own[0].family, own.size(), fmt::format("{}", fmt::join(chosen, ", ")), share,
                 best.entry, best.mean, share - best.mean, of_single);
  }
};

/// What the first setting of each of the runs shows, in a sentence each.
std::string finding_of(const Table& settings) {
  std::string text, before;
  each_row(settings, [&](const Row& row) {
    const std::string runs = row.text("runs");
    if (runs == before) return;
    before = runs;
    const auto percent = [&](const char* name) { return 100 * row.number(name); };
    text += fmt::format(
        "{}On the problems of the plan {}, {}, auto solves {:.0f} % of the runs [{:.0f}, {:.0f}], "
        "mean over "
        "{} families; the "
        "best entry of each family {:.0f} %, the best single entry, {}, {:.0f} %.",
        text.empty() ? "" : " ", runs, row.text("setting"), percent("auto"), percent("lower"),
        percent("upper"), row.number("families"), percent("family_best"), row.text("single"),
        percent("single_share"));
  });
  return text;
}

/// The families of the first setting: auto, the best entry of each, the best single entry.
report::Chart families_chart(const Table& families) {
  report::Chart chart{
      .name = "families",
      .title = fmt::format("Share of the runs that solve, {}", all_settings()[0].title),
      .x = {.label = "family"},
      .y = {.label = "solved [%]", .range = report::Range{0, 100}},
      .width = 800};
  constexpr std::array<std::pair<const char*, const char*>, 3> shown = {
      {{"auto", "auto"},
       {"best entry of the family", "best_share"},
       {"best single entry", "single"}}};
  for (const auto& [label, column] : shown)
    chart.series.push_back({label, report::Mark::points, {}});
  each_row(families, [&](const Row& row) {
    const auto place = static_cast<double>(chart.x.categories.size());
    chart.x.categories.push_back(row.text("family"));
    for (std::size_t i = 0; i < shown.size(); ++i) {
      chart.series[i].samples.push_back({place, 100 * row.number(shown[i].second)});
    }
  });
  return chart;
}

}  // namespace

report::Results measured_choices(const std::vector<Evidence>& evidence) {
  Tables tables;
  for (const Evidence& each : evidence) {
    for (const Setting& setting : all_settings()) {
      const std::vector<Case> cases = cases_of(each, setting);
      if (!cases.empty()) tables.add(each.name, setting, cases);
    }
  }
  if (tables.settings.rows.empty()) {
    throw InputError("none of the runs are of a solver that auto would choose");
  }
  report::Results made;
  made.set("finding", finding_of(tables.settings));
  made.add(families_chart(tables.families));
  Table rule{"rule", {{"declared"}, {"solver"}, {"reason"}}};
  for (const RuleLine& line : rule_of_auto()) {
    rule.add(line.declared, fmt::format("{}", fmt::join(line.solvers, ", else ")), line.reason);
  }
  for (Table* table : {&rule, &tables.settings, &tables.lines, &tables.families}) {
    made.add(std::move(*table));
  }
  return made;
}

Study choice_study(std::vector<Evidence> evidence) {
  const auto all = std::make_shared<const std::vector<Evidence>>(std::move(evidence));
  return {"choice", "", [all](bool) { return json_of(measured_choices(*all)); }};
}

}  // namespace ricochet::studies::choice
