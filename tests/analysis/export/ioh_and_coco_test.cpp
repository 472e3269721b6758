#include <regex>

#include "src/analysis/export/formats.h"
#include "tests/analysis/export/exported_store.h"
#include "tests/support/numbers.h"

namespace ricochet::exports {
namespace {

using nlohmann::json;

TEST(Numbering, HasAnotherNameForEveryAlgorithmThatAnyFileMayHave) {
  Numbering numbering{CampaignDescription()};
  std::set<std::string> names;
  for (const char* solver : {"a b", "a_b", "a/b", "", ".a", "-a", "../..", "ä", "a\n\"b\"'"}) {
    for (const std::string& formulation : {std::string("count"), std::string(300, 'f')}) {
      for (const std::int64_t budget : {1, 10}) {
        Cell cell{"q", formulation, "plain", solver, budget, "n"};
        const std::string name = numbering.algorithm(cell);
        EXPECT_TRUE(std::regex_match(name, std::regex("[A-Za-z0-9_+][-A-Za-z0-9._+]{0,99}")))
            << name;
        EXPECT_TRUE(names.insert(name).second) << name << " is of two";
        cell.problem = "other";
        EXPECT_EQ(numbering.algorithm(cell), name);
      }
    }
  }
}

TEST(BestSoFar, HasNoOptimalityGapTwiceAndNoneThatIsNoNumber) {
  using Rows = std::vector<std::pair<std::int64_t, double>>;  // evaluations and optimality gaps
  const auto best_rows = [](std::int64_t evaluations, std::vector<comparison::Step> steps) {
    comparison::Outcome outcome;
    outcome.steps = std::move(steps);
    outcome.evaluations = evaluations;
    Rows rows;
    for (const auto& row : best_so_far(outcome)) {
      rows.emplace_back(row.evaluations, row.optimality_gap);
    }
    return rows;
  };
  EXPECT_EQ(best_rows(5, {{2, 0, 3}, {3, 0, 3}, {3, 0, 2}, {3, 0, 1}, {4, 0, 1}}),
            (Rows{{1, 1e30}, {2, 3}, {3, 1}, {5, 1}}));
  EXPECT_EQ(best_rows(6, {{2, 0, infinity}, {3, 0, -infinity}, {4, 0, quiet_nan}, {5, 0, 1e31}}),
            (Rows{{1, 1e30}, {6, 1e30}}));
}

/// Every file of every algorithm, made again from the records: what the readers of other suites
/// require holds for all of them.
class SuiteFiles : public ExportedStore {
 protected:
  using Files = std::map<std::string, std::string>;  ///< texts, by paths

  /// The runs of each cell.
  auto cells() const {
    std::map<Cell, std::vector<std::pair<RunKey, RunRecord>>> all;
    for (const auto& run : records) all[run.first.cell].push_back(run);
    return all;
  }

  /// By the number of variables: those that COCO opens come first.
  static int id_of(const StoredProblem& problem) {
    return std::map<std::int64_t, int>{{6, 1}, {5, 2}, {1, 3}, {12, 4}}.at(problem.variables);
  }

  std::string algorithm_of(const Cell& cell) const {
    const std::map<std::string, std::string> names = {
        {description.solvers[0].name, "nlopt-cobyla"},
        {description.solvers[1].name, "python3__my___own__.py"},
        {description.solvers[2].name, "a_b_c_d_e__f_g_h_i_j_k--l"}};
    return fmt::format("{}_original_{}_price-n_budget-{}", names.at(cell.solver), cell.perturbation,
                       cell.budget);
  }

  static std::int64_t end_of(const RunRecord& record) {
    return std::max<std::int64_t>(record.ledger.charged, 1);
  }

  /// Evaluation 1, those that lowered the optimality gap, and the last.
  std::set<std::int64_t> turns_of(const RunKey& key, const RunRecord& record) const {
    std::set<std::int64_t> all = {1, end_of(record)};
    for (const Improvement& step : record.trace) {
      const std::int64_t at = step.evaluations;
      if (optimality_gap_after(key, at) < optimality_gap_after(key, at - 1)) all.insert(at);
    }
    return all;
  }

