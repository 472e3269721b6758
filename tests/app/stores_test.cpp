#include "src/experiment/store.h"
#include "tests/app/tool.h"

/// What is done with the runs of a campaign: exported, archived, joined; runs that are forged; and
/// the programs that plans and stores name.
namespace ricochet::cli {
namespace {

const std::string own = RICOCHET_EXAMPLE_LIBRARY;

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
  const report::Results data = results_of("mine");
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
  run_part(
      "problems = [\"hs-71\"]\nsolvers = [\"random-search\", \"nlopt-cobyla\"]\n"
      "formulations = [\"original\", \"penalised\"]\nbudgets = [5, 20]\ninstances = 2");
  for (const std::string format : {"csv", "json", "latex", "markdown", "iohanalyzer", "coco"}) {
    EXPECT_THAT(out_of("export made/runs.sqlite --format {0} --out {0}", format),
                StartsWith("12 runs: "));
  }
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
  EXPECT_EQ(counted.out, "12 12\n") << counted.err;
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

  /// What is changed of a problem, or of its runs; of all runs if there is no problem.
  struct Forgery {
    std::string problem = {}, words = {};  ///< words: of the refusal
    std::function<void(StoredProblem&)> change_problem = [](StoredProblem&) {};
    std::function<void(RunRecord&)> change_run = [](RunRecord&) {};
  };

  static std::string forged(const std::string& name, const Forgery& forgery) {
    const Store honest = Store::open(here() / honest_, Store::For::reading);
    CampaignDescription description = honest.description();
    for (StoredProblem& one : description.problems) {
      if (one.name == forgery.problem) forgery.change_problem(one);
    }
    Store::write(here() / name, description, [&](const Store::AddRun& add) {
      honest.each([&](const StoredRun& run) {
        RunRecord record = run.record;
        const bool is_meant = forgery.problem.empty() || run.key.cell.problem == forgery.problem;
        if (is_meant) forgery.change_run(record);
        add(run.key, record);
      });
    });
    return name;
  }

  static constexpr const char* honest_ = "made/runs.sqlite";
};

TEST_F(ForgedStores, AreRefusedWhereTheyContradictWhatIsKnown) {
  const auto runs = [](const char* problem, const char* words, auto change) {
    return Forgery{.problem = problem, .words = words, .change_run = change};
  };
  const auto returns = [](double objective) {
    return [objective](RunRecord& record) {
      if (record.returned) record.returned->true_values = {objective, 0.0};
    };
  };
  int number = 0;
  for (const Forgery& forgery : std::vector<Forgery>{
           {"hs-71", "best_known of hs-71 is", [](auto& one) { one.best_known += 1; }},
           {"hs-71", "tolerance of hs-71 is 100", [](auto& one) { one.tolerance = 100; }},
           {"count-C1", "variables of count-C1 is 3", [](auto& one) { one.variables = 3; }},
           {"count-C1", "count-C1 is not described as", [](auto& one) { one.family = "classic"; }},
           {"top-speed-C1", "top-speed-C1 is not described as",
            [](auto& one) { one.findings["best_known"] = -9; }},
           runs("count-C1", "it is proven that none is better than", returns(-1)),
           runs("top-speed-C1", "it is proven that none is better than", returns(-9)),
           runs("classic-sphere-5", "it is proven that none is better than 0", returns(-0.001)),
           runs("classic-sphere-5", "it is proven",
                [](auto& record) { record.trace.back().true_values.objective = -2; }),
           runs("hs-71", "the plan allows 120",
                [](auto& record) { record.budget.evaluations = 1'000'000; }),
           runs("hs-71", "returned_x has 2 coordinates: must be 4", [](auto& record) {
             if (record.returned) record.returned->x = Vector::Zero(2);
           })}) {
    const std::string store = forged(fmt::format("{}.sqlite", ++number), forgery);
    for (const char* reader :
         {"digest {0}", "export {0} --format csv --out csv",
          "submit {0} --solvers '*' --out a --verify 0", "merge m {0} --verify 0",
          "merge m {1} {0} --verify 0", "merge m {0} {1} --verify 0", "compare --stores {1} {0}"}) {
      expect_refusal(filled(reader, store, honest_), forgery.words);
    }
    EXPECT_FALSE(exists("m") || exists("a")) << forgery.words;
  }
}

/// What could be true is found by repeating runs.
TEST_F(ForgedStores, AreRefusedWhereARunThatIsRepeatedDiffers) {
  int number = 0;
  for (const auto& change : std::vector<std::function<void(RunRecord&)>>{
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
           [](RunRecord& record) { record.ledger.refused += 1; }}) {
    const std::string store = forged(fmt::format("{}.sqlite", ++number), {.change_run = change});
    out_of("digest " + store);
    for (const char* taking : {"submit {} --solvers '*' --out a", "merge m {}"}) {
      expect_refusal(filled(taking, store),
                     "when it is repeated: it is not what this program does");
    }
    EXPECT_FALSE(exists("m") || exists("a"));
  }
}

TEST_F(ForgedStores, AreSaidNotToBeCheckedWhereAProblemIsAnother) {
  forged("other.sqlite", {"hs-71", "", [](StoredProblem& problem) {
                            problem.tolerance = 100;
                            problem.hash = "0123456789abcdef";
                          }});
  const Outcome outcome = call("digest other.sqlite");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err,
              AllOf(HasSubstr("1 problem is not this program's, by hash"), HasSubstr("hs-71")));
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
  EXPECT_THAT(merged("there/runs.sqlite", "--verify 3").at("verified"), StartsWith("3 of "));
  EXPECT_THAT(merged("c.sqlite", "--verify 0").at("verified"), HasSubstr("runs was repeated"));
  out_of("run plan.toml --out there --resume");
  EXPECT_THAT(read("there/summary.md"),
              HasSubstr("The runs of 1 store were joined. Of these runs, 3 of "));
  EXPECT_THAT(read("made/summary.md"), Not(HasSubstr("were joined")));
  out_of("run plan.toml --out from --from {}", honest_);
  EXPECT_THAT(read("from/summary.md"), HasSubstr("Some runs taken over from "));
}

