#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "src/research/impact_test/answer.h"
#include "src/research/impact_test/scored_scene.h"

namespace ricochet::studies::impact_test {

/// The answers to some scenes, in their order. Those in the file are taken from there; the others
/// are asked for and added to it one by one, so that a run which is interrupted goes on there. A
/// file whose first line is not `origin` is replaced, and a last line that is cut off is asked
/// for again.
std::vector<Answer> kept_answers(const std::filesystem::path& file, const std::string& origin,
                                 const std::vector<ScoredScene>& scenes,
                                 const std::function<Answer(const ScoredScene&)>& ask);

}  // namespace ricochet::studies::impact_test
