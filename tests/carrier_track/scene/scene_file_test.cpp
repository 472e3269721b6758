#include "problems/carrier_track/scene/scene_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cctype>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <system_error>
#include <vector>

#include "problems/carrier_track/suite/machine.h"
#include "ricochet/error.h"
#include "ricochet/scene.h"
#include "tests/support/scenes.h"

namespace ricochet::carrier_track {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A complete scene, one key a line.
const std::vector<std::string>& lines() {
  static const std::vector<std::string> text = {"[scene]",
                                                "mass = 1.2",
                                                "wall_lower = 0.0",
                                                "wall_upper = 2e-3",
                                                "restitution = 0.1",
                                                "friction = 0.1",
                                                "normal_force = 4.2",
                                                "contact_friction = false",
                                                "pull = 0.86",
                                                "pull_rotates = false",
                                                "pull_phase = 0.5",
                                                "centrifugal = \"projected\"",
                                                "centrifugal_mass_radius = 0.078",
                                                "slider_mass_radius = 3.2566e-4",
                                                "phase = 0.0",
                                                "disturbance = 0.0",
                                                "disturbance_frequency = 1.0",
                                                "disturbance_phase = 0.25",
                                                "start_position = 1e-3",
                                                "start_velocity = 0.0",
                                                "omega = 3.0",
                                                "[window]",
                                                "revolutions = 1.22",
                                                "[count]",
                                                "rule = \"impacts\"",
                                                "counting_limit = 3.6e-3",
                                                "peak_high = 3e-3",
                                                "peak_low = 1e-3",
                                                "[model]",
                                                "fidelity = \"impact\"",
                                                "contact_law = \"flores\"",
                                                "stiffness = 2e7",
                                                "contact_exponent = 1.3",
                                                "contact_speed = 0.25"};
  return text;
}

/// A folder of this process alone, gone with it: ctest runs the tests of this file side by side.
class Folder {
 public:
  Folder() : path_(std::filesystem::path(testing::TempDir()) / std::to_string(getpid())) {
    std::filesystem::create_directories(path_);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

std::filesystem::path file_with(const std::string& text) {
  static const Folder folder;
  const auto path = folder.path() / "machine.toml";
  std::ofstream(path) << text;
  return path;
}

/// The complete scene with the line of `key` replaced.
std::string with(const std::string& key, const std::string& line) {
  std::string text;
  for (const std::string& old : lines()) {
    text += (old.starts_with(key + " =") ? line : old) + "\n";
  }
  return text;
}

/// The complete scene with a second direction, the line of `key` in its table replaced.
std::string with_across(const std::string& key, const std::string& line) {
  std::string text = with("", "") + "[across]\n";
  for (const std::string old :
       {"pull = -0.5", "wall_lower = -1e-3", "wall_upper = 3e-3", "restitution = [0.3, 0.4]",
        "start_position = 2e-3", "start_velocity = 0.01"}) {
    text += (old.starts_with(key + " =") ? line : old) + "\n";
  }
  return text;
}

/// The one line of complaint about a file with this text; fails if there is none.
std::string complaint_about(const std::string& text) {
  try {
    read_scene(file_with(text));
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_THAT(message, Not(HasSubstr("\n")));
    EXPECT_THAT(message, HasSubstr("machine.toml"));
    return message;
  }
  ADD_FAILURE() << "accepted:\n" << text;
  return {};
}

TEST(SceneFile, ReadsEveryKey) {
  const Scene scene = read_scene(file_with(with("", "")));
  EXPECT_EQ(scene.mass, 1.2);
  EXPECT_EQ(scene.wall_upper, 2e-3);
  EXPECT_EQ(scene.restitution_lower, 0.1);
  EXPECT_EQ(scene.restitution_upper, 0.1);
  EXPECT_EQ(scene.normal_force, 4.2);
  EXPECT_EQ(scene.slider_mass_radius, 3.2566e-4);
  EXPECT_EQ(scene.start_position, 1e-3);
  EXPECT_EQ(scene.omega, 3.0);
  EXPECT_EQ(std::get<Revolutions>(scene.window).count, 1.22);
  EXPECT_EQ(scene.counting_limit, 3.6e-3);
  EXPECT_EQ(scene.contact_law, ContactLaw::flores);
  EXPECT_EQ(scene.stiffness, 2e7);
  EXPECT_EQ(scene.contact_exponent, 1.3);
  EXPECT_EQ(scene.contact_speed, 0.25);
}

TEST(SceneFile, ReadsEveryKeyOfTheSecondDirection) {
  EXPECT_FALSE(read_scene(file_with(with("", ""))).across.has_value());
  const Scene scene = read_scene(file_with(with_across("", "")));
  EXPECT_EQ(scene.pull, 0.86);
  EXPECT_EQ(scene.across.value().pull, -0.5);
  EXPECT_EQ(scene.across->wall_lower, -1e-3);
  EXPECT_EQ(scene.across->wall_upper, 3e-3);
  EXPECT_EQ(scene.across->restitution_lower, 0.3);
  EXPECT_EQ(scene.across->restitution_upper, 0.4);
  EXPECT_EQ(scene.across->start_position, 2e-3);
  EXPECT_EQ(scene.across->start_velocity, 0.01);
}

TEST(SceneFile, IsReadFromATextAsFromAFile) {
  const std::string text = write_scene(exploratory_scene());
  EXPECT_EQ(write_scene(parse_scene(text, "a text")), text);
  try {
    parse_scene("[scene]\nmass = 1", "a text");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("a text: "));
  }
}

TEST(SceneFile, ReadsTheOtherFormsOfAKey) {
  EXPECT_EQ(
      read_scene(file_with(with("restitution", "restitution = [0.2, 0.7]"))).restitution_upper,
      0.7);
  EXPECT_EQ(read_scene(file_with(with("wall_upper", "wall_upper = inf"))).wall_upper,
            std::numeric_limits<double>::infinity());
  EXPECT_EQ(
      std::get<Seconds>(read_scene(file_with(with("revolutions", "seconds = 4"))).window).count,
      4.0);
  EXPECT_EQ(read_scene(file_with(with("centrifugal", "centrifugal = \"inward\""))).centrifugal,
            Centrifugal::inward);
  EXPECT_TRUE(read_scene(file_with(with("pull_rotates", "pull_rotates = true"))).pull_rotates);
  EXPECT_EQ(read_scene(file_with(with("rule", "rule = \"peaks\""))).rule, CountRule::peaks);
  EXPECT_EQ(read_scene(file_with(with("fidelity", "fidelity = \"compliant\""))).fidelity,
            Fidelity::compliant);
  EXPECT_FALSE(read_scene(file_with(with("contact_speed", "contact_speed = \"each\"")))
                   .contact_speed.has_value());
}

TEST(SceneFile, AdvisesNoNewKeyForWhatItRefuses) {
  testing::internal::CaptureStderr();
  // A warning is given once for each origin: this one is of no other test.
  EXPECT_THROW(parse_scene(with("restitution", "restitution = [[0, 1], 1]"), "refused.toml"),
               InputError);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(SceneFile, KnowsTheExponentOfKelvinVoigt) {
  std::string text = with("contact_law", "contact_law = \"kelvin-voigt\"");
  text.erase(text.find("contact_exponent"),
             text.find("contact_speed") - text.find("contact_exponent"));
  EXPECT_EQ(read_scene(file_with(text)).contact_exponent, 1.0);
}

TEST(SceneFile, ReadsNumbersWithUnits) {
  EXPECT_EQ(read_scene(file_with(with("mass", "mass = \"900 g\""))).mass, 0.9);
  EXPECT_EQ(read_scene(file_with(with("wall_upper", "wall_upper = \"2.5 mm\""))).wall_upper,
            2.5e-3);
  EXPECT_EQ(
      read_scene(file_with(with("counting_limit", "counting_limit = \"5 mm/s\""))).counting_limit,
      5e-3);
  EXPECT_EQ(
      read_scene(file_with(with("contact_speed", "contact_speed = \"10 cm/s\""))).contact_speed,
      0.1);
  const Scene timed = read_scene(file_with(with("revolutions", "seconds = \"400 ms\"")));
  EXPECT_EQ(std::get<Seconds>(timed.window).count, 0.4);
  const Scene profile =
      read_scene(file_with(with("omega", "omega = [[0, \"30 rpm\"], [\"500 ms\", \"60 rpm\"]]")));
  EXPECT_EQ(profile.profile[1].time, 0.5);
  EXPECT_DOUBLE_EQ(profile.profile[1].omega, 2 * 3.14159265358979323846);
}

TEST(SceneFile, ReadsThePathRadius) {
  const auto with_radius = [](const std::string& line) {
    return with("centrifugal_mass_radius", line);
  };
  EXPECT_EQ(read_scene(file_with(with_radius("path_radius = 0.065"))).centrifugal_mass_radius,
            1.2 * 0.065);
  const std::string both = "path_radius = 0.065\ncentrifugal_mass_radius = ";
  EXPECT_EQ(read_scene(file_with(with_radius(both + "0.07800007"))).centrifugal_mass_radius,
            1.2 * 0.065);
  const std::string disagreement = complaint_about(with_radius(both + "0.0780001"));
  EXPECT_THAT(disagreement, HasSubstr("scene.path_radius = 0.065 and "
                                      "scene.centrifugal_mass_radius = 0.0780001: must agree"));
  EXPECT_THAT(complaint_about(with_radius("path_radius = -1")),
              HasSubstr("scene.path_radius = -1: must be a finite number >= 0 [m]"));
  EXPECT_THAT(complaint_about(with_radius("path_radius = nan")), HasSubstr("path_radius = nan"));
  EXPECT_THAT(complaint_about(with_radius("path_radius = \"1 kg\"")), HasSubstr("m, mm, cm, um"));
  EXPECT_THAT(
      complaint_about(with_radius(
          "path_radius = 0.065\ncentrifugal_mass_radius = {value = 0.078, plus_minus = 1e-3}")),
      HasSubstr("give only one of the two"));
}

TEST(SceneFile, KeepsUncertaintiesBesideTheScene) {
  std::string text =
      with("centrifugal_mass_radius", "path_radius = {value = \"65 mm\", plus_minus = \"1 mm\"}");
  text.replace(text.find("mass = 1.2"), 10, "mass = {value = 1.2, plus_minus = \"100 g\"}");
  text.replace(text.find("restitution = 0.1"), 17,
               "restitution = {value = 0.1, plus_minus = 0.05}");
  text.replace(text.find("contact_speed = 0.25"), 20,
               "contact_speed = {value = 0.25, plus_minus = 0.01}");
  EXPECT_EQ(
      write_scene(read_scene(file_with(text))),
      write_scene(read_scene(file_with(with("centrifugal_mass_radius", "path_radius = 0.065")))));
  const SceneFile file = read_scene_file(file_with(text));
  std::vector<std::string> keys;
  for (const Uncertainty& each : file.uncertainties) keys.push_back(each.key);
  ASSERT_THAT(keys, testing::ElementsAre("scene.mass", "scene.restitution", "scene.path_radius",
                                         "model.contact_speed"));
  EXPECT_EQ(file.uncertainties[2].value, 0.065);
  EXPECT_EQ(file.uncertainties[2].plus_minus, 0.001);
  EXPECT_EQ(file.uncertainties[2].unit, "m");
  const Scene drawn = file.at(std::vector<double>{-0.5, 1, 0.5, -1});
  EXPECT_DOUBLE_EQ(drawn.mass, 1.15);
  EXPECT_DOUBLE_EQ(drawn.restitution_lower, 0.15);
  EXPECT_EQ(drawn.restitution_upper, drawn.restitution_lower);
  EXPECT_DOUBLE_EQ(drawn.centrifugal_mass_radius, 1.15 * 0.0655);
  EXPECT_DOUBLE_EQ(drawn.contact_speed.value(), 0.24);
  EXPECT_EQ(write_scene(file.at(std::vector<double>(4, 0))), write_scene(file.scene));
}

TEST(SceneFile, RefusesUncertaintiesThatLeaveTheRange) {
  EXPECT_THAT(complaint_about(with("friction", "friction = {value = 0.1, plus_minus = 0.2}")),
              testing::AllOf(HasSubstr("with scene.friction at 0.1 - 0.2: scene.friction = -0.1"),
                             HasSubstr(">= 0")));
  for (const char* width : {"0", "-0.1", "inf", "nan"}) {
    EXPECT_THAT(
        complaint_about(
            with("friction", std::string("friction = {value = 0.1, plus_minus = ") + width + "}")),
        HasSubstr("plus_minus > 0"));
  }
  for (const char* table :
       {"{value = 0.1}", "{plus_minus = 0.1}", "{}", "{value = 0.1, plus_minus = 0.1, unit = 1}"}) {
    EXPECT_THAT(complaint_about(with("friction", std::string("friction = ") + table)),
                HasSubstr("scene.friction = {...}: must be a number, or {value = NUMBER"));
  }
  EXPECT_THAT(complaint_about(with("omega", "omega = [[0, {value = 1, plus_minus = 0.1}]]")),
              HasSubstr("scene.omega = {...}: must be a number"));
  EXPECT_THAT(complaint_about(with("friction", "friction = {value = {value = 1}, plus_minus = 1}")),
              HasSubstr("must be a number"));
}

struct Wrong {
  std::string key, line, named, allowed;
};

/// A test is named by its line, with a word for every sign that a name cannot have.
std::string name_of(const testing::TestParamInfo<Wrong>& tested) {
  const auto& [key, line, named, allowed] = tested.param;
  std::string name;
  for (const char sign : line.empty() ? key + " missing" : line) {
    if (std::isalnum(static_cast<unsigned char>(sign))) {
      name += sign;
    } else if (sign == '-') {
      name += "minus_";
    } else if (!name.empty() && name.back() != '_') {
      name += '_';
    }
  }
  return name;
}

class WrongField : public testing::TestWithParam<Wrong> {};

TEST_P(WrongField, IsNamedWithItsValueAndTheAllowedRange) {
  const Wrong& wrong = GetParam();
  const std::string message = complaint_about(with(wrong.key, wrong.line));
  EXPECT_THAT(message, HasSubstr(wrong.named));
  EXPECT_THAT(message, HasSubstr(wrong.allowed));
}

INSTANTIATE_TEST_SUITE_P(
    SceneFile, WrongField,
    testing::Values(
        Wrong{"mass", "mass = -1", "scene.mass = -1", "> 0"},
        Wrong{"mass", "mass = 0", "scene.mass = 0", "> 0"},
        Wrong{"mass", "mass = inf", "scene.mass = inf", "finite"},
        Wrong{"mass", "mass = \"heavy\"", "scene.mass", "a number"},
        Wrong{"mass", "mass = \"1 lb\"", "scene.mass = '1 lb'", "with a unit of kg, g"},
        Wrong{"mass", "mass = \"1lb\"", "scene.mass = '1lb'", "with a unit of kg, g"},
        Wrong{"friction", "friction = \"0.1 N\"", "scene.friction = '0.1 N'", "a number"},
        Wrong{"stiffness", "stiffness = \"1 N\"", "model.stiffness = '1 N'", "a number"},
        Wrong{"mass", "", "scene.mass", "missing"},
        Wrong{"mass", "mas = 1", "there is no key scene.mas; ", "did you mean mass"},
        Wrong{"wall_lower", "wall_lower = nan", "scene.wall_lower = nan", "finite"},
        Wrong{"wall_lower", "wall_lower = true", "scene.wall_lower = true", "a number"},
        Wrong{"wall_upper", "wall_upper = -1e-3", "scene.wall_upper = -0.001", "> wall_lower"},
        Wrong{"wall_upper", "wall_upper = 0", "scene.wall_upper = 0", "> wall_lower"},
        Wrong{"wall_upper", "wall_upper = nan", "scene.wall_upper = nan", "> wall_lower"},
        Wrong{"restitution", "restitution = 1.1", "scene.restitution = 1.1", "0..1"},
        Wrong{"restitution", "restitution = [0.1, -0.1]", "scene.restitution = -0.1", "0..1"},
        Wrong{"restitution", "restitution = [0.1]", "scene.restitution", "[lower, upper]"},
        Wrong{"restitution", "restitution = [0.1, \"a\"]", "scene.restitution", "[lower, upper]"},
        Wrong{"friction", "friction = -0.1", "scene.friction = -0.1", ">= 0"},
        Wrong{"normal_force", "normal_force = -2", "scene.normal_force = -2", ">= 0"},
        Wrong{"contact_friction", "contact_friction = 0", "scene.contact_friction = 0",
              "true or false"},
        Wrong{"pull", "pull = inf", "scene.pull = inf", "finite"},
        Wrong{"pull_rotates", "pull_rotates = 1", "scene.pull_rotates = 1", "true or false"},
        Wrong{"pull_phase", "pull_phase = nan", "scene.pull_phase = nan", "finite"},
        Wrong{"centrifugal", "centrifugal = \"sideways\"", "sideways", "\"inward\""},
        Wrong{"centrifugal", "centrifugal = 3", "scene.centrifugal = 3", "\"projected\""},
        Wrong{"centrifugal_mass_radius", "centrifugal_mass_radius = -1",
              "scene.centrifugal_mass_radius = -1", ">= 0"},
        Wrong{"slider_mass_radius", "slider_mass_radius = -1", "scene.slider_mass_radius = -1",
              ">= 0"},
        Wrong{"phase", "phase = nan", "scene.phase = nan", "finite"},
        Wrong{"disturbance", "disturbance = -inf", "scene.disturbance = -inf", "finite"},
        Wrong{"disturbance_frequency", "disturbance_frequency = -1",
              "scene.disturbance_frequency = -1", ">= 0"},
        Wrong{"disturbance_phase", "disturbance_phase = inf", "scene.disturbance_phase = inf",
              "finite"},
        Wrong{"start_position", "start_position = 3e-3", "scene.start_position = 0.003",
              "within the walls, 0..0.002"},
        Wrong{"start_position", "start_position = -1e-9", "scene.start_position",
              "within the walls"},
        Wrong{"start_velocity", "start_velocity = nan", "scene.start_velocity = nan", "finite"},
        Wrong{"omega", "omega = -3", "scene.omega = -3", "> 0"},
        Wrong{"omega", "omega = 0", "scene.omega = 0", "revolutions"},
        Wrong{"revolutions", "revolutions = 0", "window.revolutions = 0", "> 0"},
        Wrong{"revolutions", "seconds = -1", "window.seconds = -1", "> 0"},
        Wrong{"revolutions", "seconds = 1\nrevolutions = 1", "window", "one of"},
        Wrong{"revolutions", "", "window", "one of"},
        Wrong{"revolutions", "turns = 1", "window.turns", "allowed: revolutions, seconds"},
        Wrong{"rule", "rule = \"noise\"", "noise", "\"impacts\" or \"peaks\""},
        Wrong{"counting_limit", "counting_limit = 0", "count.counting_limit = 0", "> 0"},
        Wrong{"peak_high", "peak_high = -1", "count.peak_high = -1", "> 0"},
        Wrong{"peak_low", "peak_low = nan", "count.peak_low = nan", "> 0"},
        Wrong{"fidelity", "fidelity = \"perfect\"", "perfect", "\"impact\""},
        Wrong{"contact_law", "contact_law = \"rubber\"", "rubber", "\"hunt-crossley\""},
        Wrong{"stiffness", "stiffness = -1", "model.stiffness = -1", "> 0"},
        Wrong{"contact_exponent", "contact_exponent = 0", "model.contact_exponent = 0", "> 0"},
        Wrong{"contact_speed", "contact_speed = \"all\"", "model.contact_speed", "\"each\""},
        Wrong{"contact_speed", "contact_speed = 0", "model.contact_speed = 0", "> 0"},
        Wrong{"pull", "pul = 0.86", "scene.pul", "did you mean pull"}),
    name_of);

class WrongFieldAcross : public testing::TestWithParam<Wrong> {};

TEST_P(WrongFieldAcross, IsNamedWithItsValueAndTheAllowedRange) {
  const Wrong& wrong = GetParam();
  const std::string message = complaint_about(with_across(wrong.key, wrong.line));
  EXPECT_THAT(message, HasSubstr(wrong.named));
  EXPECT_THAT(message, HasSubstr(wrong.allowed));
}

INSTANTIATE_TEST_SUITE_P(
    SceneFile, WrongFieldAcross,
    testing::Values(
        Wrong{"pull", "pull = inf", "across.pull = inf", "finite"},
        Wrong{"pull", "pull = \"up\"", "across.pull", "a number"},
        Wrong{"wall_lower", "wall_lower = -inf", "across.wall_lower = -inf", "finite"},
        Wrong{"wall_lower", "", "across.wall_lower", "missing"},
        Wrong{"wall_lower", "wall_lowr = 0", "there is no key across.wall_lowr; ", "wall_lower"},
        Wrong{"restitution", "restitution_loer = 0", "across.restitution_loer",
              "did you mean restitution_lower"},
        Wrong{"wall_upper", "wall_upper = -1e-3", "across.wall_upper = -0.001", "> wall_lower"},
        Wrong{"wall_upper", "", "across.wall_upper", "missing"},
        Wrong{"restitution", "restitution = -0.1", "across.restitution = -0.1", "0..1"},
        Wrong{"restitution", "restitution = [0.1, 1.1]", "across.restitution = 1.1", "0..1"},
        Wrong{"restitution", "", "across.restitution", "missing"},
        Wrong{"start_position", "start_position = 4e-3", "across.start_position = 0.004",
              "within the walls, -0.001..0.003"},
        Wrong{"start_position", "", "across.start_position", "missing"},
        Wrong{"start_velocity", "start_velocity = nan", "across.start_velocity = nan", "finite"},
        Wrong{"pull", "pul = 0.5", "across.pul", "did you mean pull"}),
    name_of);

TEST(SceneFile, NeedsASecondDirectionForTheFidelityThatMovesInIt) {
  const std::string planar = with("fidelity", "fidelity = \"planar\"");
  EXPECT_THAT(complaint_about(planar), HasSubstr("[across]"));
  const std::string across = with_across("", "");
  const std::string whole = planar + across.substr(across.find("[across]"));
  EXPECT_EQ(read_scene(file_with(whole)).fidelity, Fidelity::planar);
}

TEST(SceneFile, NamesATableThatIsMissingOrUnknown) {
  EXPECT_THAT(complaint_about(""), HasSubstr("[scene] is missing"));
  EXPECT_THAT(complaint_about("[scene]\nmass = 1\n"), HasSubstr("[window] is missing"));
  EXPECT_THAT(complaint_about(with("", "") + "[windwo]\nseconds = 1\n"), HasSubstr("windwo"));
  EXPECT_THAT(complaint_about("mass = 1\n"), HasSubstr("mass is not a table"));
}

TEST(SceneFile, RefusesATruncatedFileWithItsLine) {
  const std::string whole = with("", "");
  EXPECT_THAT(complaint_about(whole.substr(0, whole.find("normal_force") + 6)),
              HasSubstr("machine.toml:7: not valid TOML"));
}

TEST(SceneFile, NeverAcceptsAFileCutBeforeItsWindow) {
  const std::string whole = with("", "");
  const std::size_t window = whole.find("revolutions = 1");
  for (std::size_t cut = 0; cut < window; ++cut) {
    EXPECT_THROW(read_scene(file_with(whole.substr(0, cut))), InputError) << cut;
  }
}

TEST(SceneFile, RefusesAFileThatCannotBeRead) {
  EXPECT_THROW(read_scene("no/such/machine.toml"), InputError);
  EXPECT_THROW(read_scene(testing::TempDir()), InputError);
}

TEST(SceneFile, WritesWhatItReadsBackBitForBit) {
  for (const Case& a_case : all_cases()) {
    Scene scene = scene_of(a_case, exploratory_scene());
    scene.phase = 1.0 / 3.0;
    scene.pull_phase = 1.0 / 11.0;
    scene.contact_friction = a_case.id == "C2";
    scene.disturbance_phase = 1.0 / 13.0;
    scene.restitution_upper = 0.7;
    scene.wall_upper = a_case.id == "C1" ? std::numeric_limits<double>::infinity() : 2e-3;
    scene.centrifugal = Centrifugal::outward;
    scene.pull_rotates = a_case.id != "C4";
    scene.window = Seconds{12};
    if (a_case.id == "C3" || a_case.id == "C4") {
      scene.across = Across<double>{scene.pull_rotates ? 0.0 : -1.0 / 3.0,
                                    -0.1,
                                    std::numeric_limits<double>::infinity(),
                                    0.1,
                                    0.3,
                                    1.0 / 7.0,
                                    -1e-3};
    }
    scene.rule = CountRule::peaks;
    scene.fidelity = Fidelity::compliant;
    scene.contact_law = ContactLaw::zhiying_qishao;
    scene.stiffness = 1e8 / 3.0;
    scene.contact_exponent = 10.0 / 9.0;
    if (a_case.id == "C2") scene.contact_speed = 0.1;
    const std::string text = write_scene(scene);
    EXPECT_EQ(write_scene(read_scene(file_with(text))), text);
    EXPECT_EQ(read_scene(file_with(text)).across.has_value(), scene.across.has_value());
    if (scene.across) {
      EXPECT_EQ(read_scene(file_with(text)).across->pull, scene.across->pull);
      EXPECT_EQ(read_scene(file_with(text)).across->start_position, 1.0 / 7.0);
    }
    EXPECT_EQ(read_scene(file_with(text)).phase, scene.phase);
    EXPECT_EQ(read_scene(file_with(text)).pull_phase, scene.pull_phase);
    EXPECT_EQ(read_scene(file_with(text)).contact_friction, scene.contact_friction);
    EXPECT_EQ(read_scene(file_with(text)).disturbance_phase, scene.disturbance_phase);
    EXPECT_EQ(read_scene(file_with(text)).stiffness, scene.stiffness);
    EXPECT_EQ(read_scene(file_with(text)).contact_speed, scene.contact_speed);
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
