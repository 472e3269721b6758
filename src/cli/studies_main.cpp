#include "ricochet/solvers.h"
#include "src/benchmark/problem_pages/study.h"
#include "src/benchmark/stress/study.h"
#include "src/cli/commands.h"
#include "src/cli/other_program.h"
#include "src/cli/scene_choice.h"
#include "src/cli/shared_options.h"
#include "src/cli/tell.h"
#include "src/research/dynamics/study.h"
#include "src/research/fireworks/study.h"
#include "src/research/suite/families.h"
#include "src/research/surrogate/study.h"

namespace ricochet::cli {
namespace {

/// Adds a command that runs the study returned by `make` when it is called. Further options may be
/// added.
CLI::App* add_study(CommandLine& line, const std::string& command,
                    const std::function<studies::Study()>& make, const std::string& examples) {
  CLI::App* added = line.add(command, summary_of(command), examples);
  const auto options = add_study_options(added, make());
  line.on_call(added, [make, options] {
    tell(studies::run(make(), options->quick, options->out));
    return 0;
  });
  return added;
}

void add_problems(CommandLine& line) {
  const auto machine = std::make_shared<SceneChoice>();
  const auto families = [machine] {
    return suite_families(machine->scene_file, machine->settings);
  };
  CLI::App* command = add_study(
      line, "problems",
      [machine, families] { return studies::problems_study(families, machine->scene_file); },
      "  ricochet problems\n"
      "  ricochet problems --scene machine.toml --out mine");
  command
      ->add_option("--scene", machine->scene_file,
                   "A machine file (TOML) in place of the paper's cases; - is standard input")
      ->type_name("FILE");
  add_settings(command, machine->settings);
}

}  // namespace
}  // namespace ricochet::cli

/// The studies of the suite itself, which ricochet calls.
int main(int argc, char** argv) {
  using namespace ricochet;
  using namespace ricochet::cli;
  CommandLine line;
  add_calibrate(line);
  add_study(line, "dynamics", studies::dynamics_study, "  ricochet dynamics --quick");
  add_study(line, "surrogate", studies::surrogate_study, "  ricochet surrogate --quick");
  add_study(line, "fireworks", studies::fireworks_study, "  ricochet fireworks --quick");
  add_verify(line);
  add_study(
      line, "stress", [] { return studies::stress_study(all_solvers()); }, "  ricochet stress");
  add_impact_test(line);
  add_problems(line);
  add_best_values(line);
  line.add_description();
  return line.run(argc, argv);
}
