#include "problems/carrier_track/gradients/shape_derivatives.h"

#include "problems/carrier_track/gradients/derivatives.h"
#include "problems/carrier_track/scene/scene_values.h"
#include "problems/carrier_track/suite/profile.h"
#include "tests/carrier_track/models/watch.h"
#include "tests/support/scenes.h"

namespace ricochet::carrier_track {
namespace {

/// A sum over the motion of a shape: by the adjoint method, and as a function for dual numbers.
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

  Gradient gradient(const Vector& x) const {
    const Scene shaped = at(x);
    return shape_gradient(of, shaped, shaped_knots(shaped, x), widths(x));
  }

  Matrix curvature(const Vector& x, const Matrix& directions) const {
    const Scene shaped = at(x);
    return shape_curvature(of, shaped, shaped_knots(shaped, x), directions);
  }

  Gradient gradient_by_duals(const Vector& x) const { return gradient_of<16>(*this, x, widths(x)); }

  static Vector widths(const Vector& x) { return Vector::Constant(x.size(), 1.5); }
};

Vector random_shape(Eigen::Index n, RandomScenes& draws) {
  Vector x(n);
  for (double& factor : x) factor = draws.within(0.5, 2);
  return x;
}

/// What the last bits of x do to a result of f, at most, in a few trials.
template <class Result>
double unrest(const Result& f, const Vector& x, RandomScenes& draws) {
  const auto here = f(x);
  double most = 0;
  for (int trial = 0; trial < 4; ++trial) {
    Vector near = x;
    for (double& factor : near) factor = std::nextafter(factor, draws.chance(0.5) ? 0 : 3);
    most = std::max(most, (f(near) - here).norm());
  }
  return most;
}

/// Compares results with those of dual numbers. Some motions are so sensitive that the last bits of
/// x change the result by more than 1e-12; and a release, where forces cancel, has an angle of 16
/// digits.
class DualAgreement {
 public:
  explicit DualAgreement(std::uint64_t seed) : draws_(seed) {}

  template <class Result, class Duals>
  void expect(const Result& result, const Duals& duals, const Vector& x) {
    const auto exact = duals(x);
    const double error = (result - exact).norm();
    ++compared_;
    if (error <= 1e-12 * exact.norm()) {
      ++equal_;
    } else {
      EXPECT_LT(error, std::max(5e-12 * exact.norm(), 10 * unrest(duals, x, draws_)));
    }
  }

  int compared() const { return compared_; }
  double equal_share() const { return static_cast<double>(equal_) / compared_; }

