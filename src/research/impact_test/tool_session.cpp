#include "src/research/impact_test/tool_session.h"

#include <fmt/format.h>

#include <fstream>

#include "src/core/one_line.h"
#include "src/report/json.h"

namespace ricochet::studies::impact_test {
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

}  // namespace ricochet::studies::impact_test
