#include "src/research/impact_test/tool_program.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <set>
#include <stdexcept>

#include "solvers/outside/line_program.h"
#include "src/core/fnv_hash.h"
#include "src/core/one_line.h"
#include "src/core/progress.h"

namespace ricochet::studies::impact_test {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::seconds patience{300};  // to compile

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A hash of what a driver is compiled from: its source, the headers beside it, and the command.
std::string hash_of(const Tool& tool) {
  std::vector<fs::path> files = {tool.source};
  for (const auto& entry : fs::directory_iterator(tool.source.parent_path())) {
    if (entry.path().extension() == ".h") files.push_back(entry.path());
  }
  std::sort(files.begin() + 1, files.end());
  FnvHash hash;
  hash.add(tool.compile);
  for (const fs::path& file : files) hash.add(text_of(file));
  return fmt::format("{:016x}", hash.value());
}

/// What stands for the paths of a tool in its commands.
struct Places {
  std::string here, source, out, python;

  std::string filled(std::string text) const {
    for (const auto& [name, value] : {std::pair{"$HERE", &here}, std::pair{"$SOURCE", &source},
                                      std::pair{"$OUT", &out}, std::pair{"$PYTHON", &python}}) {
      const std::string key = name;
      for (auto at = text.find(key); at != std::string::npos;
           at = text.find(key, at + value->size())) {
        text.replace(at, key.size(), *value);
      }
    }
    return text;
  }
  std::vector<std::string> filled(std::vector<std::string> words) const {
    for (std::string& word : words) word = filled(word);
    return words;
  }
};

fs::path environment_in(const fs::path& folder) {
  return folder / "python";
}

Places places_of(const Tool& tool, const fs::path& folder) {
  const fs::path python = environment_in(folder) / "bin" / "python3";
  Places places{fs::absolute(tool.source.parent_path()).string(),
                fs::absolute(tool.source).string(), "",
                fs::exists(python) ? fs::absolute(python).string() : "python3"};
  if (!tool.compile.empty()) {
    places.out =
        fs::absolute(folder / (tool.source.stem().string() + "-" + hash_of(tool))).string();
  }
  return places;
}

/// What a command has printed last, and whether it ended well.
struct Ran {
  bool well;
  std::string output;  // the first line
  std::string last;    // the last one
};

Ran ran(const std::vector<std::string>& command) {
  std::vector<std::string> words = {"sh", "-c", "\"$@\" 2>&1; echo \"$?\"", "sh"};
  words.insert(words.end(), command.begin(), command.end());
  outside::LineProgram program(words);
  Ran result{false, "", ""};
  std::string code;
  for (;;) {
    const auto line = program.line({patience, "it was started", patience});
    if (!line) break;
    if (!code.empty()) result.last = code;
    if (result.output.empty()) result.output = code;
    code = one_line(*line);
  }
  result.well = code == "0";
  return result;
}

/// Compiles the driver. Returns why it failed, or nothing.
std::string compiled(const Tool& tool, const Places& places) {
  if (tool.compile.empty() || fs::exists(places.out)) return "";
  fs::create_directories(fs::path(places.out).parent_path());
  const char* compiler = std::getenv("CXX");
  const std::string draft = places.out + ".new";
  Places aside = places;
  aside.out = draft;
  std::string text = aside.filled(tool.compile);
  if (const auto at = text.find("$CXX"); at != std::string::npos) {
    text.replace(at, 4, compiler != nullptr ? compiler : "c++");
  }
  Progress::announce("compiling the driver of " + tool.name);
  const Ran result = ran({"sh", "-c", text});
  if (!result.well) {
    return fmt::format("its driver does not compile: {}", result.output);
  }
  fs::rename(draft, places.out);
  return "";
}

bool is_installed(const std::string& package) {
  return ran({"dpkg-query", "-W", "-f=${Status}\n", package}).output == "install ok installed";
}

/// Runs a command that shows what it does. Throws std::runtime_error if it fails.
void carry_out(const std::string& command) {
  Progress::announce(command);
  if (std::system((command + " >&2").c_str()) != 0) throw std::runtime_error("failed: " + command);
}

}  // namespace

FoundTool found_tool(const Tool& tool, const fs::path& folder) {
  if (tool.source.empty()) return {ToolProgram{tool, tool.run, ""}, ""};
  const Places places = places_of(tool, folder);
  if (std::string failure = compiled(tool, places); !failure.empty()) return {{}, failure};
  std::vector<std::string> version = places.filled(tool.version);
  if (version.size() == 1) version = {"sh", "-c", version.front()};
  const Ran told = ran(version);
  if (!told.well || told.output.empty()) {
    return {{}, fmt::format("is not installed: {}", told.last.empty() ? "no version" : told.last)};
  }
  return {ToolProgram{tool, places.filled(tool.run), told.output}, ""};
}

void install(const std::vector<Tool>& tools, const fs::path& folder) {
  std::set<std::string> packages, pip;
  for (const Tool& tool : tools) {
    for (const std::string& package : tool.packages) {
      if (!is_installed(package)) packages.insert(package);
    }
    pip.insert(tool.pip.begin(), tool.pip.end());
  }
  if (!pip.empty() && !is_installed("python3-venv")) packages.insert("python3-venv");
  const std::string become = geteuid() == 0 ? "" : "sudo ";
  if (!packages.empty()) {
    carry_out(become + "apt-get update -qq");
    carry_out(
        fmt::format("{}env DEBIAN_FRONTEND=noninteractive apt-get install -y "
                    "--no-install-recommends {}",
                    become, fmt::join(packages, " ")));
  }
  if (pip.empty()) return;
  const fs::path environment = environment_in(folder);
  if (!fs::exists(environment)) {
    carry_out(fmt::format("python3 -m venv --system-site-packages '{}'", environment.string()));
  }
  carry_out(fmt::format("'{}' install --quiet {}", (environment / "bin" / "pip").string(),
                        fmt::join(pip, " ")));
}

}  // namespace ricochet::studies::impact_test
