#pragma once

#include <string>
#include <vector>

namespace ricochet::cli {

/// A command that is a separate program, so that it need not be built unless it is used.
struct OtherCommand {
  const char* command;
  const char* program;  ///< file name, in ricochet's folder
  const char* summary;
};

/// The reproduction of the paper.
inline constexpr OtherCommand reproduction = {
    "reproduce", "ricochet-reproduce", "The main job: every case against the paper, as a report"};

/// The studies of the suite itself, and the speed measurements.
inline constexpr OtherCommand other_commands[] = {
    {"calibrate", "ricochet-studies",
     "Which interpretation of the paper, and which constants, give its thresholds"},
    {"limits", "ricochet-studies",
     "How near any interpretation can come to the paper, as a report"},
    {"dynamics", "ricochet-studies",
     "Contact laws, numerical methods, hard and compliant walls, as a report"},
    {"surrogate", "ricochet-studies",
     "Where the smooth surrogate and its gradient can be trusted, as a report"},
    {"fireworks", "ricochet-studies",
     "The fireworks family beside what is published of it, as a report"},
    {"verify", "ricochet-studies", "The impact model against an oracle in extended precision"},
    {"stress", "ricochet-studies", "What every solver does on pathological problems, as a report"},
    {"problems", "ricochet-studies", "What every problem asks, as a report"},
    {"best-values", "ricochet-studies",
     "The best known value of every problem, looked for at length"},
    {"bench", "ricochet-bench", "The speed measurements; further flags are Google Benchmark's"},
};

/// Returns the summary of one of these commands. Throws std::out_of_range for any other.
const char* summary_of(const std::string& command);

/// Returns the path of that program: in the folder of this one.
std::string path_of(const OtherCommand& other);

/// Returns the output of that program for this argument; empty if it fails.
std::string output_of(const OtherCommand& other, const std::string& argument);

/// Replaces this process by that program, called with the command and the arguments. Throws
/// std::runtime_error if it does not exist; otherwise does not return.
[[noreturn]] void hand_over(const OtherCommand& other, std::vector<std::string> arguments);

}  // namespace ricochet::cli
