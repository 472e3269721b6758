#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "src/report/json.h"
#include "tests/app/tool.h"

namespace ricochet::cli {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// A folder with runs.sqlite, of 8 runs.
fs::path small_campaign() {
  const fs::path folder = fresh_folder();
  const fs::path plan = write(folder, "plan.toml",
                              "name = \"small\"\n[[part]]\nproblems = [\"hs-71\"]\n"
                              "solvers = [\"random-search\", \"nlopt-cobyla\"]\n"
                              "formulations = [\"original\", \"penalised\"]\n"
                              "budgets = [5, 20]\ninstances = 2\n");
  const Outcome made = call(fmt::format("run {} --out {}", plan.string(), folder.string()));
  EXPECT_EQ(made.exit_code, 0) << made.err;
  return folder;
}

/// Has Python read every file, and print how many runs and improvements there are.
constexpr const char* reader = R"(
import csv, json, sys
folder = sys.argv[1]
runs = list(csv.DictReader(open(folder + '/csv/runs.csv', newline='')))
lines = [json.loads(line) for line in open(folder + '/json/runs.jsonl')]
steps = list(csv.DictReader(open(folder + '/csv/improvements.csv', newline='')))
assert json.load(open(folder + '/json/campaign.json'))['problems'][0]['name'] == 'hs-71'
assert len(steps) == sum(len(run['improvements']) for run in lines) > 0
for row, run in zip(runs, lines):
    assert row['number'] == str(run['number']) and row['solver'] == run['key']['solver']
    assert float(row['seconds']) == run['ledger']['seconds']
    assert (row['solved'] == '1') == run['verdict']['solved']
    assert row['optimality_gap'] == '' or float(row['optimality_gap']) == run['verdict']['optimality_gap']
print(len(runs), len(lines))
)";

TEST(Export, WritesEveryFormatThatOthersRead) {
  const fs::path folder = small_campaign();
  std::size_t runs = 0;
  for (const std::string format : {"csv", "json", "latex", "markdown", "iohanalyzer", "coco"}) {
    const Outcome outcome = call(
        fmt::format("export {0}/runs.sqlite --format {1} --out {0}/{1}", folder.string(), format));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr(" runs: ")) << format;
    runs = std::stoul(outcome.out);
  }
  EXPECT_GT(runs, 0U);
  EXPECT_TRUE(fs::exists(folder / "latex" / "table.tex"));
  EXPECT_TRUE(fs::exists(folder / "latex" / "summary.tex"));
  EXPECT_TRUE(fs::exists(folder / "markdown" / "table.md"));
  EXPECT_TRUE(fs::exists(folder / "coco" / "README.txt"));
  if (std::string(RICOCHET_PYTHON).ends_with("NOTFOUND")) return;
  const fs::path script = write(folder, "read.py", reader);
  const int status = std::system(fmt::format("{} {} {} >{}/said 2>&1", RICOCHET_PYTHON,
                                             script.string(), folder.string(), folder.string())
                                     .c_str());
  EXPECT_EQ(status, 0) << read(folder / "said");
  EXPECT_EQ(read(folder / "said"), fmt::format("{0} {0}\n", runs));
}

/// As the report has them: two entries of one family, with the larger budget.
TEST(Export, RanksTheEntriesOfACompleteCampaign) {
  const fs::path folder = small_campaign();
  const std::string store = (folder / "runs.sqlite").string();
  EXPECT_EQ(call(fmt::format("export {0} --format csv --out {1}/csv", store, folder.string())).err,
            "");
  const std::string ratings = read(folder / "csv" / "ratings.csv");
  EXPECT_THAT(ratings, HasSubstr("\nhs,1,20,random-search,penalised,1,"));
  EXPECT_THAT(ratings, HasSubstr("\nhs,1,20,nlopt-cobyla,original,1,"));
  EXPECT_THAT(read(folder / "csv" / "ecdf.csv"), HasSubstr("\nhs,nlopt-cobyla,original,20,"));
  EXPECT_THAT(read(folder / "csv" / "targets.csv"), HasSubstr("\nhs,hs-71,"));
}

/// A program that asks for one point of hs-71 again and again; what it says of itself.
std::string program(const fs::path& folder, const std::string& name, const std::string& claims) {
  const fs::path file = write(folder, name + ".sh",
                              fmt::format("echo '{{\"name\": \"{}\", {}}}'\nwhile read line; do\n"
                                          "  echo '{{\"ask\": [1, 5, 5, 1]}}'\n  read line\n"
                                          "  echo '{{\"done\": \"asked\"}}'\ndone\n",
                                          name, claims));
  return "sh " + file.string();
}

