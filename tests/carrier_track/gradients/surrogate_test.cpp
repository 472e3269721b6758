#include <ceres/jet.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/gradients/shape_derivatives.h"
#include "problems/carrier_track/scene/scene_fields.h"
#include "problems/carrier_track/scene/scene_values.h"
#include "problems/carrier_track/suite/machine.h"
#include "src/core/difference.h"
#include "tests/carrier_track/models/watch.h"
#include "tests/support/scenes.h"

namespace ricochet::carrier_track {
namespace {

using Jet = ceres::Jet<double, 1>;

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

TEST(Surrogate, HasTheSlopeOfDifferencesAtAThousandRandomSpeeds) {
  RandomScenes draws(5);
  std::vector<double> errors;
  const auto cases = all_cases();
  for (std::size_t i = 0; i < 1000; ++i) {
    Scene scene = scene_of(cases[i % cases.size()], exploratory_scene());
    scene.omega = draws.within(0.5, 18.0);
    const Slope exact = surrogate_slope(scene, default_smoothing);
    EXPECT_NEAR(exact.value, objective(scene, default_smoothing), 1e-9 * exact.value);
    const auto value_at = [&](double omega) {
      Scene near = scene;
      near.omega = omega;
      return objective(near, default_smoothing);
    };
    const Difference slope = difference(value_at, scene.omega, 1e-3 * scene.omega);
    errors.push_back(std::abs(exact.slope - slope.slope) / std::abs(slope.slope));
  }
  for (const double share : {0.5, 0.9, 0.99, 1.0}) {
    RecordProperty("relative_error_quantile_" + std::to_string(share),
                   std::to_string(quantile(errors, share) * 1e12) + "e-12");
  }
  EXPECT_LT(quantile(errors, 0.5), 1e-10);
  EXPECT_LT(quantile(errors, 0.99), 1e-7);
}

struct SceneField {
  const char* name;
  double Scene::*plain;
  Jet BasicScene<Jet>::*dual;
};

TEST(Surrogate, HasTheSlopeOfDifferencesWithRespectToEveryConstant) {
  using Dual = BasicScene<Jet>;
  std::vector<double> errors;
  for (const SceneField& field :
       {SceneField{"mass", &Scene::mass, &Dual::mass},
        {"wall_upper", &Scene::wall_upper, &Dual::wall_upper},
        {"restitution_lower", &Scene::restitution_lower, &Dual::restitution_lower},
        {"restitution_upper", &Scene::restitution_upper, &Dual::restitution_upper},
        {"friction", &Scene::friction, &Dual::friction},
        {"normal_force", &Scene::normal_force, &Dual::normal_force},
        {"pull", &Scene::pull, &Dual::pull},
        {"centrifugal_mass_radius", &Scene::centrifugal_mass_radius,
         &Dual::centrifugal_mass_radius},
        {"slider_mass_radius", &Scene::slider_mass_radius, &Dual::slider_mass_radius},
        {"phase", &Scene::phase, &Dual::phase},
        {"disturbance", &Scene::disturbance, &Dual::disturbance},
        {"disturbance_frequency", &Scene::disturbance_frequency, &Dual::disturbance_frequency},
        {"pull_phase", &Scene::pull_phase, &Dual::pull_phase},
        {"disturbance_phase", &Scene::disturbance_phase, &Dual::disturbance_phase},
        {"start_position", &Scene::start_position, &Dual::start_position},
        {"start_velocity", &Scene::start_velocity, &Dual::start_velocity},
        {"omega", &Scene::omega, &Dual::omega},
        {"counting_limit", &Scene::counting_limit, &Dual::counting_limit}}) {
    for (const char* id : {"C5", "C10", "C11"}) {
      Scene scene = scene_of(find_case(id), exploratory_scene());
      scene.restitution_upper *= 0.9;
      scene.slider_mass_radius = 0.01;
      scene.disturbance_phase = 0.7;
      scene.pull_rotates = std::string(field.name) == "pull_phase";
      scene.pull_phase = 0.3;
      scene.disturbance_frequency = 3.0;
      scene.omega = 4.3;
      Dual dual = lifted<Jet>(scene);
      (dual.*field.dual).v[0] = 1.0;
      const double exact = objective(dual, default_smoothing).v[0];
      const auto value_at = [&](double x) {
        Scene near = scene;
        near.*field.plain = x;
        return objective(near, default_smoothing);
      };
      const double x = scene.*field.plain;
      const Difference slope = difference(value_at, x, 1e-4 * std::abs(x));
      EXPECT_NEAR(exact / slope.slope, 1.0, 1e-6) << field.name << " of " << id;
    }
  }
}

TEST(Surrogate, HasTheSlopeOfDifferencesUnderTheRuleOfPeaks) {
  RandomScenes draws(6);
  std::vector<double> errors;
  for (int i = 0; i < 100; ++i) {
    Scene scene = scene_of(find_case(i % 2 == 0 ? "C2" : "C9"), exploratory_scene());
    scene.rule = CountRule::peaks;
    scene.peak_high = 0.8e-3;
    scene.peak_low = 0.2e-3;
    scene.window = Seconds{0.3};
    scene.omega = draws.within(1.0, 18.0);
    const Slope exact = surrogate_slope(scene, default_smoothing);
    const auto value_at = [&](double omega) {
      Scene near = scene;
      near.omega = omega;
      return objective(near, default_smoothing);
    };
    const Difference slope = difference(value_at, scene.omega, 1e-5 * scene.omega);
    errors.push_back(std::abs(exact.slope - slope.slope) / std::abs(slope.slope));
  }
  EXPECT_LT(quantile(errors, 0.5), 1e-7);
  EXPECT_LT(quantile(errors, 0.9), 1e-5);
}

TEST(Surrogate, HasTheSecondDerivativeOfDifferencesThroughDualsOfDuals) {
  using Second = ceres::Jet<Jet, 1>;
  for (const char* id : {"C1", "C4", "C6", "C12"}) {
    Scene scene = scene_of(find_case(id), exploratory_scene());
    scene.omega = 3.7;
    auto dual = lifted<Second>(scene);
    dual.omega.a.v[0] = 1.0;
    dual.omega.v[0].a = 1.0;
    const Second result = objective(dual, default_smoothing);
    const Slope slope = surrogate_slope(scene, default_smoothing);
    EXPECT_NEAR(result.a.a, slope.value, 1e-9 * slope.value);
    EXPECT_NEAR(result.v[0].a / slope.slope, 1.0, 1e-9);
    const auto slope_at = [&](double omega) {
      Scene near = scene;
      near.omega = omega;
      return surrogate_slope(near, default_smoothing).slope;
    };
    const Difference second = difference(slope_at, scene.omega, 1e-4 * scene.omega);
    EXPECT_NEAR(result.v[0].v[0] / second.slope, 1.0, 1e-6) << id;
  }
}

TEST(Surrogate, DualsOfDualsGiveTheClosedFormCurvatureOfAnImpactTime) {
  // t_k = sqrt(2 h / g) (1 + e - 2 e^(k+1)) / (1 - e): dt/dg = -t / 2g, d2t/dg2 = 3 t / 4g^2.
  using Second = ceres::Jet<Jet, 1>;
  Scene scene;
  scene.wall_upper = std::numeric_limits<double>::infinity();
  scene.start_position = 50.0;
  scene.pull = 9.8;
  scene.restitution_lower = 0.8;
  scene.window = Seconds{40.0};
  auto dual = lifted<Second>(scene);
  dual.pull.a.v[0] = 1.0;
  dual.pull.v[0].a = 1.0;
  const auto watched = watch(dual);
  ASSERT_GT(watched.hits.size(), 50U);
  for (std::size_t k = 0; k < 50; ++k) {
    const Second& t = watched.hits[k].time;
    EXPECT_NEAR(t.v[0].a / (-t.a.a / (2 * 9.8)), 1.0, 1e-12);
    EXPECT_NEAR(t.v[0].v[0] / (3 * t.a.a / (4 * 9.8 * 9.8)), 1.0, 1e-12);
  }
  // The end of the bouncing carries derivatives as well, through the sum of the sequence.
  const Second& end = watched.stretches.back().time;
  EXPECT_NEAR(end.v[0].a / (-28.7494454249973 / (2 * 9.8)), 1.0, 1e-12);
  EXPECT_NEAR(end.v[0].v[0] / (3 * 28.7494454249973 / (4 * 9.8 * 9.8)), 1.0, 1e-12);
}

TEST(Surrogate, HasASlopeForABodyThatStartsAtRestAtAWall) {
  for (const bool upper : {false, true}) {
    for (Case a_case : all_cases()) {
      Scene scene = scene_of(a_case, exploratory_scene());
      scene.omega = 7.0;
      scene.start_position = upper ? scene.wall_upper : scene.wall_lower;
      scene.start_velocity = 0.0;
      const Slope exact = surrogate_slope(scene, default_smoothing);
      const auto value_at = [&](double omega) {
        Scene near = scene;
        near.omega = omega;
        return objective(near, default_smoothing);
      };
      const Difference slope = difference(value_at, 7.0, 1e-3);
      EXPECT_NEAR(exact.slope / slope.slope, 1.0, 1e-7) << a_case.id;
    }
  }
}

TEST(Surrogate, HasASlopeWhereAnImpactOnlyTouches) {
  // Thrown up with the apex at the wall: some touch it at next to 0 m/s, where dt/dx is infinite.
  int touches = 0;
  for (double velocity = 0.5; velocity < 10; velocity += 0.5) {
    for (double gravity = 0.5; gravity < 10; gravity += 0.5) {
      Scene scene;
      scene.start_position = 0.0;
      scene.start_velocity = velocity;
      scene.pull = gravity;
      scene.wall_upper = velocity * velocity / (2 * gravity);
      scene.restitution_lower = 0.5;
      scene.window = Seconds{5.0};
      auto dual = lifted<Jet>(scene);
      dual.start_velocity.v[0] = 1.0;
      EXPECT_TRUE(std::isfinite(objective(dual, default_smoothing).v[0]))
          << velocity << " " << gravity;
      for (const auto& hit : watch(scene).hits) touches += hit.speed < 1e-9;
    }
  }
  EXPECT_GT(touches, 0);
}

}  // namespace
}  // namespace ricochet::carrier_track
