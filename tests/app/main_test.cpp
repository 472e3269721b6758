#include <regex>

#include "problems/carrier_track/scene/scene_fields.h"
#include "src/experiment/plan.h"
#include "tests/app/tool.h"
#include "tests/support/refusals.h"

/// What every command owes its user: help, streams, colours, and what the documents say of machine
/// files and plans.
namespace ricochet::cli {
namespace {

TEST(Main, TellsItsVersion) {
  EXPECT_THAT(out_of("--version"),
              AllOf(StartsWith("ricochet 0.2.0 (commit "), HasSubstr("Eigen 3"), HasSubstr("fmt "),
                    HasSubstr("CLI11 "), HasSubstr("NLopt ")));
}

TEST(Main, EchoesBadInputInOneShortLine) {
  const Outcome outcome = call("simulate --case \"$(printf 'C\\033[31m%0100000d')\"");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_LT(outcome.err.size(), 5000U);
  EXPECT_THAT(outcome.err, HasSubstr("C\\x1b[31m000"));
}

TEST(Main, ReportsOutputThatIsLostWhereThereIsSome) {
  if (const auto reason = missing({"/dev/full"}); !reason.empty()) GTEST_SKIP() << reason;
  for (const std::string arguments :
       {"scene --case C1", "list problems", "list problems --format json", "simulate --case C1",
        "--version", "--help", "list --help"}) {
    for (const std::string output : {" >/dev/full", " >&-"}) {
      SCOPED_TRACE(arguments + output);
      const Outcome outcome = call(arguments + output);
      EXPECT_EQ(outcome.exit_code, 1);
      EXPECT_THAT(outcome.err, testing::MatchesRegex("ricochet: standard output: [^\n]*\n"));
    }
  }
  EXPECT_EQ(call("list speeds >/dev/full").exit_code, 2);
}

/// Closed, or full: what is said there is lost, and the command does its work, whichever streams
/// are closed beside it.
TEST(Main, NeedsNoStandardError) {
  if (const auto reason = missing({"/dev/full", "/proc/self/exe"}); !reason.empty())
    GTEST_SKIP() << reason;
  write("plan.toml",
        "[[part]]\nproblems = \"classic-sphere-5\"\nsolvers = \"random-search\"\nbudgets = 20\n");
  for (const std::string streams : {"2>&-", "2>/dev/full", "2>&- <&-", "2>/dev/full </dev/null"}) {
    fs::remove_all(here() / "made");
    EXPECT_THAT(out_of("run plan.toml --out made " + streams), HasSubstr("\ndigest ")) << streams;
    for (const std::string arguments :
         {"digest made", "threshold --case C1", "simulate --case C1",
          "solve mads count-C1 --budget 20", "surrogate --quick", "report made"}) {
      out_of(arguments + " " + streams);
    }
    EXPECT_EQ(call("simulate --case C77 " + streams).exit_code, 2) << streams;
    EXPECT_EQ(call("simulate --case C1 >&- " + streams).exit_code, 1) << streams;
  }
}

TEST(Main, SendsEscapesOnlyToATerminalThatTakesThem) {
  if (const auto reason = no_terminal(); !reason.empty()) GTEST_SKIP() << reason;
  const auto on_terminal = [](const std::string& environment, const std::string& arguments) {
    return call_in_shell(filled("env -u NO_COLOR {} script -qec 'ricochet {}' /dev/null </dev/null",
                                environment, arguments))
        .out;
  };
  const std::string wrong = "simulate --case C77";
  const std::string drawn = "solve random-search count-C1 --budget 300";
  EXPECT_THAT(on_terminal("TERM=xterm", wrong), HasSubstr("\x1b[31m"));
  EXPECT_THAT(on_terminal("TERM=xterm", drawn), HasSubstr("\x1b[K"));
  EXPECT_THAT(on_terminal("TERM=xterm NO_COLOR=1", wrong), Not(HasSubstr("\x1b")));
  for (const char* environment : {"TERM=dumb", "-u TERM", "TERM="}) {
    for (const std::string& command : {wrong, drawn, std::string("surrogate --quick")}) {
      const std::string shown = on_terminal(environment, command);
      EXPECT_NE(shown, "");
      EXPECT_THAT(shown, Not(HasSubstr("\x1b"))) << environment << command;
    }
  }
  EXPECT_THAT(on_terminal("TERM=dumb", wrong + " --color always"), HasSubstr("\x1b[31m"));
}

TEST(Main, ColoursErrorsWhereAsked) {
  EXPECT_THAT(call("simulate --case C77 --color always").err,
              StartsWith("\x1b[31mricochet:\x1b[m C77: "));
  EXPECT_THAT(call("simulate --case C77 --color never").err, StartsWith("ricochet: C77: "));
  EXPECT_THAT(call("calibrate --color always --interpretation sideways").err,
              HasSubstr("\x1b[31mricochet:\x1b[m --interpretation sideways: there is no such"))
      << "returned";
}

/// However small the stack is, a command works or says what it needs.
TEST(DailyUse, WorksOnASmallStackOrSaysWhatItNeeds) {
  for (const int kilobytes : {48, 64, 96, 512, 2048}) {
    for (const char* arguments : {"list problems", "threshold --case C1", "solve mads count-C1",
                                  "solve ipopt hs-71", "machine check /dev/null"}) {
      const Outcome outcome =
          call_in_shell(fmt::format("ulimit -s {}; ricochet {}", kilobytes, arguments));
      EXPECT_LE(outcome.exit_code, 2) << arguments << kilobytes << outcome.err;
      if (kilobytes < 1024 && outcome.exit_code != 0) {
        EXPECT_THAT(outcome.err, testing::AnyOf(HasSubstr("must be at least 1024, see ulimit -s"),
                                                HasSubstr("/dev/null")));
      }
    }
  }
}

TEST(Description, OfEveryCommandHasExamplesAndExitCodes) {
  if (const auto reason = no_other_programs(); !reason.empty()) GTEST_SKIP() << reason;
  for (const std::string command :
       {"machine",   "simulate",  "threshold", "regimes", "identify",   "scene",      "problem",
        "list",      "solve",     "evaluate",  "compare", "plan",       "run",        "replay",
        "merge",     "digest",    "submit",    "export",  "report",     "site",       "reproduce",
        "calibrate", "surrogate", "fireworks", "verify",  "simulators", "best-values"}) {
    EXPECT_THAT(out_of(command + " --help"), AllOf(HasSubstr("Usage: ricochet " + command),
                                                   HasSubstr("Examples:\n  ricochet " + command),
                                                   HasSubstr("Exit codes: 0 done; 1 ")));
  }
}

/// A row of the table of the scene's keys; its cells after the keys.
struct KeyRow {
  std::string unit, allowed, missing;
};

const std::string page_of_machines = RICOCHET_SOURCE "/docs/machine-files.md";

/// The rows by table and key, such as "scene.mass".
std::map<std::string, KeyRow> rows_of_scene_keys() {
  static const std::regex heading(R"([|] [*][*]\[([a-z]+)\].*)"), named_key("`([^`]+)`");
  static const std::regex cells(
      R"([|] (`[^|]*?) *[|] *([^|]*?) *[|] *([^|]*?) *[|] *([^|]*?) *[|])");
  std::map<std::string, KeyRow> rows;
  std::string table;
  for (const std::string& line : lines_of(read(page_of_machines))) {
    std::smatch found;
    if (line.empty()) table.clear();
    if (std::regex_match(line, found, heading)) table = found[1];
    if (table.empty() || !line.starts_with("| `")) continue;
    if (!std::regex_match(line, found, cells)) throw std::runtime_error("no four cells: " + line);
    const std::string keys = found[1];
    for (std::sregex_iterator key(keys.begin(), keys.end(), named_key), end; key != end; ++key) {
      rows[table + "." + (*key)[1].str()] = {found[2], found[3], found[4]};
    }
  }
  return rows;
}

TEST(MachineFiles, DocumentEveryUnit) {
  const std::string page = read(page_of_machines);
  for (const char* unit : {"m", "m/s", "kg", "kg m", "N", "s", "rad", "rad/s"}) {
    std::string row = fmt::format("| {} |", unit);
    for (const std::string_view name : units_for(unit)) {
      row += fmt::format("{}`{}`", row.ends_with('|') ? " " : ", ", name);
    }
    EXPECT_THAT(page, HasSubstr(row + " |\n"));
  }
}

TEST(MachineFiles, DocumentEveryFieldOfAScene) {
  const std::map<std::string, KeyRow> rows = rows_of_scene_keys();
  // What the list of fields has not as keys of their own: the window, one restitution a wall, and
  // another way to give a field.
  std::set<std::string> keys = {"scene.path_radius",       "window.revolutions",
                                "window.seconds",          "scene.restitution_lower",
                                "scene.restitution_upper", "across.restitution_lower",
                                "across.restitution_upper"};
  const auto expect_row_in = [&](const std::string& table) {
    return [&rows, &keys, table](const carrier_track::SceneField& field) {
      const std::string key = fmt::format("{}.{}", table, field.key);
      keys.insert(key);
      ASSERT_TRUE(rows.contains(key)) << key;
      KeyRow row = rows.at(key);
      if (row.allowed == "as in [scene]") row = rows.at(fmt::format("scene.{}", field.key));
      SCOPED_TRACE(key);
      const std::string unit(field.unit == "1" ? "" : field.unit);
      EXPECT_THAT(row.unit, StartsWith(unit));
      EXPECT_EQ(row.unit.empty(), unit.empty());
      if (field.key != "wall_lower") {  // whose row is that of both walls
        const bool is_finite = field.range == carrier_track::ranges::finite;
        EXPECT_THAT(row.allowed, HasSubstr(is_finite ? "finite" : field.range.brief));
      }
      EXPECT_EQ(row.missing.starts_with("must be given"), field.presence == Presence::required);
    };
  };
  carrier_track::visit_scene_fields(expect_row_in("scene"));
  expect_row_in("scene")(carrier_track::path_radius);
  carrier_track::visit_across_fields(expect_row_in("across"));
  carrier_track::visit_count_fields(expect_row_in("count"));
  carrier_track::visit_model_fields(expect_row_in("model"));
  std::set<std::string> documented;
  for (const auto& [key, row] : rows) documented.insert(key);
  EXPECT_EQ(documented, keys);
}

/// The keys that a table may have: those that the refusal of another one lists.
std::vector<std::string> keys_beside(const std::string& unknown_key) {
  static const std::regex word("[a-z_]+");
  const std::string said = complaint_of([&] { return plan_from(unknown_key, "a plan"); });
  const std::size_t list = said.find("allowed: ");
  if (list == std::string::npos) return {};
  const std::string keys = said.substr(list + 9);
  return {std::sregex_token_iterator(keys.begin(), keys.end(), word), {}};
}

TEST(PlanFiles, HaveEveryKeyInTheirTemplate) {
  const std::string page = read(RICOCHET_SOURCE "/src/app/plan_template.toml");
  for (const auto& [table, least] :
       {std::pair("", 6U), std::pair("[limits]\n", 2U), std::pair("[[solver]]\n", 3U),
        std::pair("[[scene]]\n", 3U), std::pair("[[part]]\n", 15U)}) {
    const std::vector<std::string> keys = keys_beside(std::string(table) + "qqqqqqqq = 1");
    EXPECT_GE(keys.size(), least) << table;
    for (const std::string& key : keys) {
      EXPECT_THAT(page, testing::ContainsRegex("[ \n]" + key + " =|\\[" + key + "\\]")) << table;
    }
  }
}

}  // namespace
}  // namespace ricochet::cli
