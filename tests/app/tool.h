#pragma once

#include "src/report/results.h"
#include "tests/support/files.h"

namespace ricochet::cli {

using Json = nlohmann::ordered_json;

/// What a command left behind.
struct Outcome {
  int exit_code;
  std::string out, err;
};

/// The folder of this test, empty at first, in which its commands work.
fs::path here();

/// The text of a file, whose name is relative to here().
std::string read(const fs::path& file);

/// A file with this text, in a folder that is made where it is missing; the name.
std::string write(const std::string& name, const std::string& text);

/// The same, which can be called.
void write_program(const std::string& name, const std::string& text);

bool exists(const fs::path& file);

/// What the report in that folder found.
report::Results results_of(const std::string& folder);

/// A part of a command; a path is not quoted.
inline std::string plain(const fs::path& path) {
  return path.string();
}
template <class Part>
requires(!std::is_same_v<Part, fs::path>) std::string plain(const Part& part) {
  return fmt::format("{}", part);
}

/// The pattern of fmt with these parts in it; as it is where there are none.
template <class... Parts>
std::string filled(std::string_view pattern, const Parts&... parts) {
  if constexpr (sizeof...(parts) == 0) return std::string(pattern);
  return fmt::vformat(pattern, fmt::make_format_args(plain(parts)...));
}

/// A command of the shell, which finds the program under test by its name, ricochet.
Outcome call_in_shell(const std::string& command);

/// Calls the program under test with the arguments, filled, as a shell would read them.
template <class... Parts>
Outcome call(std::string_view arguments, const Parts&... parts) {
  return call_in_shell("ricochet " + filled(arguments, parts...));
}

/// What the call writes on standard output; it must be a success, with exit code 0.
template <class... Parts>
std::string out_of(std::string_view arguments, const Parts&... parts) {
  const Outcome outcome = call(arguments, parts...);
  EXPECT_EQ(outcome.exit_code, 0) << arguments << '\n' << outcome.err;
  return outcome.out;
}

/// The same as JSON, for which it asks.
template <class... Parts>
Json json_of(std::string_view arguments, const Parts&... parts) {
  return Json::parse(out_of(filled(arguments, parts...) + " --format json"), nullptr, false);
}

/// A call that is sent the signal of that name after so many seconds.
Outcome call_interrupted(const std::string& signal, const std::string& arguments, int seconds = 1);

/// Expects what every command owes bad input: exit code 2, nothing on standard output, and one
/// line on standard error that holds `complaint`.
void expect_refusal(const std::string& arguments, const std::string& complaint);

/// What must be there for this test and is not, for GTEST_SKIP; empty if nothing is missing.
std::string no_terminal();
std::string missing(const std::vector<std::string>& files);
std::string no_other_programs();  // which it starts for some commands, as it finds itself in /proc

}  // namespace ricochet::cli
