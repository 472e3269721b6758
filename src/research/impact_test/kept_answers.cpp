#include "src/research/impact_test/kept_answers.h"

#include <cerrno>
#include <fstream>
#include <map>
#include <sstream>
#include <system_error>

#include "src/core/text_file.h"

namespace ricochet::studies::impact_test {
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
