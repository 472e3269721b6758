#include "src/studies/impact_test/tool.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include "ricochet/error.h"
#include "solvers/outside/line_solver.h"
#include "src/core/files.h"
#include "src/core/instance.h"
#include "src/core/names.h"
#include "src/core/progress.h"
#include "src/core/toml.h"
#include "src/report/json.h"

namespace ricochet::studies::impact_test {

namespace {

const std::vector<std::string> keys = {"name",   "title",   "kind", "packages", "pip",
                                       "source", "compile", "run",  "version",  "loose",
                                       "usual",  "tight",   "sets", "advice"};

/// One [[tool]] of the file.
class Entry {
 public:
  Entry(const toml::table& table, const std::string& place) : table_(table), place_(place) {
    for (const auto& [key, node] : table_) {
      const std::string name(key.str());
      if (std::ranges::find(keys, name) != keys.end()) continue;
      refuse(fmt::format("there is no key {}; {}", name, what_instead(name, keys)));
    }
  }

  std::string text(const char* key) const {
    const auto value = table_[key].value<std::string>();
    if (!value && table_.contains(key)) refuse(fmt::format("{} must be a text", key));
    return value.value_or("");
  }

  std::string needed_text(const char* key) const {
    if (text(key).empty()) refuse(fmt::format("{} is missing", key));
    return text(key);
  }

  std::vector<std::string> list(const char* key) const {
    std::vector<std::string> list;
    const toml::array* array = table_[key].as_array();
    if (array == nullptr && table_.contains(key)) refuse(fmt::format("{} must be a list", key));
    for (std::size_t k = 0; array != nullptr && k < array->size(); ++k) {
      const auto value = (*array)[k].value<std::string>();
      if (!value) refuse(fmt::format("{} must be a list of texts", key));
      list.push_back(*value);
    }
    return list;
  }

  std::vector<std::string> needed_list(const char* key) const {
    if (list(key).empty()) refuse(fmt::format("{} is missing", key));
    return list(key);
  }

  [[noreturn]] void refuse(const std::string& reason) const {
    throw InputError(fmt::format("{}: {}", place_, reason));
  }

