#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "problems/carrier_track/counting/staircase.h"
#include "problems/carrier_track/counting/threshold.h"
#include "ricochet/machine.h"
#include "src/analysis/comparison/group.h"
#include "src/analysis/comparison/solver_pages.h"
#include "src/studies/reproduction/sections.h"

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

Chart threshold_chart(const Findings& findings, const std::string& error) {
  Chart chart{.name = "thresholds",
              .title = fmt::format("By the paper's rule the thresholds are {} from the paper's, "
                                   "after fitting {} parameters",
                                   error, findings.interpretation.free.size()),
              .x = {.label = "case"},
              .y = {.label = "threshold [rad/s]",
                    .scale = report::Scale::logarithmic,
                    .range = report::Range{1, 20}},
              .series = {{"paper", Mark::points, {}},
                         {"computed by its rule", Mark::points, {}},
                         {"end of two a turn in the long run", Mark::points, {}}},
              .width = 640};
  for (const CaseStudy& c : findings.cases) {
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

/// Which of the speeds in the paper's figures come out on its side.
std::string told_examples(const std::vector<CaseStudy>& cases, const Agreement& agreement) {
  std::string wrong;
  for (const CaseStudy& c : cases) {
    for (const Example& e : c.score.examples) {
      if (e.right) continue;
      wrong += fmt::format("{}{} at {} rad/s ({} collisions, shown {})",
                           wrong.empty() ? " On the wrong side: " : ", ", c.the_case.id, e.omega,
                           e.count, e.loud ? "loud" : "quiet");
    }
  }
  return fmt::format(
      "Of the {} speeds that the paper's figures show as quiet or loud, {} come out on the paper's "
      "side.{}{}",
      agreement.examples, agreement.right, wrong, wrong.empty() ? "" : ".");
}

/// The root mean square of ln(border / paper's threshold).
std::optional<double> error_of(const std::vector<CaseStudy>& cases,
                               std::optional<double> LongRunBorders::*border) {
  std::vector<double> errors;
  for (const CaseStudy& c : cases) {
    const std::optional<double>& speed = c.borders.*border;
    if (speed && c.the_case.claim.threshold)
      errors.push_back(std::log(*speed / *c.the_case.claim.threshold));
  }
  if (errors.empty()) return {};
  return root_mean_square(errors);
}

}  // namespace

std::vector<QuietCase> quiet_cases(const std::vector<CaseStudy>& cases) {
  std::vector<QuietCase> quiet;
  for (const CaseStudy& c : cases) quiet.push_back({c.the_case, c.borders.quiet});
  return quiet;
}

void add_thresholds(const Findings& findings, Results& results) {
  const Agreement agreement = agreement_of(findings.cases);
  const std::string error =
      fmt::format("{:.0f} %{}", 100 * agreement.relative_error,
                  agreement.interval ? fmt::format(" (95 % interval {:.0f} to {:.0f} %)",
                                                   100 * agreement.interval->lower,
                                                   100 * agreement.interval->upper)
                                     : "");
  const std::size_t fitted = findings.interpretation.free.size();
  results.set(
      "finding",
      fmt::format("The computed thresholds differ from the paper's by {}, root mean "
                  "square in log speed, after fitting {} parameters to the same thresholds; {} of "
                  "10 can be compared.",
                  error, fitted, agreement.thresholds));
  results.set("examples", told_examples(findings.cases, agreement));
  results.set("error", agreement.relative_error);
  results.set("compared", agreement.thresholds);
  results.set("fitted", fitted);
  results.set("quiet_error", error_of(findings.cases, &LongRunBorders::quiet));
  results.set("loud_error", error_of(findings.cases, &LongRunBorders::loud_from));
  for (const CaseStudy& c : findings.cases) {
    results.set(c.the_case.id + ".threshold", c.score.threshold);
    results.set(c.the_case.id + ".quiet_up_to", c.borders.quiet);
    results.set(c.the_case.id + ".quiet_count", c.score.quiet_count);
  }
  results.add(threshold_table(findings.cases));
  results.add(threshold_chart(findings, error));
}

namespace {

constexpr double usual_reach = 1.5;

std::optional<StepSharpness> sharpness_of(const CaseStudy& c, double reach) {
  if (!c.score.threshold) return std::nullopt;
  return step_sharpness(c.scan, *c.score.threshold, quiet_limit(c.score.quiet_count), reach);
}

/// Whether ranges of another width give the same answer.
bool is_steady(const CaseStudy& c, Rise rise) {
  for (const double reach : {1.25, 2.0}) {
    const auto other = sharpness_of(c, reach);
    if (!other || other->rise != rise) return false;
  }
  return true;
}

std::string name_of(Rise rise) {
  return rise == Rise::step ? "a step" : rise == Rise::climb ? "a climb" : "no increase that lasts";
}

/// Returns true if the step is at the threshold of the paper's rule, applied to the same counts.
bool is_near(const Step& step, const std::optional<double>& threshold) {
  return threshold && std::abs(std::log(step.omega / *threshold)) < std::log(1.1);
}

std::string listed(const std::vector<Step>& steps) {
  std::string text;
  for (const Step& step : steps) {
    text += fmt::format("{}{:.2f} ({} to {})", text.empty() ? "" : "; ", step.omega, step.below,
                        step.above);
  }
  return text.empty() ? "none" : text;
}

/// How many cases of one restitution rise in which way: "at restitution 0.1 in 5 of 6 cases".
std::string told_rises(const std::vector<CaseStudy>& cases) {
  std::string text, unsteady;
  for (const double restitution : {0.1, 0.9}) {
    int all = 0, steps = 0, climbs = 0;
    for (const CaseStudy& c : cases) {
      if (c.the_case.restitution != restitution) continue;
      ++all;
      const auto found = sharpness_of(c, usual_reach);
      steps += found && found->rise == Rise::step;
      climbs += found && found->rise == Rise::climb;
      if (found && !is_steady(c, found->rise))
        unsteady += (unsteady.empty() ? "" : ", ") + c.the_case.id;
    }
    text +=
        fmt::format("{} restitution {} the increase is a step in {} of {} cases and a climb in {}",
                    text.empty() ? "At" : ", at", restitution, steps, all, climbs);
    if (steps + climbs < all) text += fmt::format("; in {} none lasts", all - steps - climbs);
  }
  text += unsteady.empty() ? ". Ranges to 1.25 and to 2 times the speed give the same verdicts."
                           : ". Ranges to 1.25 or to 2 times the speed give another verdict in " +
                                 unsteady + ".";
  return text;
}

/// How many thresholds are no step of the staircase.
std::string told_staircases(const std::vector<CaseStudy>& cases) {
  int thresholds = 0, with_step = 0, with_main_step = 0, without = 0;
  for (const CaseStudy& c : cases) {
    const std::vector<Step>& steps = c.staircase.steps;
    thresholds += c.score.threshold ? 1 : 0;
    without += steps.empty() ? 1 : 0;
    with_step += std::ranges::any_of(
        steps, [&](const Step& step) { return is_near(step, c.score.threshold); });
    const auto main = c.staircase.main_step();
    with_main_step += main && is_near(*main, c.score.threshold) ? 1 : 0;
  }
  return fmt::format(
      "Of {} thresholds by the paper's rule {} are no step of the staircase within a tenth of the "
      "speed, and {} not its most significant one. {} cases have no step at all: their counts rise "
      "gradually.",
      thresholds, thresholds - with_step, thresholds - with_main_step, without);
}

/// How much of what the paper says of the speeds below a threshold comes out.
std::optional<std::string> told_plateaus(const std::vector<CaseStudy>& cases) {
  std::optional<double> least, most;
  int claimed = 0, same = 0;
  double misclassified = 0;
  std::string others;
  for (const CaseStudy& c : cases) {
    misclassified = std::max(misclassified, c.score.misclassified);
    if (!c.the_case.claim.quiet_count) continue;
    ++claimed;
    const int claim = *c.the_case.claim.quiet_count;
    if (c.score.quiet_count == claim) {
      ++same;
    } else {
      others +=
          fmt::format("; {} has {} in place of {}", c.the_case.id, c.score.quiet_count, claim);
    }
    if (!c.score.purity) continue;
    least = std::min(least.value_or(1), *c.score.purity);
    most = std::max(most.value_or(0), *c.score.purity);
  }
  if (!least) return {};
  return fmt::format(
      "The paper says that one number of collisions holds at all speeds below. Here that number, "
      "or "
      "one more or less, holds at {:.0f} to {:.0f} % of them. {} of {} quiet counts are the "
      "paper's{}. At most {:.1g} % of all speeds lie on the wrong side of a threshold.",
      100 * *least, 100 * *most, same, claimed, others, 100 * misclassified);
}

}  // namespace

void add_steps(const std::vector<CaseStudy>& cases, Results& results) {
  Table table{"steps",
              {{"case"},
               {"paper_quiet_count", "paper's quiet count"},
               {"quiet_count", "quiet count"},
               {"purity", "purity [%]", ".0%"},
               {"before"},
               {"after"},
               {"relative_width", "width [% of the speed]", ".1%"},
               {"rise"},
               {"steps", "steps of the staircase [rad/s]"},
               {"main", "most significant", ".2f"}}};
  for (const CaseStudy& c : cases) {
    const auto found = sharpness_of(c, usual_reach);
    const auto main = c.staircase.main_step();
    table.add(c.the_case.id, c.the_case.claim.quiet_count, c.score.quiet_count, c.score.purity,
              found ? std::optional(found->before) : std::nullopt,
              found ? std::optional(found->after) : std::nullopt,
              found ? std::optional(found->width / found->threshold) : std::nullopt,
              found ? name_of(found->rise) : "no threshold", listed(c.staircase.steps),
              main ? std::optional(main->omega) : std::nullopt);
  }
  results.set("plateaus", told_plateaus(cases));
  results.set("rises", told_rises(cases));
  results.set("staircases", told_staircases(cases));
  results.add(std::move(table));
}

namespace {

using namespace comparison;

constexpr std::size_t told_entries =
    3;  // of a family, beside random search and the paper's algorithm
constexpr std::size_t pale_entries = 6;

/// The first entries, and the best ones of the paper's solver and of random search.
std::vector<const Rating*> told_ratings(const std::vector<Rating>& ratings) {
  std::vector<const Rating*> told;
  std::set<std::string> solvers;
  for (const Rating& rating : ratings) {
    const bool asked = rating.solver == paper_solver || rating.solver == "random-search";
    if (told.size() < told_entries || (asked && !solvers.contains(rating.solver)))
      told.push_back(&rating);
    solvers.insert(rating.solver);
  }
  return told;
}

report::Series runtimes_of(const Rating& rating, std::string label) {
  report::Series series{std::move(label), Mark::steps, {}};
  for (const Reach& reach : rating.progress) {
    if (series.samples.empty()) series.samples.push_back({reach.evaluations, 0});
    auto& samples = series.samples;
    const std::size_t many = samples.size();
    const double share = 100 * reach.share;
    const bool level =
        many > 1 && samples[many - 1].value == share && samples[many - 2].value == share;
    if (level) samples.pop_back();  // its ends suffice
    samples.push_back({reach.evaluations, share});
  }
  return series;
}

/// The ECDF of runtimes: the told entries in colour, others in grey.
Chart runtime_chart(const std::string& family, const std::vector<Rating>& ratings,
                    std::int64_t budget) {
  const Rating& first = ratings.front();
  Chart chart{.name = "runtimes",
              .title = fmt::format("{}: {} reaches {:.0f} % of the targets in {} evaluations a "
                                   "variable",
                                   family, entry(first.solver, first.formulation),
                                   100 * first.progress.back().share, budget),
              .x = {.label = "evaluations for each variable", .scale = report::Scale::logarithmic},
              .y = {.label = "targets reached [%]", .range = report::Range{0, 100}},
              .width = 720,
              .height = 360};
  std::vector<report::Series> told;
  std::set<std::string> solvers;
  for (const Rating* rating : told_ratings(ratings)) {
    const bool paper = rating->solver == paper_solver;
    told.push_back(runtimes_of(
        *rating, entry(rating->solver + (paper ? " (the paper's)" : ""), rating->formulation)));
    told.back().dark = paper;
    solvers.insert(rating->solver);
  }
  for (const Rating& rating : ratings) {
    if (chart.series.size() == pale_entries) break;
    if (!solvers.insert(rating.solver).second) continue;
    chart.series.push_back(runtimes_of(rating, ""));
    chart.series.back().pale = true;
  }
  chart.series.insert(chart.series.end(), told.begin(), told.end());
  return chart;
}

}  // namespace

void add_solvers(const std::optional<StoredCampaign>& comparison, Results& results) {
  Table table{"solvers",
              {{"family"},
               {"problems"},
               {"solver"},
               {"formulation"},
               {"rank", "mean rank", ".1f", 3},
               {"best", "P(best)", ".2f"},
               {"returned", "success rate [%]", ".0%", 3},
               {"share", "targets reached [%]", ".0%", 3},
               {"lower", "", ".0%", 4},
               {"upper", "", ".0%", 4}}};
  results.set("problems", comparison ? comparison->campaign.problems().size() : 0);
  std::set<std::string> versions;
  if (comparison) {
    const Campaign& campaign = comparison->campaign;
    for (const Solver& solver : campaign.solvers()) versions.insert(solver.version);
    const Comparison compared =
        comparison_of(campaign, cell_results(campaign, comparison->store), Conditions());
    const std::vector<Group> groups = groups_of(compared);
    const Ratings ratings = ratings_of(compared, groups);
    for (std::size_t g = 0; g < groups.size(); ++g) {
      const std::vector<Rating>& by_returned = ratings[g].back();
      if (by_returned.empty()) continue;
      for (const Rating* r : told_ratings(by_returned)) {
        const Reach& last = r->progress.back();
        table.add(groups[g].family, groups[g].problems.size(), r->solver, r->formulation, r->rank,
                  r->probability_of_being_best, r->returned, last.share, last.interval.lower,
                  last.interval.upper);
      }
      if (results.chart("runtimes") == nullptr)
        results.add(runtime_chart(groups[g].family, by_returned, compared.part->budgets.back()));
    }
  }
  std::string libraries;
  for (const std::string& version : versions)
    libraries += (libraries.empty() ? "" : ", ") + version;
  results.set("libraries", libraries);
  results.add(std::move(table));
}

void add_interpretation(const FittedInterpretation& interpretation, Results& results) {
  Table table{"parameters", {{"parameter"}, {"value", "", ".4g"}, {"unit"}, {"origin"}}};
  for (const Unknown open : unknowns_of(interpretation.interpretation)) {
    const auto i = static_cast<std::size_t>(open);
    table.add(unknown_parameters()[i].name, interpretation.constants[i],
              unknown_parameters()[i].unit,
              contains(interpretation.free, open) ? "fitted" : "fixed");
  }
  const auto* turns = std::get_if<Revolutions>(&interpretation.scene.window);
  results.set("turns", turns != nullptr ? std::optional(turns->count) : std::nullopt);
  results.set("interpretation", interpretation.name);
  results.set("description", interpretation.description);
  results.set("provenance", interpretation.provenance);
  results.add(std::move(table));
}

}  // namespace ricochet::studies::reproduction
