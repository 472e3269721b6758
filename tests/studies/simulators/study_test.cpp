#include "src/studies/simulators/study.h"

#include "problems/carrier_track/scene/contact_law.h"
#include "ricochet/error.h"
#include "src/core/files.h"
#include "src/studies/simulators/suite.h"
#include "tests/studies/pages.h"
#include "tests/support/files.h"
#include "tests/support/test.h"

namespace ricochet::studies::simulators {
namespace {

using testing::Ge;
using testing::Le;

/// A tool that says that nothing ever strikes a wall, but for one kind of scenes, which it cannot
/// express.
Tool quiet_tool(const fs::path& folder) {
  Tool tool = own_tool("quiet=sh " + (folder / "quiet.sh").string());
  write_file(folder / "quiet.sh", R"(while read -r line; do case $line in
*'"plastic"'*) echo '{"cannot":"e = 0"}';;
*) echo '{"impacts":[],"seconds":0.25}';;
esac; done
)");
  return tool;
}

report::Results losses_of(const Plan& plan) {
  report::Results results;
  add_losses(results, plan);
  return results;
}

TEST(Losses, CompareEverybody) {
  const ScratchFolder folder;
  const auto out = folder.path() / "out";
  const report::Results all =
      losses_of({1, 44, 44, {Level::usual}, {quiet_tool(folder.path())}, false, out});
  EXPECT_EQ(text_of(*all.value("lost")), "0");
  EXPECT_THAT(text_of(*all.value("losses-finding")), HasSubstr("the worst, "));
  const Table& table = *all.table("simulators");
  EXPECT_EQ(table[0].text("simulator"), "ricochet");
  const Row quiet = row_of(table, "simulator", "quiet");
  EXPECT_EQ(quiet.number("missed"), 1000);
  EXPECT_EQ(quiet.number("invented"), 0);
  EXPECT_GT(quiet.number("ratio"), 100);
  EXPECT_EQ(quiet.text("reasons"), "e = 0");
  EXPECT_EQ(row_of(*all.table("levels"), "simulator", "quiet").number("cannot"), 4);
  EXPECT_EQ(all.table("kinds")->rows.size(), scene_kinds().size());
  each_row(*all.table("kinds"), [](const Row& kind) { EXPECT_EQ(kind.number("scenes"), 4); });
  // Every simulator at every level is a dot of its kind, with its name at the level that is shown.
  std::size_t dots = 0;
  for (const report::Series& series : all.chart("speed-accuracy")->series)
    if (!series.pale) dots += series.samples.size();
  EXPECT_EQ(dots, table.rows.size());
  EXPECT_EQ(all.table("levels")->rows.size(), table.rows.size());
  // One impact is enough to break it, and the scene is kept.
  EXPECT_EQ(row_of(*all.table("smallest-scenes"), "tool", "quiet").number("missed"), 1);
  EXPECT_TRUE(fs::exists(out / "smallest" / "quiet.jsonl"));
  EXPECT_EQ(lines_of(text_of(out / "scenes.jsonl")).size(), 44U);
}

TEST(Losses, NameTheMethodsAndToolsThatAreMissing) {
  const ScratchFolder folder;
  const report::Results all = losses_of({1, 1, 1, {Level::loose}, {}, false, folder.path()});
  for (const char* name : {"cvode-adams", "cvode-bdf"}) {
    const auto rows = [&](const char* table, const char* column) {
      return where(*all.table(table), column, value_of(name)).rows.size();
    };
    EXPECT_EQ(rows("simulators", "simulator") + rows("missing", "tool"), 1U) << name;
  }
  Plan plan{
      1, 3, 3, {Level::usual}, {own_tool("gone=no-such-program-at-all")}, false, folder.path()};
  const auto reason = [&plan] {
    const Table table = *losses_of(plan).table("missing");
    EXPECT_EQ(table.rows.size(), 1 + carrier_track::methods_not_built().size());
    return table[table.rows.size() - 1].text("reason");
  };
  EXPECT_THAT(reason(), HasSubstr("no such program"));
  plan.tools[0].source = (folder.path() / "driver").string();
  plan.tools[0].version = {"false"};
  EXPECT_THAT(reason(), HasSubstr("not installed"));
  plan.needs_all = true;
  EXPECT_THROW(losses_of(plan), InputError);
}

TEST(Laws, ReturnWhatTheirDampingSays) {
  // With D = 1.35, D (1 + e) = ln((1 + D) / (1 - e D)).
  const double e = closed_return(carrier_track::ContactLaw::hunt_crossley, 0.1);
  EXPECT_GT(e, 0.5);
  EXPECT_NEAR(1.35 * (1 + e), std::log(2.35 / (1 - e * 1.35)), 1e-12);
  report::Results all;
  add_laws(all, 24);
  const Table& laws = *all.table("restitution");
  EXPECT_EQ(laws.rows.size(), 8U);
  each_row(laws, [](const Row& law) {
    EXPECT_LT(law.number("simulation_off"), 1e-7) << law.text("law");
    if (law.text("law") == "exact-restitution") {
      EXPECT_LT(law.number("off"), 1e-8);
    } else if (law.text("law") == "hertz") {
      EXPECT_NEAR(law.number("off"), 0.98, 1e-12) << "it returns all";
    }
  });
  EXPECT_EQ(text_of(*all.value("faithful")), "kelvin-voigt, exact-restitution");
}

TEST(Models, AgreeWhereNothingGivesOrCouples) {
  report::Results all;
  add_models(all, 3);
  const Table& walls = *all.table("walls");
  double before = 0;
  each_row(walls, [&](const Row& wall) {
    EXPECT_EQ(wall.number("compared") + wall.number("unfinished"), 72);
    EXPECT_GE(wall.number("share"), before) << "stiffer is nearer";
    before = wall.number("share");
  });
  EXPECT_GT(before, 0.95);
  EXPECT_LT(walls[0].number("share"), 0.5);
  // Without a lateral pull nothing couples, so that both directions count as one does.
  const Row alone = (*all.table("directions"))[0];
  EXPECT_EQ(alone.number("lateral"), 0);
  EXPECT_EQ(alone.number("equal"), 72);
  ASSERT_EQ(all.chart("models")->series.size(), 4U);
  EXPECT_EQ(all.chart("models")->series[2].samples.size(), walls.rows.size());
}

TEST(StiffWalls, GiveEnergyFromAboutTheBoundOfLinearTheory) {
  report::Results all;
  add_stiff_walls(all, 2);
  int fixed = 0, adaptive = 0;
  each_row(*all.table("stiff-walls"), [&](const Row& method) {
    if (const auto bound = method.number_if("bound")) {
      EXPECT_THAT(method.number("lowest_bad"), AllOf(Ge(0.5 * *bound), Le(2 * *bound)));
      ++fixed;
    } else {
      EXPECT_LE(method.number("energetic"), 0.02 * method.number("runs")) << method.text("method");
      EXPECT_LE(method.number("wrong"), 0.1 * method.number("runs")) << method.text("method");
      ++adaptive;
    }
  });
  EXPECT_EQ(fixed, 2);
  EXPECT_GE(adaptive, 2);
}

TEST(SimulatorsStudy, FillsItsPage) {
  const ScratchFolder folder;
  Plan plan;
  plan.scenes = 11;
  plan.folder = folder.path();
  const report::Results results = report::results_in(simulators_study(plan).compute(true));
  EXPECT_THAT(study_page("simulators", results).terminal, HasSubstr("moreau-jean"));
  plan.scenes = 0;
  EXPECT_THROW(simulators_study(plan), InputError);
}

}  // namespace
}  // namespace ricochet::studies::simulators
