// dynFWA, bare-bones, loser-out and space-partitioned fireworks.

#include "solvers/fireworks/dynamic_fireworks.h"
#include "solvers/fireworks/loser_out_fireworks.h"
#include "solvers/fireworks/partitioned_fireworks.h"
#include "tests/solvers/solve.h"

namespace ricochet::fireworks {
namespace {

Problem plain(Eigen::Index n, double start, double (*objective)(const Vector& x)) {
  return box_problem("plain", n, -1000, 1000, start, objective);
}

double seven(const Vector&) {
  return 7;
}

/// Expects that the `core` first points of each of forty generations reach from `centre` as far as
/// an amplitude that falls from 2000 by a tenth each time. Below `inside` no spark leaves the box.
void expect_decline(const std::vector<Vector>& asked, std::size_t first, std::size_t generation,
                    std::size_t core, double centre, double inside, double share) {
  ASSERT_EQ(asked.size(), first + 40 * generation);
  double amplitude = 2000;
  for (std::size_t g = 0; g < 40; ++g, amplitude *= 0.9) {
    if (amplitude >= inside) continue;
    double farthest = 0;
    for (std::size_t k = first + generation * g; k < first + generation * g + core; ++k) {
      farthest = std::max(farthest, (asked[k].array() - centre).abs().maxCoeff());
    }
    EXPECT_LE(farthest, amplitude * (1 + 1e-12)) << g;
    EXPECT_GT(farthest, share * amplitude) << g;
  }
}

TEST(DynamicFireworks, LessenTheBestAmplitudeAsLongAsNothingIsBetter) {
  // A plateau of 7 with a needle at the start, which gets 120 sparks and the others 6 each. No
  // clones, and the best only once: it alone has the needle's worth.
  const Problem needle =
      plain(2, 500, [](const Vector& x) { return x[0] == 500 && x[1] == 500 ? -1e6 : 7.0; });
  const Solver solver = dynamic_fireworks(
      "dynfwa",
      {.moved = Moved::all, .selection = {.others = Others::uniform, .replacement = false}});
  expect_decline(asked_points(needle, solver, 5 + 144 * 40, 0), 5, 144, 120, 500, 500, 0.9);
}

TEST(BareBonesFireworks, ShrinkTheirBoxOnAPlateauAndStay) {
  expect_decline(asked_points(plain(2, 100, seven), bare_bones_fireworks("bbfwa"), 1 + 300 * 40, 0),
                 1, 300, 300, 100, 900, 0.95);
}

TEST(DynamicFireworks, RaiseTheBestAmplitudeAsLongAsSomethingIsBetter) {
  Problem problem = plain(1, 0, seven);
  double value = 0;  // every point is better than all before it
  problem.evaluate = [&value](const Vector&) { return Values{value -= 1, {}}; };
  const std::vector<Vector> asked = asked_points(
      problem, dynamic_fireworks("dynfwa", {.steps = {.growth = 1, .decline = 1e-9}}), 3000, 0);
  const auto tail = std::minmax_element(
      asked.end() - 500, asked.end(), [](const Vector& a, const Vector& b) { return a[0] < b[0]; });
  EXPECT_GT((*tail.second)[0] - (*tail.first)[0], 1500) << "with any decline it would be next to 0";
}

TEST(BareBonesFireworks, MoveAlongAPlateauOnlyIfSoDecided) {
  for (const bool neutral_moves : {false, true}) {
    const std::vector<Vector> asked = asked_points(
        plain(1, 100, seven), bare_bones_fireworks("bbfwa", {.neutral_moves = neutral_moves}),
        1 + 300 * 60, 0);
    double middle = 0;  // of the last generation, which is some 2000 * 0.9^59 = 4 wide to each side
    for (auto x = asked.end() - 300; x != asked.end(); ++x) middle += (*x)[0] / 300;
    EXPECT_EQ(std::abs(middle - 100) > 4, neutral_moves);
  }
}

TEST(Successors, FindAShiftedOptimum) {
  for (const double centre : {0.0, 30.0, 70.0}) {
    const auto end = [&](const Solver& solver, Eigen::Index n = 10) {
      return end_of(sphere(n, centre), solver, 60000, 1);
    };
    EXPECT_LT(end(bare_bones_fireworks("bbfwa"), 3), 1e-6) << centre;
    EXPECT_LT(end(dynamic_fireworks("dynfwa")), 1e-3) << centre;
    EXPECT_LT(end(loser_out_fireworks("lotfwa")), 1e-2) << centre;
    EXPECT_LT(end(loser_out_fireworks("mgfwa", multi_guiding_options())), 1e-2) << centre;
    EXPECT_LT(end(partitioned_fireworks("fwassp")), 1e-6) << centre;
  }
}

TEST(LoserOutFireworks, LoseWhereTheyGetBetterTooSlowly) {
  EXPECT_TRUE(loses(10, 9, 0, 8));    // 8 more at best, of 9
  EXPECT_FALSE(loses(10, 9, 0, 9));   // just enough
  EXPECT_FALSE(loses(10, 10, 0, 8));  // who stands still is not judged
  EXPECT_FALSE(loses(10, 9, 9, 0));   // the best never loses
}

using Sparks = std::vector<Vector>::const_iterator;

/// The means of the best and the worst fifth of 60 sparks.
struct Fifths {
  Vector best, worst;

