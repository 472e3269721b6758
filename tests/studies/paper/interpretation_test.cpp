#include "src/studies/paper/interpretation.h"

#include "problems/carrier_track/scene/contact_law.h"
#include "problems/carrier_track/suite/machine.h"
#include "tests/support/refusals.h"
#include "tests/support/test.h"

namespace ricochet::carrier_track::inline paper {
namespace {

using testing::SizeIs;

std::vector<Interpretation> every_interpretation() {
  std::vector<Interpretation> interpretations;
  for (const Interpretation& core : core_interpretations()) {
    interpretations.push_back(core);
    for (const Interpretation& varied : variations(core)) interpretations.push_back(varied);
  }
  return interpretations;
}

TEST(Interpretation, CoversEveryForcingTensionAndWindow) {
  // 3 x 3 x 2, and one other answer to one of seven further questions: 3 + 2 + 1 + 2 + 2 + 1 + 2.
  EXPECT_EQ(core_interpretations().size(), 18U);
  EXPECT_EQ(variations({}).size(), 13U);
  EXPECT_EQ(variations({.window = WindowUnit::seconds}).size(), 12U);  // turns a to b are turns
}

TEST(Interpretation, IsFoundByItsNameAndHasADescriptionOfItsOwn) {
  std::set<std::string> descriptions;
  for (const Interpretation& r : every_interpretation()) {
    EXPECT_EQ(find_interpretation(name_of(r)), r);
    EXPECT_TRUE(descriptions.insert(description_of(r)).second) << description_of(r);
  }
  EXPECT_EQ(name_of({}), "projected-constant-revolutions");
}

TEST(Interpretation, IsRefusedUnderAnotherNameWithWhatThereIs) {
  expect_refusals(find_interpretation,
                  {{"projected-constant-hours", "projected-constant-hours"},
                   {"projected-constant-hours", "inward-rotating-seconds"},
                   {"projected-constant-hours", "-peaks-0.1mm"},
                   {"projected-constant-seconds-later-window", "must be a number of revolutions"}});
}

TEST(Interpretation, AnswersTenQuestionsAndVariesOneAnswerAtATime) {
  const auto base = answers_of({});
  for (const Interpretation& r : every_interpretation()) EXPECT_EQ(answers_of(r).size(), 10U);
  for (const Interpretation& varied : variations({})) {
    const auto answers = answers_of(varied);
    int different = 0;
    for (std::size_t i = 0; i < 10; ++i) different += answers.at(i).answer != base[i].answer;
    EXPECT_EQ(different, 1) << name_of(varied);
  }
  EXPECT_THAT(answers_of({.normal_force = NormalForce::weight})[4],
              FieldsAre("friction multiplies", "weight"));
}

Scene natural_scene(const Interpretation& interpretation, const char* id = "C11") {
  return scene_of(find_case(id), interpretation, natural_constants());
}

TEST(UnknownParameters, HaveNamesAndNaturalValuesWithinTheirBounds) {
  ASSERT_EQ(unknown_parameters().size(), unknown_size);
  const auto name = [](Unknown unknown) {
    return unknown_parameters()[static_cast<std::size_t>(unknown)].name;
  };
  EXPECT_EQ(name(Unknown::clearance), "clearance");
  EXPECT_EQ(name(Unknown::counting_limit), "counting_limit");
  EXPECT_EQ(name(Unknown::contact_speed), "contact_speed");
  const Constants natural = natural_constants();
  for (std::size_t i = 0; i < unknown_size; ++i) {
    const UnknownParameter& c = unknown_parameters()[i];
    EXPECT_LT(c.lower, c.upper) << c.name;
    EXPECT_TRUE(c.lower <= natural[i] && natural[i] <= c.upper) << c.name;
    EXPECT_TRUE(!c.logarithmic || c.lower > 0) << c.name;
  }
}

TEST(UnknownParameters, HaveAPlaceWithinTheirBounds) {
  const UnknownParameter size = {"size", "m", 1e-3, 10, true, {}, ""};
  EXPECT_DOUBLE_EQ(value_at(size, 0.25), 1e-2);
  EXPECT_DOUBLE_EQ(share_of(size, 1), 0.75);
  EXPECT_EQ(share_of(size, 100), 1);
  const UnknownParameter place = {"place", "m", -1, 3, false, {}, ""};
  EXPECT_DOUBLE_EQ(value_at(place, 0.25), 0);
  EXPECT_DOUBLE_EQ(share_of(place, 2), 0.75);
  EXPECT_EQ(share_of(place, -2), 0);
}

TEST(UnknownParameters, AreThoseThatTheInterpretationUses) {
  EXPECT_THAT(unknowns_of({}), AllOf(SizeIs(9), Contains(Unknown::revolutions).Times(1),
                                     Not(Contains(Unknown::seconds))));
  EXPECT_THAT(unknowns_of({.window = WindowUnit::seconds}), Contains(Unknown::seconds));
  EXPECT_THAT(unknowns_of({.normal_force = NormalForce::weight}),
              Not(Contains(Unknown::normal_force)));
  EXPECT_THAT(unknowns_of({.rule = Rule::peaks_1mm}), Not(Contains(Unknown::counting_limit)));
  EXPECT_THAT(unknowns_of({.counted = Counted::later}), Contains(Unknown::first_turn));
  // Not where and how fast it starts, and when.
  EXPECT_THAT(unknowns_of({.counted = Counted::long_run}),
              AllOf(SizeIs(6), Not(Contains(Unknown::start_velocity))));
}

TEST(UnknownParameters, MakeValidScenesOfEveryInterpretationAndCase) {
  for (const Interpretation& r : every_interpretation()) {
    for (const Case& c : all_cases()) {
      const Scene scene = scene_of(c, r, natural_constants());
      EXPECT_NO_THROW(check(scene_at(scene, r, natural_constants(), 3.0), name_of(r)));
    }
  }
}

TEST(UnknownParameters, PutEveryAnswerIntoTheScene) {
  const Scene plain = natural_scene({});
  EXPECT_EQ(std::tuple(plain.mass, plain.restitution_lower, plain.friction, plain.disturbance),
            std::tuple(1.2, 0.9, 0.4, 1.0));
  EXPECT_DOUBLE_EQ(plain.start_position, 1e-3);
  const Scene spindle =
      natural_scene({.disturbance = DisturbanceKind::acceleration, .base = Base::spindle});
  EXPECT_EQ(std::tuple(spindle.mass, spindle.disturbance), std::tuple(1.8, 1.8));
  EXPECT_DOUBLE_EQ(natural_scene({.normal_force = NormalForce::weight}).normal_force, 1.2 * 9.81);
  EXPECT_TRUE(natural_scene({.normal_force = NormalForce::contact}).contact_friction);
  EXPECT_DOUBLE_EQ(natural_scene({.recovery = Recovery::hunt_crossley}, "C1").restitution_lower,
                   returned_restitution(dissipation(ContactLaw::hunt_crossley, 0.1)));
  const Scene soft = natural_scene({.recovery = Recovery::contact_speed});
  EXPECT_EQ(soft.fidelity, Fidelity::compliant);
  EXPECT_EQ(soft.contact_speed, 0.1);
  const Scene peaks = natural_scene({.rule = Rule::peaks_100um});
  EXPECT_EQ(std::tuple(peaks.rule, peaks.peak_low, peaks.peak_high),
            std::tuple(CountRule::peaks, 1e-4, 3e-3));
}

TEST(UnknownParameters, TurnASpeedIntoAProfileWhereThereAreCrossings) {
  const Interpretation crossing = {.transition = Transition::crossing};
  const Scene scene = scene_at(natural_scene(crossing), crossing, natural_constants(), 5.0);
  ASSERT_FALSE(scene.profile.empty());
  EXPECT_NEAR(std::ranges::max(scene.profile, {}, &SpeedKnot<double>::omega).omega,
              5.0 / std::pow(std::cos(0.4), 2), 1e-12);
  EXPECT_TRUE(scene_at(scene, {}, natural_constants(), 4.0).profile.empty());
}

TEST(FittedInterpretation, OfTheDefaultIsTheDefaultMachine) {
  const FittedInterpretation& fitted = default_interpretation();
  EXPECT_EQ(write_scene(fitted.scene), write_scene(default_machine()));
  EXPECT_NO_THROW(check(fitted.scene, fitted.name));
  EXPECT_TRUE(is_one_scene(fitted.interpretation));
  EXPECT_FALSE(fitted.provenance.empty());
  EXPECT_LE(fitted.free.size(), unknowns_of(fitted.interpretation).size());
  for (const Case& c : all_cases())
    EXPECT_EQ(write_scene(at_speed(scene_of(c, fitted.scene), 2.0)),
              write_scene(at_speed(scene_of(c, fitted.interpretation, fitted.constants), 2.0)));
}

TEST(FittedInterpretation, IsWrittenAndReadBackBitForBit) {
  Parameterisation fit = {{.tension = Tension::phased}, {Unknown::pull}, natural_constants()};
  fit.constants[0] = 1.0 / 3.0;
  const std::string text =
      write_fitted_interpretation(fitted_interpretation(fit, "a test", "here"));
  const FittedInterpretation read = parse_fitted_interpretation(text, "there");
  EXPECT_EQ(std::tuple(read.interpretation, read.free, read.constants[0]),
            std::tuple(fit.interpretation, fit.free, 1.0 / 3.0));
  EXPECT_EQ(write_fitted_interpretation(read), text);
}

TEST(FittedInterpretation, IsRefusedWithTheReason) {
  const std::string text = write_fitted_interpretation(default_interpretation());
  const auto with = [&](const std::string& key, const std::string& replacement) {
    std::string changed = text;
    return changed.replace(changed.find(key), key.size(), replacement);
  };
  expect_refusals(
      [](const std::string& wrong) { return parse_fitted_interpretation(wrong, "some.toml"); },
      {{"interpretation = 3", "interpretation = 3: must be a text"},
       {"", "some.toml: interpretation is missing"},
       {"interpretation = ", "not valid TOML"},
       {text + "\nhope = 1\n", "hope"},
       {with("clearance =", "slack ="), "clearance must be in one of"},
       {with("start_share =", "start_share = 7 #"), "fixed.start_share = 7: must be within 0..1"}});
  // Where cases differ in more.
  for (const char* name :
       {"projected-constant-revolutions-acceleration", "projected-constant-revolutions-crossing",
        "projected-constant-revolutions-hunt-crossley"}) {
    EXPECT_THROW(
        fitted_interpretation({find_interpretation(name), {}, natural_constants()}, "", "here"),
        InputError);
  }
}

}  // namespace
}  // namespace ricochet::carrier_track::inline paper