/// Two programs that leave a file when they are started, and a plan that names them.
class Programs : public testing::Test {
 protected:
  void SetUp() override {
    for (const std::string name : {"first", "second"}) {
      write(name + ".sh",
            filled("touch {0}/{1}.started; echo '{{\"name\": \"{1}\"}}'\nwhile read -r problem; do "
                   "echo '{{\"ask\": [1]}}'; read -r answer; echo '{{\"done\": \"done\"}}'; done\n",
                   here(), name));
    }
    write("plan.toml",
          "[[part]]\nproblems = \"count-C1\"\nformulations = \"count\"\nbudgets = 5\n"
          "instances = 2\nsolvers = [\"scan\", \"sh first.sh\", \"sh second.sh\"]\n");
  }

  /// Those that were started since this was asked before.
  static std::set<std::string> started() {
    std::set<std::string> names;
    for (const std::string name : {"first", "second"}) {
      if (fs::remove(here() / (name + ".started"))) names.insert(name);
    }
    return names;
  }
};

TEST_F(Programs, AreListedByACheckThatStartsNone) {
  const std::string check = out_of("plan check plan.toml");
  EXPECT_THAT(check, AllOf(HasSubstr("run would start: sh first.sh\n"),
                           HasSubstr("run would start: sh second.sh\n"), HasSubstr("; at least ")));
  const Json data = json_of("plan check plan.toml");
  EXPECT_EQ(data["programs"], (Json{"sh first.sh", "sh second.sh"}));
  EXPECT_EQ(data["runs"], 6);
  EXPECT_EQ(data["at_least"], true) << "they take a time that a check does not know";
  EXPECT_THAT(out_of("plan slurm plan.toml"),
              AllOf(HasSubstr("# It starts: sh second.sh\n"), HasSubstr(" --allow-programs "),
                    HasSubstr("# The time below is at least needed")));
  EXPECT_THAT(started(), IsEmpty());
  EXPECT_THAT(out_of("plan check quick"), HasSubstr("; about "));
  EXPECT_THAT(out_of("plan slurm quick"),
              AllOf(Not(HasSubstr("at least")), Not(HasSubstr("--allow-programs"))));
}

TEST_F(Programs, AreShownInALineEach) {
  write("odd.toml",
        "[[part]]\nproblems = \"hs-71\"\nbudgets = 5\n"
        "solvers = \"sh -c '\\u001b[31m\\ntouch evil'\"\n");
  const std::string shown = "sh -c '\\x1b[31m\\x0atouch evil'\n";
  EXPECT_THAT(out_of("plan check odd.toml"), HasSubstr("run would start: " + shown));
  EXPECT_THAT(out_of("plan slurm odd.toml"), HasSubstr("# It starts: " + shown))
      << "else its second line would be a command";
}

TEST_F(Programs, OfAPlanRunOnlyWhereTheyAreAllowed) {
  expect_refusal("run plan.toml --out out",
                 "plan.toml: names programs, which run with your rights: sh first.sh; "
                 "sh second.sh; add --allow-programs if you trust them");
  EXPECT_THAT(started(), IsEmpty());
  EXPECT_FALSE(exists("out"));
  const Outcome run = call("run plan.toml --out out --allow-programs");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.err, AllOf(StartsWith("starts sh first.sh\nstarts sh second.sh\n"),
                             HasSubstr("\nabout ")));
  EXPECT_THAT(started(), ElementsAre("first", "second"));
}

TEST_F(Programs, OfAStoreAreStartedForTheirOwnRunsOnly) {
  out_of("run plan.toml --out out --allow-programs");
  started();
  std::multiset<std::string> solvers;
  for (int number = 1; number <= 6; ++number) {
    const std::string replay = filled("replay out {}", number);
    const Outcome unasked = call(replay);
    EXPECT_THAT(started(), IsEmpty());
    const Json again = json_of(replay + " --allow-programs");
    EXPECT_EQ(again["same"], true);
    const std::string solver = *solvers.insert(again["solver"]);
    const bool is_program = solver != "scan";
    EXPECT_EQ(started(), is_program ? std::set{solver} : std::set<std::string>());
    EXPECT_EQ(unasked.exit_code, is_program ? 2 : 0) << solver;
    EXPECT_THAT(unasked.err,
                HasSubstr(is_program ? "run with your rights: sh " + solver + ".sh; add" : ""));
  }
  EXPECT_THAT(solvers, ElementsAre("first", "first", "scan", "scan", "second", "second"));
  for (const std::string reading :
       {"digest out", "export out --format csv --out csv", "merge all.sqlite out"}) {
    call(reading);
    EXPECT_THAT(started(), IsEmpty()) << reading;
  }
}

TEST_F(Programs, GivenByACommandNeedNoPermission) {
  out_of("solve 'sh first.sh' count-C1");
  EXPECT_THAT(started(), ElementsAre("first"));
}

}  // namespace
}  // namespace ricochet::cli
