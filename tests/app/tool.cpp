#include "tests/app/tool.h"

#include <sys/wait.h>

#include "src/report/text.h"

namespace ricochet::cli {
namespace {

/// Where the current test works: its folder is .here, beside what its last command wrote.
std::string stem() {
  const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
  std::string name = fmt::format("ricochet_cli_{}_{}", test->test_suite_name(), test->name());
  std::ranges::replace(name, '/', '_');
  return testing::TempDir() + name;
}

/// Gives each test an empty folder.
class Folders : public testing::EmptyTestEventListener {
  void OnTestStart(const testing::TestInfo&) override {
    fs::remove_all(here());
    fs::create_directories(here());
  }
};

[[maybe_unused]] const bool listening = [] {
  testing::UnitTest::GetInstance()->listeners().Append(new Folders);
  return true;
}();

}  // namespace

fs::path here() {
  return stem() + ".here";
}

std::string read(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(here() / file).rdbuf();
  return text.str();
}

std::string write(const std::string& name, const std::string& text) {
  write_file(here() / name, text);
  return name;
}

void write_program(const std::string& name, const std::string& text) {
  fs::permissions(here() / write(name, text), fs::perms::owner_all);
}

bool exists(const fs::path& file) {
  return fs::exists(here() / file);
}

report::Results results_of(const std::string& folder) {
  return report::results_in(report::data_in(read(folder + "/data.json")));
}

Outcome call_in_shell(const std::string& command) {
  const std::string folder = fs::path(RICOCHET_PROGRAM).parent_path();
  const int status = std::system(fmt::format("cd {0}.here && (PATH={1}:$PATH; {2}\n) >{0}.out "
                                             "2>{0}.err",
                                             stem(), folder, command)
                                     .c_str());
  return {WEXITSTATUS(status), read(stem() + ".out"), read(stem() + ".err")};
}

Outcome call_interrupted(const std::string& signal, const std::string& arguments, int seconds) {
  return call_in_shell(fmt::format("timeout --preserve-status --signal={} {} ricochet {}", signal,
                                   seconds, arguments));
}

void expect_refusal(const std::string& arguments, const std::string& complaint) {
  const Outcome outcome = call(arguments);
  EXPECT_EQ(outcome.exit_code, 2) << arguments;
  EXPECT_EQ(outcome.out, "") << arguments;
  EXPECT_THAT(outcome.err, AllOf(HasSubstr(complaint), testing::MatchesRegex("ricochet: [^\n]*\n")))
      << arguments;
}

std::string no_terminal() {
  const Outcome tried =
      call_in_shell("script -qec 'test -t 1 && stty cols 60' /dev/null </dev/null");
  return tried.exit_code == 0 ? "" : "there is no terminal: " + tried.err + tried.out;
}

std::string missing(const std::vector<std::string>& files) {
  for (const std::string& file : files) {
    if (!fs::exists(file)) return "there is no " + file;
  }
  return "";
}

std::string no_other_programs() {
  return missing({"/proc/self/exe"});
}

}  // namespace ricochet::cli
