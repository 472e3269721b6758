#include "src/report/site/machine_page.h"

#include <gmock/gmock.h>

#include <filesystem>

#include "tests/report/site/made_up_reports.h"

namespace ricochet::site {
namespace {

TEST(MachinePage, HasTheThresholdsOfTheReferenceByConstants) {
  const auto reports = found_reports(std::filesystem::path(RICOCHET_SOURCE) / "reports/reference");
  const auto machines = paper_machines(reports);
  ASSERT_TRUE(machines);
  const OwnPage own = machine_page(*machines, reports);
  ASSERT_GE(own.page.sections.size(), 3U);
  const report::Table& grid = own.page.sections[0].tables.at(0);
  ASSERT_EQ(grid.rows.size(), 6U);
  EXPECT_EQ(grid.rows[4][0].text, row_label(0.4, 0.5));
  EXPECT_EQ(grid.rows[5][1].text, "C4, C8, C11");
  EXPECT_EQ(own.page.sections[0].figures.at(0).chart.series.size(), 4U)
      << "over the counting limit, without disturbance";
  const report::Table& table = own.page.sections[1].tables.at(0);
  ASSERT_EQ(table.rows.size(), machines->machines.size());
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const PaperMachine& machine = machines->machines[i];
    EXPECT_EQ(table.rows[i][0].text, machine.id);
    EXPECT_EQ(table.rows[i][6].text == "none given", !machine.paper_threshold) << machine.id;
  }
}

}  // namespace
}  // namespace ricochet::site
