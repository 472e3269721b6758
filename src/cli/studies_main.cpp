#include <optional>

#include "problems/carrier_track/check/verification/study.h"
#include "ricochet/solvers.h"
#include "src/benchmark/problem_pages/study.h"
#include "src/benchmark/stress/study.h"
#include "src/cli/best_values.h"
#include "src/cli/command_line.h"
#include "src/cli/impact_test.h"
#include "src/cli/other_program.h"
#include "src/cli/tell.h"
#include "src/cli/verify.h"
#include "src/research/calibration/study.h"
#include "src/research/dynamics/study.h"
#include "src/research/fireworks/study.h"
#include "src/research/impact_test/study.h"
#include "src/research/limits/study.h"
#include "src/research/long_run/study.h"
#include "src/research/suite/families.h"
#include "src/research/surrogate/study.h"

namespace ricochet::cli {
namespace {

/// The studies of the suite itself, which ricochet calls.
class Studies : public CommandLine {
 public:
  Studies() {
    add_calibrate();
    add_limits();
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
    add_impact_test();
    add_problems();
    add_best_values();
    add_description();
  }

 private:
  void add_calibrate() {
    CLI::App* command = add("calibrate", summary_of("calibrate"),
                            "  ricochet calibrate --quick\n"
                            "  ricochet calibrate --all-interpretations --check\n"
                            "  ricochet calibrate --variants\n"
                            "  ricochet calibrate --long-run");
    command->add_option("--interpretation", calibration_.interpretation,
                        "A name of `ricochet list interpretations`, in place of the default");
    command->add_flag("--all-interpretations", calibration_.all_interpretations,
                      "Compare all interpretations");
    command->add_flag("--check", calibration_.check,
                      "Rank the interpretations by another seed and by another solver too");
    command->add_flag(
        "--converge", calibration_.converge,
        "Search the best interpretations longer, with three seeds and two solvers, until they "
        "agree");
    command->add_flag("--variants", calibration_.variants,
                      "Fit twelve model variants, too, which the paper does not contain");
    command->add_option("--seed", calibration_.seed, "Seed of the searches")->capture_default_str();
    command->add_option("--solver", calibration_.solver, "Solver that searches within the bounds")
        ->capture_default_str();
    StudyOptions& options = add_study_options(command, studies::calibration_study(calibration_));
    command
        ->add_flag("--long-run", long_run_,
                   "Instead: fit borders and counts of the long run to the thresholds, as a report "
                   "in reports/long-run")
        ->excludes("--interpretation", "--all-interpretations", "--check", "--converge",
                   "--variants", "--seed", "--solver");
    on_call(command, [this, command, &options] {
      if (long_run_) {
        const studies::Study study = studies::long_run_study();
        const bool elsewhere = command->count("--out") > 0;
        tell(studies::run(study, options.quick, elsewhere ? options.out : "reports/" + study.name));
        return 0;
      }
      calibration_.folder = options.out;
      const studies::Study study = studies::calibration_study(calibration_);
      tell(studies::run(study, options.quick, options.out));
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
      tell(studies::run(study, options.quick, options.out));
      return 0;
    });
  }

  void add_verify() {
    CLI::App* command = add("verify", summary_of("verify"),
                            "  ricochet verify --scenes 10000\n"
                            "  ricochet verify --scene-index 17");
    command->add_option("--scenes", verification_.scenes, "Number of random and hostile scenes")
        ->capture_default_str();
    command->add_option("--seed", verification_.seed, "Seed of the scenes")->capture_default_str();
    command->add_option("--scene-index", scene_index_,
                        "Print this scene and both lists of impacts instead");
    add_format(command, verification_json_);
    StudyOptions& options = add_study_options(command, studies::verification_study(verification_));
    on_call(command, [this, &options] {
      if (!scene_index_) return verify(verification_, options.out, verification_json_);
      show_hostile_scene(verification_.seed, *scene_index_, verification_json_);
      return 0;
    });
  }

