#include "src/report/table.h"

#include "src/report/json.h"
#include "tests/support/golden.h"
#include "tests/support/numbers.h"

namespace ricochet {
namespace {

/// Runs of two solvers on two problems.
Table runs() {
  Table table{"runs",
              {{"solver"}, {"problem"}, {"gap", "gap [m/s]", ".2f"}, {"solved", "", ".0%"}}};
  table.add("b", "p", 2.5, true);
  table.add("a", "p", 1.25, false);
  table.add("b", "q", std::nullopt, false);
  table.add("a", "q", infinity, true);
  return table;
}

std::vector<std::string> column(const Table& table, const std::string& name) {
  std::vector<std::string> texts;
  each_row(table, [&](const Row& row) { texts.push_back(text_of(row[name])); });
  return texts;
}

TEST(Table, WritesNumbersAsTheFormatSays) {
  for (const auto& [value, format, text] : {std::tuple{value_of(0.1254), ".1%", "12.5"},
                                            {value_of(0.00125), ".3gm", "1.25"},
                                            {value_of(-1e-9), ".2f", "0.00"},
                                            {value_of(3), ".1f", "3.0"},
                                            {value_of(3), "", "3"},
                                            {value_of(1.0 / 3), "", "0.3333"},
                                            {value_of(true), "", "yes"},
                                            {value_of(false), "", "no"},
                                            {value_of(true), "mark", "✓"},
                                            {value_of(false), "mark", "✗"},
                                            {value_of(std::optional<double>()), "", ""},
                                            {value_of(quiet_nan), "", ""},
                                            {value_of(-infinity), "", ""}}) {
    EXPECT_EQ(text_of(value, format), text);
  }
  EXPECT_THROW(static_cast<void>(text_of(value_of(1.5), "d")), std::logic_error);
}

TEST(Table, RefusesRowsAndColumnsThatDoNotFit) {
  Table table = runs();
  EXPECT_THROW(table.add("c"), std::logic_error);
  EXPECT_THROW(static_cast<void>(table[0]["cost"]), std::logic_error);
  EXPECT_THROW(static_cast<void>(table[0].number("solver")), std::logic_error);
  EXPECT_THROW(static_cast<void>(table[2].number("gap")), std::logic_error);
  EXPECT_THROW(static_cast<void>(table[0].text("gap")), std::logic_error);
}

TEST(Table, KeepsRowsAndSortsThem) {
  EXPECT_EQ(column(where(runs(), "solver", value_of("a")), "problem"),
            (std::vector<std::string>{"p", "q"}));
  EXPECT_EQ(where(runs(), [](const Row& row) { return row.is("solved"); }).rows.size(), 2U);
  EXPECT_THAT(column(sorted(runs(), {"solver", "-problem"}), "problem"),
              ElementsAre("q", "p", "q", "p"));
  EXPECT_THAT(column(sorted(runs(), {"gap"}), "gap"), ElementsAre("1.25", "2.5", "", ""));
  EXPECT_THAT(column(sorted(runs(), {"-gap"}), "gap"), ElementsAre("2.5", "1.25", "", ""));
}

TEST(Table, AggregatesGroupsInTheOrderOfTheirFirstRows) {
  const Table groups = aggregated(runs(), {"solver"},
                                  {{{"runs"}, "", count_of},
                                   {{"gap"}, "gap", median_of},
                                   {{"share"}, "solved", mean_of},
                                   {{"solved"}, "solved", sum_of},
                                   {{"all"}, "gap", sum_of},
                                   {{"none"}, "problem", sum_of}});
  EXPECT_EQ(csv_of(groups),
            "solver,runs,gap,share,solved,all,none\nb,2,2.5,0.5,1,2.5,0\na,2,1.25,0.5,1,1.25,0\n");
}

TEST(Table, AggregatesAsSortingByHandDoes) {
  std::mt19937 random(7);
  Table table{"numbers", {{"group"}, {"x"}}};
  std::vector<std::vector<double>> groups(3);
  for (int i = 0; i < 300; ++i) {
    const std::size_t group = random() % 3;
    groups[group].push_back(static_cast<double>(random() % 100));
    table.add(static_cast<int>(group), groups[group].back());
  }
  const Table medians = aggregated(
      table, {"group"},
      {{{"median"}, "x", median_of}, {{"least"}, "x", least_of}, {{"most"}, "x", most_of}});
  ASSERT_EQ(medians.rows.size(), 3U);
  each_row(medians, [&](const Row& row) {
    auto& own = groups[static_cast<std::size_t>(row.number("group"))];
    std::ranges::sort(own);
    // The quantile of Hyndman and Fan's type 2, American Statistician 50 (1996) 361.
    const double middle = (own[(own.size() - 1) / 2] + own[own.size() / 2]) / 2;
    EXPECT_EQ(row.number("median"), middle);
    EXPECT_EQ(row.number("least"), own.front());
    EXPECT_EQ(row.number("most"), own.back());
  });
}

TEST(Table, JoinsTheFirstMatch) {
  Table kinds{"kinds", {{"solver"}, {"kind"}}};
  kinds.add("a", "local");
  kinds.add("a", "again");
  EXPECT_THAT(column(joined(runs(), kinds, {"solver"}), "kind"),
              ElementsAre("", "local", "", "local"));
}

TEST(Table, IsWrittenAsCsvLatexMarkdownAndText) {
  Table table = runs();
  table.columns[0].title = "the solver";
  table.add("c|_%", "r,s", 1.0 / 3, true);
  std::string all = markdown_of(table);
  for (const std::string& text : {markdown_of(table, 1), csv_of(table), latex_of(table),
                                  terminal_text_of(table), terminal_text_of(table, 18)}) {
    all += "\n```text\n" + text + "```\n";
  }
  expect_golden(all, "table.md");
}

/// The head once and the rows batch by batch are the same file as all at once.
TEST(Table, IsWrittenInBatches) {
  Table first = runs(), rest = runs();
  first.rows.resize(1);
  rest.rows.erase(rest.rows.begin());
  const auto in_batches = [&](const auto& write) {
    return write(first, Lines::head) + write(first, Lines::rows) + write(rest, Lines::rows);
  };
  const auto csv = [](const Table& t, Lines lines) { return csv_of(t, lines); };
  const auto markdown = [](const Table& t, Lines lines) { return markdown_of(t, SIZE_MAX, lines); };
  const auto latex = [](const Table& t, Lines lines) { return latex_of(t, lines); };
  EXPECT_EQ(in_batches(csv), csv_of(runs()));
  EXPECT_EQ(in_batches(markdown), markdown_of(runs()));
  EXPECT_THAT(latex_of(runs()),
              HasSubstr(in_batches(latex).substr(latex_of(first, Lines::head).size())));
}

TEST(Table, HasExactNumbersAndNoLabelThatIsReadAsMissingInCsv) {
  std::mt19937_64 random(3);
  Table table{"numbers", {{"x"}, {"name"}}};
  for (int k = 0; k < 1000; ++k) {
    const double number = std::bit_cast<double>(random());
    table.rows = {{number, std::string("nan")}};
    const std::string row = csv_of(table, Lines::rows);
    const double read = std::strtod(row.c_str(), nullptr);
    EXPECT_TRUE(read == number || std::isnan(number)) << row;
    EXPECT_THAT(row, EndsWith(",missing-value\n"));
  }
  table.rows = {{-infinity, std::string("two\nlines")}};
  EXPECT_EQ(csv_of(table, Lines::rows), "-inf,two\\x0alines\n");
}

TEST(Table, IsAListOfObjectsInJson) {
  const report::Json rows = json_rows_of(runs());
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows[0].dump(), R"({"solver":"b","problem":"p","gap":2.5,"solved":true})");
  EXPECT_TRUE(rows[2]["gap"].is_null());
  EXPECT_TRUE(rows[3]["gap"].is_null());
}

}  // namespace
}  // namespace ricochet