TEST(Export, RanksAUsersProgramsWithoutStartingThem) {
  const fs::path folder = fresh_folder();
  const fs::path plan = write(
      folder, "plan.toml",
      fmt::format("name = \"own\"\n[[part]]\nproblems = [\"hs-71\", \"hs-1\"]\n"
                  "solvers = [\"random-search\", \"{}\", \"{}\"]\n"
                  "formulations = [\"original\", \"penalised\"]\nbudgets = [5]\ninstances = 1\n",
                  program(folder, "takes-none", "\"takes_constraints\": 0"),
                  program(folder, "takes-all", "\"takes_constraints\": 2")));
  const Outcome made =
      call(fmt::format("run {} --out {} --allow-programs", plan.string(), folder.string()));
  ASSERT_EQ(made.exit_code, 0) << made.err;
  fs::remove(folder / "takes-none.sh");
  fs::remove(folder / "takes-all.sh");
  const Outcome outcome =
      call(fmt::format("export {0}/runs.sqlite --format csv --out {0}/csv", folder.string()));
  EXPECT_EQ(outcome.err, "");
  const std::string ratings = read(folder / "csv" / "ratings.csv");
  EXPECT_THAT(ratings, HasSubstr(",takes-none,penalised,"));
  EXPECT_THAT(ratings, HasSubstr(",takes-all,original,"));
  EXPECT_THAT(ratings, HasSubstr(",takes-all,penalised,"));
}

TEST(Export, SaysThatItDoesNotRankAPartOfACampaign) {
  const fs::path folder = small_campaign();
  const std::string part = (folder / "part").string();
  ASSERT_EQ(
      call(fmt::format("run {}/plan.toml --out {} --shard 1/2", folder.string(), part)).exit_code,
      0);
  const Outcome outcome =
      call(fmt::format("export {0}/runs.sqlite --format csv --out {0}/csv", part));
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("warning: entries are not ranked: "));
  EXPECT_TRUE(fs::exists(folder / "part" / "csv" / "running_times.csv"));
  EXPECT_FALSE(fs::exists(folder / "part" / "csv" / "ratings.csv"));
}

TEST(Export, RefusesWhatItCannotDo) {
  const fs::path folder = small_campaign();
  const std::string store = (folder / "runs.sqlite").string();
  const std::string fresh = (folder / "fresh").string();
  expect_refusal("export " + store + " --format cvs --out " + fresh, "csv");
  expect_refusal("export " + store + " --format csv --out " + folder.string(),
                 "must be a folder that is new or empty");
  expect_refusal("export " + store + ".none --format csv --out " + fresh, ".none");
  EXPECT_FALSE(fs::exists(fresh)) << "nothing was left there";
}

/// Shards 1 and 3 of 3 of a campaign of 24 runs.
class IncompleteCampaign : public testing::Test {
 protected:
  void SetUp() override {
    for (const int shard : {1, 3}) {
      const Outcome made = run(shard);
      EXPECT_THAT(made.out, HasSubstr("8 of 24 planned runs: "));
      EXPECT_THAT(made.err, HasSubstr("16 are missing"));
    }
    merged_ = call(fmt::format("merge {} {} {}", path("all.sqlite"), path("1/runs.sqlite"),
                               path("3/runs.sqlite")));
  }

  Outcome run(int shard) const {
    const fs::path plan = write(folder_, "plan.toml",
                                "[[part]]\nname = \"low\"\nproblems = [\"classic-ellipsoid-5\"]\n"
                                "solvers = [\"random-search\", \"nlopt-bobyqa\"]\nbudgets = [20]\n"
                                "instances = 6\n[[part]]\nname = \"high\"\n"
                                "problems = [\"classic-sphere-5\"]\nsolvers = [\"random-search\", "
                                "\"nlopt-bobyqa\"]\nbudgets = [20]\ninstances = 6\n");
    return call(fmt::format("run {} --out {} --shard {}/3", plan.string(),
                            path(std::to_string(shard)), shard));
  }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  const fs::path folder_ = fresh_folder();
  Outcome merged_;
};

constexpr auto missing =
    "16 of 24 planned runs are present, 8 are missing: shard 2 of 3; of classic-ellipsoid-5, "
    "classic-sphere-5; of nlopt-bobyqa, random-search; on instances 2, 5; 8 of 12 of low; 8 of 12 "
    "of high";