  void add_impact_test() {
    CLI::App* command =
        add("impact-test", summary_of("impact-test"),
            "  ricochet impact-test --quick\n"
            "  ricochet impact-test --tools none --tool mine=./my-simulator --levels usual\n"
            "  ricochet impact-test --tools 'odeint*,scipy*' --install-tools");
    command->add_option("--scenes", impact_test_.scenes, "Number of scenes")->capture_default_str();
    command->add_option("--seed", impact_test_.seed, "Seed of the scenes")->capture_default_str();
    command
        ->add_option("--tools", impact_test_.tools,
                     "Names or patterns such as 'odeint*', all that are installed, or none")
        ->capture_default_str();
    command
        ->add_option(
            "--tool", impact_test_.own_tools,
            "A program of your own, too; docs/impact-test.md says what it reads and writes")
        ->type_name("NAME=COMMAND");
    command->add_option("--levels", impact_test_.levels, "How exactly tools are asked to simulate")
        ->capture_default_str();
    command->add_flag("--list-tools", list_tools_, "Instead: list the tools");
    command->add_flag(
        "--install-tools", install_tools_,
        "Instead: install the tools from Debian and Python's registry, and list them");
    add_format(command, impact_test_json_);
    StudyOptions& options = add_study_options(command, studies::impact_test_study({}));
    on_call(command, [this, &options] {
      impact_test_.quick = options.quick;
      impact_test_.out = options.out;
      if (install_tools_) return install_tools(impact_test_, impact_test_json_);
      if (list_tools_) return list_tools(impact_test_, impact_test_json_);
      return impact_test(impact_test_, impact_test_json_);
    });
  }

  void add_problems() {
    CLI::App* command = add_study(
        "problems", summary_of("problems"),
        [this] {
          return studies::problems_study(
              [this] { return suite_families(problems_scene_, problems_settings_); },
              problems_scene_);
        },
        "  ricochet problems\n"
        "  ricochet problems --scene machine.toml --out mine");
    command
        ->add_option("--scene", problems_scene_,
                     "A machine file (TOML) in place of the paper's cases; - is standard input")
        ->type_name("FILE");
    add_settings(command, problems_settings_);
  }

  void add_best_values() {
    CLI::App* command = add("best-values", summary_of("best-values"),
                            "  ricochet best-values --problems 'robust-*-C4'\n"
                            "  ricochet best-values --seconds 600  # and the same again, to go on");
    command
        ->add_option("--problems", best_values_.problems,
                     "A pattern such as robust-*-C4, or a part of the names")
        ->type_name("PROBLEMS");
    command->add_option("--seconds", best_values_.seconds,
                        "Start no search after this time [s]; the same command continues");
    command
        ->add_option("--budget", best_values_.budget,
                     "Evaluations a variable of each search: 50 times those of a comparison")
        ->check(CLI::Range(std::int64_t{1}, std::int64_t{1'000'000'000}))
        ->capture_default_str();
    command->add_option("--out", best_values_.out, "The file of the values")
        ->type_name("FILE")
        ->capture_default_str();
    command
        ->add_option("--from", best_values_.from,
                     "Instead: take the values of a store's runs that are better than those known")
        ->type_name("STORE")
        ->excludes("--problems", "--seconds", "--budget");
    command
        ->add_option(
            "--hard-machines", best_values_.hard_machines,
            "Instead: search machines whose fastest quiet speed is hard to find, and write "
            "this file")
        ->type_name("FILE")
        ->excludes("--problems", "--seconds", "--budget", "--from", "--out");
    on_call(command, [this] { return best_values(best_values_); });
  }

  studies::CalibrationOptions calibration_;
  bool long_run_ = false;
  studies::VerificationOptions verification_;
  std::optional<int> scene_index_;
  bool verification_json_ = false;
  ImpactTestOptions impact_test_;
  bool list_tools_ = false;
  bool install_tools_ = false;
  bool impact_test_json_ = false;
  std::string problems_scene_;
  std::vector<std::string> problems_settings_;
  BestValuesOptions best_values_;
};

}  // namespace
}  // namespace ricochet::cli

int main(int argc, char** argv) {
  return ricochet::cli::Studies().run(argc, argv);
}