  Fifths(Sparks first, const std::function<double(const Vector&)>& value) {
    std::vector<Vector> sparks(first, first + 60);
    std::sort(sparks.begin(), sparks.end(),
              [&](const Vector& a, const Vector& b) { return value(a) < value(b); });
    const Vector zero = Vector::Zero(first->size());
    best = std::accumulate(sparks.begin(), sparks.begin() + 12, zero) / 12;
    worst = std::accumulate(sparks.end() - 12, sparks.end(), zero) / 12;
  }
};

/// Expects a point where it is inside the box, and else redrawn; returns how many coordinates are.
int expect_unless_redrawn(const Vector& x, const Vector& expected) {
  int inside = 0;
  for (Eigen::Index k = 0; k < x.size(); ++k) {
    if (std::abs(expected[k]) > 1000) continue;
    ++inside;
    EXPECT_NEAR(x[k], expected[k], 1e-9);
  }
  return inside;
}

TEST(LoserOutFireworks, GuideTheLastSparkOfEachFirework) {
  const auto value = [](const Vector& x) { return x[0]; };  // no two of its sparks are tied
  const std::vector<Vector> asked =
      asked_points(plain(2, 0, value), loser_out_fireworks("lotfwa"), 5 + 5 * 61, 0);
  int inside = 0;
  for (std::size_t i = 0; i < 5; ++i) {
    const Sparks first = asked.begin() + static_cast<std::ptrdiff_t>(5 + 61 * i);
    const Fifths fifths(first, value);
    inside += expect_unless_redrawn(first[60], asked[i] + fifths.best - fifths.worst);
  }
  EXPECT_GE(inside, 5);
}

TEST(LoserOutFireworks, BeginAnewWhereTheyLose) {
  // Every point is a little better than all before it, but the first guiding spark, the 66th point,
  // is much better: the four other fireworks lose, and are drawn and evaluated anew before the
  // second generation.
  Problem problem = plain(6, 0, seven);
  int call = 0;
  problem.evaluate = [&call](const Vector&) {
    ++call;
    return Values{call == 66 ? -1e6 : -1e-3 * call, {}};
  };
  const std::vector<Vector> asked = asked_points(problem, loser_out_fireworks("lotfwa"), 400, 0);
  const Sparks second = asked.begin() + 5 + 5 * 61 + 4;
  const Fifths fifths(second, [&](const Vector& x) {  // later sparks are better
    return -static_cast<double>(std::find(second, second + 60, x) - second);
  });
  EXPECT_GE(expect_unless_redrawn(second[60], asked[65] + fifths.best - fifths.worst), 3);
}

TEST(LoserOutFireworks, GuideSeveralSparksBeyondTheMeanOfTheBest) {
  const auto value = [](const Vector& x) { return std::abs(x[0]); };
  const std::vector<Vector> asked = asked_points(
      plain(2, 0, value), loser_out_fireworks("mgfwa", multi_guiding_options()), 5 + 5 * 70, 0);
  std::vector<double> reached;  // by those that are not redrawn
  for (std::ptrdiff_t i = 0; i < 5; ++i) {
    const Sparks first = asked.begin() + 5 + 70 * i;
    const auto [best, worst] = Fifths(first, value);
    for (Sparks spark = first + 60; spark != first + 70; ++spark) {
      const double times = ((*spark)[1] - best[1]) / (best[1] - worst[1]);
      const double off = (*spark)[0] - best[0] - times * (best[0] - worst[0]);
      if (std::abs(off) <= 1e-6) reached.push_back(times);
    }
  }
  ASSERT_GE(reached.size(), 10U);
  EXPECT_THAT(reached, Each(AllOf(testing::Ge(0), testing::Le(1.5))));
  EXPECT_GT(std::ranges::max(reached) - std::ranges::min(reached), 0.3);
}

TEST(PartitionedFireworks, ShareTheGapBetweenTheirSurfaces) {
  EXPECT_DOUBLE_EQ(fitted_radius(10, 4, 2, false), 1.5);  // a gap of 4, half of it to each
  EXPECT_DOUBLE_EQ(fitted_radius(10, 4, 2, true), 2);
  EXPECT_DOUBLE_EQ(fitted_radius(10, 8, 6, false), 0.75);  // an overlap
  EXPECT_DOUBLE_EQ(fitted_radius(100, 4, 2, true), 2);
  EXPECT_DOUBLE_EQ(fitted_radius(4, 4, 3, true), 0.5);
  EXPECT_DOUBLE_EQ(fitted_radius(4, 4, 10, true), -1.5);
}

TEST(PartitionedFireworks, ReachForEachOther) {
  // Which sparks are good is chance: only the other firework gives a direction.
  const Problem noise = box_problem("noise", 2, 0, 1, 0.5, [](const Vector& x) {
    return std::sin(1e7 * x[0]) + std::sin(1.3e7 * x[1]);
  });
  const Solver solver = partitioned_fireworks("fwassp", {.fireworks = 2});
  double along = 0, across = 0;
  for (int number = 1; number <= 20; ++number) {
    const std::vector<Vector> asked = asked_points(noise, solver, 2 + 120 + 60, number);
    const Vector towards = (asked[1] - asked[0]).normalized();
    for (auto x = asked.begin() + 122; x != asked.end(); ++x) {
      const Vector step = *x - asked[0];
      if (step.norm() > 0.2) continue;  // redrawn
      const double length = step.dot(towards);
      along += length * length;
      across += step.squaredNorm() - length * length;
    }
  }
  EXPECT_GT(along, 1.6 * across);
}

TEST(PartitionedFireworks, SearchAShiftedBoxAsTheBoxItself) {
  const auto asked = [](double shift) {
    const Problem valley =
        box_problem("valley", 2, shift - 8, shift + 8, shift + 2, [shift](const Vector& x) {
          const double a = x[0] - shift, b = x[1] - shift;
          return (a - 1) * (a - 1) + 100 * (b - a) * (b - a);
        });
    return asked_points(valley, partitioned_fireworks("fwassp"), 3000);
  };
  const std::vector<Vector> here = asked(0), there = asked(32);
  ASSERT_EQ(here.size(), there.size());
  // The first generations, before rounding grows.
  for (std::size_t i = 0; i < 600; ++i) {
    EXPECT_LT((here[i] + Vector::Constant(2, 32) - there[i]).norm(), 1e-9) << i;
  }
}

TEST(PartitionedFireworks, TurnAlongAValley) {
  const Problem valley = box_problem("valley", 5, -100, 100, 40, [](const Vector& x) {
    return x[0] * x[0] + 1e4 * (x.array() - x[0]).square().sum();
  });
  EXPECT_LT(end_of(valley, partitioned_fireworks("fwassp"), 60000, 1), 1e-3);
}

TEST(PartitionedFireworks, BeginAnewWhereAllSparksAreTied) {
  const Problem problem = plateau(1);
  const std::vector<Vector> asked =
      asked_points(problem, partitioned_fireworks("fwassp", {.sparks = 10}), 5 + 50 + 5 + 50, 0);
  const double near = 0.3 * (problem.upper[0] - problem.lower[0]);
  // Each of the five is drawn anew after its sparks, and they lie about it.
  for (std::ptrdiff_t i = 0; i < 5; ++i) {
    const double at = asked.begin()[55 + i][0];
    const Sparks first = asked.begin() + 60 + 10 * i;
    EXPECT_GE(std::count_if(first, first + 10,
                            [&](const Vector& x) { return std::abs(x[0] - at) < near; }),
              6)
        << i;
  }
}

template <class Options>
void expect_refused(Solver (*make)(std::string, const Options&),
                    const std::vector<Options>& refused) {
  for (const Options& options : refused) {
    EXPECT_THROW(make("refused", options), std::invalid_argument) << &options - &refused[0];
  }
}

TEST(Successors, RefuseOptionsThatMakeNoSense) {
  const AmplitudeSteps growing{1.2, 1.1};
  expect_refused<DynamicFireworksOptions>(
      dynamic_fireworks,
      {{.fireworks = 0}, {.amplitude = -1}, {.counts = {.sparks = 5}}, {.steps = growing}});
  expect_refused<BareBonesFireworksOptions>(bare_bones_fireworks,
                                            {{.sparks = 0}, {.steps = growing}});
  expect_refused<LoserOutFireworksOptions>(loser_out_fireworks, {{.fireworks = 0},
                                                                 {.sparks = 0},
                                                                 {.guiding_share = 1.5},
                                                                 {.guiding_sparks = 0},
                                                                 {.reach = -1},
                                                                 {.steps = growing}});
  expect_refused<PartitionedFireworksOptions>(
      partitioned_fireworks,
      {{.fireworks = 0}, {.sparks = 0}, {.initial_scale = 0}, {.patience = 0}});
}

}  // namespace
}  // namespace ricochet::fireworks
