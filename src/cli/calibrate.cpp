#include "src/cli/commands.h"
#include "src/cli/other_program.h"
#include "src/cli/shared_options.h"
#include "src/cli/tell.h"
#include "src/research/calibration/study.h"

namespace ricochet::cli {
void add_calibrate(CommandLine& line) {
  CLI::App* command = line.add("calibrate", summary_of("calibrate"),
                               "  ricochet calibrate --quick\n"
                               "  ricochet calibrate --all-interpretations --converge");
  const auto options = std::make_shared<studies::CalibrationOptions>();
  command->add_option("--interpretation", options->interpretation,
                      "A name of `ricochet list interpretations`, in place of the default");
  command->add_flag("--all-interpretations", options->all_interpretations,
                    "Compare all interpretations");
  command->add_flag(
      "--converge", options->converge,
      "Search the best interpretations longer, with three seeds and two solvers, until they "
      "agree");
  command->add_option("--seed", options->seed, "Seed of the searches")->capture_default_str();
  command->add_option("--solver", options->solver, "Solver that searches within the bounds")
      ->capture_default_str();
  const auto study = add_study_options(command, studies::calibration_study(*options));
  line.on_call(command, [options, study] {
    options->folder = study->out;
    tell(studies::run(studies::calibration_study(*options), study->quick, study->out));
    return 0;
  });
}

}  // namespace ricochet::cli
