#include "problems/carrier_track/questions/best_known.h"

#include <gtest/gtest.h>

#include <limits>

#include "problems/carrier_track/paper/fitted_reading.h"
#include "src/core/error.h"

namespace ricochet::carrier_track {
namespace {

Problem named(const std::string& name) {
  Problem problem;
  problem.name = name;
  return problem;
}

TEST(BestKnown, IsReadAsItWasWritten) {
  const double infinite = std::numeric_limits<double>::infinity();
  const BestValues values{"a-reading",
                          {{"count-C1", {3.0, Vector::Constant(1, 0.1), "a scan"}},
                           {"design-C2", {-1.0 / 3, Vector::LinSpaced(5, 0, 1e-7), "a solver"}},
                           {"robust-C3", {infinite, Vector(), "none"}}}};
  const BestValues read = parse_best_values(write_best_values(values), "text");
  EXPECT_EQ(read.reading, values.reading);
  ASSERT_EQ(read.of.size(), values.of.size());
  for (const auto& [name, best] : values.of) {
    EXPECT_EQ(read.of.at(name).value, best.value) << name;
    EXPECT_EQ(read.of.at(name).point, best.point) << name;
    EXPECT_EQ(read.of.at(name).provenance, best.provenance) << name;
  }
}

TEST(BestKnown, RefusesWhatIsNoSuchText) {
  for (const char* text :
       {"", "reading = 3", "reading = \"r\"\ncount-C1 = 3",
        "reading = \"r\"\n[count-C1]\nvalue = 1",
        "reading = \"r\"\n[count-C1]\nvalue = 1\nprovenance = \"p\"\npoint = [\"x\"]"}) {
    EXPECT_THROW(parse_best_values(text, "text"), InputError) << text;
  }
}

TEST(BestKnown, IsToldToTheProblemsOfItsReadingAlone) {
  const auto& [name, best] = *best_values().of.begin();
  Problem of_this = named(name);
  know_best(of_this, best_values().reading);
  EXPECT_EQ(of_this.best_known, best.value);
  EXPECT_EQ(*of_this.best_point, best.point);
  EXPECT_EQ(of_this.provenance, best.provenance);
  for (const char* other : {"", "another-reading"}) {
    Problem of_other = named(name);
    know_best(of_other, other);
    EXPECT_FALSE(of_other.best_known);
  }
}

TEST(BestKnown, IsOfTheDefaultReading) {
  EXPECT_EQ(best_values().reading, default_reading().name);
}

}  // namespace
}  // namespace ricochet::carrier_track
