#include <gtest/gtest.h>

#include "src/report/site/machine_page.h"
#include "tests/report/site/made_up_reports.h"

namespace ricochet::site {
namespace {

FoundReport with_grid() {
  FoundReport report = made_up("comparison", Json::object(), "comparison", {"across"});
  report.pages[0].data = {
      {"machines",
       {{{"family", "count-machines"}},
        {{"family", "top-speed-machines"},
         {"column", "disturbance"},
         {"columns", {{{"level", "0"}}, {{"level", "0.1"}}}},
         {"known", {{{"machine", "friction 0.4, restitution 0.5"}, {"cells", {4.5, nullptr}}}}}}}}};
  return report;
}

TEST(MachineGrid, HasTheThresholdOfAMachineWithAnotherRestitution) {
  const auto grid = machine_grid({with_grid()});
  ASSERT_TRUE(grid);
  const PaperMachine machine{"C4", 0.9, 0.4, 0, 3, 3.5, 3.1};
  EXPECT_EQ(with_restitution(*grid, machine, 0.5), 4.5);
  EXPECT_FALSE(with_restitution(*grid, machine, 0.6));
  EXPECT_FALSE(with_restitution(*grid, {"C8", 0.9, 0.4, 0.1, 3, 3.5, 3}, 0.5));
  EXPECT_FALSE(machine_grid({made_up("comparison", Json::object(), "comparison")}));
}

}  // namespace
}  // namespace ricochet::site
