#include "src/research/dynamics/restitution.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "problems/carrier_track/models/simulate.h"
#include "problems/carrier_track/scene/contact_law.h"
#include "problems/carrier_track/scene/enum_names.h"

namespace ricochet::studies::dynamics {
namespace {

using namespace carrier_track;
using report::Json;

double distance(const ReturnedRestitution& point) {
  return std::abs(point.returned - point.asked);
}

constexpr double faithful_within = 0.01;

Json data_of(const LawStudy& law) {
  const ReturnedRestitution worst = worst_of(law);
  const double off = distance(worst);
  const bool exact = off < 5e-4;  // its worst place depends on rounding only
  return {{"law", law.name},
          {"exact", exact},
          {"worst_asked", exact ? Json() : Json(worst.asked)},
          {"worst_returned", exact ? Json() : Json(worst.returned)},
          {"off", off},
          {"faithful", off < faithful_within ? Json(true) : Json()},
          {"of_a_tenth", closed_return(law.law, 0.1)},
          {"of_nine_tenths", closed_return(law.law, 0.9)},
          {"measurement_error", largest_measurement_error(law)}};
}

}  // namespace

ReturnedRestitution worst_of(const LawStudy& study) {
  return *std::max_element(study.exact.begin(), study.exact.end(),
                           [](const auto& a, const auto& b) { return distance(a) < distance(b); });
}

double largest_measurement_error(const LawStudy& study) {
  double largest = 0;
  for (const ReturnedRestitution& point : study.measured) {
    largest = std::max(largest, std::abs(point.returned - closed_return(study.law, point.asked)));
  }
  return largest;
}

double closed_return(ContactLaw law, double asked) {
  if (law != ContactLaw::kelvin_voigt) return returned_restitution(dissipation(law, asked));
  return kelvin_voigt_restitution(damping_ratio(asked, Release::zero_force), Release::zero_force);
}

double measured_return(ContactLaw law, double asked) {
  Scene scene;  // 1 kg without any force, 1 mm above the only wall
  scene.wall_upper = std::numeric_limits<double>::infinity();
  scene.restitution_lower = scene.restitution_upper = asked;
  scene.start_position = 1e-3;
  scene.start_velocity = -1;
  scene.window = Seconds{1};
  scene.fidelity = Fidelity::compliant;
  scene.contact_law = law;
  if (law == ContactLaw::kelvin_voigt) scene.contact_exponent = 1;
  Observer nobody;
  return simulate(scene, nobody).velocity / -scene.start_velocity;
}

std::vector<LawStudy> study_laws(std::size_t stride) {
  std::vector<LawStudy> studies;
  for (const auto& [name, law] : contact_law_names()) {
    LawStudy& study = studies.emplace_back(LawStudy{std::string(name), law, {}, {}});
    for (std::size_t k = 2; k <= 98; ++k) {
      const double asked = 0.01 * static_cast<double>(k);
      study.exact.push_back({asked, closed_return(law, asked)});
      if ((k - 2) % stride == 0) study.measured.push_back({asked, measured_return(law, asked)});
    }
  }
  return studies;
}

Json data_of(const std::vector<LawStudy>& laws) {
  const double asked = 0.1;
  const double returned = closed_return(ContactLaw::hunt_crossley, asked);
  Json data = {{"hunt_crossley",
                {{"asked", asked},
                 {"returned", returned},
                 {"energy_asked", asked * asked},
                 {"energy_returned", returned * returned}}},
               {"faithful", Json::array()},
               {"laws", Json::array()},
               {"curves", Json::array()},
               {"measured", Json::array()}};
  for (const LawStudy& law : laws) {
    data["laws"].push_back(data_of(law));
    data["curves"].push_back({{"law", law.name}, {"exact", law.exact}});
    for (const ReturnedRestitution& one : law.measured) data["measured"].push_back(one);
    if (distance(worst_of(law)) <= faithful_within) data["faithful"].push_back(law.name);
  }
  return data;
}

}  // namespace ricochet::studies::dynamics