 private:
  const toml::table& table_;
  const std::string place_;
};

void check_name(const std::string& name, const std::string& place) {
  if (!is_name(name)) {
    throw InputError(fmt::format("{}: \"{}\": must be {}", place, name, names_in_words));
  }
}

Tool tool_of(const Entry& entry, const std::filesystem::path& folder) {
  Tool tool;
  tool.name = entry.needed_text("name");
  tool.title = entry.needed_text("title");
  tool.kind = entry.needed_text("kind");
  tool.packages = entry.list("packages");
  tool.pip = entry.list("pip");
  tool.source = folder / entry.needed_text("source");
  tool.compile = entry.text("compile");
  tool.run = entry.needed_list("run");
  tool.version = entry.needed_list("version");
  for (const Level level : all_levels) {
    tool.levels[static_cast<std::size_t>(level)] = entry.text(name_of(level).c_str());
  }
  tool.sets = entry.text("sets");
  tool.advice = entry.text("advice");
  return tool;
}

}  // namespace

std::string name_of(Level level) {
  constexpr std::array names = {"loose", "usual", "tight"};
  return names[static_cast<std::size_t>(level)];
}

std::vector<Tool> tools_in(const std::filesystem::path& file) {
  const toml::table content = parse_toml_file(file);
  const toml::array* entries = content["tool"].as_array();
  if (entries == nullptr) throw InputError(fmt::format("{}: has no [[tool]]", file.string()));
  std::vector<Tool> tools;
  for (std::size_t k = 0; k < entries->size(); ++k) {
    const std::string place = fmt::format("{}: tool {}", file.string(), k + 1);
    const toml::table* table = (*entries)[k].as_table();
    if (table == nullptr) throw InputError(place + ": must be a table");
    Tool tool = tool_of(Entry(*table, place), file.parent_path());
    check_name(tool.name, place);
    if (std::ranges::find(tools, tool.name, &Tool::name) != tools.end()) {
      throw InputError(fmt::format("{}: {} is there twice", place, tool.name));
    }
    tools.push_back(std::move(tool));
  }
  return tools;
}

Tool own_tool(const std::string& text) {
  const std::size_t equals = text.find('=');
  Tool tool;
  tool.name = text.substr(0, equals);
  if (equals != std::string::npos) {
    std::istringstream words(text.substr(equals + 1));
    for (std::string word; words >> word;) tool.run.push_back(word);
  }
  if (tool.run.empty()) {
    throw InputError(
        fmt::format("--tool {}: must be NAME=COMMAND, such as mine='./my-tool'", text));
  }
  check_name(tool.name, "--tool");
  tool.title = tool.name;
  tool.kind = "your own";
  return tool;
}

namespace {

namespace fs = std::filesystem;
using boost::algorithm::replace_all;

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
      replace_all(text, name, *value);
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
  replace_all(text, "$CXX", compiler != nullptr ? compiler : "c++");
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

namespace {

/// The last line of a file that is not empty.
std::string last_line_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string last;
  for (std::string line; std::getline(in, line);) {
    if (!line.empty()) last = line;
  }
  return one_line(last);
}

}  // namespace

ToolSession::ToolSession(const ToolProgram& program, Level level, const std::filesystem::path& log,
                         TimeLimits limits)
    // One core each, so that times can be compared.
    : command_{"sh", "-c", "OMP_NUM_THREADS=1 exec \"$@\" 2>>\"$0\"", log.string()},
      log_(log),
      limits_(limits) {
  command_.insert(command_.end(), program.command.begin(), program.command.end());
  command_.push_back(name_of(level));
}

void ToolSession::start() {
  process_.emplace(command_);
  has_answered_ = false;
}

Answer ToolSession::ask(const TestScene& scene) {
  if (!process_) start();
  Answer answer = answered(scene);
  if (answer.ending == Ending::never || !process_) {
    process_.reset();
    if (!has_ever_answered_ && ++failed_starts_ == most_failed_starts) {
      throw ToolFailure(answer.reason);
    }
  } else {
    has_answered_ = has_ever_answered_ = true;
  }
  return answer;
}

Answer ToolSession::answered(const TestScene& scene) {
  const std::chrono::seconds limit = has_answered_ ? limits_.scene : limits_.start;
  const outside::Patience patience{limit, "it was sent a scene", limit};
  try {
    process_->send(report::Json(scene).dump() + "\n");
    const auto line = process_->line(patience);
    if (line) return answer_in(*line, scene.scene);
  } catch (const std::runtime_error&) {  // it has read or written nothing for too long
    return {scene.scene, Ending::never, fmt::format("no answer within {} s", limit.count())};
  }
  return failed(scene.scene);
}

Answer ToolSession::failed(const std::string& scene) {
  const std::string how = process_->how_it_ended();
  process_.reset();
  const std::string said = last_line_of(log_);
  return {scene, Ending::error, said.empty() ? how : fmt::format("{}: {}", how, said)};
}

namespace {

/// The whole lines of a file, without their ends.
std::vector<std::string> lines_of(const std::filesystem::path& file) {
  std::vector<std::string> lines;
  std::istringstream in(std::filesystem::exists(file) ? text_of_file(file) : "");
  for (std::string line; std::getline(in, line) && !in.eof();) lines.push_back(std::move(line));
  return lines;
}

}  // namespace

std::vector<Answer> kept_answers(const std::filesystem::path& file, const std::string& origin,
                                 const std::vector<ScoredScene>& scenes,
                                 const std::function<Answer(const ScoredScene&)>& ask) {
  std::vector<std::string> lines = lines_of(file);
  if (lines.empty() || lines.front() != origin) lines = {origin};
  std::map<std::string, std::string> kept;
  std::string text = origin + "\n";
  for (std::size_t k = 1; k < lines.size(); ++k) {
    const report::Json json = report::Json::parse(lines[k], nullptr, false);
    if (!json.is_object() || !json.contains("scene")) continue;
    kept[json["scene"].get<std::string>()] = lines[k];
    text += lines[k] + "\n";
  }
  std::filesystem::create_directories(file.parent_path());
  write_text_file(file, text, SymbolicLinks::refused);
  std::ofstream out(file, std::ios::binary | std::ios::app);
  std::vector<Answer> answers;
  for (const ScoredScene& scored : scenes) {
    const std::string& name = scored.scene.scene;
    if (const auto found = kept.find(name); found != kept.end()) {
      answers.push_back(answer_in(found->second, name));
      continue;
    }
    answers.push_back(ask(scored));
    const Uninterrupted whole_line;
    if (!(out << line_of(answers.back()) << std::endl)) {
      throw OutputError(file.string() + ": " + std::generic_category().message(errno));
    }
  }
  return answers;
}

}  // namespace ricochet::studies::impact_test
