#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "src/research/impact_test/results.h"

namespace ricochet::cli {

struct ImpactTestOptions {
  int scenes = 10'000;
  int seed = 1;
  std::string tools = "all";           ///< names or patterns, separated by commas; or none
  std::vector<std::string> own_tools;  ///< NAME=COMMAND each
  std::string levels = "loose,usual,tight";
  bool quick = false;
  std::string out;
};

/// The plan of these options. Throws InputError for an unknown tool or level.
studies::impact_test::Plan plan_of(const ImpactTestOptions& options);

/// Runs the test, writes its report, and prints its summary, or its results as JSON. Returns the
/// exit code: 1 where ricochet itself misses or invents an impact.
int impact_test(const ImpactTestOptions& options, bool json);

/// Prints all tools: name, title, and whether each can be started.
int list_tools(const ImpactTestOptions& options, bool json);

/// Installs what the chosen tools need, from Debian and from Python's registry, then lists them.
int install_tools(const ImpactTestOptions& options, bool json);

}  // namespace ricochet::cli
