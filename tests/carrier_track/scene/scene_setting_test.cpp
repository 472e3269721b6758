#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "problems/carrier_track/scene/scene_fields.h"
#include "problems/carrier_track/scene/scene_file.h"
#include "ricochet/error.h"

namespace ricochet::carrier_track {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const std::string own =
    "[scene]\nmass = 1\nwall_lower = 0\nwall_upper = 1e-3\nrestitution = 0.5\nstart_position = 0\n"
    "centrifugal_mass_radius = 0.1\n[window]\nrevolutions = 2\n";
const std::string with_across =
    own + "[across]\nwall_lower = 0\nwall_upper = 2e-3\nrestitution = 0.4\nstart_position = 0\n";

Scene with(const std::vector<std::string>& settings, const std::string& text = own) {
  return parse_scene_file(text, "own", settings).scene;
}

std::string complaint_about(const std::string& setting, const std::string& text = own) {
  try {
    with({setting}, text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(SceneSetting, ChangesOrAddsAKey) {
  EXPECT_EQ(with({"mass=2"}).mass, 2);
  EXPECT_EQ(with({"friction = 0.25"}).friction, 0.25);
  EXPECT_EQ(with({"scene.friction=0.25", "friction=0.5"}).friction, 0.5);
  EXPECT_EQ(with({"counting_limit=7e-3"}).counting_limit, 7e-3);
  EXPECT_EQ(with({"wall_upper=inf"}).wall_upper, std::numeric_limits<double>::infinity());
  EXPECT_TRUE(with({"contact_friction=true"}).contact_friction);
  EXPECT_EQ(with({"omega=[[0, 1], [2, 3]]"}).profile.size(), 2U);
}

TEST(SceneSetting, NeedsNoQuotesForATextOrAUnit) {
  EXPECT_EQ(with({"wall_upper=0.8 mm"}).wall_upper, 0.8e-3);
  EXPECT_EQ(with({"wall_upper=\"0.8 mm\""}).wall_upper, 0.8e-3);
  EXPECT_EQ(with({"centrifugal=outward"}).centrifugal, Centrifugal::outward);
  EXPECT_EQ(with({"model.fidelity=compliant"}).fidelity, Fidelity::compliant);
  EXPECT_EQ(with({"contact_law=hertz"}).contact_law, ContactLaw::hertz);
}

TEST(SceneSetting, TakesThePlaceOfKeysThatSayTheSame) {
  EXPECT_EQ(with({"path_radius=65 mm"}).centrifugal_mass_radius, 0.065);
  EXPECT_EQ(with({"path_radius=1", "centrifugal_mass_radius=0.2"}).centrifugal_mass_radius, 0.2);
  EXPECT_EQ(std::get<Seconds>(with({"seconds=3"}).window).count, 3);
  EXPECT_EQ(std::get<Revolutions>(with({"seconds=3", "revolutions=4"}).window).count, 4);
  const Scene walls = with({"restitution_upper=0.7"});
  EXPECT_EQ(walls.restitution_lower, 0.5);
  EXPECT_EQ(walls.restitution_upper, 0.7);
  EXPECT_EQ(with({"restitution_upper=0.7", "restitution=0.6"}).restitution_lower, 0.6);
  const std::string old = own + "[count]\nslowest = 2e-3\n";
  EXPECT_EQ(with({"counting_limit=9e-3"}, old).counting_limit, 9e-3);
}

TEST(SceneSetting, NamesTheTableOnlyWhereItMust) {
  EXPECT_EQ(with({"wall_upper=3e-3"}).wall_upper, 3e-3);
  EXPECT_EQ(complaint_about("wall_upper=3e-3", with_across),
            "--set wall_upper=3e-3: wall_upper is ambiguous: must be scene.wall_upper or "
            "across.wall_upper");
  EXPECT_EQ(with({"across.wall_upper=3e-3"}, with_across).across->wall_upper, 3e-3);
  EXPECT_EQ(with({"scene.wall_upper=3e-3"}, with_across).wall_upper, 3e-3);
}

TEST(SceneSetting, IsNamedWhereItIsWrong) {
  EXPECT_EQ(complaint_about("friction"), "--set friction: must be KEY=VALUE");
  EXPECT_THAT(complaint_about("fricton=1"), StartsWith("--set fricton=1: there is no key fricton; "
                                                       "did you mean friction"));
  EXPECT_THAT(complaint_about("count.mass=1"), HasSubstr("there is no key count.mass"));
  EXPECT_THAT(complaint_about("=1"), HasSubstr("there is no key"));
  EXPECT_EQ(complaint_about("friction=-1"),
            "own with --set friction=-1: scene.friction = -1: must be a finite number >= 0 [1], at "
            "most 1e15");
  EXPECT_THAT(complaint_about("mass=1 lb"),
              HasSubstr("own with --set mass=1 lb: scene.mass = '1 lb': must be a number [kg], or "
                        "a text such as \"1 g\" with a unit of kg, g"));
  EXPECT_THAT(complaint_about("friction="), HasSubstr("scene.friction = ''"));
  EXPECT_THAT(complaint_about("friction=1\nmass=3"), HasSubstr("must be a number"));
  EXPECT_THAT(complaint_about("model.fidelity=planar"), HasSubstr("must have the table [across]"));
}

TEST(SceneSetting, ReachesEveryKey) {
  for (const auto& [table, keys] : scene_keys()) {
    for (const std::string& key : keys) {
      EXPECT_THAT(complaint_about(table + "." + key + "=[{}]", with_across),
                  StartsWith("own with --set " + table + "." + key + "=[{}]: " + table))
          << key;
    }
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
