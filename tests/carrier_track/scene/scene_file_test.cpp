#include "problems/carrier_track/scene/scene_file.h"

#include "problems/carrier_track/scene/scene_fields.h"
#include "tests/support/files.h"
#include "tests/support/refusals.h"
#include "tests/support/scenes.h"

namespace ricochet::carrier_track {
namespace {

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
    "[across]\npull = -0.5\nwall_lower = -1e-3\nwall_upper = 3e-3\nrestitution = 0.4\n"
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

TEST(SceneFile, IsReadFromATextAsFromAFile) {
  const std::string text = write_scene(exploratory_scene());
  EXPECT_EQ(write_scene(scene_in(text)), text);
  const auto file = fs::path(testing::TempDir()) / "scene_file_test" / "machine.toml";
  EXPECT_EQ(write_scene(read_scene(write_file(file, text))), text);
  EXPECT_THAT(complaint_of([&] { read_scene(write_file(file, "[scene]\nmass = 1")); }),
              AllOf(HasSubstr("scene_file_test"), HasSubstr("machine.toml: ")));
  fs::remove_all(file.parent_path());
  EXPECT_THROW(read_scene("no/such/machine.toml"), InputError);
  EXPECT_THROW(read_scene(testing::TempDir()), InputError);
}

/// What is read otherwise than it is written; for the rest see
/// SceneFields.AreWrittenAndReadBackBitForBit.
TEST(SceneFile, ReadsTheOtherFormsOfAKey) {
  EXPECT_EQ(scene_with("restitution = [0.2, 0.7]").restitution_upper, 0.7);
  EXPECT_EQ(scene_with("centrifugal = \"inward\"").centrifugal, Centrifugal::inward);
  const std::string linear = replaced("contact_law", "contact_law = \"kelvin-voigt\"");
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

/// One that gives no more than it must.
const std::string brief =
    "[scene]\nmass = 1\nwall_lower = 0\nwall_upper = 1e-3\nrestitution = 0.5\nstart_position = 0\n"
    "centrifugal_mass_radius = 0.1\n[window]\nrevolutions = 2\n";

Scene after(const std::vector<std::string>& settings, const std::string& text = brief) {
  return parse_scene_file(text, "own", settings).scene;
}

std::string complaint_about_setting(const std::string& setting, const std::string& text = brief) {
  return complaint_of([&] { after({setting}, text); });
}

void expect_refused_settings(const std::vector<Refusal<>>& settings) {
  expect_refusals([](const std::string& setting) { after({setting}); }, settings);
}

TEST(SceneFile, RefusesUncertaintiesThatLeaveTheRange) {
  expect_refused_settings({
      {"friction={value = 0.1, plus_minus = 0.2}",
       "with scene.friction at 0.1 - 0.2: scene.friction = -0.1: must be a finite number >= 0"},
      {"friction={value = {value = 1}, plus_minus = 1}", "must be a number"},
      {"omega=[[0, {value = 1, plus_minus = 0.1}]]", "scene.omega = {...}: must be a number"},
  });
  for (const std::string width : {"0", "-0.1", "inf", "nan"}) {
    expect_refused_settings(
        {{"friction={value = 0.1, plus_minus = " + width + "}", "plus_minus > 0"}});
  }
  for (const std::string wrong :
       {"value = 0.1", "plus_minus = 0.1", "", "value = 0.1, plus_minus = 0.1, unit = 1"}) {
    expect_refused_settings({{"friction={" + wrong + "}",
                              "scene.friction = {...}: must be a number, or {value = NUMBER"}});
  }
}

/// Fields of another kind, unknown and missing ones, and one that is out of its range; for all
/// ranges see SceneCheck.
TEST(SceneFile, NamesAWrongFieldWithItsValueAndTheAllowedRange) {
  expect_refused_settings({
      {"mass=-1", "scene.mass = -1: must be a finite number > 0 [kg]"},
      {"mass=\"heavy\"", "scene.mass = 'heavy': must be a number [kg]"},
      {"wall_lower=true", "scene.wall_lower = true: must be a number"},
      {"restitution=[0.1]", "[lower, upper]"},
      {"restitution=[0.1, \"a\"]", "[lower, upper]"},
      {"friction=0.1 N", "scene.friction = '0.1 N': must be a number"},
      {"contact_friction=0", "scene.contact_friction = 0: must be true or false"},
      {"centrifugal=sideways",
       "scene.centrifugal = 'sideways': must be \"projected\" or \"inward\" or \"outward\""},
      {"centrifugal=3", "scene.centrifugal = 3: must be \"projected\""},
      {"rule=noise", "count.rule = 'noise': must be \"impacts\" or \"peaks\""},
      {"contact_law=rubber", "\"hunt-crossley\""},
      {"contact_speed=all", "\"each\""},
  });
  for (const auto& [key, line, message] :
       {std::tuple("mass", "", "scene.mass is missing"),
        {"mass", "mas = 1", "there is no key scene.mas; did you mean mass"},
        {"revolutions", "seconds = 1\nrevolutions = 1", "one of"},
        {"revolutions", "", "one of"},
        {"revolutions", "turns = 1",
         "there is no key window.turns; allowed: revolutions, seconds"}}) {
    EXPECT_THAT(complaint_about(replaced(key, line)), HasSubstr(message));
  }
  EXPECT_THAT(
      complaint_about(whole + replaced("restitution", "restitution_loer = 0", second_direction)),
      HasSubstr("there is no key across.restitution_loer; did you mean restitution_lower"));
  for (const char* key : {"wall_lower", "wall_upper", "restitution", "start_position"}) {
    EXPECT_THAT(complaint_about(whole + replaced(key, "", second_direction)),
                HasSubstr(fmt::format("across.{} is missing", key)));
  }
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
  const std::string old = brief + "[count]\nslowest = 2e-3\n";
  EXPECT_EQ(after({"counting_limit=9e-3"}, old).counting_limit, 9e-3);
}

TEST(SceneSetting, NamesTheTableOnlyWhereItMust) {
  EXPECT_EQ(complaint_about_setting("wall_upper=3e-3", whole + second_direction),
            "--set wall_upper=3e-3: wall_upper is ambiguous: must be scene.wall_upper or "
            "across.wall_upper");
  EXPECT_EQ(after({"across.wall_upper=3e-3"}, whole + second_direction).across->wall_upper, 3e-3);
  EXPECT_EQ(after({"scene.wall_upper=3e-3"}, whole + second_direction).wall_upper, 3e-3);
}

TEST(SceneSetting, IsNamedWhereItIsWrong) {
  EXPECT_EQ(complaint_about_setting("friction"), "--set friction: must be KEY=VALUE");
  EXPECT_EQ(complaint_about_setting("friction=-1"),
            "own with --set friction=-1: scene.friction = -1: must be a finite number >= 0 [1], at "
            "most 1e15");
  expect_refused_settings(
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
      EXPECT_THAT(complaint_about_setting(table + "." + key + "=[{}]", whole + second_direction),
                  StartsWith("own with --set " + table + "." + key + "=[{}]: " + table));
    }
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
