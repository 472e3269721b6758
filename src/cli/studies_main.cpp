#include <fmt/format.h>

#include <optional>

#include "solvers/solvers.h"
#include "src/cli/best_values.h"
#include "src/cli/command_line.h"
#include "src/cli/other_program.h"
#include "src/cli/verify.h"
#include "src/studies/calibration/study.h"
#include "src/studies/dynamics/study.h"
#include "src/studies/fireworks/study.h"
#include "src/studies/limits/study.h"
#include "src/studies/problems/study.h"
#include "src/studies/stress/study.h"
#include "src/studies/surrogate/study.h"
#include "src/studies/trials/study.h"
#include "src/studies/verification/study.h"

namespace ricochet::cli {
namespace {

/// The studies of the suite itself, to which ricochet hands over.
class Studies : public CommandLine {
 public:
  Studies() {
    add_calibrate();
    add_limits();
    add_trials();
    add_study("dynamics", summary_of("dynamics"), studies::dynamics_study,
              "  ricochet dynamics --quick");
    add_study("surrogate", summary_of("surrogate"), studies::surrogate_study,
              "  ricochet surrogate --quick");
    add_study("fireworks", summary_of("fireworks"), studies::fireworks_study,
              "  ricochet fireworks --quick");
    add_verify();
    add_study(
        "stress", summary_of("stress"), [] { return studies::stress_study(all_solvers()); },
        "  ricochet stress");
    add_problems();
    add_best_values();
    add_description();
  }

 private:
  void add_calibrate() {
    CLI::App* command = add("calibrate", summary_of("calibrate"),
                            "  ricochet calibrate --quick\n"
                            "  ricochet calibrate --all-readings --check");
    command->add_option("--reading", calibration_.reading,
                        "One of ricochet list readings, for the default one");
    command->add_flag("--all-readings", calibration_.all_readings, "Every reading, compared");
    command->add_flag("--check", calibration_.check,
                      "Rank the readings by another seed and by another solver too");
    command->add_flag(
        "--converge", calibration_.converge,
        "Search the best readings at length, from three seeds by two solvers: do they "
        "end alike?");
    command->add_option("--seed", calibration_.seed, "Of the searches")->capture_default_str();
    command->add_option("--solver", calibration_.solver, "That searches the whole of the bounds")
        ->capture_default_str();
    StudyOptions& options = add_study_options(command, studies::calibration_study(calibration_));
    on_call(command, [this, &options] {
      calibration_.folder = options.out;
      const studies::Study study = studies::calibration_study(calibration_);
      std::fputs(studies::run(study, options.quick, options.out).epilogue.c_str(), stdout);
      return 0;
    });
  }

  void add_trials() {
    CLI::App* command = add("trials", summary_of("trials"), "  ricochet trials --quick");
    StudyOptions& options = add_study_options(command, studies::trials_study({}));
    on_call(command, [&options] {
      const studies::Study study = studies::trials_study(options.out);
      std::fputs(studies::run(study, options.quick, options.out).epilogue.c_str(), stdout);
      return 0;
    });
  }

  void add_limits() {
    CLI::App* command =
        add("limits", summary_of("limits"),
            "  ricochet limits --quick\n"
            "  ricochet limits --out mine  # and the same again, to go on where it was stopped");
    StudyOptions& options = add_study_options(command, studies::limits_study({}));
    on_call(command, [&options] {
      const studies::Study study = studies::limits_study(options.out);
      std::fputs(studies::run(study, options.quick, options.out).epilogue.c_str(), stdout);
      return 0;
    });
  }

  void add_verify() {
    CLI::App* command = add("verify", summary_of("verify"),
                            "  ricochet verify --scenes 10000\n"
                            "  ricochet verify --scene-index 17");
    command->add_option("--scenes", verification_.scenes, "How many random and hostile scenes")
        ->capture_default_str();
    command->add_option("--seed", verification_.seed, "Of the scenes")->capture_default_str();
    command->add_option("--scene-index", scene_index_,
                        "Prints this scene and both lists of impacts instead");
    add_format(command, verification_json_);
    StudyOptions& options = add_study_options(command, studies::verification_study(verification_));
    on_call(command, [this, &options] {
      if (!scene_index_) return verify(verification_, options.out, verification_json_);
      show_hostile_scene(verification_.seed, *scene_index_, verification_json_);
      return 0;
    });
  }

  void add_problems() {
    CLI::App* command = add_study(
        "problems", summary_of("problems"),
        [this] { return studies::problems_study(problems_scene_); },
        "  ricochet problems\n"
        "  ricochet problems --scene machine.toml --out mine");
    command
        ->add_option("--scene", problems_scene_,
                     "A machine of your own, a TOML file, for the paper's cases; - reads it")
        ->type_name("FILE");
  }

  void add_best_values() {
    CLI::App* command = add("best-values", summary_of("best-values"),
                            "  ricochet best-values --questions 'robust-*-C4'\n"
                            "  ricochet best-values --seconds 600  # and the same again, to go on");
    command->add_option("--questions,--problems", best_values_.questions,
                        "A pattern such as robust-*-C4, or a part of their names");
    command->add_option("--seconds", best_values_.seconds,
                        "Begin nothing later; the same command then goes on");
    command->add_option("--out", best_values_.out, "The file of the values")
        ->type_name("FILE")
        ->capture_default_str();
    command
        ->add_option("--hard-machines", best_values_.hard_machines,
                     "Instead: look for machines whose fastest quiet speed is hard to find, into "
                     "this file")
        ->type_name("FILE")
        ->excludes("--questions", "--seconds", "--out");
    on_call(command, [this] { return best_values(best_values_); });
  }

  /// For ricochet, which describes all commands.
  void add_description() {
    CLI::App* command = add("describe", "Prints what there is to say of the commands, as JSON");
    command->group("");  // hidden
    on_call(command, [this] {
      fmt::print("{}\n", description().dump());
      return 0;
    });
  }

  studies::CalibrationOptions calibration_;
  studies::VerificationOptions verification_;
  std::optional<int> scene_index_;
  bool verification_json_ = false;
  std::string problems_scene_;
  BestValuesOptions best_values_;
};

}  // namespace
}  // namespace ricochet::cli

int main(int argc, char** argv) {
  return ricochet::cli::Studies().run(argc, argv);
}