TEST_F(IncompleteCampaign, IsSaidToBeByEveryReader) {
  EXPECT_EQ(merged_.exit_code, 0);
  EXPECT_THAT(merged_.out, HasSubstr("16 of 24 planned runs: "));
  EXPECT_THAT(merged_.err, HasSubstr(missing));
  const Outcome digest = call("digest " + path("all.sqlite"));
  EXPECT_EQ(digest.exit_code, 0);
  EXPECT_THAT(digest.err, HasSubstr(missing));
  for (const std::string format : {"csv", "json", "latex", "markdown", "iohanalyzer", "coco"}) {
    const Outcome outcome = call(
        fmt::format("export {} --format {} --out {}", path("all.sqlite"), format, path(format)));
    EXPECT_EQ(outcome.exit_code, 0) << format;
    EXPECT_THAT(outcome.out, HasSubstr("16 of 24 planned runs: ")) << format;
    EXPECT_THAT(outcome.err, HasSubstr(missing)) << format;
  }
  const Outcome archived =
      call(fmt::format("submit {} --solvers '*' --out {}", path("all.sqlite"), path("an.archive")));
  EXPECT_THAT(archived.err, HasSubstr(missing));
  EXPECT_THAT(call("digest " + path("an.archive")).err, HasSubstr(missing));
  const Outcome compared = call(fmt::format("compare --stores {} {} --format json",
                                            path("all.sqlite"), path("1/runs.sqlite")));
  EXPECT_THAT(compared.err, HasSubstr(missing));
  const auto stores = report::Json::parse(compared.out)["stores"];
  EXPECT_EQ(stores[0]["planned"], 24);
  EXPECT_EQ(stores[0]["present"], 16);
  EXPECT_EQ(stores[0]["missing"], 8);
  EXPECT_EQ(stores[1]["missing"], 16);
}

TEST_F(IncompleteCampaign, IsSaidToBeInWhatIsExported) {
  for (const std::string format : {"csv", "json", "latex", "markdown", "iohanalyzer", "coco"}) {
    call(fmt::format("export {} --format {} --out {}", path("all.sqlite"), format, path(format)));
  }
  EXPECT_EQ(read(folder_ / "csv" / "completeness.csv"),
            "part,planned,present,missing\nall,24,16,8\nlow,12,8,4\nhigh,12,8,4\n");
  const auto campaign = report::Json::parse(read(folder_ / "json" / "campaign.json"));
  EXPECT_EQ(campaign["planned"], 24);
  EXPECT_EQ(campaign["present"], 16);
  EXPECT_EQ(campaign["missing"], 8);
  EXPECT_EQ(campaign["parts"][1]["part"], "high");
  EXPECT_EQ(campaign["missing_shards"], "shard 2 of 3");
  for (const char* file : {"csv/README.txt", "json/README.txt", "latex/table.tex",
                           "markdown/table.md", "iohanalyzer/README.txt", "coco/README.txt"}) {
    EXPECT_THAT(read(folder_ / file), HasSubstr("16 of 24 planned runs are present")) << file;
  }
  for (const auto& file : fs::recursive_directory_iterator(folder_)) {
    const std::string name = file.path().filename().string();
    if (!name.ends_with(".info") && !name.starts_with("IOHprofiler_f1_classic")) continue;
    if (name.ends_with(".json") || name.ends_with(".info")) {
      EXPECT_THAT(read(file.path()), HasSubstr("16 of 24 planned runs")) << name;
    }
  }
}

TEST_F(IncompleteCampaign, IsCompleteWithItsLastShardOrMadeFromWhatIsThere) {
  run(2);
  const std::string parts =
      fmt::format("{0}/1/runs.sqlite {0}/2/runs.sqlite {0}/3/runs.sqlite", folder_.string());
  const Outcome twice = call(fmt::format("merge {0} {1} {1}", path("twice.sqlite"), parts));
  EXPECT_THAT(twice.out, HasSubstr("24 runs: ")) << "all shards twice";
  EXPECT_EQ(twice.err, "");
  const Outcome taken = call(fmt::format("run {} --out {} --from {}", path("plan.toml"),
                                         path("taken"), path("all.sqlite")));
  EXPECT_THAT(taken.err, HasSubstr("16 runs are there already"));
  EXPECT_THAT(taken.out, HasSubstr("24 runs: "));
  EXPECT_EQ(call("digest " + path("taken/runs.sqlite")).out,
            call("digest " + path("twice.sqlite")).out);
}

}  // namespace
}  // namespace ricochet::cli
