#include "problems/carrier_track/scene/scene_check.h"

#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/counting/recording.h"
#include "tests/support/refusals.h"
#include "tests/support/scenes.h"

namespace ricochet::carrier_track {
namespace {

using Knots = std::vector<SpeedKnot<double>>;

std::string complaint_about(const Scene& scene) {
  return complaint_of([&] { check(scene, "machine"); });
}

void expect_refused(const std::vector<Refusal<Scene>>& scenes) {
  expect_refusals([](const Scene& scene) { check(scene, "machine"); }, scenes);
}

void expect_accepted(const std::vector<Scene>& scenes) {
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    EXPECT_EQ(complaint_about(scenes[i]), "accepted") << i;
  }
}

TEST(SceneCheck, AcceptsTheDefaultsTheDefaultMachineAndRandomScenes) {
  expect_accepted({Scene{}, default_machine()});
  RandomScenes scenes(31);
  for (int i = 0; i < 1000; ++i) expect_accepted({scenes.next(), scenes.next_planar()});
}

TEST(SceneCheck, AcceptsTheEdgesOfEveryRange) {
  const Scene edges =
      with(Scene{}, set::wall_upper(infinity), set::restitution_lower(0), set::start_position(0),
           set::omega(0), set::disturbance_frequency(0), set::pull(-1e15), set::disturbance(1e15),
           set::mass(1e-15), set::counting_limit(1e-15));
  expect_accepted({edges, with(edges, set::wall_upper(1), set::start_position(1)),
                   with(Scene{}, set::revolutions(1e6)),
                   with(Scene{}, set::profile(Knots{{0.0, 1.0}, {1e-9, 9.0}}))});
}

template <class Owner>
struct Wrong {
  double Owner::*field;
  std::string key;
  std::string allowed;
  std::vector<double> values;
};

/// Sets each wrong value in turn in what `owner` finds in a valid scene.
template <class Owner, class Find>
void expect_named(const std::vector<Wrong<Owner>>& fields, const Find& owner) {
  for (const auto& [field, key, allowed, values] : fields) {
    for (const double value : values) {
      Scene scene;
      owner(scene).*field = value;
      EXPECT_THAT(complaint_about(scene),
                  AllOf(StartsWith(fmt::format("machine: {} = {}: must be ", key, value)),
                        HasSubstr(allowed)));
    }
  }
}

constexpr double tiny = std::numeric_limits<double>::denorm_min();

TEST(SceneCheck, NamesEveryFieldOutOfItsRange) {
  const std::vector<double> not_finite{infinity, -infinity, quiet_nan, 1e16, -1e16};
  const std::vector<double> not_positive{0, -1, infinity, quiet_nan, 1e16, 0.9e-15};
  const std::vector<double> negative{-tiny, infinity, quiet_nan, 1e16};
  const std::vector<double> no_fraction{-tiny, 1.0001, quiet_nan};
  const std::string finite = "within -1e15..1e15", positive = "within 1e-15..1e15";
  const std::string not_negative = ">= 0";
  expect_named<Scene>(
      {
          {&Scene::mass, "scene.mass", "> 0 [kg], within 1e-15..1e15", not_positive},
          {&Scene::wall_lower, "scene.wall_lower", finite, not_finite},
          {&Scene::wall_upper, "scene.wall_upper", "> wall_lower = 0", {0, -1, quiet_nan, 1e16}},
          {&Scene::restitution_lower, "scene.restitution", "0..1", no_fraction},
          {&Scene::restitution_upper, "scene.restitution", "0..1", no_fraction},
          {&Scene::friction, "scene.friction", not_negative, negative},
          {&Scene::normal_force, "scene.normal_force", not_negative, negative},
          {&Scene::pull, "scene.pull", finite, not_finite},
          {&Scene::pull_phase, "scene.pull_phase", finite, not_finite},
          {&Scene::disturbance_phase, "scene.disturbance_phase", finite, not_finite},
          {&Scene::centrifugal_mass_radius, "scene.centrifugal_mass_radius", not_negative,
           negative},
          {&Scene::slider_mass_radius, "scene.slider_mass_radius", not_negative, negative},
          {&Scene::phase, "scene.phase", finite, not_finite},
          {&Scene::disturbance, "scene.disturbance", finite, not_finite},
          {&Scene::disturbance_frequency, "scene.disturbance_frequency",
           ">= 0 [rad/s], at most 1e9", negative},
          {&Scene::start_position, "scene.start_position", "0..1", {-tiny, 1.01, quiet_nan}},
          {&Scene::start_velocity, "scene.start_velocity", finite, not_finite},
          {&Scene::omega, "scene.omega", not_negative, negative},
          {&Scene::counting_limit, "count.counting_limit", positive, not_positive},
          {&Scene::peak_high, "count.peak_high", positive, not_positive},
          {&Scene::peak_low, "count.peak_low", positive, not_positive},
          {&Scene::stiffness, "model.stiffness", positive, not_positive},
          {&Scene::contact_exponent, "model.contact_exponent", positive, not_positive},
      },
      [](Scene& scene) -> Scene& { return scene; });
  using Y = Across<double>;
  expect_named<Y>(
      {
          {&Y::pull, "across.pull", finite, not_finite},
          {&Y::wall_lower, "across.wall_lower", finite, not_finite},
          {&Y::wall_upper, "across.wall_upper", "> wall_lower = 0", {0, -1, quiet_nan}},
          {&Y::restitution_lower, "across.restitution", "0..1", no_fraction},
          {&Y::restitution_upper, "across.restitution", "0..1", no_fraction},
          {&Y::start_position, "across.start_position", "0..1", {-tiny, 1.01, quiet_nan}},
          {&Y::start_velocity, "across.start_velocity", finite, not_finite},
      },
      [](Scene& scene) -> Y& { return scene.across.emplace(); });
}

/// Of rules about several fields, each with the nearest scene that they accept.
TEST(SceneCheck, NamesFieldsThatDoNotGoTogether) {
  const Scene rubbed = with(Scene{}, set::contact_friction(true), set::friction(1));
  const Scene turned = with(Scene{}, set::pull_rotates(true), set::across(Across<double>{}));
  expect_accepted({with(Scene{}, set::friction(1.5)), rubbed, turned, with(Scene{}, set::planar()),
                   with(Scene{}, set::across(Across<double>{}))});
  expect_refused({
      {with(rubbed, set::friction(1.5)), "scene.friction = 1.5: must be within 0..1"},
      {with(rubbed, set::across(Across<double>{})), "scene.contact_friction = 1: must be false"},
      {with(Scene{}, set::fidelity(Fidelity::planar)), "[across]"},
      {with(turned, set::across(Across<double>{.pull = 1})), "machine: across.pull = 1: must be 0"},
      {with(Scene{}, set::walls(0, infinity), set::start_position(infinity)),
       "machine: scene.start_position = inf"},
      {with(Scene{}, set::profile(Knots{{0.0, 1.0}, {1e-50, 9.0}})),
       "machine: scene.omega's time = 1e-50: must be"},
      {with(Scene{}, set::omega(0), set::revolutions(1)), "because the window is in revolutions"},
  });
  for (const double speed : {0.0, -1.0, infinity, quiet_nan}) {
    expect_refused({{with(Scene{}, set::contact_speed(speed)), "machine: model.contact_speed = "}});
  }
  for (const double speed : {-1.0, infinity, quiet_nan}) {
    expect_refused({{with(Scene{}, set::profile(Knots{{0.0, 1.0}, {1.0, speed}, {2.0, 1.0}})),
                     fmt::format("machine: scene.omega = {}: must be", speed)}});
  }
}

TEST(SceneCheck, RefusesARestitutionThatTheContactLawCannotReturn) {
  const Scene linear = with(Scene{}, set::contact_exponent(1), set::restitution(0.5));
  for (const Scene& scene :
       {with(linear, set::restitution_lower(0)), with(linear, set::restitution_upper(0))}) {
    const Scene compliant = with(scene, set::fidelity(Fidelity::compliant));
    expect_accepted({compliant});
    for (const ContactLaw law : {ContactLaw::kelvin_voigt, ContactLaw::flores, ContactLaw::gonthier,
                                 ContactLaw::exact_restitution}) {
      expect_refused({{with(compliant, set::contact_law(law)),
                       "machine: scene.restitution = 0: must be at least 1e-6"}});
      expect_accepted({with(scene, set::contact_law(law))});  // which does not use the law
    }
  }
}

TEST(SceneCheck, RefusesAFrictionThatLeavesTheContactLawNoRestitution) {
  const Scene scene = with(Scene{}, set::contact_friction(true), set::friction(1),
                           set::contact_law(ContactLaw::flores));
  expect_accepted({scene});  // which does not use the law
  for (const Fidelity level : {Fidelity::compliant, Fidelity::automatic}) {
    const Scene used = with(scene, set::fidelity(level));
    expect_refused({{used, "machine: scene.friction = 1: must be at most 0.999999, because"}});
    EXPECT_NO_THROW(record(with(used, set::friction(0.999999)), 0.25, 0));
  }
}

/// No step of an integration is small enough for the jump of a force whose exponent is below 1.
TEST(SceneCheck, RefusesAnExponentThatTheContactDoesNotHave) {
  const Scene stiff = with(Scene{}, set::contact_exponent(0.99));
  expect_accepted({stiff});  // as hard walls have no use for it
  for (const Fidelity fidelity : {Fidelity::compliant, Fidelity::automatic}) {
    const Scene used = with(stiff, set::fidelity(fidelity));
    expect_refused({{used, "contact_exponent = 0.99: must be at least 1"}});
    expect_accepted({with(used, set::contact_exponent(1))});
  }
  const Scene linear =
      with(Scene{}, set::fidelity(Fidelity::compliant), set::contact_law(ContactLaw::kelvin_voigt));
  expect_refused({{linear, "machine: model.contact_exponent = 1.5: must be 1"}});
  expect_accepted({with(linear, set::contact_exponent(1))});
}

TEST(SceneCheck, RefusesAWindowThatIsEmptyOrOfPeriodsWithoutNumber) {
  for (const double count : {0.0, -1.0, infinity, quiet_nan}) {
    expect_refused({{with(Scene{}, set::seconds(count)), "machine: window.seconds = "},
                    {with(Scene{}, set::revolutions(count)), "machine: window.revolutions = "}});
  }
  const Scene lasting = with(Scene{}, set::seconds(1e4), set::disturbance_frequency(1e9));
  expect_accepted({lasting});  // as nothing disturbs
  expect_refused({
      {with(Scene{}, set::revolutions(1.001e6)),
       "machine: window.revolutions = 1001000: must be at most 1000000"},
      {with(lasting, set::disturbance(1)), "seconds = 10000: must be at most 0.0062831"},
      {with(lasting, set::profile(Knots{{0.0, 1.0}, {1.0, 700.0}, {2.0, 1.0}})), "of 700 rad/s"},
      {with(Scene{}, set::omega(1e-12), set::revolutions(1e5)),
       "machine: window.revolutions = 100000: must be"},
  });
}

TEST(SceneCheck, OfASpeedAloneLooksAtTheWindow) {
  const auto complaint = [](const Scene& scene) {
    return complaint_of([&] { check_omega(scene, "command line", "--omega"); });
  };
  const Scene standing = with(Scene{}, set::omega(0));
  EXPECT_EQ(complaint(standing), "accepted");
  EXPECT_THAT(complaint(with(standing, set::revolutions(1))),
              AllOf(StartsWith("command line: --omega = 0: must be"), HasSubstr("revolutions")));
  EXPECT_THAT(complaint(with(Scene{}, set::omega(1e3), set::seconds(1e4))),
              StartsWith("command line: window.seconds = 10000: must be at most"));
}

/// The fitted start and window are those of a short look at a carrier that was thrown in.
TEST(SceneDoubts, OfThePapersCasesAreAboutTheirStartAlone) {
  for (const Case& a_case : all_cases()) {
    EXPECT_THAT(doubts_about(case_scene(a_case.id)),
                ElementsAre(HasSubstr("scene.start_velocity = 0.5987 m/s"),
                            HasSubstr("window: 1.38 turns")))
        << a_case.id;
  }
}

Scene plausible() {
  return with(Scene{}, set::mass(1.2), set::centrifugal_mass_radius(1.2 * 0.065),
              set::walls(0, 0.8e-3), set::restitution(0.5), set::friction(0.2),
              set::normal_force(11.8), set::disturbance(0.1), set::start(0, 0), set::omega(6),
              set::revolutions(10), set::counting_limit(5e-3));
}

/// Expects one doubt, about what has slipped in a plausible scene.
template <class... Slips>
void expect_doubt(const std::string& said, const Slips&... slips) {
  EXPECT_THAT(doubts_about(with(plausible(), slips...)), ElementsAre(HasSubstr(said)));
}

TEST(SceneDoubts, NameEverySlip) {
  EXPECT_THAT(doubts_about(plausible()), IsEmpty());
  EXPECT_THAT(doubts_about(with(plausible(), set::wall_upper(infinity))), IsEmpty());
  expect_doubt("scene.mass = 1200 kg", set::mass(1200), set::normal_force(11772),
               set::friction(0.01), set::centrifugal_mass_radius(78));
  expect_doubt("scene.mass = 0.0001 kg", set::mass(1e-4), set::normal_force(1e-3),
               set::centrifugal_mass_radius(6.5e-6), set::disturbance(0));
  expect_doubt("are these millimetres?", set::wall_upper(0.8));
  expect_doubt("a fifth of the path radius", set::wall_upper(0.02));
  expect_doubt("hardly any play", set::wall_upper(9e-7), set::counting_limit(1e-3));
  expect_doubt("nothing to multiply", set::normal_force(0));
  for (const double force : {120.0, 1.1}) {
    expect_doubt("the weight is 11.77 N", set::normal_force(force));
  }
  expect_doubt("scene.friction = 1.1", set::friction(1.1));
  expect_doubt("scene.restitution = [0.5, 1]", set::restitution_upper(1));
  expect_doubt("scene.start_velocity = -9 m/s", set::start_velocity(-9));
  expect_doubt("never changes", set::disturbance_frequency(0));
  expect_doubt("count.counting_limit = 2 m/s", set::counting_limit(2));
  expect_doubt("2865 turns a minute", set::omega(300));
  expect_doubt("0.477 turns", set::seconds(0.5));
}

TEST(SceneDoubts, CompareConstantsWithEachOther) {
  for (const auto& [mass_radius, said] :
       {std::pair{78.0, "a path radius of 65 m, not within 0.01..1 m"},
        {0.0078, "a path radius of 0.0065 m"}}) {
    EXPECT_THAT(doubts_about(with(plausible(), set::centrifugal_mass_radius(mass_radius))),
                Contains(HasSubstr(said)));
  }
  expect_doubt("= 54 N: holds the carrier at every speed up to 18 rad/s", set::friction(0.9),
               set::normal_force(60));
  expect_doubt("holds the carrier up to 0.087 rad/s (0.831 rpm) only", set::friction(5e-5),
               set::disturbance(0));
  // 18 rad/s: (0.078 18^2 + 0.1 - 2.36) N over 1.2 kg give 0.175 m/s in 0.8 mm.
  expect_doubt("only 0.175 m/s across the clearance", set::counting_limit(0.18));
  expect_doubt("rebounds count that nobody hears", set::counting_limit(1e-6));
  // 6 rad/s: (2.808 + 0.1 - 2.36) N give 0.027 m/s.
  expect_doubt("-0.09 m/s: at scene.omega = 6 rad/s the forces give the carrier 0.027 m/s across",
               set::start_velocity(-0.09));
  expect_doubt("window: 4 turns at scene.omega: the first impacts are", set::revolutions(4));
}

}  // namespace
}  // namespace ricochet::carrier_track
