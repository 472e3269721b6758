#include <gmock/gmock.h>

#include "src/studies/impact_test/score.h"
#include "src/studies/impact_test/tool.h"
#include "tests/studies/impact_test/some_scenes.h"

namespace ricochet::studies::impact_test {
namespace {

using testing::HasSubstr;

/// A shell script that answers scenes by their names.
ToolProgram script(const std::filesystem::path& folder, const std::string& body) {
  const auto file = write_file(folder / "tool.sh",
                               "while read -r line; do case $line in\n" + body + "esac; done\n");
  ToolProgram program;
  program.tool.name = "fake";
  program.command = {"sh", file.string()};
  return program;
}

TestScene named(const std::string& name) {
  TestScene scene;
  scene.scene = name;
  scene.force = {{0, {}}};
  return scene;
}

constexpr const char* body = R"(
*'"good"'*) echo '{"scene":"good","impacts":[[1,"lower",1]],"seconds":0.1}';;
*'"cannot"'*) echo '{"scene":"cannot","cannot":"no"}';;
*'"crash"'*) echo "memory is full" >&2; exit 3;;
*'"hang"'*) sleep 100;;
)";

TEST(ToolSession, OutlivesWhatTheToolDoes) {
  const ScratchFolder folder;
  ToolSession session(script(folder.path(), body), Level::usual, folder.path() / "log",
                      {std::chrono::seconds(20), std::chrono::seconds(1)});
  EXPECT_EQ(session.ask(named("good")).impacts.size(), 1U);
  EXPECT_EQ(session.ask(named("cannot")).ending, Ending::cannot);
  const Answer crash = session.ask(named("crash"));
  EXPECT_EQ(crash.ending, Ending::error);
  EXPECT_THAT(crash.reason, HasSubstr("exit code 3"));
  EXPECT_THAT(crash.reason, HasSubstr("memory is full"));
  EXPECT_EQ(session.ask(named("good")).ending, Ending::answered) << "it is started again";
  const Answer hang = session.ask(named("hang"));
  EXPECT_EQ(hang.ending, Ending::never);
  EXPECT_THAT(hang.reason, HasSubstr("1 s"));
  EXPECT_EQ(session.ask(named("good")).ending, Ending::answered);
}

TEST(ToolSession, GivesUpAToolThatNeverStarts) {
  const ScratchFolder folder;
  ToolProgram program;
  program.command = {"no-such-program-at-all"};
  ToolSession session(program, Level::usual, folder.path() / "log");
  EXPECT_EQ(session.ask(named("good")).ending, Ending::error);
  EXPECT_EQ(session.ask(named("good")).ending, Ending::error);
  EXPECT_THROW(session.ask(named("good")), ToolFailure);
}

TEST(ToolSession, TellsTheToolItsLevel) {
  const ScratchFolder folder;
  ToolProgram program;
  program.command = {"sh", "-c", R"(read -r line; echo "{\"scene\":\"a\",\"cannot\":\"$0\"}")"};
  ToolSession session(program, Level::tight, folder.path() / "log");
  EXPECT_EQ(session.ask(named("a")).reason, "tight");
}

TEST(ToolSession, IsScoredForEveryThirdImpactThatItMisses) {
  const ScratchFolder folder;
  const ScoredScene scored = with_impacts(9);
  ToolSession session(
      script(folder.path(),
             R"(*) echo '{"scene":"made","impacts":[[1,"lower",1],[2,"lower",1],[4,"lower",1],)"
             R"([5,"lower",1],[7,"lower",1],[8,"lower",1]],"seconds":0.1}';;
)"),
      Level::usual, folder.path() / "log");
  const Score score = score_of(session.ask(scored.scene), scored);
  EXPECT_EQ(score.missed, 3);
  EXPECT_EQ(score.invented, 0);
  EXPECT_EQ(score.late, 0);
}

}  // namespace
}  // namespace ricochet::studies::impact_test
