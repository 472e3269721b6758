#include "src/benchmark/problem_pages/study.h"

#include <filesystem>

#include "src/benchmark/problem_pages/family_data.h"
#include "src/core/suite_version.h"

namespace ricochet::studies {
namespace {

using report::Json;

constexpr int simulations = 1000;  // of a problem, to see how hard it is

Json compute(const std::vector<Family>& families, const std::string& scene_file) {
  Json data = {{"suite", suite_version},    {"scene", Json()},       {"problems", 0}, {"kinds", 0},
               {"families", Json::array()}, {"pages", Json::array()}};
  if (!scene_file.empty()) data["scene"] = std::filesystem::path(scene_file).filename().string();
  std::size_t problems = 0;
  for (const Family& family : families) {
    if (family.problems.empty()) continue;
    problems += family.problems.size();
    data["families"].push_back(problems::family_row(family));
    data["pages"].push_back(
        {{"folder", family.name}, {"data", problems::family_data(family, simulations)}});
  }
  data["problems"] = problems;
  data["kinds"] = data["families"].size();
  return data;
}

}  // namespace

Study problems_study(const std::function<std::vector<Family>()>& families,
                     const std::string& scene_file) {
  return {"problems", "",
          [families, scene_file](bool /*quick*/) { return compute(families(), scene_file); }};
}

}  // namespace ricochet::studies
