#include "src/studies/problems/study.h"

#include <filesystem>

#include "problems/families.h"
#include "src/studies/problems/family_data.h"

namespace ricochet::studies {
namespace {

using report::Json;

Json compute(const std::string& scene_file) {
  const std::vector<Family> families = all_families(scene_file);
  Json data = {{"scene", Json()},
               {"questions", 0},
               {"kinds", 0},
               {"families", Json::array()},
               {"pages", Json::array()}};
  if (!scene_file.empty()) data["scene"] = std::filesystem::path(scene_file).filename().string();
  std::size_t questions = 0;
  for (const Family& family : families) {
    if (family.questions.empty()) continue;
    questions += family.questions.size();
    data["families"].push_back(problems::family_row(family));
    data["pages"].push_back({{"folder", family.name}, {"data", problems::family_data(family)}});
  }
  data["questions"] = questions;
  data["kinds"] = data["families"].size();
  return data;
}

}  // namespace

Study problems_study(const std::string& scene_file) {
  return {"problems", "", [scene_file](bool /*quick*/) { return compute(scene_file); }};
}

}  // namespace ricochet::studies
