#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "src/analysis/export/formats.h"
#include "src/analysis/export/output.h"
#include "src/analysis/outcomes.h"
#include "src/core/names.h"
#include "src/report/json.h"

namespace ricochet::exports {

namespace {

namespace fs = std::filesystem;
using report::Json;

constexpr const char* coco_readme =
    R"(A campaign of ricochet for the post-processing of COCO, https://github.com/numbbo/coco:
python -m cocopp FOLDER FOLDER ...

Every folder is one algorithm: a solver-formulation pair with its perturbation, price of a gradient,
and budget in evaluations per variable. Every problem is one function with its own number of
variables; running_times.csv lists them.

The files use the format of COCO's suite bbob-mixint, of which cocopp opens only 5 and 6 variables
and functions 1 to 24. Problems of 5 and 6 variables have the first numbers. All others are here,
too, for a cocopp that knows them. The function names in cocopp's pages are not ricochet's.

Values are optimality gaps: the true objective minus the best known value (fopt), of feasible points
only; 1e30 until there is one. Evaluations are as charged, gradients at their price; evaluations of
constraints are included and not counted again. Coordinates are those of the best point, else nan.
cocopp's targets do not know the problems' tolerances. See running_times.csv for solved runs and
expected running times: unsolved runs count with all their evaluations, identical runs count once,
intervals are 95 %. Runs on the same instance have different seeds. A run that ended before its
first evaluation is listed with one evaluation.
)";

/// The next count at which every run has a row in .tdat: 1, 2, 5, 10, 20, ...
std::int64_t after(std::int64_t count) {
  std::int64_t power = 1;
  while (count / power >= 10) power *= 10;
  const std::int64_t digit = count / power;
  return power * (digit == 1 ? 2 : digit == 2 ? 5 : 10);
}

/// The file, whose folder is made if it is not there.
fs::path in_made_folder(const fs::path& file) {
  fs::create_directories(file.parent_path());
  return file;
}

/// Files of one algorithm on one problem.
class CocoCase {
 public:
  CocoCase(const comparison::JudgedRun& first, const CampaignDescription& /*campaign*/,
           const Completeness& completeness, Numbering& numbering, const fs::path& folder)
      : comment_(completeness.is_in_doubt() ? "of a campaign of ricochet: " + in_words(completeness)
                                            : "of ricochet"),
        root_(folder / numbering.algorithm(first.stored.key.cell)),
        id_(numbering.function_id(first.problem.name)),
        variables_(first.problem.variables),
        algorithm_(numbering.algorithm(first.stored.key.cell)),
        stem_(fmt::format("data_f{0}/bbobexp_f{0}_DIM{1}", id_, variables_)),
        improvements_(in_made_folder(root_ / (stem_ + ".dat"))),
        counts_(root_ / (stem_ + ".tdat")) {}

  void add(const comparison::JudgedRun& run) {
    const double fopt = run.problem.best_known;
    const std::string header = header_of(fopt);
    improvements_.write(header);
    counts_.write(header);
    const auto steps = best_so_far(run.outcome);
    const auto& trace = run.stored.record.trace;
    std::int64_t count = 1;
    for (std::size_t k = 0; k < steps.size(); ++k) {
      const bool is_best = steps[k].optimality_gap == steps.back().optimality_gap &&
                           !trace.empty() && trace.back().true_values.violation <= 0;
      const std::string values =
          values_of(steps[k].optimality_gap, fopt, is_best ? &trace.back().x : nullptr);
      improvements_.write(fmt::format("{} {}", steps[k].evaluations, values));
      const bool last = k + 1 == steps.size();
      for (; !last && count < steps[k + 1].evaluations; count = after(count)) {
        counts_.write(fmt::format("{} {}", count, values));
      }
      if (last) counts_.write(fmt::format("{} {}", steps[k].evaluations, values));
    }
    summary_ += fmt::format(", {}:{}|{:.1e}", run.stored.key.instance, steps.back().evaluations,
                            steps.back().optimality_gap);
  }

  void close() {
    improvements_.close();
    counts_.close();
    write_file(root_ / fmt::format("bbobexp_f{}.info", id_),
               fmt::format("suite = 'bbob-mixint', funcId = {}, DIM = {}, Precision = 1.000e-08, "
                           "algId = '{}', coco_version = '2.8.0', logger = 'bbob', "
                           "data_format = 'bbob-new2'\n% {}\n{}.dat{}\n",
                           id_, variables_, algorithm_, comment_, stem_, summary_));
  }

