#include "src/experiment/store.h"
#include "src/report/results.h"
#include "src/report/text.h"
#include "tests/app/tool.h"
#include "tests/support/test.h"

/// What is done with the runs of a campaign: exported, archived, joined; and runs that are missing
/// or forged.
namespace ricochet::cli {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const std::string own = RICOCHET_EXAMPLE_LIBRARY;
const std::vector<std::string> formats = {"csv",      "json",        "latex",
                                          "markdown", "iohanalyzer", "coco"};

/// Runs a plan of one part, into the folder `made`.
void run_part(const std::string& part, const std::string& options = "") {
  write("plan.toml", "name = \"small\"\n[[part]]\n" + part + "\n");
  out_of("run plan.toml --out made " + options);
}

/// A campaign of two solvers on six problems, and an archive of it.
class Archives : public testing::Test {
 protected:
  void SetUp() override {
    run_part(
        "problems = [\"classic-*-5\"]\nsolvers = [\"random-search\", \"nlopt-bobyqa\"]\n"
        "budgets = [30]\ninstances = 2");
    EXPECT_THAT(out_of("submit made/runs.sqlite --solvers '*' --out small.archive"),
                HasSubstr("runs, drawn at random, were repeated to the last bit"));
  }
};

TEST_F(Archives, AreReadAsStores) {
  EXPECT_THAT(out_of("replay small.archive 3"), HasSubstr("The same, to the last bit"));
  EXPECT_EQ(out_of("digest small.archive").size(), 17U);
  out_of("export small.archive --format csv --out csv");
  EXPECT_THAT(read("csv/runs.csv"), HasSubstr("nlopt-bobyqa"));
}

TEST_F(Archives, StandBesideAUsersSolverAndTakeItIn) {
  out_of("compare --solver {} --against small.archive --out mine", own);
  const report::Results data = report::results_in(report::data_in(read("mine/data.json")));
  const Table& totals = *data.table("own-totals");
  ASSERT_EQ(totals.rows.size(), 1U);
  EXPECT_EQ(totals[0].text("solver"), "mine");
  const Row solver = (*data.table("own-solvers"))[0];
  EXPECT_EQ(solver.number("rivals"), 2);
  EXPECT_EQ(solver.text("family"), "classic");
  EXPECT_EQ(number_in(*data.value("runs")), 3 * 2 * *number_in(*data.value("problems")));
  EXPECT_THAT(read("mine/summary.md"), HasSubstr("Your solver"));

  write("CITATION.cff", "title: mine\n");
  EXPECT_THAT(out_of("submit mine/runs.sqlite --out mine.archive --citation CITATION.cff "
                     "--allow-programs"),
              HasSubstr("runs of mine"));
  out_of("merge all.sqlite small.archive mine.archive");
  out_of("export all.sqlite --format csv --out csv");
  EXPECT_THAT(read("csv/runs.csv"), AllOf(HasSubstr("mine"), HasSubstr("nlopt-bobyqa")));
}

TEST_F(Archives, AreRefusedInOneLine) {
  write("text", "no archive");
  expect_refusal("compare --solver " + own + " --against text", "file is not a database");
  expect_refusal("submit small.archive --out again.archive", "has only solvers of the suite");
  EXPECT_FALSE(exists("again.archive"));
}

void make_small_campaign(const std::string& options = "") {
  run_part(
      "problems = [\"hs-71\"]\nsolvers = [\"random-search\", \"nlopt-cobyla\"]\n"
      "formulations = [\"original\", \"penalised\"]\nbudgets = [5, 20]\ninstances = 2",
      options);
}

/// Has Python read every file, and print how many runs and improvements there are.
constexpr const char* reader = R"(
import csv, json
runs = list(csv.DictReader(open('csv/runs.csv', newline='')))
lines = [json.loads(line) for line in open('json/runs.jsonl')]
steps = list(csv.DictReader(open('csv/improvements.csv', newline='')))
assert json.load(open('json/campaign.json'))['problems'][0]['name'] == 'hs-71'
assert len(steps) == sum(len(run['improvements']) for run in lines) > 0
for row, run in zip(runs, lines):
    assert row['number'] == str(run['number']) and row['solver'] == run['key']['solver']
    assert float(row['seconds']) == run['ledger']['seconds']
    assert (row['solved'] == '1') == run['verdict']['solved']
    assert row['optimality_gap'] == '' or float(row['optimality_gap']) == run['verdict']['optimality_gap']
print(len(runs), len(lines))
)";