  Files written() const {
    Files files;
    for (const auto& entry : fs::recursive_directory_iterator(out)) {
      if (entry.is_directory() || entry.path().parent_path() == out) continue;
      files[entry.path().lexically_relative(out).string()] = text_of(entry.path());
    }
    return files;
  }
};

using Coco = SuiteFiles;

// cocopp leaves out a row that has not five words and all coordinates, and takes 1e30 as it is.
TEST_F(Coco, RowsAreWhatTheRecordsSay) {
  Files expected;
  for (const auto& [cell, runs] : cells()) {
    const StoredProblem& asked = problem(cell.problem);
    std::string header = fmt::format(
        "% f evaluations | g evaluations | best noise-free fitness - Fopt ({:.12e}) + sum g_i+ | "
        "measured fitness | best measured fitness or single-digit g-values",
        asked.best_known);
    for (int k = 1; k <= asked.variables; ++k) header += fmt::format(" | x{}", k);
    std::string improvements, counts, summary;
    for (const auto& [key, record] : runs) {
      const double last = optimality_gap_after(key, end_of(record));
      const auto row = [&, &key = key, &record = record](std::int64_t evaluations) {
        const double gap = optimality_gap_after(key, evaluations);
        const double fitness = gap == 1e30 ? 1e30 : asked.best_known + gap;
        std::string text = fmt::format("{} 0 {:+} {:+} {:+}", evaluations, gap, fitness, fitness);
        for (int k = 0; k < asked.variables; ++k) {
          text +=
              gap == last && gap < 1e30 ? fmt::format(" {:+}", record.trace.back().x[k]) : " nan";
        }
        return text + "\n";
      };
      improvements += header + "\n";
      for (const std::int64_t evaluations : turns_of(key, record)) improvements += row(evaluations);
      counts += header + "\n";
      for (const std::int64_t round : {1, 2, 5, 10, 20, 50, 100, 200}) {
        if (round < end_of(record)) counts += row(round);
      }
      counts += row(end_of(record));
      summary += fmt::format(", {}:{}|{:.1e}", key.instance, end_of(record), last);
    }
    const std::string root = algorithm_of(cell) + "/";
    const std::string stem =
        fmt::format("data_f{0}/bbobexp_f{0}_DIM{1}", id_of(asked), asked.variables);
    expected[root + stem + ".dat"] = improvements;
    expected[root + stem + ".tdat"] = counts;
    expected[root + fmt::format("bbobexp_f{}.info", id_of(asked))] = fmt::format(
        "suite = 'bbob-mixint', funcId = {}, DIM = {}, Precision = 1.000e-08, algId = '{}', "
        "coco_version = '2.8.0', logger = 'bbob', data_format = 'bbob-new2'\n% of ricochet\n"
        "{}.dat{}\n",
        id_of(asked), asked.variables, algorithm_of(cell), stem, summary);
  }
  write_coco(store, {}, out);
  EXPECT_EQ(written(), expected);
  EXPECT_EQ(expected.size(), 12U * 4 * 3) << "12 algorithms: 3 solvers, 2 perturbations, 2 budgets";
  EXPECT_THAT(text_of(out / "README.txt"), HasSubstr("functions 1 to 24."));
}

using IohAnalyzer = SuiteFiles;

// IOHanalyzer's reader would silently get wrong numbers if a run did not begin at evaluation 1, if
// raw_y rose, or if a head told of other runs than the rows.
TEST_F(IohAnalyzer, RowsAreWhatTheRecordsSay) {
  write_iohanalyzer(store, {}, out);
  Files files = written();
  for (const auto& [cell, runs] : cells()) {
    const StoredProblem& asked = problem(cell.problem);
    const int id = id_of(asked);
    const char* const names[] = {"profile_6", "profile_5", "top-speed_C1", "wide"};
    const std::string name = names[id - 1];
    const std::string path =
        fmt::format("data_f{}_{}/IOHprofiler_f{}_DIM{}.dat", id, name, id, asked.variables);
    std::string rows;
    json told = json::array();
    for (const auto& [key, record] : runs) {
      rows += "evaluations raw_y time_s gevals\n";
      std::int64_t best = 1;
      for (const std::int64_t evaluations : turns_of(key, record)) {
        const double gap = optimality_gap_after(key, evaluations);
        double seconds = evaluations == 1 ? 0 : record.ledger.seconds;
        if (gap < optimality_gap_after(key, evaluations - 1)) {
          best = evaluations;
          for (const Improvement& step : record.trace) {  // the last of them
            if (step.evaluations == evaluations) seconds = step.seconds;
          }
        }
        rows += fmt::format("{} {} {} {}\n", evaluations, gap, seconds, record.ledger.derivatives);
      }
      const Vector x = record.trace.empty() ? Vector() : record.trace.back().x;
      told.push_back({{"instance", key.instance},
                      {"evals", end_of(record)},
                      {"best",
                       {{"evals", best},
                        {"y", optimality_gap_after(key, best)},
                        {"x", std::vector(x.begin(), x.end())}}}});
    }
    json attributes = json::array();
    for (const auto& [factor, value] : asked.factors) {
      attributes.push_back({{factor, fmt::format("{}", value)}});
    }
    attributes.push_back({{"formulation", "original"}});
    attributes.push_back({{"perturbation", cell.perturbation}});
    const auto solver = std::ranges::find(description.solvers, cell.solver, &StoredSolver::name);
    const json head = {
        {"version", "0.3.18"},
        {"suite", "ricochet"},
        {"function_id", id},
        {"function_name", name},
        {"maximization", false},
        {"algorithm",
         {{"name", algorithm_of(cell)},
          {"info", fmt::format("{} {}, formulation original, perturbation {}, gradients at n, {} "
                               "evaluations for each variable",
                               cell.solver, solver->version, cell.perturbation, cell.budget)}}},
        {"experiment_attributes", attributes},
        {"attributes", {"evaluations", "raw_y", "time_s", "gevals"}},
        {"scenarios", {{{"dimension", asked.variables}, {"path", path}, {"runs", told}}}}};
    const std::string root = algorithm_of(cell) + "/";
    EXPECT_EQ(files[root + path], rows) << path;
    EXPECT_EQ(json::parse(files[root + fmt::format("IOHprofiler_f{}_{}.json", id, name)]), head);
  }
  EXPECT_EQ(files.size(), 12U * 4 * 2) << "12 algorithms: 3 solvers, 2 perturbations, 2 budgets";
  EXPECT_THAT(text_of(out / "README.txt"), HasSubstr("450 instead of 310"));
}

}  // namespace
}  // namespace ricochet::exports
