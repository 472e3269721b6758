#include "src/research/impact_test/simulator.h"

#include <memory>

#include "src/research/impact_test/own_level.h"
#include "src/research/impact_test/tool_session.h"

namespace ricochet::studies::impact_test {

std::vector<Simulator> own_simulators() {
  std::vector<Simulator> simulators;
  for (const OwnLevel& own : own_levels()) {
    const auto open = [answer = own.answer](Level level) -> Ask {
      return [answer, level](const ScoredScene& scored) { return answer(scored, level); };
    };
    simulators.push_back({own.tool, RICOCHET_VERSION, true, open});
  }
  return simulators;
}

Simulator simulator_of(const ToolProgram& program, const std::filesystem::path& logs) {
  const auto open = [program, logs](Level level) -> Ask {
    std::filesystem::create_directories(logs);
    const auto session =
        std::make_shared<ToolSession>(program, level, logs / (program.tool.name + ".log"));
    return [session](const ScoredScene& scored) { return session->ask(scored.scene); };
  };
  return {program.tool, program.version, false, open};
}

}  // namespace ricochet::studies::impact_test
