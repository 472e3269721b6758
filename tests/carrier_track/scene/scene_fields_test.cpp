#include "problems/carrier_track/scene/scene_fields.h"

#include <ceres/jet.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "problems/carrier_track/scene/scene_check.h"
#include "problems/carrier_track/scene/scene_values.h"
#include "ricochet/error.h"
#include "ricochet/scene.h"
#include "src/core/files.h"
#include "tests/support/numbers.h"

namespace ricochet::carrier_track {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// Calls use(field, x) for every number of a visited field.
template <class Use>
struct Numbers {
  Use use;

  template <class T>
  void operator()(const SceneField& field, T&& x) const {
    if constexpr (requires { x.profile; }) {
      use(field, x.omega);
      for (auto& knot : x.profile) use(field, knot.omega);
    } else if constexpr (requires { x.lower; }) {
      use(field, x.lower);
      use(field, x.upper);
    } else if constexpr (requires { x.has_value(); }) {
      if (x) use(field, *x);
    } else if constexpr (!std::is_enum_v<std::remove_cvref_t<T>> &&
                         !std::same_as<std::remove_cvref_t<T>, bool>) {
      use(field, x);
    }
  }
};
template <class Use>
Numbers(Use) -> Numbers<Use>;

/// A valid scene in which no field, other than the flags, has its default.
Scene unusual_scene() {
  Scene scene;
  scene.across.emplace().pull = -0.5;
  scene.contact_speed = 0.25;
  const Numbers change{[](const SceneField&, double& x) { x = 0.75 * x + 0.1875; }};
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

/// The fields of which the member differs between two scenes or second directions.
struct Differences {
  std::vector<std::string>& keys;

  template <class T>
  void operator()(const SceneField& field, const T& a, const T& b) const {
    bool same = true;
    if constexpr (requires { a.profile; }) {
      same = a.omega == b.omega && std::equal(a.profile.begin(), a.profile.end(), b.profile.begin(),
                                              b.profile.end(), [](const auto& x, const auto& y) {
                                                return x.time == y.time && x.omega == y.omega;
                                              });
    } else if constexpr (requires { a.lower; }) {
      EXPECT_EQ(a.lower == b.lower, a.upper == b.upper) << "they go together in these tests";
      same = a.lower == b.lower && a.upper == b.upper;
    } else {
      same = a == b;
    }
    if (!same) keys.emplace_back(field.key);
  }
};

std::vector<std::string> differences(const Scene& a, const Scene& b) {
  std::vector<std::string> keys;
  visit_flat_fields(Differences{keys}, a, b);
  return keys;
}

std::vector<std::string> differences(const Across<double>& a, const Across<double>& b) {
  std::vector<std::string> keys;
  visit_across_fields(Differences{keys}, a, b);
  return keys;
}

std::vector<std::string> all_keys() {
  std::vector<std::string> keys;
  visit_flat_fields([&](const SceneField& field) { keys.emplace_back(field.key); });
  return keys;
}

/// The largest gap in bytes between the members that `visit` shows of `owner` and those `apart`.
template <class Owner, class Visit>
std::size_t largest_gap(const Owner& owner, const Visit& visit,
                        std::vector<std::pair<const void*, std::size_t>> apart) {
  std::vector<std::pair<const std::byte*, std::size_t>> members;
  const auto add = [&](const auto& x) {
    members.emplace_back(reinterpret_cast<const std::byte*>(&x), sizeof(x));
  };
  const auto add_field = [&](const SceneField&, const auto& x) {
    if constexpr (requires { x.profile; }) {
      add(x.omega);
      add(x.profile);
    } else if constexpr (requires { x.lower; }) {
      add(x.lower);
      add(x.upper);
    } else {
      add(x);
    }
  };
  visit(add_field, owner);
  for (const auto& [at, size] : apart) {
    members.emplace_back(static_cast<const std::byte*>(at), size);
  }
  const auto* end = reinterpret_cast<const std::byte*>(&owner);
  members.emplace_back(end + sizeof(owner), 0);
  std::sort(members.begin(), members.end());
  std::size_t gap = 0;
  for (const auto& [at, size] : members) {
    gap = std::max(gap, static_cast<std::size_t>(at - end));
    end = at + size;
  }
  return gap;
}

TEST(SceneFields, AreAllTheNumbersOfTheStructs) {
  const Scene scene;
  EXPECT_LT(
      largest_gap(scene, [](const auto& visit, const Scene& s) { visit_flat_fields(visit, s); },
                  {{&scene.window, sizeof(scene.window)}, {&scene.across, sizeof(scene.across)}}),
      sizeof(double))
      << "a member of BasicScene is not in the list";
  const Across<double> across;
  EXPECT_LT(
      largest_gap(across,
                  [](const auto& visit, const Across<double>& y) { visit_across_fields(visit, y); },
                  {}),
      sizeof(double))
      << "a member of Across is not in the list";
}

TEST(SceneFields, AreWrittenAndReadBack) {
  const auto file = std::filesystem::path(testing::TempDir()) / "scene_fields_test.toml";
  for (const Scene& scene : {unusual_scene(), flagged_scene()}) {
    write_text_file(file, write_scene(scene));
    const Scene read = read_scene(file);
    EXPECT_THAT(differences(scene, read), testing::IsEmpty());
    ASSERT_EQ(read.across.has_value(), scene.across.has_value());
    if (scene.across) {
      EXPECT_THAT(differences(*scene.across, *read.across), testing::IsEmpty());
    }
  }
  std::filesystem::remove(file);
  // Which says something of every field, as none has the value that a missing key has.
  std::vector<std::string> seen = differences(unusual_scene(), Scene{});
  EXPECT_EQ(seen.size() + 2, all_keys().size());
  for (const std::string& key : differences(flagged_scene(), Scene{})) seen.push_back(key);
  for (const std::string& key : all_keys()) EXPECT_THAT(seen, testing::Contains(key));
  EXPECT_EQ(differences(*unusual_scene().across, Across<double>{}).size(), 6U);
}

/// What a complaint says of a number out of range, and one that is.
std::pair<std::string, double> out_of_range(const SceneField& field) {
  const Range& range = field.range;
  if (range == ranges::finite) {
    return {fmt::format("must be a finite number [{}], within -1e15..1e15", field.unit), infinity};
  }
  if (range == ranges::not_negative) {
    return {fmt::format("must be a finite number >= 0 [{}], at most 1e15", field.unit), -1.0};
  }
  if (range == ranges::frequency) {
    return {fmt::format("must be a finite number >= 0 [{}], at most 1e9", field.unit), -1.0};
  }
  if (range == ranges::positive) {
    return {fmt::format("must be a finite number > 0 [{}], within 1e-15..1e15", field.unit), 0.0};
  }
  if (range == ranges::fraction) return {"must be within 0..1", 1.5};
  EXPECT_EQ(range, ranges::by_rule) << field.key;
  return {"must be ", -1.0};
}

/// Refuses NaN and what is out of range in each number of a table in turn.
template <class Visit>
int expect_termination_reasons(const std::string& table, const Visit& visit) {
  int termination_reasons = 0;
  const std::size_t numbers = [&] {
    std::size_t n = 0;
    Scene scene = unusual_scene();
    visit(Numbers{[&n](const SceneField&, double&) { ++n; }}, scene);
    return n;
  }();
  for (std::size_t wrong = 0; wrong < numbers; ++wrong) {
    for (const bool not_a_number : {true, false}) {
      Scene scene = unusual_scene();
      std::string start, allowed;
      std::size_t i = 0;
      visit(Numbers{[&](const SceneField& field, double& x) {
              if (i++ != wrong) return;
              const auto [must, value] = out_of_range(field);
              x = not_a_number ? std::numeric_limits<double>::quiet_NaN() : value;
              start = fmt::format("machine.toml: {}.{} = {}: ", table, field.key, x);
              allowed = must;
            }},
            scene);
      try {
        check(scene, "machine.toml");
        ADD_FAILURE() << start << "accepted";
      } catch (const InputError& error) {
        EXPECT_THAT(error.what(), StartsWith(start));
        EXPECT_THAT(error.what(), HasSubstr(allowed));
        ++termination_reasons;
      }
    }
  }
  return termination_reasons;
}

TEST(SceneFields, AreChecked) {
  EXPECT_NO_THROW(check(unusual_scene(), "machine.toml"));
  EXPECT_NO_THROW(check(flagged_scene(), "machine.toml"));
  EXPECT_GT(expect_termination_reasons(
                "scene", [](const auto& v, Scene& scene) { visit_scene_fields(v, scene); }),
            30);
  EXPECT_GT(
      expect_termination_reasons(
          "across", [](const auto& v, Scene& scene) { visit_across_fields(v, *scene.across); }),
      10);
  EXPECT_GT(expect_termination_reasons(
                "count", [](const auto& v, Scene& scene) { visit_count_fields(v, scene); }),
            5);
  EXPECT_GT(expect_termination_reasons(
                "model", [](const auto& v, Scene& scene) { visit_model_fields(v, scene); }),
            5);
}

/// The numbers of a scene and of its second direction, in the order of the list.
template <class Scalar>
std::vector<double> numbers_of(const BasicScene<Scalar>& scene) {
  std::vector<double> numbers;
  const Numbers add{[&](const SceneField&, const auto& x) { numbers.push_back(value(x)); }};
  visit_flat_fields(add, scene);
  if (scene.across) visit_across_fields(add, *scene.across);
  return numbers;
}

template <class Scalar>
void expect_kept_when_lifted(const Scene& scene) {
  const BasicScene<Scalar> dual = lifted<Scalar>(scene);
  EXPECT_EQ(numbers_of(dual), numbers_of(scene));
  EXPECT_EQ(dual.across.has_value(), scene.across.has_value());
  EXPECT_EQ(dual.contact_friction, scene.contact_friction);
  EXPECT_EQ(dual.pull_rotates, scene.pull_rotates);
  EXPECT_EQ(dual.centrifugal, scene.centrifugal);
  EXPECT_EQ(std::get<Seconds>(dual.window).count, std::get<Seconds>(scene.window).count);
  EXPECT_EQ(dual.rule, scene.rule);
  EXPECT_EQ(dual.fidelity, scene.fidelity);
  EXPECT_EQ(dual.contact_law, scene.contact_law);
  ASSERT_EQ(dual.profile.size(), scene.profile.size());
  for (std::size_t k = 0; k < scene.profile.size(); ++k) {
    EXPECT_EQ(dual.profile[k].time, scene.profile[k].time);
  }
}

TEST(SceneFields, AreKeptWhenLifted) {
  using Jet = ceres::Jet<double, 2>;
  for (const Scene& scene : {unusual_scene(), flagged_scene()}) {
    expect_kept_when_lifted<double>(scene);
    expect_kept_when_lifted<Jet>(scene);
    expect_kept_when_lifted<ceres::Jet<Jet, 2>>(scene);
  }
}

TEST(SceneFields, ArePerturbedUnlessTheListSaysNot) {
  for (const Scene& scene : {unusual_scene(), flagged_scene()}) {
    std::vector<Perturbation> rules;
    const Numbers add{[&](const SceneField& f, double) { rules.push_back(f.perturbation); }};
    visit_flat_fields(add, scene);
    if (scene.across) visit_across_fields(add, *scene.across);
    const std::vector<double> given = numbers_of(scene);
    const std::vector<double> near = numbers_of(perturbed(scene, 0.6180339887498949, 1.0));
    ASSERT_EQ(rules.size(), given.size());
    ASSERT_EQ(near.size(), given.size());
    for (std::size_t i = 0; i < given.size(); ++i) {
      EXPECT_EQ(near[i] == given[i], rules[i] == Perturbation::none) << i;
    }
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
