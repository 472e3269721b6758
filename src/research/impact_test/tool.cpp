#include "src/research/impact_test/tool.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "ricochet/error.h"
#include "src/core/name.h"
#include "src/core/near_names.h"
#include "src/core/toml_file.h"

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

}  // namespace ricochet::studies::impact_test
