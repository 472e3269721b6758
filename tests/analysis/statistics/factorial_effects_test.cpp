#include "src/analysis/statistics/factorial_effects.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace ricochet {
namespace {

using Levels = std::vector<std::size_t>;

const FactorialEffect& effect_of(const std::vector<FactorialEffect>& effects, const Levels& factors,
                                 const Levels& levels) {
  return *std::find_if(effects.begin(), effects.end(), [&](const FactorialEffect& effect) {
    return effect.factors == factors && effect.levels == levels;
  });
}

void expect_effect(const FactorialEffect& effect, double size, double lower, double upper) {
  EXPECT_NEAR(effect.effect, size, 1e-9);
  EXPECT_NEAR(effect.interval.lower, lower, 1e-6);
  EXPECT_NEAR(effect.interval.upper, upper, 1e-6);
}

/// A pilot plant's yield at two temperatures, concentrations and catalysts, the first changing
/// fastest, in two runs each: Box, Hunter and Hunter (Statistics for Experimenters, second edition
/// 2005, chapter 5, ISBN 978-0-471-71813-0). For want of other units the first runs are taken for
/// one and the second runs for another.
const std::array<std::array<double, 8>, 2> yields = {
    {{59, 74, 50, 69, 50, 81, 46, 79}, {61, 70, 58, 67, 54, 85, 44, 81}}};

std::vector<Response> pilot_plant() {
  std::vector<Response> responses;
  for (std::size_t unit = 0; unit < 2; ++unit) {
    for (std::size_t run = 0; run < 8; ++run) {
      responses.push_back({{run % 2, run / 2 % 2, run / 4}, unit, yields[unit][run]});
    }
  }
  return responses;
}

TEST(FactorialEffects, AreHalfOfThosePublishedOfAPilotPlant) {
  const auto effects = factorial_effects(pilot_plant(), {2, 2, 2});
  EXPECT_EQ(effects.size(), 1U + 3 * 2 + 3 * 4);
  EXPECT_DOUBLE_EQ(effect_of(effects, {}, {}).effect, 64.25);
  EXPECT_DOUBLE_EQ(effect_of(effects, {0}, {1}).effect, 23 / 2.0);
  EXPECT_DOUBLE_EQ(effect_of(effects, {0}, {0}).effect, -23 / 2.0);
  EXPECT_DOUBLE_EQ(effect_of(effects, {1}, {1}).effect, -5 / 2.0);
  EXPECT_DOUBLE_EQ(effect_of(effects, {2}, {1}).effect, 1.5 / 2);
  EXPECT_DOUBLE_EQ(effect_of(effects, {0, 1}, {1, 1}).effect, 1.5 / 2);
  EXPECT_DOUBLE_EQ(effect_of(effects, {0, 2}, {1, 1}).effect, 10 / 2.0);
  EXPECT_DOUBLE_EQ(effect_of(effects, {0, 2}, {1, 0}).effect, -10 / 2.0);
  EXPECT_NEAR(effect_of(effects, {1, 2}, {1, 1}).effect, 0, 1e-12);
}

TEST(FactorialEffects, AreExactlyZeroWhereNothingDiffers) {
  std::vector<Response> responses = pilot_plant();
  for (Response& response : responses) response.value = 0.7;
  for (const FactorialEffect& effect : factorial_effects(responses, {2, 2, 2})) {
    if (effect.factors.empty()) continue;
    EXPECT_EQ(effect.effect, 0);
    EXPECT_EQ(effect.interval.lower, 0);
    EXPECT_EQ(effect.interval.upper, 0);
  }
}

TEST(FactorialEffects, HaveTheIntervalComputedByHand) {
  // Temperature has 24.5 as its effect among the first runs and 21.5 among the second, so that the
  // halves have the mean 11.5 and the standard error 0.75; Student's quantile is 12.7062.
  const auto effects = factorial_effects(pilot_plant(), {2, 2, 2});
  const FactorialEffect& temperature = effect_of(effects, {0}, {1});
  EXPECT_NEAR(temperature.interval.lower, 11.5 - 12.7062047 * 0.75, 1e-6);
  EXPECT_NEAR(temperature.interval.upper, 11.5 + 12.7062047 * 0.75, 1e-6);
}

/// Some cells missing in each unit, some there twice.
std::vector<Response> unbalanced() {
  std::vector<Response> responses;
  for (std::size_t g = 0; g < 6; ++g) {
    for (std::size_t a = 0; a < 3; ++a) {
      for (std::size_t b = 0; b < 2; ++b) {
        for (std::size_t c = 0; c < 2; ++c) {
          if ((7 * a + 5 * b + 3 * c + g) % 5 == 0) continue;
          for (std::size_t r = 0; r < ((a + b + c + g) % 4 == 0 ? 2U : 1U); ++r) {
            const std::size_t value =
                13 * a * a + 7 * b + 3 * c * a + 5 * g * b + 11 * a * b + 2 * r + g * g;
            responses.push_back({{a, b, c}, g, static_cast<double>(value % 17)});
          }
        }
      }
    }
  }
  return responses;
}

/// Figures of NumPy's lstsq on the rows themselves, with each unit left out in turn.
TEST(FactorialEffects, AreThoseOfLeastSquaresFromAnUnbalancedGrid) {
  const auto effects = factorial_effects(unbalanced(), {3, 2, 2});
  expect_effect(effect_of(effects, {}, {}), 8.2393837424, 6.7259255335, 9.7528419514);
  expect_effect(effect_of(effects, {0}, {2}), -0.6143837424, -3.5504859311, 2.3217184462);
  expect_effect(effect_of(effects, {1}, {0}), -1.2334018956, -2.7406498004, 0.2738460091);
  expect_effect(effect_of(effects, {0, 1}, {0, 1}), 0.6113268386, -2.5416067185, 3.7642603956);
  expect_effect(effect_of(effects, {0, 2}, {2, 0}), -0.1442028986, -1.4546469607, 1.1662411636);
  expect_effect(effect_of(effects, {1, 2}, {1, 1}), -1.1287608868, -2.9227477104, 0.6652259368);
}

TEST(FactorialEffects, AreThoseThatMadeTheResponsesAndSumToZero) {
  // Without noise, by their definition: what is added to each cell is found again.
  const Levels levels = {4, 3};
  const std::array<double, 4> first = {3, -1, -4, 2};
  const std::array<double, 3> second = {0.5, 1, -1.5};
  std::vector<Response> responses;
  for (std::size_t unit = 0; unit < 5; ++unit) {
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (i == unit % 4 && k == unit % 3) continue;
        const double together = (i == 0 ? 3.0 : -1.0) * (k == 0 ? 2.0 : -1.0);
        responses.push_back({{i, k}, unit, 7 + first[i] + second[k] + together});
      }
    }
  }
  const auto effects = factorial_effects(responses, levels);
  expect_effect(effect_of(effects, {}, {}), 7, 7, 7);
  for (std::size_t i = 0; i < 4; ++i) {
    expect_effect(effect_of(effects, {0}, {i}), first[i], first[i], first[i]);
    for (std::size_t k = 0; k < 3; ++k) {
      const double together = (i == 0 ? 3.0 : -1.0) * (k == 0 ? 2.0 : -1.0);
      expect_effect(effect_of(effects, {0, 1}, {i, k}), together, together, together);
    }
  }
}

TEST(FactorialEffects, RefuseWhatDoesNotFit) {
  const std::vector<Response> plant = pilot_plant();
  EXPECT_THROW(factorial_effects(plant, {2, 2}), std::invalid_argument);
  EXPECT_THROW(factorial_effects(plant, {2, 1, 2}), std::invalid_argument);
  EXPECT_THROW(factorial_effects(plant, {2, 2, 2}, 1), std::invalid_argument);
  EXPECT_THROW(factorial_effects(plant, {3, 2, 2}), std::invalid_argument);  // a level is missing
  EXPECT_THROW(factorial_effects({plant.begin(), plant.begin() + 8}, {2, 2, 2}),
               std::invalid_argument);  // one unit
  EXPECT_THROW(factorial_effects({plant.begin(), plant.begin() + 9}, {2, 2, 2}),
               std::invalid_argument);  // nothing follows without the first
  EXPECT_THROW(factorial_effects({}, {2, 2}), std::invalid_argument);
  EXPECT_THROW(factorial_effects({{{0}, 0, std::nan("")}}, {2}), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet
