#pragma once

#include <string>
#include <vector>

namespace ricochet::cli {

/// A command that a program of its own carries out, so that who does not call it need not build it.
struct OtherCommand {
  const char* command;
  const char* program;  ///< its file's name, beside ricochet
  const char* summary;
};

/// The studies of the suite itself, and the speed measurements.
inline constexpr OtherCommand other_commands[] = {
    {"calibrate", "ricochet-studies",
     "Which reading of the paper, and which constants, give its thresholds"},
    {"limits", "ricochet-studies", "How near any reading can come to the paper, as a report"},
    {"dynamics", "ricochet-studies",
     "Contact laws, numerical methods, hard and compliant walls, as a report"},
    {"surrogate", "ricochet-studies",
     "Where the smooth surrogate and its gradient can be trusted, as a report"},
    {"trials", "ricochet-studies",
     "Would a reading of the paper that nobody has tried come nearer, as a report"},
    {"fireworks", "ricochet-studies",
     "The fireworks family beside what is published of it, as a report"},
    {"verify", "ricochet-studies", "The impact model against an oracle in extended precision"},
    {"stress", "ricochet-studies", "What every solver does where a problem is ill, as a report"},
    {"problems", "ricochet-studies", "What every question asks, as a report"},
    {"best-values", "ricochet-studies",
     "The best known value of every question, looked for at length"},
    {"bench", "ricochet-bench", "The speed measurements; further flags are Google Benchmark's"},
};

/// The summary of one of these commands. Throws std::out_of_range if it is none.
const char* summary_of(const std::string& command);

/// Where that program is: beside this one.
std::string path_of(const OtherCommand& other);

/// Becomes that program, which is called with the command and the arguments. Throws
/// std::runtime_error if it is not there; otherwise it does not return.
[[noreturn]] void hand_over(const OtherCommand& other, std::vector<std::string> arguments);

}  // namespace ricochet::cli
