#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include "ricochet/error.h"
#include "src/core/files.h"
#include "src/core/instance.h"
#include "src/core/names.h"
#include "src/core/progress.h"
#include "src/core/toml_fields.h"
#include "src/studies/simulators/suite.h"

namespace ricochet::studies::simulators {

template <class Visit, IsOf<Tool>... T>
void visit_fields(const Visit& visit, T&... t) {
  const auto required = [](std::string_view key) {
    return Field{key, "", "", {}, Presence::required};
  };
  const auto level = [](auto& tool, Level of) -> auto& {
    return tool.levels[static_cast<std::size_t>(of)];
  };
  visit(required("name"), Name{t.name}...);
  visit(required("title"), t.title...);
  visit(required("kind"), t.kind...);
  visit(Field{"packages"}, t.packages...);
  visit(required("source"), t.source...);
  visit(Field{"compile"}, t.compile...);
  visit(required("run"), t.run...);
  visit(required("version"), t.version...);
  for (const Level of : all_levels) visit(Field{name_of(of)}, level(t, of)...);
  visit(Field{"sets"}, t.sets...);
  visit(Field{"advice"}, t.advice...);
}

namespace {

/// A file of tools.
struct ToolsFile {
  std::vector<Tool> tools;
};

template <class Visit, IsOf<ToolsFile>... F>
void visit_fields(const Visit& visit, F&... f) {
  visit(Field{"tool", "", "", {}, Presence::required}, f.tools...);
}

}  // namespace

std::string name_of(Level level) {
  constexpr std::array names = {"loose", "usual", "tight"};
  return names[static_cast<std::size_t>(level)];
}

std::vector<Tool> tools_in(const std::filesystem::path& file) {
  std::vector<Tool> tools = fields_from<ToolsFile>(read_toml_text(file), file.string()).tools;
  std::set<std::string> names;
  for (Tool& tool : tools) {
    tool.source = (file.parent_path() / tool.source).string();
    if (!names.insert(tool.name).second) {
      throw InputError(fmt::format("{}, tool: {} is there twice", file.string(), tool.name));
    }
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
  if (!is_name(tool.name)) {
    throw InputError(fmt::format("--tool {}: \"{}\": must be {}", text, tool.name, names_in_words));
  }
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

}  // namespace

std::string driver_hash(const Tool& tool) {
  FnvHash hash;
  hash.add(tool.compile);
  if (tool.source.empty()) return fmt::format("{:016x}", hash.value());
  std::vector<fs::path> files = {tool.source};
  for (const auto& entry : fs::directory_iterator(files.front().parent_path())) {
    const fs::path& file = entry.path();
    const bool shared = file.extension() == ".h" || file.stem() == "tool" ||
                        file.stem().string().starts_with("tool_");
    if (shared) files.push_back(file);
  }
  std::sort(files.begin() + 1, files.end());
  for (const fs::path& file : files) hash.add(text_of(file));
  return fmt::format("{:016x}", hash.value());
}

namespace {

/// What stands for the paths of a tool in its commands.
struct Places {
  std::string here, source, out;

  std::string filled(std::string text) const {
    replace_all(text, "$HERE", here);
    replace_all(text, "$SOURCE", source);
    replace_all(text, "$OUT", out);
    return text;
  }
  std::vector<std::string> filled(std::vector<std::string> words) const {
    for (std::string& word : words) word = filled(word);
    return words;
  }
};

Places places_of(const Tool& tool, const fs::path& folder) {
  Places places{fs::absolute(tool.source).parent_path().string(),
                fs::absolute(tool.source).string(), ""};
  if (!tool.compile.empty()) {
    places.out =
        fs::absolute(folder / (fs::path(tool.source).stem().string() + "-" + driver_hash(tool)))
            .string();
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

}  // namespace

FoundTool found_tool(const Tool& tool, const fs::path& folder) {
  FoundTool found{tool, tool.run, "", ""};
  if (tool.source.empty()) return found;
  const Places places = places_of(tool, folder);
  found.reason = compiled(tool, places);
  if (!found.reason.empty()) return found;
  std::vector<std::string> version = places.filled(tool.version);
  if (version.size() == 1) version = {"sh", "-c", version.front()};
  const Ran told = ran(version);
  if (!told.well || told.output.empty())
    found.reason = "is not installed: " + (told.last.empty() ? "no version" : told.last);
  found.command = places.filled(tool.run);
  found.version = told.output;
  return found;
}

void install(const std::vector<Tool>& tools) {
  std::set<std::string> packages;
  for (const Tool& tool : tools) {
    for (const std::string& package : tool.packages) {
      if (ran({"dpkg-query", "-W", "-f=${Status}\n", package}).output != "install ok installed")
        packages.insert(package);
    }
  }
  if (packages.empty()) return;
  const std::string become = geteuid() == 0 ? "" : "sudo ";
  for (const std::string& command :
       {become + "apt-get update -qq",
        fmt::format(
            "{}env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends {}",
            become, fmt::join(packages, " "))}) {
    Progress::announce(command);
    if (std::system((command + " >&2").c_str()) != 0)
      throw std::runtime_error("failed: " + command);
  }
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

ToolSession::ToolSession(const FoundTool& tool, Level level, const std::filesystem::path& log,
                         TimeLimits limits)
    // One core each, so that times can be compared.
    : command_{"sh", "-c", "OMP_NUM_THREADS=1 exec \"$@\" 2>>\"$0\"", log.string()},
      log_(log),
      limits_(limits) {
  command_.insert(command_.end(), tool.command.begin(), tool.command.end());
  command_.push_back(name_of(level));
}

Answer ToolSession::ask(const TestScene& scene) {
  if (!process_) {
    process_.emplace(command_);
    has_answered_ = false;
  }
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
    report::Json sent = scene;
    sent["scales"] = scales_of(scene);
    process_->send(sent.dump() + "\n");
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

Simulator simulator_of(const FoundTool& tool, const fs::path& logs) {
  const auto open = [tool, logs](Level level) -> Ask {
    fs::create_directories(logs);
    const auto session =
        std::make_shared<ToolSession>(tool, level, logs / (tool.tool.name + ".log"));
    return [session](const ScoredScene& scored) { return session->ask(scored.scene); };
  };
  return {tool.tool, tool.version, false, open};
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
                                 std::span<const ScoredScene> scenes, const Ask& ask) {
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

}  // namespace ricochet::studies::simulators