 private:
  std::string header_of(double fopt) const {
    std::string header = fmt::format(
        "% f evaluations | g evaluations | best noise-free fitness - Fopt ({:.12e}) + sum g_i+ | "
        "measured fitness | best measured fitness or single-digit g-values",
        fopt);
    for (std::int64_t k = 1; k <= variables_; ++k) header += fmt::format(" | x{}", k);
    return header + "\n";
  }

  /// The values of a row, without its evaluations. Readers drop rows that lack a coordinate.
  std::string values_of(double optimality_gap, double fopt, const Vector* x) const {
    const double fitness =
        optimality_gap == nothing_feasible ? optimality_gap : fopt + optimality_gap;
    std::string values = fmt::format("0 {0:+} {1:+} {1:+}", optimality_gap, fitness);
    for (std::int64_t k = 0; k < variables_; ++k) {
      values += x != nullptr && k < x->size() ? fmt::format(" {:+}", (*x)[k]) : " nan";
    }
    return values + "\n";
  }

  std::string comment_;
  fs::path root_;
  int id_;
  std::int64_t variables_;
  std::string algorithm_, stem_;
  OutputFile improvements_, counts_;
  std::string summary_;  ///< of the runs
};

/// Has a Case, made of the first run of each cell, write its files.
template <class Case>
void write_cases(const Store& store, const Completeness& completeness, const fs::path& folder,
                 const char* readme) {
  Numbering numbering(store.description());
  RunningTimes times(folder / "running_times.csv");
  std::optional<Case> now;
  comparison::each_judged(
      store,
      [&](const comparison::JudgedRun& run) {
        if (!now) now.emplace(run, store.description(), completeness, numbering, folder);
        now->add(run);
      },
      [&](const comparison::JudgedCell& cell) {
        now->close();
        now.reset();
        times.add(cell, numbering);
      });
  times.close();
  write_file(folder / "README.txt", readme + ("\n" + as_sentence(completeness)) + "\n");
}

}  // namespace

void write_coco(const Store& store, const Completeness& completeness, const fs::path& folder) {
  write_cases<CocoCase>(store, completeness, folder, coco_readme);
}

namespace {

constexpr const char* ioh_readme =
    R"(A campaign of ricochet for IOHanalyzer, https://iohanalyzer.liacs.nl.

Load every folder as one algorithm: a solver-formulation pair with its perturbation, price of a
gradient, and budget in evaluations per variable. Another budget means other runs, hence another
algorithm. Every problem is one function; running_times.csv lists them.

evaluations: as charged, gradients at their price.
raw_y: optimality gap, to be minimised: the true objective minus the best known value, of the best
  feasible point so far. Below 0: better than the best known value. 1e30: no feasible point yet;
  best.x is then the least infeasible point.
time_s: processor time of the run [s]; 0 if unknown.
gevals: derivatives requested in the whole run, the same in all its rows.
Runs on the same instance have different seeds. A run that ended before its first evaluation is
listed with one evaluation.

IOHanalyzer's expected running time is wrong if runs end after different numbers of evaluations, as
they do when a solver gives up or fails: in one example it gave 450 instead of 310. Use
running_times.csv: evaluations until the optimality gap is within the problem's tolerance. Unsolved
runs count with all their evaluations, identical runs count once, intervals are 95 %.
)";

/// Files of one algorithm on one problem.
class IohCase {
 public:
  IohCase(const comparison::JudgedRun& first, const CampaignDescription& campaign,
          const Completeness& completeness, Numbering& numbering, const fs::path& folder)
      : root_(folder / numbering.algorithm(first.stored.key.cell)),
        stem_(fmt::format("f{}_{}", numbering.function_id(first.problem.name),
                          numbering.function_name(first.problem.name))),
        rows_path_(fmt::format("data_{}/IOHprofiler_f{}_DIM{}.dat", stem_,
                               numbering.function_id(first.problem.name), first.problem.variables)),
        head_(head_of(first, campaign, completeness, numbering)),
        rows_(in_made_folder(root_ / rows_path_)) {}

  void add(const comparison::JudgedRun& run) {
    const RunRecord& record = run.stored.record;
    const auto steps = best_so_far(run.outcome);
    rows_.write("evaluations raw_y time_s gevals\n");
    const comparison::Step* best = &steps.front();
    for (const comparison::Step& step : steps) {
      if (step.optimality_gap < best->optimality_gap) best = &step;
      rows_.write(fmt::format("{} {} {} {}\n", step.evaluations, step.optimality_gap, step.seconds,
                              record.ledger.derivatives));
    }
    Json x = Json::array();
    if (!record.trace.empty()) {
      for (const double coordinate : record.trace.back().x) x.push_back(coordinate);
    }
    runs_.push_back(
        {{"instance", run.stored.key.instance},
         {"evals", steps.back().evaluations},
         {"best",
          {{"evals", best->evaluations}, {"y", best->optimality_gap}, {"x", std::move(x)}}}});
  }

