#include "src/research/calibration/variant_search.h"

#include <gtest/gtest.h>

#include "ricochet/solvers.h"

namespace ricochet::studies::calibration {
namespace {

using namespace carrier_track;
using namespace variants;

/// Its loss is made up: every count is the value of its own constant.
ModelVariant made_up_variant() {
  ModelVariant variant;
  variant.name = "made-up";
  variant.free = {Unknown::clearance, Unknown::phase};
  variant.own = {{"one", "", 1, 100, true, 10, "why"}, {"two", "", -1, 3, false, 0, "why"}};
  variant.counts = [](const Case&, const VariantConstants& constants,
                      const EarlyStopping&) -> CountAt {
    return [own = constants.own](double) { return static_cast<int>(own[0]); };
  };
  return variant;
}

Search brief_search() {
  return {solver_named("pagmo-cmaes-ipop"), {}, solver_named("nlopt-sbplx"), 45, 1};
}

TEST(VariantSearch, MovesFreedAndOwnConstantsWithinTheirBounds) {
  const Problem problem = variant_problem(made_up_variant());
  ASSERT_EQ(problem.dimension(), 4);
  EXPECT_EQ(problem.variables[1].name, "phase");
  EXPECT_EQ(problem.variables[2].name, "one");
  EXPECT_DOUBLE_EQ(problem.start[2], 0.5) << "10 is in the middle of 1 to 100";
  EXPECT_DOUBLE_EQ(problem.start[3], 0.25);
  const VariantConstants low = constants_at(made_up_variant(), problem.lower);
  const VariantConstants high = constants_at(made_up_variant(), problem.upper);
  EXPECT_DOUBLE_EQ(low.base[static_cast<std::size_t>(Unknown::clearance)], 5e-5);
  EXPECT_DOUBLE_EQ(high.base[static_cast<std::size_t>(Unknown::clearance)], 1e-2);
  EXPECT_DOUBLE_EQ(low.own[0], 1);
  EXPECT_DOUBLE_EQ(high.own[1], 3);
  const VariantConstants start = constants_at(made_up_variant(), problem.start);
  EXPECT_EQ(start.base[static_cast<std::size_t>(Unknown::pull)],
            start_of(made_up_variant()).base[static_cast<std::size_t>(Unknown::pull)]);
}

TEST(VariantSearch, FindsTheSameFromTheSameSeedAndIsNoWorseThanItsStart) {
  const ModelVariant variant = made_up_variant();
  const Fit one = fit(variant, brief_search());
  const Fit two = fit(variant, brief_search());
  EXPECT_EQ(one.own, two.own);
  EXPECT_EQ(one.loss, two.loss);
  EXPECT_EQ(one.loss, loss_of(variant, variant_constants(one)));
  EXPECT_LT(one.loss, loss_of(variant, start_of(variant)));
}

TEST(VariantSearch, AsksForWhatDecides) {
  const AskedFit asked = fit_task(made_up_variant(), brief_search()).asked.at(0);
  const auto differs = [&](const ModelVariant& variant, const Search& search) {
    const AskedFit other = fit_task(variant, search).asked.at(0);
    return other.name() != asked.name() || other.options != asked.options;
  };
  EXPECT_FALSE(differs(made_up_variant(), brief_search()));
  Search search = brief_search();
  search.evaluations = 46;
  EXPECT_TRUE(differs(made_up_variant(), search));
  search = brief_search();
  search.seed = 2;
  EXPECT_TRUE(differs(made_up_variant(), search));
  search = brief_search();
  search.local = search.global;
  EXPECT_TRUE(differs(made_up_variant(), search));
  ModelVariant variant = made_up_variant();
  variant.free.pop_back();
  EXPECT_TRUE(differs(variant, brief_search()));
  variant = made_up_variant();
  variant.own[0].upper = 101;
  EXPECT_TRUE(differs(variant, brief_search()));
  const Fit found = fit(made_up_variant(), brief_search());
  EXPECT_EQ(asked.loss(found), found.loss);
}

}  // namespace
}  // namespace ricochet::studies::calibration
