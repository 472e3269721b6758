#include "problems/carrier_track/suite/best_known.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "problems/carrier_track/suite/machine.h"
#include "ricochet/error.h"
#include "src/core/instance.h"

namespace ricochet::carrier_track {
namespace {

Problem named(const std::string& name) {
  Problem problem;
  problem.name = name;
  return problem;
}

TEST(BestKnown, IsReadAsItWasWritten) {
  const double infinite = std::numeric_limits<double>::infinity();
  const BestValues values{"0123456789abcdef",
                          {{"count-C1", {3.0, Vector::Constant(1, 0.1), "a scan"}},
                           {"design-C2", {-1.0 / 3, Vector::LinSpaced(5, 0, 1e-7), "a solver"}},
                           {"robust-C3", {infinite, Vector(), "none"}}}};
  const BestValues read = parse_best_values(write_best_values(values), "text");
  EXPECT_EQ(read.machine, values.machine);
  ASSERT_EQ(read.of.size(), values.of.size());
  for (const auto& [name, best] : values.of) {
    EXPECT_EQ(read.of.at(name).value, best.value) << name;
    EXPECT_EQ(read.of.at(name).point, best.point) << name;
    EXPECT_EQ(read.of.at(name).provenance, best.provenance) << name;
  }
}

TEST(BestKnown, RefusesWhatIsNoSuchText) {
  for (const char* text :
       {"", "machine = 3", "machine = \"m\"\ncount-C1 = 3",
        "machine = \"m\"\n[count-C1]\nvalue = 1",
        "machine = \"m\"\n[count-C1]\nvalue = 1\nprovenance = \"p\"\npoint = [\"x\"]"}) {
    EXPECT_THROW(parse_best_values(fmt::format("suite = {}\n{}", suite_version, text), "text"),
                 InputError)
        << text;
  }
}

TEST(BestKnown, RefusesBestValuesOfAnotherVersionOfTheSuite) {
  for (const char* text : {"interpretation = \"r\"", "suite = 1\nmachine = \"m\""}) {
    try {
      parse_best_values(text, "best_known.toml");
      FAIL() << text;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::StartsWith("best_known.toml: best values of version 1"));
    }
  }
  EXPECT_NO_THROW(
      parse_best_values(fmt::format("suite = {}\nmachine = \"m\"", suite_version), "text"));
}

TEST(BestKnown, IsToldToTheProblemsOfItsMachineAlone) {
  const auto& [name, best] = *best_values().of.begin();
  Problem of_this = named(name);
  know_best(of_this, best_values().machine);
  EXPECT_EQ(of_this.best_known, best.value);
  EXPECT_EQ(*of_this.best_point, best.point);
  EXPECT_EQ(of_this.provenance, best.provenance);
  for (const char* other : {"", "0123456789abcdef"}) {
    Problem of_other = named(name);
    know_best(of_other, other);
    EXPECT_FALSE(of_other.best_known);
  }
}

TEST(BestKnown, IsOfTheDefaultMachine) {
  EXPECT_EQ(best_values().machine, default_machine_hash());
}

}  // namespace
}  // namespace ricochet::carrier_track
