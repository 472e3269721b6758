#include "src/studies/trials/all_trials.h"

#include <gtest/gtest.h>

#include <set>

#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/paper/fitted_reading.h"

namespace ricochet::studies::trials {
namespace {

using namespace carrier_track;

std::vector<Trial> trials_and_baselines() {
  std::vector<Trial> all = baselines();
  for (Trial& trial : all_trials()) all.push_back(std::move(trial));
  return all;
}

const Trial& called(const std::string& name) {
  static const std::vector<Trial> all = trials_and_baselines();
  for (const Trial& trial : all) {
    if (trial.name == name) return trial;
  }
  throw std::out_of_range(name);
}

int count_of(const Trial& trial, const TrialConstants& constants, const char* id, double omega) {
  return trial.counts(find_case(id), constants, judging)(omega);
}

/// The constants of the default reading, whatever a trial begins at.
TrialConstants fitted(const Trial& trial) {
  TrialConstants constants = start_of(trial);
  constants.base = default_reading().constants;
  return constants;
}

TEST(AllTrials, HaveNamesOfTheirOwnAndBeginWithinTheirBounds) {
  std::set<std::string> names;
  for (const Trial& trial : trials_and_baselines()) {
    EXPECT_TRUE(names.insert(trial.name).second) << trial.name;
    EXPECT_EQ(trial.description.back(), '.') << trial.name;
    EXPECT_EQ(trial.own.size(), start_of(trial).own.size());
    for (const OpenConstant& own : trial.own) {
      EXPECT_LE(own.lower, own.natural.value()) << trial.name;
      EXPECT_GE(own.upper, own.natural.value()) << trial.name;
      EXPECT_FALSE(own.why.empty());
    }
  }
}

TEST(AllTrials, AreMeasuredByTheCountsOfTheEventDrivenModel) {
  const Trial& nothing = called("nothing");
  const TrialConstants constants = fitted(nothing);
  for (const Case& a_case : all_cases()) {
    const Scene scene = scene_of(a_case, nothing.base, constants.base);
    for (double omega = 0.2; omega < 18; omega += 0.7) {
      EXPECT_EQ(count_of(nothing, constants, a_case.id.c_str(), omega), count_at(scene, omega));
    }
  }
}

TEST(AllTrials, HaveTheMisfitOfTheReadingWhereNothingIsChanged) {
  for (const char* name : {"nothing", "nothing-plain", "nothing-brief"}) {
    const Trial& nothing = called(name);
    EXPECT_EQ(misfit_of(nothing, fitted(nothing)),
              misfit(nothing.base, default_reading().constants))
        << name;
  }
}

TEST(AllTrials, AreTheReadingWhereTheirOwnConstantsMakeThemSo) {
  const Trial& nothing = called("nothing");
  const TrialConstants constants = fitted(nothing);
  const auto same_as_nothing = [&](const char* name, const TrialConstants& own, const char* id) {
    for (double omega = 0.5; omega < 18; omega += 1.3) {
      EXPECT_EQ(count_of(called(name), own, id, omega), count_of(nothing, constants, id, omega))
          << name << ' ' << omega;
    }
  };
  same_as_nothing("random-disturbance", fitted(called("random-disturbance")), "C1");
  TrialConstants far = fitted(called("heights-1mm"));
  far.base[static_cast<std::size_t>(Open::clearance)] = 1.9e-3;
  far.own = {0.99e-3};  // both walls lie within the wrong limits
  const int none = count_of(called("heights-1mm"), far, "C2", 5);
  far.own = {1.1e-3};  // the outer wall is high enough, the inner one too high
  const int outer = count_of(called("heights-1mm"), far, "C2", 5);
  far.base[static_cast<std::size_t>(Open::clearance)] = 2.1e-3;
  far.own = {0.95e-3};  // both walls count
  const int both = count_of(called("heights-1mm"), far, "C2", 5);
  EXPECT_GT(both, outer);
  EXPECT_GT(both, none);
}

TEST(AllTrials, HaveADisturbanceThatIsDrawnOnce) {
  const Trial& first = called("random-disturbance");
  const TrialConstants constants = fitted(first);
  const Trial again = random_disturbance(first.base, 1);
  const Trial other = random_disturbance(first.base, 2);
  bool differs = false;
  for (double omega = 0.5; omega < 18; omega += 0.5) {
    const int count = count_of(first, constants, "C10", omega);
    EXPECT_EQ(count_of(again, constants, "C10", omega), count);
    differs |= count_of(other, constants, "C10", omega) != count;
  }
  EXPECT_TRUE(differs);
}

TEST(AllTrials, StopCountingWhereASearchHasHeardEnough) {
  for (const char* name : {"nothing", "sampled-peaks-all", "heights-1mm", "ode45-default"}) {
    const Trial& trial = called(name);
    const Patience brief{3, 0.01};
    const int count = trial.counts(find_case("C2"), fitted(trial), brief)(8);
    EXPECT_LE(count, 4) << name;
  }
}

}  // namespace
}  // namespace ricochet::studies::trials