  void close() {
    rows_.close();
    head_["scenarios"] = Json::array(
        {{{"dimension", dimension_}, {"path", rows_path_}, {"runs", std::move(runs_)}}});
    write_file(root_ / fmt::format("IOHprofiler_{}.json", stem_),
               head_.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n");
  }

 private:
  Json head_of(const comparison::JudgedRun& first, const CampaignDescription& campaign,
               const Completeness& completeness, Numbering& numbering) {
    dimension_ = first.problem.variables;
    const Cell& cell = first.stored.key.cell;
    std::string version;
    for (const StoredSolver& solver : campaign.solvers) {
      if (solver.name == cell.solver) version = solver.version;
    }
    Json attributes = Json::array();
    for (const auto& [name, value] : first.problem.factors) {
      attributes.push_back({{name, fmt::format("{}", value)}});
    }
    attributes.push_back({{"formulation", cell.formulation}});
    attributes.push_back({{"perturbation", label(cell.perturbation)}});
    return {
        {"version", "0.3.18"},  // of IOHexperimenter, which defines this format
        {"suite", "ricochet"},
        {"function_id", numbering.function_id(cell.problem)},
        {"function_name", numbering.function_name(cell.problem)},
        {"maximization", false},
        {"algorithm",
         {{"name", numbering.algorithm(cell)},
          {"info",
           fmt::format(
               "{} {}, formulation {}, perturbation {}, gradients at {}, {} evaluations "
               "for each variable{}",
               cell.solver, version, cell.formulation, cell.perturbation, cell.gradient_price,
               cell.budget,
               completeness.is_in_doubt() ? "; of the campaign, " + in_words(completeness) : "")}}},
        {"experiment_attributes", attributes},
        {"attributes", {"evaluations", "raw_y", "time_s", "gevals"}}};
  }

  fs::path root_;
  std::string stem_, rows_path_;
  std::int64_t dimension_ = 0;
  Json head_;
  OutputFile rows_;
  Json runs_ = Json::array();
};

}  // namespace

void write_iohanalyzer(const Store& store, const Completeness& completeness,
                       const fs::path& folder) {
  write_cases<IohCase>(store, completeness, folder, ioh_readme);
}

std::vector<comparison::Step> best_so_far(const comparison::Outcome& outcome) {
  std::vector<comparison::Step> rows{{1, 0, nothing_feasible}};
  for (const comparison::Step& step : outcome.steps) {
    if (!std::isfinite(step.optimality_gap) || step.optimality_gap >= rows.back().optimality_gap)
      continue;
    if (step.evaluations > rows.back().evaluations) {
      rows.push_back(step);
    } else {
      rows.back().seconds = step.seconds;
      rows.back().optimality_gap = step.optimality_gap;
    }
  }
  if (outcome.evaluations > rows.back().evaluations) {
    rows.push_back({outcome.evaluations, outcome.seconds, rows.back().optimality_gap});
  }
  return rows;
}

namespace {

/// A valid name made from the text that is not in `taken`; it is added there.
std::string free_name(std::string_view text, std::set<std::string>& taken) {
  constexpr std::size_t longest = 90;
  constexpr std::string_view allowed =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-._+";
  // A file whose name begins with a dot is hidden; one with a dash looks like an option.
  std::string name(text.empty() || text[0] == '.' || text[0] == '-' ? 1 : 0, '_');
  for (const char c : text.substr(0, longest)) {
    name += allowed.find(c) == std::string_view::npos ? '_' : c;
  }
  std::string free = name;
  for (int more = 2; !taken.insert(free).second; ++more) free = fmt::format("{}_{}", name, more);
  return free;
}

}  // namespace

Numbering::Numbering(const CampaignDescription& description) {
  std::set<std::string> taken;
  for (const bool opened_by_coco : {true, false}) {
    for (const StoredProblem& problem : description.problems) {
      if ((problem.variables == 5 || problem.variables == 6) != opened_by_coco) continue;
      const int id = static_cast<int>(functions_.size()) + 1;
      functions_[problem.name] = {id, free_name(problem.name, taken)};
    }
  }
}

const std::string& Numbering::algorithm(const Cell& cell) {
  Cell algorithm = cell;
  algorithm.problem.clear();
  const auto known = algorithms_.find(algorithm);
  if (known != algorithms_.end()) return known->second;
  const std::string text = fmt::format("{}_{}_{}_price-{}_budget-{}", cell.solver, cell.formulation,
                                       cell.perturbation, cell.gradient_price, cell.budget);
  return algorithms_[algorithm] = free_name(text, taken_);
}

}  // namespace ricochet::exports
