#include "src/cli/impact_test.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "ricochet/error.h"
#include "src/core/near_names.h"
#include "src/core/patterns.h"
#include "src/report/drawn_chart.h"
#include "src/research/impact_test/study.h"

namespace ricochet::cli {
namespace {

namespace fs = std::filesystem;

using namespace studies::impact_test;
using report::Json;

/// The tools that come with ricochet.
std::vector<Tool> known_tools() {
  const fs::path program = fs::read_symlink("/proc/self/exe").parent_path();
  constexpr std::array places = {"../share/ricochet/impact_test/tools.toml",
                                 "../../../../src/research/impact_test/tools/tools.toml"};
  for (const char* place : places) {
    const fs::path file = (program / place).lexically_normal();
    if (fs::exists(file)) return tools_in(file);
  }
  throw InputError(fmt::format("tools: {} is not there",
                               (program / places.front()).lexically_normal().string()));
}

std::vector<Tool> chosen_tools(const ImpactTestOptions& options) {
  std::vector<Tool> tools;
  if (options.tools != "none") tools = known_tools();
  if (options.tools != "none" && options.tools != "all") {
    std::vector<std::string> names;
    for (const Tool& tool : tools) names.push_back(tool.name);
    const std::vector<std::string> patterns = split_patterns(options.tools);
    require_fit(patterns, names, "--tools");
    std::erase_if(tools, [&](const Tool& tool) { return !fits_any(tool.name, patterns); });
  }
  for (const std::string& own : options.own_tools) {
    tools.push_back(own_tool(own));
    const auto same = std::ranges::count(tools, tools.back().name, &Tool::name);
    if (same > 1) throw InputError(fmt::format("--tool {}: the name is taken", own));
  }
  return tools;
}

Level level_named(const std::string& name) {
  std::vector<std::string> names;
  for (const Level level : all_levels) {
    names.push_back(name_of(level));
    if (names.back() == name) return level;
  }
  throw InputError(fmt::format("--levels {}: {}", name, what_instead(name, names)));
}

fs::path drivers_of(const ImpactTestOptions& options) {
  return fs::path(options.out) / "drivers";
}

}  // namespace

Plan plan_of(const ImpactTestOptions& options) {
  Plan plan{options.seed, options.scenes, {}, chosen_tools(options), false, options.out};
  plan.needs_all = options.tools != "all";
  for (const std::string& name : split_patterns(options.levels)) {
    plan.levels.push_back(level_named(name));
  }
  std::ranges::sort(plan.levels);
  const auto [first, last] = std::ranges::unique(plan.levels);
  plan.levels.erase(first, last);
  return plan;
}

int impact_test(const ImpactTestOptions& options, bool json) {
  studies::Finished finished =
      studies::run(studies::impact_test_study(plan_of(options)), options.quick, options.out);
  if (json) {
    for (const char* key : {"report", "made"}) finished.data.erase(key);
    fmt::print("{}\n", finished.data.dump(2));
  } else {
    fmt::print("{}", finished.epilogue);
  }
  report::require_none(finished.failures);
  return finished.data["ours"]["wrong"] == 0 ? 0 : 1;
}

int list_tools(const ImpactTestOptions& options, bool json) {
  Json rows = Json::array();
  for (const Tool& tool : chosen_tools(options)) {
    const FoundTool found = found_tool(tool, drivers_of(options));
    rows.push_back({{"tool", tool.name},
                    {"title", tool.title},
                    {"kind", tool.kind},
                    {"version", found.program ? Json(found.program->version) : Json()},
                    {"reason", found.program ? Json() : Json(found.reason)}});
  }
  if (json) {
    fmt::print("{}\n", rows.dump(2));
    return 0;
  }
  for (const Json& row : rows) {
    const bool there = row["reason"].is_null();
    fmt::print("{:<20} {:<60} {}\n", row["tool"].get<std::string>(),
               row["title"].get<std::string>(),
               there ? row["version"].get<std::string>() : row["reason"].get<std::string>());
  }
  return 0;
}

int install_tools(const ImpactTestOptions& options, bool json) {
  fs::create_directories(drivers_of(options));
  install(chosen_tools(options), drivers_of(options));
  return list_tools(options, json);
}

}  // namespace ricochet::cli
