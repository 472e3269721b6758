#include "src/benchmark/export/iohanalyzer.h"

#include <fmt/format.h>

#include <optional>
#include <string>

#include "src/benchmark/analysis/judged_runs.h"
#include "src/benchmark/export/best_so_far.h"
#include "src/benchmark/export/csv_row.h"
#include "src/benchmark/export/numbering.h"
#include "src/benchmark/export/output_file.h"
#include "src/benchmark/export/running_times.h"
#include "src/core/label.h"
#include "src/report/json.h"

namespace ricochet::exports {
namespace {

namespace fs = std::filesystem;
using report::Json;

constexpr const char* readme =
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
class Case {
 public:
  Case(const comparison::JudgedRun& first, const CampaignDescription& campaign,
       const Completeness& completeness, Numbering& numbering, const fs::path& folder)
      : root_(folder / numbering.algorithm(first.stored.key.cell)),
        stem_(fmt::format("f{}_{}", numbering.function_id(first.problem.name),
                          numbering.function_name(first.problem.name))),
        rows_path_(fmt::format("data_{}/IOHprofiler_f{}_DIM{}.dat", stem_,
                               numbering.function_id(first.problem.name), first.problem.variables)),
        head_(head_of(first, campaign, completeness, numbering)),
        rows_(made(root_ / rows_path_)) {}

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
  static fs::path made(const fs::path& file) {
    fs::create_directories(file.parent_path());
    return file;
  }

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
      attributes.push_back({{name, number(value)}});
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

}  // namespace ricochet::exports
