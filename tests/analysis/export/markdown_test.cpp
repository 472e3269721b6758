#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "src/analysis/export/formats.h"
#include "tests/analysis/export/exported_store.h"

namespace ricochet::exports {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using Markdown = ExportedStore;

TEST_F(Markdown, HasARowForEveryCell) {
  write_markdown(store, {}, out);
  int rows = 0;
  for (const std::string& line : lines_of(text_of(out / "table.md"))) {
    if (!line.starts_with("| ")) continue;
    ++rows;
    int bars = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
      bars += line[i] == '|' && (i == 0 || line[i - 1] != '\\');
    }
    EXPECT_EQ(bars, 13) << line;
  }
  EXPECT_EQ(rows, 4 * 3 * 2 * 2 + 1) << "and the header";
}

/// As in the table for LaTeX: 28 evaluations for 2 successes, and one run failed.
TEST_F(Markdown, SaysWhatWasSolvedAtWhatCostAndWhatFailed) {
  for (int k = 0; k < 4; ++k) {
    RunRecord record;
    record.ledger.charged = 10;
    if (k < 2) record.trace = {{3 + 2 * k, 0.1, {0.001, 0}, Vector::Zero(5)}};
    if (k == 2) record.trace = {{4, 0.1, {2, 0}, Vector::Zero(5)}};
    if (k == 3) record.failure = "thrown";
    add({{"profile/5", "*a*", "plain", "nlopt-cobyla", 7, "n"}, k, 0}, record);
  }
  write_markdown(store, {}, out);
  const std::string text = text_of(out / "table.md");
  const std::string begin =
      "| profile/5 | nlopt-cobyla | \\*a\\* | plain | n | 7 | 4 | 50 | 15 to 85 | 14 | ";
  ASSERT_THAT(text, HasSubstr(begin));
  const std::string rest = text.substr(text.find(begin));
  EXPECT_THAT(rest.substr(0, rest.find('\n')), EndsWith(" | 1 |"));
}

}  // namespace
}  // namespace ricochet::exports
