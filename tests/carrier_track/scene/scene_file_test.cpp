#include "problems/carrier_track/scene/scene_file.h"

#include "problems/carrier_track/scene/scene_fields.h"
#include "ricochet/error.h"
#include "tests/support/files.h"
#include "tests/support/refusals.h"
#include "tests/support/scenes.h"
#include "tests/support/test.h"

namespace ricochet::carrier_track {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::FieldsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// A complete scene, one key a line.
const std::string whole =
    "[scene]\nmass = 1.2\nwall_lower = 0.0\nwall_upper = 2e-3\nrestitution = 0.1\nfriction = 0.1\n"
    "normal_force = 4.2\ncontact_friction = false\npull = 0.86\npull_rotates = false\n"
    "pull_phase = 0.5\ncentrifugal = \"projected\"\ncentrifugal_mass_radius = 0.078\n"
    "slider_mass_radius = 3.2566e-4\nphase = 0.0\ndisturbance = 0.0\ndisturbance_frequency = 1.0\n"
    "disturbance_phase = 0.25\nstart_position = 1e-3\nstart_velocity = 0.0\nomega = 3.0\n"
    "[window]\nrevolutions = 1.22\n"
    "[count]\nrule = \"impacts\"\ncounting_limit = 3.6e-3\npeak_high = 3e-3\npeak_low = 1e-3\n"
    "[model]\nfidelity = \"impact\"\ncontact_law = \"flores\"\nstiffness = 2e7\n"
    "contact_exponent = 1.3\ncontact_speed = 0.25\n";

const std::string second_direction =
    "[across]\npull = -0.5\nwall_lower = -1e-3\nwall_upper = 3e-3\nrestitution = [0.3, 0.4]\n"
    "start_position = 2e-3\nstart_velocity = 0.01\n";

/// The text with the line of a key replaced.
std::string replaced(const std::string& key, const std::string& line,
                     const std::string& text = whole) {
  std::string result;
  for (const std::string& old : lines_of(text)) {
    result += (old.starts_with(key + " =") ? line : old) + "\n";
  }
  return result;
}

Scene scene_in(const std::string& text) {
  return parse_scene(text, "machine.toml");
}

/// The complete scene with this line in place of the one of its key.
Scene scene_with(const std::string& line) {
  return scene_in(replaced(line.substr(0, line.find(" =")), line));
}

/// The one line of complaint about a file with this text.
std::string complaint_about(const std::string& text) {
  const std::string message = complaint_of([&] { scene_in(text); });
  EXPECT_THAT(message, AllOf(Not(HasSubstr("\n")), StartsWith("machine.toml"))) << text;
  return message;
}

TEST(SceneFile, ReadsEveryKey) {
  const Scene scene = scene_in(whole);
  EXPECT_EQ(
      std::tuple(scene.mass, scene.wall_upper, scene.restitution_lower, scene.restitution_upper,
                 scene.normal_force, scene.slider_mass_radius, scene.start_position, scene.omega),
      std::tuple(1.2, 2e-3, 0.1, 0.1, 4.2, 3.2566e-4, 1e-3, 3.0));
  EXPECT_EQ(std::get<Revolutions>(scene.window).count, 1.22);
  EXPECT_EQ(std::tuple(scene.counting_limit, scene.contact_law, scene.stiffness,
                       scene.contact_exponent, scene.contact_speed, scene.across.has_value()),
            std::tuple(3.6e-3, ContactLaw::flores, 2e7, 1.3, 0.25, false));
  EXPECT_THAT(scene_in(whole + second_direction).across.value(),
              FieldsAre(-0.5, -1e-3, 3e-3, 0.3, 0.4, 2e-3, 0.01));
  const std::string planar = replaced("fidelity", "fidelity = \"planar\"") + second_direction;
  EXPECT_EQ(scene_in(planar).fidelity, Fidelity::planar);
}

TEST(SceneFile, IsReadFromATextAsFromAFile) {
  const std::string text = write_scene(exploratory_scene());
  EXPECT_EQ(write_scene(scene_in(text)), text);
  const auto file = std::filesystem::path(testing::TempDir()) / "scene_file_test" / "machine.toml";
  EXPECT_EQ(write_scene(read_scene(write_file(file, text))), text);
  EXPECT_THAT(complaint_of([&] { read_scene(write_file(file, "[scene]\nmass = 1")); }),
              AllOf(HasSubstr("scene_file_test"), HasSubstr("machine.toml: ")));
  std::filesystem::remove_all(file.parent_path());
  EXPECT_THROW(read_scene("no/such/machine.toml"), InputError);
  EXPECT_THROW(read_scene(testing::TempDir()), InputError);
}

TEST(SceneFile, ReadsTheOtherFormsOfAKey) {
  EXPECT_EQ(scene_with("restitution = [0.2, 0.7]").restitution_upper, 0.7);
  EXPECT_EQ(scene_with("wall_upper = inf").wall_upper, infinity);
  EXPECT_EQ(std::get<Seconds>(scene_in(replaced("revolutions", "seconds = 4")).window).count, 4.0);
  EXPECT_EQ(scene_with("centrifugal = \"inward\"").centrifugal, Centrifugal::inward);
  EXPECT_TRUE(scene_with("pull_rotates = true").pull_rotates);
  EXPECT_EQ(scene_with("rule = \"peaks\"").rule, CountRule::peaks);
  EXPECT_EQ(scene_with("fidelity = \"compliant\"").fidelity, Fidelity::compliant);
  EXPECT_FALSE(scene_with("contact_speed = \"each\"").contact_speed.has_value());
  std::string linear = replaced("contact_law", "contact_law = \"kelvin-voigt\"");
  EXPECT_EQ(scene_in(replaced("contact_exponent", "", linear)).contact_exponent, 1.0);
}

TEST(SceneFile, ReadsNumbersWithUnits) {
  EXPECT_EQ(scene_with("mass = \"900 g\"").mass, 0.9);
  EXPECT_EQ(scene_with("counting_limit = \"5 mm/s\"").counting_limit, 5e-3);
  EXPECT_EQ(scene_with("contact_speed = \"10 cm/s\"").contact_speed, 0.1);
  const Scene timed = scene_in(replaced("revolutions", "seconds = \"400 ms\""));
  EXPECT_EQ(std::get<Seconds>(timed.window).count, 0.4);
  const auto profile = scene_with("omega = [[0, \"30 rpm\"], [\"500 ms\", \"60 rpm\"]]").profile;
  EXPECT_EQ(profile[1].time, 0.5);
  EXPECT_DOUBLE_EQ(profile[1].omega, 2 * std::numbers::pi);
}

TEST(SceneFile, AdvisesNoNewKeyForWhatItRefuses) {
  testing::internal::CaptureStderr();
  // A warning is given once for each origin: this one is of no other test.
  EXPECT_THROW(parse_scene(replaced("restitution", "restitution = [[0, 1], 1]"), "refused.toml"),
               InputError);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(SceneFile, ReadsThePathRadius) {
  const auto with_radius = [](const std::string& lines) {
    return replaced("centrifugal_mass_radius", lines);
  };
  const std::string both = "path_radius = 0.065\ncentrifugal_mass_radius = ";
  for (const std::string& lines : {std::string("path_radius = 0.065"), both + "0.07800007"}) {
    EXPECT_EQ(scene_in(with_radius(lines)).centrifugal_mass_radius, 1.2 * 0.065);
  }
  expect_refusals([&](const std::string& lines) { scene_in(with_radius(lines)); },
                  {{both + "0.0780001",
                    "scene.path_radius = 0.065 and scene.centrifugal_mass_radius = 0.0780001: must "
                    "agree"},
                   {both + "{value = 0.078, plus_minus = 1e-3}", "give only one of the two"},
                   {"path_radius = -1", "scene.path_radius = -1: must be a finite number >= 0 [m]"},
                   {"path_radius = nan", "scene.path_radius = nan"},
                   {"path_radius = \"1 kg\"", "m, mm, cm, um"}});
}

TEST(SceneFile, KeepsUncertaintiesBesideTheScene) {
  const std::string plain = replaced("centrifugal_mass_radius", "path_radius = 0.065");
  std::string text = plain;
  for (const auto& [key, value] : {std::pair{"mass", "{value = 1.2, plus_minus = \"100 g\"}"},
                                   {"path_radius", "{value = \"65 mm\", plus_minus = \"1 mm\"}"},
                                   {"restitution", "{value = 0.1, plus_minus = 0.05}"},
                                   {"contact_speed", "{value = 0.25, plus_minus = 0.01}"}}) {
    text = replaced(key, std::string(key) + " = " + value, text);
  }
  const SceneFile file = parse_scene_file(text, "machine.toml");
  EXPECT_EQ(write_scene(file.scene), write_scene(scene_in(plain)));
  EXPECT_THAT(file.uncertainties, ElementsAre(FieldsAre("scene.mass", 1.2, 0.1, "kg"),
                                              FieldsAre("scene.restitution", 0.1, 0.05, "1"),
                                              FieldsAre("scene.path_radius", 0.065, 0.001, "m"),
                                              FieldsAre("model.contact_speed", 0.25, 0.01, "m/s")));
  const Scene drawn = file.at(std::vector<double>{-0.5, 1, 0.5, -1});
  EXPECT_DOUBLE_EQ(drawn.mass, 1.15);
  EXPECT_DOUBLE_EQ(drawn.restitution_lower, 0.15);
  EXPECT_EQ(drawn.restitution_upper, drawn.restitution_lower);
  EXPECT_DOUBLE_EQ(drawn.centrifugal_mass_radius, 1.15 * 0.0655);
  EXPECT_DOUBLE_EQ(drawn.contact_speed.value(), 0.24);
  EXPECT_EQ(write_scene(file.at(std::vector<double>(4, 0))), write_scene(file.scene));
}

struct WrongLine {
  std::string key, line, message;
};

/// Expects a complaint about the table with each line in place of that of its key.
void expect_complaints(const std::vector<WrongLine>& lines, const std::string& table = whole,
                       const std::string& before = "") {
  for (const auto& [key, line, message] : lines) {
    EXPECT_THAT(complaint_about(before + replaced(key, line, table)), HasSubstr(message)) << line;
  }
}

TEST(SceneFile, RefusesUncertaintiesThatLeaveTheRange) {
  const std::string form = "scene.friction = {...}: must be a number, or {value = NUMBER";
  expect_complaints({
      {"friction", "friction = {value = 0.1, plus_minus = 0.2}",
       "with scene.friction at 0.1 - 0.2: scene.friction = -0.1: must be a finite number >= 0"},
      {"friction", "friction = {value = 0.1, plus_minus = 0}", "plus_minus > 0"},
      {"friction", "friction = {value = 0.1, plus_minus = -0.1}", "plus_minus > 0"},
      {"friction", "friction = {value = 0.1, plus_minus = inf}", "plus_minus > 0"},
      {"friction", "friction = {value = 0.1, plus_minus = nan}", "plus_minus > 0"},
      {"friction", "friction = {value = 0.1}", form},
      {"friction", "friction = {plus_minus = 0.1}", form},
      {"friction", "friction = {}", form},
      {"friction", "friction = {value = 0.1, plus_minus = 0.1, unit = 1}", form},
      {"friction", "friction = {value = {value = 1}, plus_minus = 1}", "must be a number"},
      {"omega", "omega = [[0, {value = 1, plus_minus = 0.1}]]",
       "scene.omega = {...}: must be a number"},
  });
}

/// Fields of another kind, unknown and missing ones, and one of each table that is out of its
/// range; for all ranges see SceneCheck.NamesEveryFieldOutOfItsRange.
TEST(SceneFile, NamesAWrongFieldWithItsValueAndTheAllowedRange) {
  expect_complaints({
      {"mass", "mass = -1", "scene.mass = -1: must be a finite number > 0 [kg]"},
      {"mass", "mass = \"heavy\"", "scene.mass = 'heavy': must be a number [kg]"},
      {"mass", "mass = \"1 lb\"",
       "scene.mass = '1 lb': must be a number [kg], or a text such as \"1 g\" with a unit of "
       "kg, g"},
      {"mass", "mass = \"1lb\"", "with a unit of kg, g"},
      {"mass", "", "scene.mass is missing"},
      {"mass", "mas = 1", "there is no key scene.mas; did you mean mass"},
      {"wall_lower", "wall_lower = true", "scene.wall_lower = true: must be a number"},
      {"wall_upper", "wall_upper = 0", "scene.wall_upper = 0: must be > wall_lower"},
      {"restitution", "restitution = [0.1, -0.1]", "scene.restitution = -0.1: must be within 0..1"},
      {"restitution", "restitution = [0.1]", "[lower, upper]"},
      {"restitution", "restitution = [0.1, \"a\"]", "[lower, upper]"},
      {"friction", "friction = \"0.1 N\"", "scene.friction = '0.1 N': must be a number"},
      {"contact_friction", "contact_friction = 0",
       "scene.contact_friction = 0: must be true or false"},
      {"pull", "pul = 0.86", "there is no key scene.pul; did you mean pull"},
      {"pull_rotates", "pull_rotates = 1", "scene.pull_rotates = 1: must be true or false"},
      {"centrifugal", "centrifugal = \"sideways\"",
       "scene.centrifugal = 'sideways': must be \"projected\" or \"inward\" or \"outward\""},
      {"centrifugal", "centrifugal = 3", "scene.centrifugal = 3: must be \"projected\""},
      {"omega", "omega = 0", "because the window is in revolutions"},
      {"revolutions", "revolutions = 0", "window.revolutions = 0: must be a finite number > 0"},
      {"revolutions", "seconds = -1", "window.seconds = -1: must be a finite number > 0"},
      {"revolutions", "seconds = 1\nrevolutions = 1", "one of"},
      {"revolutions", "", "one of"},
      {"revolutions", "turns = 1", "there is no key window.turns; allowed: revolutions, seconds"},
      {"rule", "rule = \"noise\"", "count.rule = 'noise': must be \"impacts\" or \"peaks\""},
      {"peak_low", "peak_low = nan", "count.peak_low = nan: must be a finite number > 0"},
      {"fidelity", "fidelity = \"perfect\"", "model.fidelity = 'perfect': must be \"impact\""},
      {"fidelity", "fidelity = \"planar\"", "must have the table [across]"},
      {"contact_law", "contact_law = \"rubber\"", "\"hunt-crossley\""},
      {"stiffness", "stiffness = \"1 N\"", "model.stiffness = '1 N': must be a number"},
      {"stiffness", "stiffness = -1", "model.stiffness = -1: must be a finite number > 0"},
      {"contact_speed", "contact_speed = \"all\"", "\"each\""},
      {"contact_speed", "contact_speed = 0",
       "model.contact_speed = 0: must be a finite number > 0"},
  });
  expect_complaints(
      {
          {"pull", "pull = \"up\"", "across.pull = 'up': must be a number"},
          {"pull", "pul = 0.5", "there is no key across.pul; did you mean pull"},
          {"wall_lower", "", "across.wall_lower is missing"},
          {"wall_lower", "wall_lowr = 0",
           "there is no key across.wall_lowr; did you mean wall_lower"},
          {"wall_upper", "", "across.wall_upper is missing"},
          {"restitution", "", "across.restitution is missing"},
          {"restitution", "restitution_loer = 0",
           "across.restitution_loer; did you mean restitution_lower"},
          {"restitution", "restitution = [0.1, 1.1]",
           "across.restitution = 1.1: must be within 0..1"},
          {"start_position", "", "across.start_position is missing"},
          {"start_position", "start_position = 4e-3",
           "across.start_position = 0.004: must be within the walls, -0.001..0.003"},
      },
      second_direction, whole);
}

TEST(SceneFile, NamesATableThatIsMissingOrUnknownAndWhereItIsCut) {
  EXPECT_THAT(complaint_about(""), HasSubstr("[scene] is missing"));
  EXPECT_THAT(complaint_about("[scene]\nmass = 1\n"), HasSubstr("[window] is missing"));
  EXPECT_THAT(complaint_about(whole + "[windwo]\nseconds = 1\n"), HasSubstr("windwo"));
  EXPECT_THAT(complaint_about("mass = 1\n"), HasSubstr("mass is not a table"));
  EXPECT_THAT(complaint_about(whole.substr(0, whole.find("normal_force") + 6)),
              StartsWith("machine.toml:7: not valid TOML"));
  for (std::size_t cut = whole.find("revolutions = 1"); cut-- > 0;) {
    EXPECT_THROW(scene_in(whole.substr(0, cut)), InputError) << cut;
  }
}

const std::string own_file =
    "[scene]\nmass = 1\nwall_lower = 0\nwall_upper = 1e-3\nrestitution = 0.5\nstart_position = 0\n"
    "centrifugal_mass_radius = 0.1\n[window]\nrevolutions = 2\n";
const std::string own_across =
    own_file +
    "[across]\nwall_lower = 0\nwall_upper = 2e-3\nrestitution = 0.4\nstart_position = 0\n";

Scene after(const std::vector<std::string>& settings, const std::string& text = own_file) {
  return parse_scene_file(text, "own", settings).scene;
}

std::string complaint_about_setting(const std::string& setting,
                                    const std::string& text = own_file) {
  return complaint_of([&] { after({setting}, text); });
}

TEST(SceneSetting, ChangesOrAddsAKeyWithoutQuotesForATextOrAUnit) {
  EXPECT_EQ(after({"mass=2"}).mass, 2);
  EXPECT_EQ(after({"friction = 0.25"}).friction, 0.25);
  EXPECT_EQ(after({"scene.friction=0.25", "friction=0.5"}).friction, 0.5);
  EXPECT_EQ(after({"counting_limit=7e-3"}).counting_limit, 7e-3);
  EXPECT_EQ(after({"wall_upper=inf"}).wall_upper, infinity);
  EXPECT_TRUE(after({"contact_friction=true"}).contact_friction);
  EXPECT_EQ(after({"omega=[[0, 1], [2, 3]]"}).profile.size(), 2U);
  EXPECT_EQ(after({"wall_upper=0.8 mm"}).wall_upper, 0.8e-3);
  EXPECT_EQ(after({"wall_upper=\"0.8 mm\""}).wall_upper, 0.8e-3);
  EXPECT_EQ(after({"centrifugal=outward"}).centrifugal, Centrifugal::outward);
  EXPECT_EQ(after({"model.fidelity=compliant"}).fidelity, Fidelity::compliant);
  EXPECT_EQ(after({"contact_law=hertz"}).contact_law, ContactLaw::hertz);
}

TEST(SceneSetting, TakesThePlaceOfKeysThatSayTheSame) {
  EXPECT_EQ(after({"path_radius=65 mm"}).centrifugal_mass_radius, 0.065);
  EXPECT_EQ(after({"path_radius=1", "centrifugal_mass_radius=0.2"}).centrifugal_mass_radius, 0.2);
  EXPECT_EQ(std::get<Seconds>(after({"seconds=3"}).window).count, 3);
  EXPECT_EQ(std::get<Revolutions>(after({"seconds=3", "revolutions=4"}).window).count, 4);
  const Scene walls = after({"restitution_upper=0.7"});
  EXPECT_EQ(std::pair(walls.restitution_lower, walls.restitution_upper), std::pair(0.5, 0.7));
  EXPECT_EQ(after({"restitution_upper=0.7", "restitution=0.6"}).restitution_lower, 0.6);
  const std::string old = own_file + "[count]\nslowest = 2e-3\n";
  EXPECT_EQ(after({"counting_limit=9e-3"}, old).counting_limit, 9e-3);
}

TEST(SceneSetting, NamesTheTableOnlyWhereItMust) {
  EXPECT_EQ(after({"wall_upper=3e-3"}).wall_upper, 3e-3);
  EXPECT_EQ(complaint_about_setting("wall_upper=3e-3", own_across),
            "--set wall_upper=3e-3: wall_upper is ambiguous: must be scene.wall_upper or "
            "across.wall_upper");
  EXPECT_EQ(after({"across.wall_upper=3e-3"}, own_across).across->wall_upper, 3e-3);
  EXPECT_EQ(after({"scene.wall_upper=3e-3"}, own_across).wall_upper, 3e-3);
}

TEST(SceneSetting, IsNamedWhereItIsWrong) {
  EXPECT_EQ(complaint_about_setting("friction"), "--set friction: must be KEY=VALUE");
  EXPECT_EQ(complaint_about_setting("friction=-1"),
            "own with --set friction=-1: scene.friction = -1: must be a finite number >= 0 [1], at "
            "most 1e15");
  expect_refusals(
      [](const std::string& setting) { after({setting}); },
      {{"fricton=1", "--set fricton=1: there is no key fricton; did you mean friction"},
       {"count.mass=1", "there is no key count.mass"},
       {"=1", "there is no key"},
       {"mass=1 lb",
        "own with --set mass=1 lb: scene.mass = '1 lb': must be a number [kg], or a text such as "
        "\"1 g\" with a unit of kg, g"},
       {"friction=", "scene.friction = ''"},
       {"friction=1\nmass=3", "must be a number"},
       {"model.fidelity=planar", "must have the table [across]"}});
}

TEST(SceneSetting, ReachesEveryKey) {
  for (const auto& [table, keys] : scene_keys()) {
    for (const std::string& key : keys) {
      EXPECT_THAT(complaint_about_setting(table + "." + key + "=[{}]", own_across),
                  StartsWith("own with --set " + table + "." + key + "=[{}]: " + table));
    }
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
