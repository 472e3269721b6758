#include "problems/carrier_track/suite/cases.h"

#include <fmt/format.h>

#include <optional>

#include "ricochet/error.h"
#include "src/core/names.h"

namespace ricochet::carrier_track::inline problems {

std::vector<Case> all_cases() {
  const auto none = std::nullopt;
  return {
      {"C1", 0.1, 0.1, 0.0, {9.0, 5, Figure{5, 3.0, 10.0}}},
      {"C2", 0.9, 0.1, 0.0, {2.0, 12, Figure{6, 1.9, 5.8}}},
      {"C3", 0.1, 0.4, 0.0, {13.0, 5, Figure{7, 9.0, 17.0}}},
      {"C4", 0.9, 0.4, 0.0, {3.1, 5, Figure{8, 2.7, 11.6}}},
      {"C5", 0.1, 0.1, 0.1, {8.0, 5, Figure{9, 3.1, 12.0}}},
      {"C6", 0.9, 0.1, 0.1, {1.9, 12, Figure{10, 1.8, 4.4}}},
      {"C7", 0.1, 0.4, 0.1, {11.9, 5, Figure{11, 10.8, 16.9}}},
      {"C8", 0.9, 0.4, 0.1, {3.0, 5, Figure{12, 2.6, 16.0}}},
      {"C9", 0.1, 0.1, 1.0, {7.3, 5, Figure{13, 3.6, 13.3}}},
      {"C10", 0.9, 0.1, 1.0, {2.0, 12, Figure{14, 1.8, 4.4}}},
      {"C11", 0.9, 0.4, 1.0, {none, none, none}},
      {"C12", 0.1, 0.4, 1.0, {none, none, none}},
  };
}

Case find_case(const std::string& id) {
  std::vector<std::string> known;
  for (const Case& a_case : all_cases()) {
    if (equal_in_any_case(a_case.id, id)) return a_case;
    known.push_back(a_case.id);
  }
  throw InputError(fmt::format("{}: there is no such case; {}", id, what_instead(id, known)));
}

Scene scene_of(const Case& a_case, const Scene& machine) {
  Scene scene = machine;
  scene.restitution_lower = scene.restitution_upper = a_case.restitution;
  scene.friction = a_case.friction;
  scene.disturbance = a_case.disturbance;
  return scene;
}

}  // namespace ricochet::carrier_track::inline problems