 private:
  RandomScenes draws_;
  int compared_ = 0;
  int equal_ = 0;  // to 12 digits
};

template <class EventSum>
void expect_gradient_of_duals(const SumOfShape<EventSum>& f, const Vector& x,
                              DualAgreement& agreement) {
  const Gradient gradient = f.gradient(x);
  EXPECT_EQ(gradient.value, value_of(f, x));
  agreement.expect(
      gradient.gradient, [&](const Vector& at) { return f.gradient_by_duals(at).gradient; }, x);
  const Trust trust = f.gradient_by_duals(x).trust;
  EXPECT_EQ(gradient.trust.doubt, trust.doubt);
  if (std::isinf(trust.reach)) {
    EXPECT_EQ(gradient.trust.reach, trust.reach);
  } else if (x.size() <= 16) {
    EXPECT_NEAR(gradient.trust.reach / trust.reach, 1, 1e-7);
  } else {  // a lower bound, from several blocks
    EXPECT_GE(gradient.trust.reach / trust.reach, 1 - 1e-7);
    EXPECT_LE(gradient.trust.reach / trust.reach, 2);
  }
}

template <class EventSum>
void expect_curvature_of_duals(const SumOfShape<EventSum>& f, const Vector& x, RandomScenes& draws,
                               DualAgreement& agreement) {
  const Matrix curvature = f.curvature(x, Matrix::Identity(x.size(), x.size()));
  agreement.expect(
      curvature, [&](const Vector& at) { return hessian_of(f, at).hessian; }, x);
  const Vector along = random_shape(x.size(), draws);
  EXPECT_LE((f.curvature(x, along) - curvature * along).norm(), 1e-10 * curvature.norm());
}

/// Calls `look(sum, shape)` for the surrogate and the wear of all cases.
template <class Look>
void for_each_case(std::initializer_list<Eigen::Index> sizes, int shapes, RandomScenes& draws,
                   const Look& look) {
  for (const Case& a_case : all_cases()) {
    SCOPED_TRACE(a_case.id);
    const Scene scene = scene_of(a_case, exploratory_scene());
    const ProfileFrame frame = profile_frame({a_case.id, scene, 0, a_case.claim.threshold, {}});
    for (const Eigen::Index n : sizes) {
      for (int k = 0; k < shapes; ++k) {
        const Vector x = random_shape(n, draws);
        look(SumOfShape<SurrogateSum>{{0.25}, scene, frame}, x);
        look(SumOfShape<WearSum>{{}, scene, frame}, x);
      }
    }
  }
}

/// A scene with every term of equation (31), either rule, and a mean speed.
SumOfShape<SurrogateSum> random_sum(RandomScenes& draws) {
  Scene scene = draws.next();
  scene.fidelity = Fidelity::impact;
  if (draws.chance(0.3)) {
    const double gap = std::min(scene.wall_upper - scene.wall_lower, 1e-2);
    scene.rule = CountRule::peaks;
    scene.peak_high = 0.7 * gap;
    scene.peak_low = 0.3 * gap;
  }
  return {{0.25}, scene, {scene.omega + 0.1, duration_of(scene)}};
}

TEST(ShapeDerivatives, AreThoseOfDualNumbers) {
  RandomScenes draws(5);
  DualAgreement agreement(1);
  int releases = 0, slow = 0, turns = 0;
  for_each_case({2, 4, 16, 64}, 8, draws, [&](const auto& f, const Vector& x) {
    expect_gradient_of_duals(f, x, agreement);
    if (x.size() != 16) return;
    const Scene scene = f.at(x);
    const ProfileMotion motion(scene, summed_motion(f.of, scene).legs);
    for (std::size_t i = 0; i < motion.size(); ++i) {
      releases += motion.released(i);
      turns += motion.leg(i).end == LegEnd::turn;
      slow += motion.leg(i).end == LegEnd::impact && motion.leg(i).speed < 1e-6;
    }
  });
  EXPECT_EQ(agreement.compared(), 768);
  EXPECT_GT(agreement.equal_share(), 0.98);
  EXPECT_GT(releases, 200) << "bodies that stick";
  EXPECT_GT(turns, 200);
  EXPECT_GT(slow, 200) << "and chatter";
}

TEST(ShapeDerivatives, AreThoseOfDualNumbersInAnyScene) {
  DualAgreement agreement(2);
  int peaks = 0, disturbed = 0, trial = 0;
  for_random(6, 400, [&](RandomScenes& draws) {
    const auto f = random_sum(draws);
    peaks += f.scene.rule == CountRule::peaks;
    disturbed += f.scene.disturbance != 0;
    expect_gradient_of_duals(f, random_shape(trial++ % 2 == 0 ? 3 : 12, draws), agreement);
  });
  EXPECT_GT(agreement.equal_share(), 0.97);
  EXPECT_GT(peaks, 50);
  EXPECT_GT(disturbed, 50);
}

TEST(ShapeDerivatives, OfSecondOrderAreThoseOfDualNumbers) {
  RandomScenes draws(7);
  DualAgreement agreement(3);
  const auto compare = [&](const auto& f, const Vector& x) {
    expect_curvature_of_duals(f, x, draws, agreement);
  };
  for_each_case({2, 4}, 2, draws, compare);
  for_each_case({16}, 1, draws, compare);  // these take nearly all of the time
  for (int i = 0; i < 60; ++i) {
    SCOPED_TRACE(i);
    const auto f = random_sum(draws);
    expect_curvature_of_duals(f, random_shape(i % 2 == 0 ? 3 : 12, draws), draws, agreement);
  }
  EXPECT_EQ(agreement.compared(), 180);
  EXPECT_GT(agreement.equal_share(), 0.9);
}

/// Central differences of a step.
template <class EventSum>
Vector differences(const SumOfShape<EventSum>& f, const Vector& x, double step) {
  Vector slopes(x.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const Vector by = step * Vector::Unit(x.size(), i);
    slopes[i] = (value_of(f, Vector(x + by)) - value_of(f, Vector(x - by))) / (2 * step);
  }
  return slopes;
}

/// Compares a gradient with differences where it is not in doubt and they do not depend on their
/// step. Returns true if it does.
template <class EventSum>
bool expect_gradient_of_differences(const SumOfShape<EventSum>& f, const Vector& x) {
  const Gradient gradient = f.gradient(x);
  if (gradient.trust.doubt != GradientDoubt::none) return false;
  const Vector slopes = differences(f, x, 1e-6);
  for (const double step : {1e-5, 1e-7}) {
    if ((differences(f, x, step) - slopes).norm() > 1e-4 * slopes.norm()) return false;
  }
  EXPECT_LT((gradient.gradient - slopes).norm(), 3e-4 * slopes.norm());
  return true;
}

TEST(ShapeDerivatives, AreThoseOfDifferencesInAnyScene) {
  RandomScenes draws(9);
  int compared = 0;
  for (int i = 0; i < 200; ++i) {
    SCOPED_TRACE(i);
    const auto f = random_sum(draws);
    compared += expect_gradient_of_differences(f, random_shape(3, draws));
  }
  EXPECT_GT(compared, 80);
}

/// Speeds that differ much push a body at rest the other way than the first of them alone.
TEST(ShapeDerivatives, AreThoseOfDifferencesForABodyThatStartsAtRest) {
  RandomScenes draws(10);
  int compared = 0;
  for (int i = 0; i < 600; ++i) {
    SCOPED_TRACE(i);
    auto f = random_sum(draws);
    const double omega = f.scene.omega;
    f.scene =
        with(f.scene, set::start(f.scene.start_position, 0), set::pull(0.3 * f.scene.pull),
             set::friction(0), set::slider_mass_radius(draws.within(0.3, 1) / (omega * omega)),
             set::seconds(draws.within(0.5, 2) / omega));
    f.frame.seconds = duration_of(f.scene);
    compared += expect_gradient_of_differences(f, random_shape(4, draws));
  }
  EXPECT_GT(compared, 200);
}

/// Times of impacts that are not slow.
std::vector<double> impact_times(const Scene& scene) {
  std::vector<double> times;
  for (const MotionLeg& leg : summed_motion(WearSum(), scene).legs) {
    if (leg.end == LegEnd::impact && leg.speed > 1e-3) times.push_back(leg.start + leg.duration);
  }
  return times;
}

/// Where an impact is on a knot but for the last bit, the force jumps at the impact: on either side
/// the derivatives are those of that side.
TEST(ShapeDerivatives, AreOneSidedAtAnImpactOnAKnot) {
  RandomScenes draws(8);
  DualAgreement agreement(4);
  for (int trial = 0; trial < 20; ++trial) {
    SCOPED_TRACE(trial);
    const Scene scene =
        with(scene_of(find_case("C4"), exploratory_scene()), set::slider_mass_radius(0.05));
    const Vector x = random_shape(5, draws);
    const auto number = static_cast<std::size_t>(trial) / 2;
    const auto with_window = [&](double seconds) {
      return SumOfShape<WearSum>{{}, scene, {8.0, seconds}};
    };
    const auto late = [&](double seconds) {  // by which the impact is later than the middle knot
      const auto times = impact_times(with_window(seconds).at(x));
      return times.size() > number ? times[number] - seconds / 2 : 1.0;
    };
    double after = 2e-3;
    while (late(after) > 0) after *= 1.05;
    double before = after / 1.05;
    while (std::nextafter(before, after) < after) {
      const double middle = std::midpoint(before, after);
      (late(middle) > 0 ? before : after) = middle;
    }
    EXPECT_LT(std::abs(late(after)), 1e-15);
    expect_gradient_of_duals(with_window(before), x, agreement);
    expect_gradient_of_duals(with_window(after), x, agreement);
  }
  EXPECT_GT(agreement.equal_share(), 0.95);
}

}  // namespace
}  // namespace ricochet::carrier_track
