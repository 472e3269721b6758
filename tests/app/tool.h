#pragma once

#include <filesystem>
#include <string>

namespace ricochet::cli {

/// What a call of the program left behind.
struct Outcome {
  int exit_code;
  std::string out, err;
};

/// Calls the program under test with the arguments, as a shell would read them.
Outcome call(const std::string& arguments);

/// The same with standard output put elsewhere, as a shell would, e.g. ">/dev/full".
Outcome call_with_output(const std::string& arguments, const std::string& output);

/// The same, but after so many seconds it is sent the signal of that name.
Outcome call_interrupted(const std::string& signal, const std::string& arguments, int seconds = 1);

/// A command of the shell, in a working folder of the test.
Outcome call_in_shell(const std::string& command);

/// An empty folder of this test's own.
std::filesystem::path fresh_folder();

/// The text of a file.
std::string read(const std::filesystem::path& path);

/// A file with this text in `folder`.
std::filesystem::path write(const std::filesystem::path& folder, const std::string& name,
                            const std::string& text);

/// Expects what every command owes bad input: exit code 2, nothing on standard output, and one
/// line on standard error that holds `complaint`.
void expect_refusal(const std::string& arguments, const std::string& complaint);

}  // namespace ricochet::cli