TEST(Export, WritesEveryFormatThatOthersRead) {
  make_small_campaign();
  std::size_t runs = 0;
  for (const std::string& format : formats) {
    const std::string said = out_of("export made/runs.sqlite --format {0} --out {0}", format);
    EXPECT_THAT(said, HasSubstr(" runs: ")) << format;
    runs = std::stoul(said);
  }
  EXPECT_GT(runs, 0U);
  for (const char* file :
       {"latex/table.tex", "latex/summary.tex", "markdown/table.md", "coco/README.txt"}) {
    EXPECT_TRUE(exists(file)) << file;
  }
  // As the report has them: two entries of one family, with the larger budget.
  EXPECT_THAT(read("csv/ratings.csv"), AllOf(HasSubstr("\nhs,1,20,random-search,penalised,1,"),
                                             HasSubstr("\nhs,1,20,nlopt-cobyla,original,1,")));
  EXPECT_THAT(read("csv/ecdf.csv"), HasSubstr("\nhs,nlopt-cobyla,original,20,"));
  EXPECT_THAT(read("csv/targets.csv"), HasSubstr("\nhs,hs-71,"));
  if (std::string(RICOCHET_PYTHON).ends_with("NOTFOUND")) return;
  write("read.py", reader);
  const Outcome counted = call_in_shell(RICOCHET_PYTHON " read.py");
  EXPECT_EQ(counted.out, fmt::format("{0} {0}\n", runs)) << counted.err;
}

/// A program that asks for one point of hs-71 again and again; what it says of itself.
void write_claiming_program(const std::string& name, const std::string& claims) {
  write(name + ".sh", fmt::format("echo '{{\"name\": \"{}\", {}}}'\nwhile read line; do\n"
                                  "  echo '{{\"ask\": [1, 5, 5, 1]}}'\n  read line\n"
                                  "  echo '{{\"done\": \"asked\"}}'\ndone\n",
                                  name, claims));
}

TEST(Export, RanksAUsersProgramsWithoutStartingThem) {
  write_claiming_program("takes-none", "\"takes_constraints\": 0");
  write_claiming_program("takes-all", "\"takes_constraints\": 2");
  run_part(
      "problems = [\"hs-71\", \"hs-1\"]\nbudgets = [5]\ninstances = 1\n"
      "solvers = [\"random-search\", \"sh takes-none.sh\", \"sh takes-all.sh\"]\n"
      "formulations = [\"original\", \"penalised\"]",
      "--allow-programs");
  fs::remove(here() / "takes-none.sh");
  fs::remove(here() / "takes-all.sh");
  EXPECT_EQ(call("export made/runs.sqlite --format csv --out csv").err, "");
  EXPECT_THAT(read("csv/ratings.csv"),
              AllOf(HasSubstr(",takes-none,penalised,"), HasSubstr(",takes-all,original,"),
                    HasSubstr(",takes-all,penalised,")));
}

/// Stores that somebody changed and gave the right checksums again, which have no secret.
class ForgedStores : public testing::Test {
 protected:
  void SetUp() override {
    run_part(
        "problems = [\"classic-sphere-5\", \"hs-71\", \"count-C1\", \"top-speed-C1\"]\n"
        "solvers = [\"random-search\", \"nlopt-cobyla\"]\nbudgets = [30]\ninstances = 4");
  }

  using ChangeProblem = std::function<void(StoredProblem&)>;
  using ChangeRun = std::function<void(RunRecord&)>;

  /// A store of the same runs: what belongs to a problem (to any if empty) is changed.
  static std::string forged(const std::string& name, const std::string& problem,
                            const ChangeProblem& change_problem, const ChangeRun& change_run) {
    const Store honest = Store::open(here() / honest_, Store::For::reading);
    CampaignDescription description = honest.description();
    for (StoredProblem& one : description.problems) {
      if (one.name == problem) change_problem(one);
    }
    Store::write(here() / name, description, [&](const Store::AddRun& add) {
      honest.each([&](const StoredRun& run) {
        RunRecord record = run.record;
        if (problem.empty() || run.key.cell.problem == problem) change_run(record);
        add(run.key, record);
      });
    });
    return name;
  }

  static std::string with_problem(const std::string& name, const std::string& problem,
                                  const ChangeProblem& change) {
    return forged(name, problem, change, [](RunRecord&) {});
  }

  static std::string with_runs(const std::string& name, const std::string& problem,
                               const ChangeRun& change) {
    return forged(
        name, problem, [](StoredProblem&) {}, change);
  }

  static constexpr const char* honest_ = "made/runs.sqlite";
};

