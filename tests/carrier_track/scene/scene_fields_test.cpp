#include "problems/carrier_track/scene/scene_fields.h"

#include <ceres/jet.h>

#include "problems/carrier_track/scene/scene_check.h"
#include "problems/carrier_track/scene/scene_values.h"
#include "tests/support/scenes.h"
#include "tests/support/test.h"

namespace ricochet::carrier_track {
namespace {

using std::numbers::pi;

/// Calls use(field, member) for every member of a visited field.
template <class Use>
struct Members {
  Use use;

  template <class T>
  void operator()(const SceneField& field, T&& x) const {
    if constexpr (requires { x.profile; }) {
      use(field, x.omega);
      use(field, x.profile);
    } else if constexpr (requires { x.lower; }) {
      use(field, x.lower);
      use(field, x.upper);
    } else {
      use(field, x);
    }
  }
};
template <class Use>
Members(Use) -> Members<Use>;

/// Calls use(x) for every number of a member.
template <class Member, class Use>
void each_number(Member& member, const Use& use) {
  if constexpr (requires { member.begin(); }) {
    for (auto& knot : member) use(knot.omega);
  } else if constexpr (requires { member.has_value(); }) {
    if (member) use(*member);
  } else if constexpr (!std::is_enum_v<Member> &&
                       !std::same_as<std::remove_const_t<Member>, bool>) {
    use(member);
  }
}

/// A valid scene in which no field, other than the flags, has its default. Its numbers have all
/// their digits.
Scene unusual_scene() {
  Scene scene;
  scene.across.emplace().pull = -0.5;
  scene.contact_speed = 0.25;
  const Members change{[](const SceneField&, auto& member) {
    each_number(member, [](double& x) { x = 0.75 * x + 1.0 / 7.0; });
  }};
  visit_flat_fields(change, scene);
  visit_across_fields(change, *scene.across);
  scene.restitution_upper = scene.across->restitution_upper = 0.5;  // unlike that of the lower wall
  scene.centrifugal = Centrifugal::outward;
  scene.window = Seconds{2.5};
  scene.rule = CountRule::peaks;
  scene.fidelity = Fidelity::automatic;
  scene.contact_law = ContactLaw::flores;
  return scene;
}

/// The same with a speed profile and flags, which do not go with a second direction.
Scene flagged_scene() {
  Scene scene = unusual_scene();
  scene.across.reset();
  scene.contact_friction = scene.pull_rotates = true;
  scene.profile = {{0.0, 1.5}, {0.5, 2.5}};
  scene.omega = Scene{}.omega;  // the profile takes its place in a file
  return scene;
}

/// What a scene holds, by table and key: numbers, and flags and names as numbers.
template <class Scalar>
std::map<std::string, std::vector<double>> values_of(const BasicScene<Scalar>& scene) {
  std::map<std::string, std::vector<double>> all;
  all["window"] = {std::get<Seconds>(scene.window).count};
  const auto add_to = [&](const std::string& table) {
    return Members{[&all, table](const SceneField& field, const auto& member) {
      std::vector<double>& values = all[table + std::string(field.key)];
      using Member = std::remove_cvref_t<decltype(member)>;
      if constexpr (std::is_enum_v<Member> || std::same_as<Member, bool>) {
        values.push_back(static_cast<int>(member));
      } else if constexpr (requires { member.begin(); }) {
        for (const auto& knot : member) values.push_back(knot.time);
      }
      each_number(member, [&](const auto& x) { values.push_back(value(x)); });
    }};
  };
  visit_flat_fields(add_to(""), scene);
  if (scene.across) visit_across_fields(add_to("across."), *scene.across);
  return all;
}

/// The largest gap in bytes between the members that `visit` shows of `owner` and those `apart`.
template <class Owner, class Visit>
std::size_t largest_gap(const Owner& owner, const Visit& visit,
                        std::vector<std::pair<const void*, std::size_t>> apart) {
  const auto add = [&](const SceneField&, const auto& x) { apart.emplace_back(&x, sizeof(x)); };
  visit(Members{add}, owner);
  const auto* end = reinterpret_cast<const std::byte*>(&owner);
  apart.emplace_back(end + sizeof(owner), 0);
  std::ranges::sort(apart);
  std::size_t gap = 0;
  for (const auto& [at, size] : apart) {
    gap = std::max(gap, static_cast<std::size_t>(static_cast<const std::byte*>(at) - end));
    end = static_cast<const std::byte*>(at) + size;
  }
  return gap;
}

TEST(SceneFields, AreAllTheNumbersOfTheStructs) {
  const Scene scene;
  const auto flat = [](const auto& visit, const Scene& s) { visit_flat_fields(visit, s); };
  EXPECT_LT(
      largest_gap(scene, flat,
                  {{&scene.window, sizeof(scene.window)}, {&scene.across, sizeof(scene.across)}}),
      sizeof(double))
      << "a member of BasicScene is not in the list";
  const auto across = [](const auto& visit, const auto& y) { visit_across_fields(visit, y); };
  EXPECT_LT(largest_gap(Across<double>{}, across, {}), sizeof(double))
      << "a member of Across is not in the list";
}

TEST(SceneFields, AreWrittenAndReadBackBitForBit) {
  // Without an end on one side of each track, and with a pull that turns into both.
  Scene endless = with(unusual_scene(), set::wall_upper(infinity), set::pull_rotates(true));
  endless.across->wall_upper = infinity;
  endless.across->pull = 0;
  endless.contact_speed.reset();
  for (const Scene& scene : {unusual_scene(), flagged_scene(), endless}) {
    EXPECT_NO_THROW(check(scene, "machine.toml"));
    EXPECT_EQ(values_of(parse_scene(write_scene(scene), "a text")), values_of(scene));
  }
  // Which says something of every field, as none has the value that a missing key has.
  auto unusual = values_of(unusual_scene()), flagged = values_of(flagged_scene());
  for (const auto& [key, missing] : values_of(with(Scene{}, set::across(Across<double>{})))) {
    EXPECT_TRUE(unusual[key] != missing || flagged[key] != missing) << key;
  }
}

TEST(SceneFields, AreKeptWhenLifted) {
  using Jet = ceres::Jet<double, 2>;
  for (const Scene& scene : {unusual_scene(), flagged_scene()}) {
    EXPECT_EQ(values_of(lifted<double>(scene)), values_of(scene));
    EXPECT_EQ(values_of(lifted<Jet>(scene)), values_of(scene));
    EXPECT_EQ(values_of(lifted<ceres::Jet<Jet, 2>>(scene)), values_of(scene));
  }
}

using Texts = std::map<std::string, double>;

/// With a blank, two, or none.
TEST(Quantity, IsInTheSiUnitWhateverUnitItIsGivenIn) {
  const std::map<std::string, Texts> exact = {
      {"m",
       {{"0.8 mm", 0.8e-3},
        {"80 um", 80e-6},
        {"6.5 cm", 6.5e-2},
        {"inf m", infinity},
        {"0.8mm", 0.8e-3},
        {"1e-3m", 1e-3},
        {"infm", infinity}}},
      {"kg", {{"1.2 kg", 1.2}, {"900 g", 0.9}, {"1e-3  kg", 1e-3}, {"1kg", 1.0}}},
      {"N", {{"9.81 N", 9.81}, {"-10 mN", -10e-3}, {"-5e3mN", -5.0}, {"0.3 kN", 300.0}}},
      {"m/s", {{"2 m/s", 2.0}, {"5 mm/s", 5e-3}, {"5mm/s", 5e-3}, {"7 cm/s", 7e-2}}},
      {"s", {{"3 s", 3.0}, {"1.5 ms", 1.5e-3}, {"2 min", 120.0}, {"2.min", 120.0}}}};
  const std::map<std::string, Texts> near = {{"rad", {{"2 rad", 2.0}, {"30 deg", pi / 6}}},
                                             {"rad/s",
                                              {{"2 rad/s", 2.0},
                                               {"120 rpm", 4 * pi},
                                               {"60rpm", 2 * pi},
                                               {"2 Hz", 4 * pi},
                                               {"90 deg/s", pi / 2}}},
                                             {"kg m",
                                              {{"2 kg m", 2.0},
                                               {"78 g m", 0.078},
                                               {"78g m", 0.078},
                                               {"0.33 kg mm", 3.3e-4},
                                               {"4 g mm", 4e-6}}}};
  for (const auto& [unit, texts] : exact) {
    for (const auto& [text, value] : texts) EXPECT_EQ(quantity(text, unit), value) << text;
  }
  for (const auto& [unit, texts] : near) {
    for (const auto& [text, value] : texts) {
      EXPECT_DOUBLE_EQ(quantity(text, unit).value_or(quiet_nan), value) << text;
    }
  }
  // None is left out.
  for (const auto* tried : {&exact, &near}) {
    for (const auto& [unit, texts] : *tried) {
      for (const std::string_view name : units_for(unit)) {
        EXPECT_TRUE(std::ranges::any_of(texts, [name](const auto& entry) {
          return entry.first.ends_with(fmt::format(" {}", name));
        })) << name;
      }
    }
  }
}

TEST(Quantity, IsNothingElse) {
  for (const char* text : {"",     " ",      "1",        "1 ",     "kg",     " 1 kg", "1kgm",
                           "1k g", "1e",     "1e kg",    "1..2kg", "1 kg ",  "1 KG",  "1 lb",
                           "1 m",  "1,2 kg", "1.2.3 kg", "one kg", "1 kg m", "0x1 kg"}) {
    EXPECT_FALSE(quantity(text, "kg").has_value()) << text;
  }
  EXPECT_FALSE(quantity("0.5 1", "1").has_value());
  EXPECT_FALSE(quantity("1 N", "N/m^contact_exponent").has_value());
}

/// What a new unit of a field must not forget.
TEST(Quantity, HasUnitsForEveryFieldThatHasADimension) {
  const auto expect_units = [](const SceneField& field) {
    if (field.unit.empty() || field.unit == "1" || field.unit.starts_with("N/m^")) return;
    ASSERT_THAT(units_for(field.unit), testing::SizeIs(testing::Ge(2U))) << field.key;
    EXPECT_EQ(units_for(field.unit).front(), field.unit);
  };
  visit_flat_fields(expect_units);
  visit_across_fields(expect_units);
  expect_units(path_radius);
}

}  // namespace
}  // namespace ricochet::carrier_track
