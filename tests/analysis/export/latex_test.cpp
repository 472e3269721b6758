#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "src/analysis/export/formats.h"
#include "tests/analysis/export/exported_store.h"

namespace ricochet::exports {
namespace {

using testing::HasSubstr;
using testing::Not;
using Latex = ExportedStore;

TEST_F(Latex, HasARowForEveryCell) {
  write_latex(store, {}, out);
  int rows = 0;
  for (const std::string& line : lines_of(text_of(out / "table.tex"))) {
    if (!line.ends_with(" \\\\")) continue;
    ++rows;
    int separators = 0;
    for (std::size_t i = 1; i < line.size(); ++i)
      separators += line[i] == '&' && line[i - 1] != '\\';
    EXPECT_EQ(separators, 11) << line;
  }
  EXPECT_EQ(rows, 4 * 3 * 2 * 2 + 2) << "and the header, for the first page and the others";
}

TEST_F(Latex, ShowsNamesAsTheyAre) {
  write_latex(store, {}, out);
  EXPECT_THAT(text_of(out / "table.tex"),
              HasSubstr("a\\textbar{}b\\_c\\%d\\{e\\}\\textbackslash{}f\\#g\\$h\\&i"
                        "\\textasciitilde{}j\\textasciicircum{}k-{}-l & original"));
}

/// 2 of 4 runs solve it, after 3 and 5 evaluations, the others are charged 10 each: 28 / 2.
TEST_F(Latex, SaysWhatWasSolvedAtWhatCostAndWhatFailed) {
  for (int k = 0; k < 4; ++k) {
    RunRecord record;
    record.ledger.charged = 10;
    if (k < 2) record.trace = {{3 + 2 * k, 0.1, {0.001, 0}, Vector::Zero(5)}};
    if (k == 2) record.trace = {{4, 0.1, {2, 0}, Vector::Zero(5)}};
    if (k == 3) record.failure = "thrown";
    add({{"profile/5", "*[a", "plain", "nlopt-cobyla", 7, "n"}, k, 0}, record);
  }
  write_latex(store, {}, out);
  EXPECT_THAT(lines_of(text_of(out / "table.tex")),
              testing::Contains(testing::AllOf(
                  testing::StartsWith("profile/5 & nlopt-cobyla & {*}{[}a & plain & n & 7 & 4 & 50 "
                                      "& 15 to 85 & 14 & "),
                  testing::EndsWith(" & 1 \\\\"))));
}

}  // namespace
}  // namespace ricochet::exports