TEST_F(ForgedStores, AreRefusedWhereTheyContradictWhatIsKnown) {
  std::vector<std::pair<std::string, std::string>> forgeries;
  const auto file = [&] { return fmt::format("{}.sqlite", forgeries.size()); };
  const auto problem = [&](const std::string& name, const char* words,
                           const ChangeProblem& change) {
    forgeries.emplace_back(with_problem(file(), name, change), words);
  };
  const auto runs = [&](const std::string& name, const char* words, const ChangeRun& change) {
    forgeries.emplace_back(with_runs(file(), name, change), words);
  };
  problem("hs-71", "best_known of hs-71 is", [](auto& p) { p.best_known += 1; });
  problem("hs-71", "tolerance of hs-71 is 100", [](auto& p) { p.tolerance = 100; });
  problem("count-C1", "variables of count-C1 is 3", [](auto& p) { p.variables = 3; });
  problem("count-C1", "count-C1 is not described as", [](auto& p) { p.family = "classic"; });
  problem("top-speed-C1", "top-speed-C1 is not described as",
          [](auto& p) { p.findings["best_known"] = -9; });
  const auto returns = [](double objective) {
    return [objective](RunRecord& record) {
      if (record.returned) record.returned->true_values = {objective, 0.0};
    };
  };
  runs("count-C1", "it is proven that none is better than", returns(-1));
  runs("top-speed-C1", "it is proven that none is better than", returns(-9));
  runs("classic-sphere-5", "it is proven that none is better than 0", returns(-0.001));
  runs("classic-sphere-5", "it is proven",
       [](RunRecord& record) { record.trace.back().true_values.objective = -2; });
  runs("hs-71", "the plan allows 120", [](auto& record) { record.budget.evaluations = 1'000'000; });
  runs("hs-71", "returned_x has 2 coordinates: must be 4", [](RunRecord& record) {
    if (record.returned) record.returned->x = Vector::Zero(2);
  });
  for (const auto& [store, words] : forgeries) {
    for (const char* reader :
         {"digest {0}", "export {0} --format csv --out csv",
          "submit {0} --solvers '*' --out a --verify 0", "merge m {0} --verify 0",
          "merge m {1} {0} --verify 0", "merge m {0} {1} --verify 0", "compare --stores {1} {0}"}) {
      expect_refusal(filled(reader, store, honest_), words);
    }
    EXPECT_FALSE(exists("m")) << words;
    EXPECT_FALSE(exists("a")) << words;
  }
}

/// What could be true is found by repeating runs.
TEST_F(ForgedStores, AreRefusedWhereARunThatIsRepeatedDiffers) {
  const std::vector<ChangeRun> changes = {
      [](RunRecord& record) {
        record.ledger.charged -= record.ledger.charged > 1 ? 1 : 0;
        for (Improvement& step : record.trace) {
          step.evaluations = std::min(step.evaluations, record.ledger.charged);
        }
      },
      [](RunRecord& record) {
        if (record.returned) record.returned->x[0] += 1e-12;
        record.seed ^= 1;
      },
      [](RunRecord& record) { record.failure = "crashed"; },
      [](RunRecord& record) { record.terminations = {{"converged"}}; },
      [](RunRecord& record) { record.ledger.refused += 1; }};
  for (std::size_t k = 0; k < changes.size(); ++k) {
    const std::string store = with_runs(fmt::format("{}.sqlite", k), "", changes[k]);
    out_of("digest " + store);
    for (const char* taking : {"submit {} --solvers '*' --out a", "merge m {}"}) {
      expect_refusal(filled(taking, store),
                     "when it is repeated: it is not what this program does");
    }
    EXPECT_FALSE(exists("m"));
    EXPECT_FALSE(exists("a"));
  }
}

TEST_F(ForgedStores, AreSaidNotToBeCheckedWhereAProblemIsAnother) {
  with_problem("other.sqlite", "hs-71", [](StoredProblem& problem) {
    problem.tolerance = 100;
    problem.hash = "0123456789abcdef";
  });
  const Outcome outcome = call("digest other.sqlite");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err,
              AllOf(HasSubstr("1 problem is not this program's, by hash"), HasSubstr("hs-71")));
  with_problem("same.sqlite", "hs-71", [](StoredProblem& problem) { problem.tolerance = 9; });
  expect_refusal(filled("merge m {} same.sqlite --verify 0", honest_), "tolerance of hs-71 is 9");
}

/// A sample of the stated size is repeated; how many, by whom and when stays with the runs, and a
/// report of them begins with it.
TEST_F(ForgedStores, AreToldFromStoresWhoseRunsWereRepeated) {
  const auto merged = [&](const std::string& name, const std::string& how) {
    out_of("merge {} {} {}", name, honest_, how);
    return Store::open(here() / name, Store::For::reading).description().made;
  };
  const auto by_default = merged("a.sqlite", "");
  EXPECT_THAT(by_default.at("verified"),
              testing::MatchesRegex("20 of [0-9]+ runs, drawn at random, were repeated to the last "
                                    "bit by .+ with ricochet .+ on 20[0-9-]+"));
  EXPECT_EQ(by_default.at("joined"), "1 store");
  fs::create_directory(here() / "there");
  EXPECT_THAT(merged("there/runs.sqlite", "--verify 3").at("verified"),
              testing::StartsWith("3 of "));
  EXPECT_THAT(merged("c.sqlite", "--verify 0").at("verified"), HasSubstr("runs was repeated"));
  out_of("run plan.toml --out there --resume");
  EXPECT_THAT(read("there/summary.md"),
              HasSubstr("The runs of 1 store were joined. Of these runs, 3 of "));
  EXPECT_THAT(read("made/summary.md"), Not(HasSubstr("were joined")));
  out_of("run plan.toml --out from --from {}", honest_);
  EXPECT_THAT(read("from/summary.md"), HasSubstr("Some runs taken over from "));
}

}  // namespace
}  // namespace ricochet::cli
