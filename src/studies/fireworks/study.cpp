#include "src/studies/fireworks/study.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <stdexcept>

#include "embedded/published.h"
#include "solvers/fireworks/fireworks.h"
#include "src/core/progress.h"
#include "src/report/json.h"
#include "src/report/table.h"

namespace ricochet::studies::fireworks {

namespace {

constexpr double negligible = 1e-8;

/// Quantile of Student's t for a two-sided 95 % interval of the mean of `degrees + 1` values, in
/// standard errors.
double student_t(double degrees) {
  return boost::math::quantile(boost::math::students_t(degrees), 0.975);
}

}  // namespace

std::vector<std::vector<double>> errors_of(const std::vector<Entry>& entries,
                                           std::int64_t evaluations, int runs,
                                           const std::string& progress) {
  std::vector<std::vector<double>> errors(entries.size(),
                                          std::vector<double>(static_cast<std::size_t>(runs)));
  Progress shown(progress, static_cast<double>(entries.size()) * runs);
  tbb::parallel_for(
      std::size_t{0}, entries.size() * static_cast<std::size_t>(runs), [&](std::size_t k) {
        const std::size_t number = k / entries.size();
        const std::size_t which = k % entries.size();
        const Entry& entry = entries[which];
        const RunRecord record =
            run(entry.problem(), entry.solver, {evaluations}, static_cast<int>(number) + 1);
        if (!record.failure.empty()) throw std::runtime_error(record.failure);
        errors[which][number] = record.trace.back().true_values.objective;
        shown.advance(1);
      });
  return errors;
}

Moments moments_of(const std::vector<double>& values) {
  const auto count = static_cast<double>(values.size());
  double mean = 0;
  for (const double value : values) mean += value / count;
  double variance = 0;
  for (const double value : values) variance += (value - mean) * (value - mean) / (count - 1);
  return {mean, std::sqrt(variance), values.size()};
}

bool agrees(const Moments& moments, const OtherMean& other) {
  const auto runs = static_cast<double>(moments.runs);
  const double other_deviation = other.deviation.value_or(moments.deviation);
  const double error =
      std::hypot(moments.deviation / std::sqrt(runs), other_deviation / std::sqrt(other.runs));
  const double apart = std::abs(moments.mean - other.mean);
  return apart <= std::max(student_t(runs - 1) * error, negligible);
}

namespace {

using namespace ricochet::fireworks;
using report::Json;

constexpr Eigen::Index dimension = 30;
constexpr std::int64_t evaluations_of_2010 = 10'000;  ///< and on the shifted sphere

/// A mean below this is printed as 0.000000.
constexpr double zero = 5e-7;

/// An optimum at more than this distance from the origin is far; a solver that is much worse there
/// is biased.
constexpr double far = 30;
constexpr double much = 100;

/// Below the axis of the chart.
constexpr double least_shown = 1e-3;

/// Published results of others; each list with its source.
const Json& published() {
  static const Json all = Json::parse(embedded::published);
  return all;
}

constexpr const char* rounded_name = "fireworks-authors with round(d U)";

/// Name and description of each variant, in the order of the table.
constexpr std::pair<const char*, const char*> descriptions[] = {
    {"fireworks", "equations (23) to (30) as the paper prints them, with the numbers of 2010"},
    {"fireworks-as-printed", "the same, with the slip in the third branch of equation (24)"},
    {"fireworks-authors", "Tan and Zhu's program, 2010: ceil(d U) coordinates move, by one draw"},
    {rounded_name, "as Tan and Zhu's paper has it, where their program takes the ceiling"},
    {"fireworks-corrected",
     "known defects corrected: as efwa, a coordinate moves at least, no clones, ties are drawn"},
    {"efwa", "enhanced: Zheng, Janecek and Tan, CEC 2013"},
    {"dynfwa", "dynamic search: Zheng, Janecek, Li and Tan, CEC 2014"},
    {"bbfwa", "bare bones, one firework: Li and Tan, 2018"},
    {"bbfwa-scaled", "bbfwa, with fewer sparks for smaller budgets: ours"},
    {"bbfwa-tuned", "bbfwa, with 2 sparks and decline 0.8, chosen on this suite: ours"},
    {"lotfwa", "loser-out tournament of 5 fireworks: Li and Tan, 2018"},
    {"lotfwa-scaled", "lotfwa, with fewer sparks for smaller budgets: ours"},
    {"mgfwa", "lotfwa with guiding sparks: Meng and Tan, 2023, as in their program"},
    {"fwassp", "search space partition: Li and Tan, 2021, as in their program"}};

/// A published mean, and who is to give it.
struct Published {
  Entry entry;
  std::string function;
  OtherMean other;
};

/// Adds a row for each mean.
void add_means(Table& results, const std::vector<Published>& means, std::int64_t evaluations,
               int runs, const std::string& progress) {
  std::vector<Entry> entries;
  for (const Published& mean : means) entries.push_back(mean.entry);
  const auto errors = errors_of(entries, evaluations, runs, progress);
  for (std::size_t k = 0; k < means.size(); ++k) {
    const OtherMean& other = means[k].other;
    const Moments moments = moments_of(errors[k]);
    // A published zero of 2010, which has a deviation, must be one.
    const bool is_zero = other.deviation && other.mean < zero;
    results.add(entries[k].solver.name, means[k].function, moments.mean, moments.deviation,
                other.mean, other.deviation,
                is_zero ? moments.mean < zero : agrees(moments, other));
  }
}

/// The nine means of 2010, by each interpretation of that algorithm.
std::vector<Published> means_of_2010() {
  const Json& table = published()["table_3"];
  // Tan and Zhu's paper rounds; their program rounds up.
  FireworksOptions rounded = authors_options();
  rounded.moved = rounded.gaussian_moved = Moved::rounded;
  std::vector<Published> means;
  for (const Json& row : table["rows"]) {
    Problem problem = benchmark_function(row["function"].get<std::string>(), dimension);
    const OtherMean other{row["mean"].get<double>(), table["runs"].get<int>(),
                          row["deviation"].get<double>()};
    for (auto [name, options] :
         {std::pair("fireworks", paper_options()),
          std::pair("fireworks-authors", authors_options()), std::pair(rounded_name, rounded)}) {
      options.start_region = {row["lower"].get<double>(), row["upper"].get<double>()};
      means.push_back(
          {{ricochet::fireworks::fireworks(name, options), [problem] { return problem; }},
           problem.name,
           other});
    }
  }
  return means;
}

/// Those of the competition of CEC 2013; none without pagmo.
std::vector<Published> means_of_2013() {
  std::vector<Published> means;
#ifdef RICOCHET_HAS_PAGMO
  const Json& table = published()["cec2013"];
  for (const Solver& solver : family()) {
    for (const Json& row : table["rows"]) {
      if (!row.contains(solver.name)) continue;
      const auto number = row["number"].get<unsigned>();
      means.push_back({{solver, [number] { return cec2013(number, dimension); }},
                       row["function"].get<std::string>(),
                       {row[solver.name].get<double>(), table["runs"].get<int>()}});
    }
  }
#endif
  return means;
}

Table results_table(const ComparisonPlan& plan) {
  Table results{"results",
                {{"solver"},
                 {"function"},
                 {"mean", "mean error", ".4g", 17},
                 {"deviation", "standard deviation", ".2g"},
                 {"published", "theirs", ".4g", 17},
                 {"published_deviation", "standard deviation of theirs", ".2g"},
                 {"agrees", "agrees", "mark"}}};
  add_means(results, means_of_2010(), evaluations_of_2010, plan.runs, "functions of 2010");
  add_means(results, means_of_2013(), plan.competition_evaluations, plan.competition_runs,
            "functions of CEC 2013");
  // By solver, each with its functions in the order of the publication.
  Table ordered{results.name, results.columns};
  for (const auto& [name, description] : descriptions) {
    for (auto& row : where(results, "solver", value_of(name)).rows) ordered.add_row(std::move(row));
  }
  return ordered;
}

/// Errors on Sphere, by where every coordinate of the optimum is.
Table shift_table(int runs) {
  Table table{"shift",
              {{"solver"},
               {"shift", "optimum at"},
               {"mean", "mean error", ".2g", 17},
               {"deviation", "standard deviation", ".1g"}}};
  const std::vector<Solver> members = family();
  const Json& rows = published()["shift"]["rows"];
  std::vector<Entry> entries;
  for (const Solver& member : members) {
    for (const Json& row : rows) {
      Problem problem = shifted_sphere(row["shift"].get<double>(), dimension);
      entries.push_back({member, [problem] { return problem; }});
    }
  }
  const auto errors = errors_of(entries, evaluations_of_2010, runs, "shifted sphere");
  for (std::size_t k = 0; k < entries.size(); ++k) {
    const Moments moments = moments_of(errors[k]);
    table.add(entries[k].solver.name, rows[k % rows.size()]["shift"].get<double>(), moments.mean,
              moments.deviation);
  }
  return table;
}

/// Whether a solver is much worse with the optimum far from the origin than at it; nothing if it
/// did not run.
std::optional<bool> is_biased(const Table& shift, const std::string& solver) {
  const Table own = where(shift, "solver", value_of(solver));
  if (own.rows.empty()) return {};
  double worst_far = 0;
  each_row(own, [&](const Row& row) {
    if (row.number("shift") >= far) worst_far = std::max(worst_far, row.number("mean"));
  });
  return worst_far > much * own[0].number("mean");
}

Table variants_table(const Table& results, const Table& shift) {
  Table table{"variants",
              {{"solver"},
               {"what", "what it is"},
               {"compared", "means compared"},
               {"agreeing", "agree"},
               {"biased", "biased to the origin"}}};
  for (const auto& [name, description] : descriptions) {
    const Table own = where(results, "solver", value_of(name));
    std::optional<std::size_t> compared, agreeing;
    if (!own.rows.empty()) {
      compared = own.rows.size();
      agreeing = where(own, "agrees", true).rows.size();
    }
    table.add(name, description, compared, agreeing, is_biased(shift, name));
  }
  return table;
}

report::Chart shift_chart(const Table& shift, const Table& variants, int runs) {
  using report::Mark;
  std::vector<std::string> biased;
  report::Chart chart{
      .name = "shift",
      .title = "",
      .x = {"every coordinate of the optimum"},
      .y = {"mean error at the end", report::Scale::logarithmic, report::Range{least_shown, 1e5}},
      .width = 640,
      .height = 420};
  bool labelled = false;
  each_row(variants, [&](const Row& variant) {
    const std::string solver = variant.text("solver");
    const Table own = where(shift, "solver", value_of(solver));
    if (own.rows.empty()) return;
    const bool pale = !variant.is("biased");
    if (!pale) biased.push_back(solver);
    report::Series series{pale ? (labelled ? "" : "the others") : solver, Mark::line, {}, pale};
    labelled = labelled || pale;
    each_row(own, [&](const Row& row) {
      series.samples.push_back({row.number("shift"), std::max(row.number("mean"), 1e-300)});
    });
    chart.series.push_back(std::move(series));
  });
  report::Series other{"another program, 2010's algorithm", Mark::points, {}};
  for (const Json& row : published()["shift"]["rows"]) {
    other.samples.push_back({row["shift"].get<double>(), row["mean"].get<double>()});
  }
  chart.series.push_back(std::move(other));
  chart.title = biased.empty()
                    ? fmt::format("No variant misses an optimum far from the origin")
                    : fmt::format("{} miss an optimum that is not at the origin (mean of {} runs)",
                                  fmt::join(biased, ", "), runs);
  return chart;
}

/// What holds of the algorithm as the paper prints it, and of its successors.
std::string finding_of(const Table& results, const Table& variants) {
  const Table own = where(results, "solver", value_of("fireworks"));
  const Table agreeing = where(own, "agrees", true);
  const auto zeros =
      where(agreeing, [](const Row& row) { return row.number("published") < zero; }).rows.size();
  std::string text = fmt::format(
      "The solver fireworks, the paper's algorithm, gives {} of the {} means published in 2010, {} "
      "of "
      "them zeros with the optimum at the origin",
      agreeing.rows.size(), own.rows.size(),
      zeros == agreeing.rows.size() ? "all" : fmt::format("{}", zeros));
  if (variants[0].is("biased")) text += ", to which it is biased";
  text += ".";
  const Table successors =
      where(results, [](const Row& row) { return !row.text("solver").starts_with("fireworks"); });
  if (!successors.rows.empty()) {
    text += fmt::format(" Of {} means of its successors, {} agree with those of other programs.",
                        successors.rows.size(), where(successors, "agrees", true).rows.size());
  }
  return text;
}

}  // namespace

report::Results compared_with_published(const ComparisonPlan& plan) {
  Table results = results_table(plan);
  Table shift = shift_table(plan.runs);
  Table variants = variants_table(results, shift);
  report::Results all;
  all.set("finding", finding_of(results, variants));
  all.set("runs", plan.runs);
  all.set("evaluations", evaluations_of_2010);
  all.set("competition-runs", plan.competition_runs);
  all.set("competition-evaluations", plan.competition_evaluations);
  all.set("published-runs", published()["table_3"]["runs"].get<int>());
  all.set("published-competition-runs", published()["cec2013"]["runs"].get<int>());
  all.set("source", published()["table_3"]["source"].get<std::string>());
  all.set("much", much);
  all.set("far", far);
  all.add(shift_chart(shift, variants, plan.runs));
  all.add(std::move(variants));
  all.add(std::move(results));
  all.add(std::move(shift));
  return all;
}

}  // namespace ricochet::studies::fireworks

namespace ricochet::studies {

Study fireworks_study() {
  return {"fireworks", "Fewer runs, in a minute", [](bool quick) {
            report::Results results =
                fireworks::compared_with_published({quick ? 5 : 20, quick ? 2 : 15, 300'000});
            results.set("quick", quick ? std::optional("This is the quick version, with few runs: "
                                                       "expect disagreement by chance.")
                                       : std::nullopt);
            return json_of(results);
          }};
}

}  // namespace ricochet::studies
