#include "src/cli/commands.h"
#include "src/cli/other_program.h"
#include "src/cli/shared_options.h"
#include "src/cli/tell.h"
#include "src/research/calibration/study.h"
#include "src/research/long_run/study.h"

namespace ricochet::cli {
namespace {

struct CalibrateOptions {
  studies::CalibrationOptions calibration;
  bool long_run = false;
};

}  // namespace

void add_calibrate(CommandLine& line) {
  CLI::App* command = line.add("calibrate", summary_of("calibrate"),
                               "  ricochet calibrate --quick\n"
                               "  ricochet calibrate --all-interpretations --check\n"
                               "  ricochet calibrate --variants\n"
                               "  ricochet calibrate --long-run");
  const auto options = std::make_shared<CalibrateOptions>();
  command->add_option("--interpretation", options->calibration.interpretation,
                      "A name of `ricochet list interpretations`, in place of the default");
  command->add_flag("--all-interpretations", options->calibration.all_interpretations,
                    "Compare all interpretations");
  command->add_flag("--check", options->calibration.check,
                    "Rank the interpretations by another seed and by another solver too");
  command->add_flag(
      "--converge", options->calibration.converge,
      "Search the best interpretations longer, with three seeds and two solvers, until they "
      "agree");
  command->add_flag("--variants", options->calibration.variants,
                    "Fit twelve model variants, too, which the paper does not contain");
  command->add_option("--seed", options->calibration.seed, "Seed of the searches")
      ->capture_default_str();
  command
      ->add_option("--solver", options->calibration.solver,
                   "Solver that searches within the bounds")
      ->capture_default_str();
  const auto study = add_study_options(command, studies::calibration_study(options->calibration));
  command
      ->add_flag("--long-run", options->long_run,
                 "Instead: fit borders and counts of the long run to the thresholds, as a report "
                 "in reports/long-run")
      ->excludes("--interpretation", "--all-interpretations", "--check", "--converge", "--variants",
                 "--seed", "--solver");
  line.on_call(command, [options, study, command] {
    options->calibration.folder = study->out;
    const studies::Study made = options->long_run
                                    ? studies::long_run_study()
                                    : studies::calibration_study(options->calibration);
    const bool elsewhere = command->count("--out") > 0;
    tell(studies::run(made, study->quick, elsewhere ? study->out : "reports/" + made.name));
    return 0;
  });
}

}  // namespace ricochet::cli
