#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "src/app/command_line.h"
#include "src/experiment/stored_campaign.h"

namespace ricochet::cli {

/// A command that is a separate program, so that it need not be built unless it is used.
struct OtherCommand {
  const char* command;
  const char* program;  ///< file name, in ricochet's folder
  const char* summary;
  const char* group = "";  ///< of the help
};

/// The reproduction of the paper.
inline constexpr OtherCommand reproduction = {
    "reproduce", "ricochet-reproduce",
    "Reproduce the paper: every case against its claims, as a report", "paper"};

/// The studies of the suite itself, and the speed measurements.
inline constexpr OtherCommand other_commands[] = {
    {"calibrate", "ricochet-studies",
     "Fit the unknown parameters to the paper's thresholds, as a report", "paper"},
    {"surrogate", "ricochet-studies",
     "Where the surrogate and its gradient can be trusted, as a report", "paper"},
    {"fireworks", "ricochet-studies",
     "The fireworks family compared with published results, as a report", "paper"},
    {"verify", "ricochet-studies", "Check the impact model against an oracle in extended precision",
     "suite"},
    {"simulators", "ricochet-studies",
     "Simulators and models compared: speed, accuracy, what is lost, as a report", "suite"},
    {"best-values", "ricochet-studies", "Search the best known value of every problem", "suite"},
    {"bench", "ricochet-bench", "Measure speed; takes Google Benchmark's flags, too", "suite"},
};

/// Returns the summary of one of these commands. Throws std::out_of_range for any other.
const char* summary_of(const std::string& command);

/// Adds this command, which hands over all arguments after it, including --help.
void add_other(CommandLine& line, const OtherCommand& other);

/// Returns the path of that program: in the folder of this one.
std::string path_of(const OtherCommand& other);

/// In single quotes, as a shell reads it.
std::string shell_quoted(std::string_view word);

/// Returns the output of that program for this argument; empty if it fails.
std::string output_of(const OtherCommand& other, const std::string& argument);

/// Replaces this process by that program, called with the command and the arguments. Throws
/// std::runtime_error if it does not exist; otherwise does not return.
[[noreturn]] void hand_over(const OtherCommand& other, std::vector<std::string> arguments);

/// Returns what stores written by this program record about their origin.
Provenance provenance();

}  // namespace ricochet::cli
