#include "problems/carrier_track/gradients/shape_derivatives.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "problems/carrier_track/check/oracle/random_scenes.h"
#include "problems/carrier_track/counting/collisions.h"
#include "problems/carrier_track/counting/wear.h"
#include "problems/carrier_track/gradients/derivatives.h"
#include "problems/carrier_track/problems/profile.h"
#include "problems/carrier_track/scene/lifted.h"
#include "tests/carrier_track/problems/exploratory_scene.h"

namespace ricochet::carrier_track {
namespace {

/// The sums that the problems minimise.
struct WeightsOfEvents {
  double smoothing;

  template <class Scalar>
  WeightSum<Scalar> over(const BasicScene<Scalar>& scene) const {
    return {scene, smoothing};
  }
};

struct LossesOfEvents {
  template <class Scalar>
  EnergyLost<Scalar> over(const BasicScene<Scalar>& scene) const {
    return EnergyLost<Scalar>(scene);
  }
};

/// The same sum of a shape by dual numbers.
template <class EventSum>
struct SumOfShape {
  EventSum of;
  Scene scene;
  ProfileFrame frame;

  template <class Scalar, class Watch>
  Scalar operator()(std::span<const Scalar> x, Watch& watch) const {
    const BasicScene<Scalar> at = with_profile(lifted<Scalar>(scene), frame, x);
    auto sum = of.over(at);
    auto watching = watch.of(at);
    ObserverPair both(sum, watching);
    simulate(at, both);
    return sum.total();
  }

  Scene at(const Vector& x) const {
    return with_profile(scene, frame, std::span(x.data(), static_cast<std::size_t>(x.size())));
  }

  Gradient adjoint(const Vector& x, const Vector& widths) const {
    const Scene shaped = at(x);
    return shape_gradient(of, shaped, shaped_knots(shaped, x), widths);
  }
  Matrix curvature(const Vector& x, const Matrix& directions) const {
    const Scene shaped = at(x);
    return shape_curvature(of, shaped, shaped_knots(shaped, x), directions);
  }
};

TEST(ShapeDerivatives, Explore) {
  RandomScenes draws(3);
  int looked = 0, off = 0, trust_off = 0;
  const auto look = [&](const auto& f, const Vector& x, const std::string& name) {
    const Vector widths = Vector::Constant(x.size(), 1.5);
    const Gradient exact = gradient_of<16>(f, x, widths);
    const Gradient adjoint = f.adjoint(x, widths);
    const double error = (exact.gradient - adjoint.gradient).norm();
    ++looked;
    if (!(error <= 1e-12 * exact.gradient.norm())) {
      ++off;
      Vector y = x;
      for (auto& e : y) e = std::nextafter(e, 3);
      const double bit = (gradient_of<16>(f, y, widths).gradient - exact.gradient).norm();
      std::printf("%s: relative %g, last bit %g, value %g, growth ...\n", name.c_str(),
                  error / exact.gradient.norm(), bit / exact.gradient.norm(),
                  exact.value - adjoint.value);
      if (x.size() <= 4) {
        using Long = ceres::Jet<long double, 4>;
        std::vector<Long> duals;
        for (int i = 0; i < x.size(); ++i) duals.push_back(Long(x[i], i));
        Unwatched nobody;
        const Long y = f(std::span<const Long>(duals), nobody);
        double a = 0, b = 0;
        for (int i = 0; i < x.size(); ++i) {
          a += std::pow(double(y.v[i] - exact.gradient[i]), 2);
          b += std::pow(double(y.v[i] - adjoint.gradient[i]), 2);
        }
        std::printf("     duals %g adjoint %g off long double; |g| %g\n", std::sqrt(a)/ exact.gradient.norm(), std::sqrt(b)/ exact.gradient.norm(), exact.gradient.norm());
      }
    }
    if (x.size() <= 16 && !(std::abs(exact.trust.reach - adjoint.trust.reach) <= 1e-9 * exact.trust.reach)) {
      ++trust_off;
      std::printf("%s: reach %.16g, %.16g\n", name.c_str(), exact.trust.reach, adjoint.trust.reach);
    }
    if (x.size() == 64) {
      if (trust_off < 100 && !(adjoint.trust.reach >= exact.trust.reach * (1 - 1e-9) && adjoint.trust.reach <= 2.0001 * exact.trust.reach)) {
        ++trust_off;
      std::printf("%s: reach64 %.16g, %.16g\n", name.c_str(), exact.trust.reach, adjoint.trust.reach);
      }
    }
  };
  for (const Case& a_case : all_cases()) {
    const Machine m{a_case.id, scene_of(a_case, exploratory_scene()), 0, draws.within(4, 12), {}};
    for (const int n : {2, 4, 16, 64}) {
      for (int draw = 0; draw < 5; ++draw) {
        Vector x(n);
        for (double& e : x) e = draws.within(0.5, 2);
        const std::string name = a_case.id + " " + std::to_string(n) + " ";
        const ProfileFrame frame = profile_frame(m);
        look(SumOfShape<WeightsOfEvents>{{0.25}, m.scene, frame}, x, name + "0.25");
        look(SumOfShape<WeightsOfEvents>{{0.05}, m.scene, frame}, x, name + "0.05");
        look(SumOfShape<LossesOfEvents>{{}, m.scene, frame}, x, name + "wear");
      }
    }
  }
  std::printf("%d looked, %d off, %d trust\n", looked, off, trust_off);
}

TEST(ShapeDerivatives, ExploreSecond) {
  RandomScenes draws(3);
  int looked = 0, off = 0;
  const auto look = [&](const auto& f, const Vector& x, const std::string& name) {
    const Hessian exact = hessian_of<4>(f, x);
    const Matrix adjoint = f.curvature(x, Matrix::Identity(x.size(), x.size()));
    const Vector one = f.curvature(x, Vector(x));
    const double error = (exact.hessian - adjoint).norm();
    const double single = (exact.hessian*x - one).norm();
    ++looked;
    if (!(error <= 1e-12 * exact.hessian.norm()) || !(single <= 1e-12 * exact.hessian.norm())) {
      ++off;
      Vector y = x;
      for (auto& e : y) e = std::nextafter(e, 3);
      const double bit = (hessian_of<4>(f, y).hessian - exact.hessian).norm();
      std::printf("%s: relative %g %g, last bit %g\n", name.c_str(),
                  error / exact.hessian.norm(), single/exact.hessian.norm(), bit / exact.hessian.norm());
    }
  };
  for (const Case& a_case : all_cases()) {
    const Machine m{a_case.id, scene_of(a_case, exploratory_scene()), 0, draws.within(4, 12), {}};
    for (const int n : {2, 4, 16}) {
      for (int draw = 0; draw < 3; ++draw) {
        Vector x(n);
        for (double& e : x) e = draws.within(0.5, 2);
        const std::string name = a_case.id + " " + std::to_string(n) + " ";
        const ProfileFrame frame = profile_frame(m);
        look(SumOfShape<WeightsOfEvents>{{0.25}, m.scene, frame}, x, name + "0.25");
        look(SumOfShape<LossesOfEvents>{{}, m.scene, frame}, x, name + "wear");
      }
    }
  }
  std::printf("%d looked, %d off\n", looked, off);
}

}  // namespace
}  // namespace ricochet::carrier_track
