#include <gtest/gtest.h>

#include "src/report/chart.h"

namespace ricochet::report {
namespace {

TEST(ColumnLabels, AreTheTitlesForASheetOfStyle) {
  EXPECT_EQ(column_labels({"a", "b < c", "the \"best\"", "d\\e", "f;"}),
            R"(--1:"a";--2:"b < c";--3:"the \"best\"";--4:"d\\e";--5:"f;";)");
}

TEST(ColumnLabels, AreNotNeededByFewColumns) {
  EXPECT_EQ(column_labels({"a", "b", "c"}), "");
}

}  // namespace
}  // namespace ricochet::report
