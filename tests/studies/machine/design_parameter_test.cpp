#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <limits>

#include "ricochet/scene.h"
#include "src/studies/machine/design_parameters.h"
#include "tests/support/files.h"
#include "tests/studies/machine/case_scene.h"

namespace ricochet::studies::advice {
namespace {

using namespace carrier_track;
using testing::ElementsAre;

std::vector<std::string> names(const Scene& scene) {
  std::vector<std::string> found;
  for (const DesignParameter& design_parameter : design_parameters_of(scene))
    found.push_back(design_parameter.name);
  return found;
}

TEST(DesignParameter, IsThereForWhatTheMachineHas) {
  Scene scene = case_scene("C1");
  EXPECT_THAT(names(scene), ElementsAre("restitution", "friction", "clearance", "disturbance"));
  scene.wall_upper = std::numeric_limits<double>::infinity();
  scene.friction = scene.pull = 0;
  EXPECT_THAT(names(scene), ElementsAre("restitution", "friction"));
}

TEST(DesignParameter, LeavesTheMachineAsItIsAtItsOwnValue) {
  const Scene scene = case_scene("C9");
  for (const DesignParameter& design_parameter : design_parameters_of(scene)) {
    EXPECT_EQ(design_parameter.value(0), design_parameter.own);
    EXPECT_EQ(write_scene(design_parameter.turned(scene, design_parameter.own)), write_scene(scene))
        << design_parameter.name;
  }
}

class TurnedDesignParameter : public TemporaryFolder {};

TEST_F(TurnedDesignParameter, LeavesMachinesValid) {
  for (const char* id : {"C1", "C2", "C9", "C11"}) {
    for (const double friction : {0.0, 0.4, 1.0}) {
      Scene scene = case_scene(id);
      scene.friction = friction;
      for (const DesignParameter& design_parameter : design_parameters_of(scene)) {
        for (const double share : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
          const double value = design_parameter.value(share);
          const std::filesystem::path file = folder_ / "turned.toml";
          std::ofstream(file) << write_scene(design_parameter.turned(scene, value));
          EXPECT_NO_THROW(read_scene(file)) << design_parameter.name << " " << value;
        }
      }
    }
  }
}

TEST(DesignParameter, TurnsBothWallsAndKeepsTheStartInItsPlace) {
  Scene scene = case_scene("C1");
  scene.restitution_lower = 0.4;
  scene.restitution_upper = 0.8;
  const auto design_parameters = design_parameters_of(scene);
  const Scene softer = design_parameters[0].turned(scene, 0.2);
  EXPECT_DOUBLE_EQ(softer.restitution_lower, 0.2);
  EXPECT_DOUBLE_EQ(softer.restitution_upper, 0.4);
  const Scene harder = design_parameters[0].turned(scene, 0.7);  // half way to 1
  EXPECT_DOUBLE_EQ(harder.restitution_lower, 0.7);
  EXPECT_DOUBLE_EQ(harder.restitution_upper, 0.9);
  const Scene wider = design_parameters[2].turned(scene, design_parameters[2].most);
  EXPECT_DOUBLE_EQ(wider.wall_upper, 2 * scene.wall_upper);
  EXPECT_DOUBLE_EQ(wider.start_position, 2 * scene.start_position);
}

}  // namespace
}  // namespace ricochet::studies::advice
