#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "problems/carrier_track/counting/staircase.h"
#include "src/analysis/statistics/intervals.h"
#include "src/studies/reproduction/study.h"

namespace ricochet::studies::reproduction {

namespace {

using namespace carrier_track;
using report::Chart;
using report::Mark;
using report::Results;

constexpr int threshold_digits = 10;  // thresholds are what others will compare with

std::optional<double> relative_error(const std::optional<double>& computed,
                                     const std::optional<double>& paper) {
  return computed && paper ? std::optional(*computed / *paper - 1) : std::nullopt;
}

Table threshold_table(const std::vector<CaseStudy>& cases) {
  Table table{"thresholds",
              {{"case"},
               {"restitution"},
               {"friction"},
               {"disturbance", "disturbance [N]"},
               {"silent_up_to", "silent up to [rad/s]", ".3f", threshold_digits},
               {"quiet_up_to", "quiet up to [rad/s]", ".3f", threshold_digits},
               {"loud_from", "every turn has more from [rad/s]", ".3f", threshold_digits},
               {"paper_threshold", "paper's threshold [rad/s]"},
               {"quiet_error", "difference [%]", "+.0%"},
               {"threshold", "threshold by the paper's rule [rad/s]", ".3f", threshold_digits},
               {"threshold_error", "difference [%]", "+.0%"}}};
  for (const CaseStudy& c : cases) {
    const Case& it = c.the_case;
    table.add(it.id, it.restitution, it.friction, it.disturbance, c.borders.silent, c.borders.quiet,
              c.borders.loud_from, it.claim.threshold,
              relative_error(c.borders.quiet, it.claim.threshold), c.score.threshold,
              relative_error(c.score.threshold, it.claim.threshold));
  }
  return table;
}

Chart threshold_chart(const std::vector<CaseStudy>& cases, const std::string& title) {
  Chart chart{.name = "thresholds",
              .title = title,
              .x = {.label = "case"},
              .y = {.label = "threshold [rad/s]",
                    .scale = report::Scale::logarithmic,
                    .range = report::Range{1, 20}},
              .series = {{"paper", Mark::points, {}},
                         {"computed by its rule", Mark::points, {}},
                         {"end of two a turn in the long run", Mark::points, {}}},
              .width = 640};
  for (const CaseStudy& c : cases) {
    const auto at = static_cast<double>(chart.x.categories.size());
    chart.x.categories.push_back(c.the_case.id);
    const std::optional<double> speeds[] = {c.the_case.claim.threshold, c.score.threshold,
                                            c.borders.quiet};
    for (std::size_t i = 0; i < chart.series.size(); ++i) {
      if (speeds[i]) chart.series[i].samples.push_back({at, speeds[i]});
    }
  }
  return chart;
}

/// The errors ln(computed / paper's threshold) of the cases that have both.
std::vector<std::vector<double>> errors_of(const Table& thresholds, const char* column) {
  std::vector<std::vector<double>> errors;
  each_row(thresholds, [&](const Row& row) {
    const auto computed = row.number_if(column), paper = row.number_if("paper_threshold");
    if (computed && paper) errors.push_back({std::log(*computed / *paper)});
  });
  return errors;
}

/// Their root mean square.
std::optional<double> error_of(const Table& thresholds, const char* column) {
  std::vector<double> errors;
  for (const auto& error : errors_of(thresholds, column)) errors.push_back(error.front());
  return errors.empty() ? std::nullopt : std::optional(root_mean_square(errors));
}

/// Which of the speeds in the paper's figures come out on its side.
std::string told_examples(const std::vector<CaseStudy>& cases) {
  int examples = 0, right = 0;
  std::string wrong;
  for (const CaseStudy& c : cases) {
    for (const Example& e : c.score.examples) {
      ++examples;
      right += e.right;
      if (e.right) continue;
      wrong += fmt::format("{}{} at {} rad/s ({} collisions, shown {})",
                           wrong.empty() ? " On the wrong side: " : ", ", c.the_case.id, e.omega,
                           e.count, e.loud ? "loud" : "quiet");
    }
  }
  return fmt::format(
      "Of the {} speeds that the paper's figures show as quiet or loud, {} come out on the paper's "
      "side.{}{}",
      examples, right, wrong, wrong.empty() ? "" : ".");
}

}  // namespace

void add_thresholds(const std::vector<CaseStudy>& cases, std::size_t fitted, Results& results) {
  Table table = threshold_table(cases);
  const auto errors = errors_of(table, "threshold");
  const auto error = error_of(table, "threshold");
  std::string told = "none can be compared";
  if (error) {
    const Interval interval = root_mean_square_interval(errors, 0.95, 10'000, 1);
    told = fmt::format("{:.0f} % (95 % interval {:.0f} to {:.0f} %)", 100 * *error,
                       100 * interval.lower, 100 * interval.upper);
  }
  results.set("finding",
              fmt::format("The computed thresholds differ from the paper's by {}, root mean square "
                          "in log speed, after fitting {} parameters to the same thresholds; {} of "
                          "10 can be compared.",
                          told, fitted, errors.size()));
  results.set("examples", told_examples(cases));
  results.set("error", error);
  results.set("compared", errors.size());
  results.set("fitted", fitted);
  results.set("quiet_error", error_of(table, "quiet_up_to"));
  results.set("loud_error", error_of(table, "loud_from"));
  for (const CaseStudy& c : cases) {
    results.set(c.the_case.id + ".threshold", c.score.threshold);
    results.set(c.the_case.id + ".quiet_count", c.score.quiet_count);
  }
  results.add(threshold_chart(
      cases, fmt::format("By the paper's rule the thresholds are {} from the paper's, after "
                         "fitting {} parameters",
                         told, fitted)));
  results.add(std::move(table));
}

namespace {

std::optional<StepSharpness> sharpness_of(const CaseStudy& c, double reach) {
  if (!c.score.threshold) return std::nullopt;
  return step_sharpness(c.scan, *c.score.threshold, quiet_limit(c.score.quiet_count), reach);
}

/// Whether ranges of another width give the same answer.
bool is_steady(const CaseStudy& c, Rise rise) {
  return std::ranges::all_of(std::array{1.25, 2.0}, [&](double reach) {
    const auto other = sharpness_of(c, reach);
    return other && other->rise == rise;
  });
}

std::string name_of(Rise rise) {
  return rise == Rise::step ? "a step" : rise == Rise::climb ? "a climb" : "no increase that lasts";
}

/// How many values of a group are this text.
Aggregate number_of(const char* column, const char* of, const std::string& text) {
  return {{column}, of, [text](const std::vector<Value>& values) {
            return value_of(std::ranges::count(values, Value(text)));
          }};
}

}  // namespace

void add_steps(const std::vector<CaseStudy>& cases, Results& results) {
  Table table{"steps",
              {{"case"},
               {"restitution"},
               {"paper_quiet_count", "paper's quiet count"},
               {"quiet_count", "quiet count"},
               {"purity", "purity [%]", ".0%"},
               {"before"},
               {"after"},
               {"relative_width", "width [% of the speed]", ".1%"},
               {"rise"},
               {"steady", "by other ranges the same"}}};
  int claimed = 0, same = 0;
  for (const CaseStudy& c : cases) {
    const auto found = sharpness_of(c, 1.5);
    const auto& claim = c.the_case.claim.quiet_count;
    claimed += claim.has_value();
    same += claim == c.score.quiet_count;
    table.add(c.the_case.id, c.the_case.restitution, claim, c.score.quiet_count, c.score.purity,
              value_of(found, &StepSharpness::before), value_of(found, &StepSharpness::after),
              value_of(found, [](const auto& it) { return it.width / it.threshold; }),
              found ? name_of(found->rise) : "no threshold",
              value_of(found, [&](const auto& it) { return is_steady(c, it.rise); }));
  }
  Table rises = aggregated(table, {"restitution"},
                           {{{"cases"}, "", count_of},
                            number_of("steps", "rise", "a step"),
                            number_of("climbs", "rise", "a climb")});
  rises.name = "rises";
  const Table claims =
      where(table, [](const Row& row) { return !is_missing(row["paper_quiet_count"]); });
  const Table purity =
      aggregated(claims, {}, {{{"least"}, "purity", least_of}, {{"most"}, "purity", most_of}});
  results.set("least-purity", purity.rows.empty() ? Value() : purity[0]["least"]);
  results.set("most-purity", purity.rows.empty() ? Value() : purity[0]["most"]);
  results.set("claimed-counts", claimed);
  results.set("same-counts", same);
  results.add(std::move(rises));
  results.add(std::move(table));
}

}  // namespace ricochet::studies::reproduction
