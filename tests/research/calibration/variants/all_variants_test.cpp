#include "src/research/calibration/variants/all_variants.h"

#include <gtest/gtest.h>

#include <set>

#include "problems/carrier_track/counting/threshold.h"
#include "src/research/paper/fitted_interpretation.h"

namespace ricochet::studies::variants {
namespace {

using namespace carrier_track;

std::vector<ModelVariant> variants_and_baselines() {
  std::vector<ModelVariant> all = baselines();
  for (ModelVariant& variant : all_variants()) all.push_back(std::move(variant));
  return all;
}

const ModelVariant& called(const std::string& name) {
  static const std::vector<ModelVariant> all = variants_and_baselines();
  for (const ModelVariant& variant : all) {
    if (variant.name == name) return variant;
  }
  throw std::out_of_range(name);
}

int count_of(const ModelVariant& variant, const VariantConstants& constants, const char* id,
             double omega) {
  return variant.counts(find_case(id), constants, judging)(omega);
}

/// The constants of the default interpretation, whatever a variant begins at.
VariantConstants fitted(const ModelVariant& variant) {
  VariantConstants constants = start_of(variant);
  constants.base = default_interpretation().constants;
  return constants;
}

TEST(AllVariants, HaveNamesOfTheirOwnAndBeginWithinTheirBounds) {
  std::set<std::string> names;
  for (const ModelVariant& variant : variants_and_baselines()) {
    EXPECT_TRUE(names.insert(variant.name).second) << variant.name;
    EXPECT_EQ(variant.description.back(), '.') << variant.name;
    EXPECT_EQ(variant.own.size(), start_of(variant).own.size());
    for (const UnknownParameter& own : variant.own) {
      EXPECT_LE(own.lower, own.natural.value()) << variant.name;
      EXPECT_GE(own.upper, own.natural.value()) << variant.name;
      EXPECT_FALSE(own.why.empty());
    }
  }
}

TEST(AllVariants, AreMeasuredByTheCountsOfTheEventDrivenModel) {
  const ModelVariant& nothing = called("nothing");
  const VariantConstants constants = fitted(nothing);
  for (const Case& a_case : all_cases()) {
    const Scene scene = scene_of(a_case, nothing.base, constants.base);
    for (double omega = 0.2; omega < 18; omega += 0.7) {
      EXPECT_EQ(count_of(nothing, constants, a_case.id.c_str(), omega), count_at(scene, omega));
    }
  }
}

TEST(AllVariants, HaveTheLossOfTheInterpretationWhereNothingIsChanged) {
  for (const char* name : {"nothing", "nothing-plain", "nothing-brief"}) {
    const ModelVariant& nothing = called(name);
    EXPECT_EQ(loss_of(nothing, fitted(nothing)),
              loss(nothing.base, default_interpretation().constants))
        << name;
  }
}

TEST(AllVariants, AreTheInterpretationWhereTheirOwnConstantsMakeThemSo) {
  const ModelVariant& nothing = called("nothing");
  const VariantConstants constants = fitted(nothing);
  const auto same_as_nothing = [&](const char* name, const VariantConstants& own, const char* id) {
    for (double omega = 0.5; omega < 18; omega += 1.3) {
      EXPECT_EQ(count_of(called(name), own, id, omega), count_of(nothing, constants, id, omega))
          << name << ' ' << omega;
    }
  };
  same_as_nothing("random-disturbance", fitted(called("random-disturbance")), "C1");
  VariantConstants far = fitted(called("heights-1mm"));
  far.base[static_cast<std::size_t>(Unknown::clearance)] = 1.9e-3;
  far.own = {0.99e-3};  // both walls lie within the wrong limits
  const int none = count_of(called("heights-1mm"), far, "C2", 5);
  far.own = {1.1e-3};  // the outer wall is high enough, the inner one too high
  const int outer = count_of(called("heights-1mm"), far, "C2", 5);
  far.base[static_cast<std::size_t>(Unknown::clearance)] = 2.1e-3;
  far.own = {0.95e-3};  // both walls count
  const int both = count_of(called("heights-1mm"), far, "C2", 5);
  EXPECT_GT(both, outer);
  EXPECT_GT(both, none);
}

TEST(AllVariants, HaveADisturbanceThatIsDrawnOnce) {
  const ModelVariant& first = called("random-disturbance");
  const VariantConstants constants = fitted(first);
  const ModelVariant again = random_disturbance(first.base, 1);
  const ModelVariant other = random_disturbance(first.base, 2);
  bool differs = false;
  for (double omega = 0.5; omega < 18; omega += 0.5) {
    const int count = count_of(first, constants, "C10", omega);
    EXPECT_EQ(count_of(again, constants, "C10", omega), count);
    differs |= count_of(other, constants, "C10", omega) != count;
  }
  EXPECT_TRUE(differs);
}

TEST(AllVariants, StopCountingWhereASearchHasHeardEnough) {
  for (const char* name : {"nothing", "sampled-peaks-all", "heights-1mm", "ode45-default"}) {
    const ModelVariant& variant = called(name);
    const EarlyStopping brief{3, 0.01};
    const int count = variant.counts(find_case("C2"), fitted(variant), brief)(8);
    EXPECT_LE(count, 4) << name;
  }
}

}  // namespace
}  // namespace ricochet::studies::variants
