#include <CLI/CLI.hpp>
#include <cstdio>
#include <deque>
#include <exception>
#include <set>

#include "problems/carrier_track/scene/enum_names.h"
#include "problems/carrier_track/scene/scene_file.h"
#include "src/cli/bench.h"
#include "src/cli/best_values.h"
#include "src/cli/list.h"
#include "src/cli/simulate.h"
#include "src/cli/threshold.h"
#include "src/cli/verify.h"
#include "src/core/error.h"
#include "src/report/report.h"
#include "src/studies/calibration/study.h"
#include "src/studies/dynamics/study.h"
#include "src/studies/problems/study.h"
#include "src/studies/reproduction/study.h"
#include "src/studies/study.h"
#include "src/studies/surrogate/study.h"
#include "src/studies/verification/study.h"

namespace ricochet::cli {
namespace {

constexpr int bad_input = 2;

void add_scene_choice(CLI::App& command, SceneChoice& choice) {
  command.add_option("--case", choice.case_id, "A case of the paper, C1..C12");
  command.add_option("--scene", choice.scene_file, "A machine of your own, a TOML file");
}

void add_format(CLI::App& command, bool& json) {
  command.add_option("--format", "What to print: text or json")
      ->check(CLI::IsMember({"text", "json"}))
      ->default_str("text")
      ->each([&json](const std::string& format) { json = format == "json"; });
}

/// What every study is asked.
struct StudyOptions {
  bool quick;
  std::string out;
};

class Program {
 public:
  Program() {
    app_.require_subcommand(1);
    app_.set_version_flag("--version", "ricochet 0.1.0");
    add_study(studies::reproduction_study);
    add_simulate();
    add_threshold();
    add_calibrate();
    add_study(studies::dynamics_study);
    add_study(studies::surrogate_study);
    add_verify();
    add_scene();
    add_list();
    add_problems();
    add_best_values();
    add_report();
    add_bench();
  }

  int run(int argc, char** argv) {
    try {
      app_.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
      if (error.get_exit_code() == 0) return app_.exit(error);  // --help, --version
      std::fprintf(stderr, "ricochet: %s; see ricochet --help\n", explanation(error).c_str());
      return bad_input;
    }
    return work_();
  }

 private:
  /// What CLI11 says, but where it only misses a command the one that was taken for it.
  std::string explanation(const CLI::ParseError& error) const {
    if (app_.get_subcommands().empty() && app_.remaining_size() > 0) {
      std::string known;
      for (const CLI::App* command : app_.get_subcommands(nullptr)) {
        known += (known.empty() ? "" : ", ") + command->get_name();
      }
      return app_.remaining().front() + " is no command; allowed: " + known;
    }
    return error.what();
  }

  /// The command of the study that `make` makes when it is called; further options may be added.
  CLI::App* add_study(const std::function<studies::Study()>& make) {
    const studies::Study study = make();
    CLI::App* command = app_.add_subcommand(study.command, study.summary);
    StudyOptions& options = studies_.emplace_back(StudyOptions{false, "reports/" + study.name});
    if (!study.quick.empty()) command->add_flag("--quick", options.quick, study.quick);
    command->add_option("--out", options.out, "Folder for the report")->capture_default_str();
    command->callback([this, make, &options] {
      work_ = [make, &options] {
        std::fputs(studies::run(make(), options.quick, options.out).epilogue.c_str(), stdout);
        return 0;
      };
    });
    return command;
  }

  void add_report() {
    CLI::App* command =
        app_.add_subcommand("report", "Draws a report again, from the data beside it");
    command->add_option("folder", report_from_, "Where its data.json is")->required();
    command->add_option("--out", report_out_, "Another folder for what is drawn");
    command->callback([this] {
      work_ = [this] {
        report::redraw_report(report_from_, report_out_.empty() ? report_from_ : report_out_);
        return 0;
      };
    });
  }

  void add_simulate() {
    CLI::App* command =
        app_.add_subcommand("simulate", "One run: impacts, peaks, count, certainty");
    add_scene_choice(*command, simulate_.scene);
    add_format(*command, simulate_.json);
    command->add_option("--omega", simulate_.omega, "Speed [rad/s] in place of the scene's");
    std::set<std::string> levels;
    for (const auto& [name, level] : carrier_track::fidelity_names()) levels.emplace(name);
    command->add_option("--fidelity", simulate_.fidelity, "Level of the model, for the scene's own")
        ->check(CLI::IsMember(levels));
    command->add_option("--width", simulate_.width, "Smoothing width of the surrogate")
        ->capture_default_str();
    command->add_option("--csv", simulate_.csv, "File for the path: time, position, velocity");
    command->add_option("--plot", simulate_.plot, "SVG file for a picture of the path");
    command->callback([this] { work_ = [this] { return simulate(simulate_); }; });
  }

  void add_threshold() {
    CLI::App* command = app_.add_subcommand("threshold", "The fastest quiet speed, to 1e-3 rad/s");
    add_scene_choice(*command, threshold_.scene);
    add_format(*command, threshold_.json);
    command->add_flag("--all", threshold_.all, "Every case of the paper");
    command->add_option("--fastest", threshold_.fastest, "End of the speed range [rad/s]")
        ->capture_default_str();
    command->callback([this] { work_ = [this] { return threshold(threshold_); }; });
  }

  void add_calibrate() {
    CLI::App* command = add_study([this] { return studies::calibration_study(calibration_); });
    command->add_option("--reading", calibration_.reading,
                        "One of ricochet list readings, for the default one");
    command->add_flag("--all-readings", calibration_.all_readings, "Every reading, compared");
    command->add_flag("--check", calibration_.check,
                      "Rank the readings by another seed and by another solver too");
    command->add_option("--seed", calibration_.seed, "Of the searches")->capture_default_str();
    command->add_option("--solver", calibration_.solver, "That searches the whole of the bounds")
        ->capture_default_str();
    StudyOptions& options = studies_.back();
    command->callback([this, &options] {
      work_ = [this, &options] {
        calibration_.folder = options.out;
        const studies::Study study = studies::calibration_study(calibration_);
        std::fputs(studies::run(study, options.quick, options.out).epilogue.c_str(), stdout);
        return 0;
      };
    });
  }

  void add_verify() {
    CLI::App* command = add_study([this] { return studies::verification_study(verification_); });
    command->add_option("--scenes", verification_.scenes, "How many random and hostile scenes")
        ->capture_default_str();
    command->add_option("--seed", verification_.seed, "Of the scenes")->capture_default_str();
    command->add_option("--scene-index", scene_index_,
                        "Prints this scene and both lists of impacts instead");
    add_format(*command, verification_json_);
    StudyOptions& options = studies_.back();
    command->callback([this, &options] { work_ = [this, &options] { return verify(options); }; });
  }

  int verify(const StudyOptions& options) const {
    if (scene_index_) {
      show_hostile_scene(verification_.seed, *scene_index_, verification_json_);
      return 0;
    }
    studies::Finished finished =
        studies::run(studies::verification_study(verification_), options.quick, options.out);
    const bool failed = finished.data["failed"].get<bool>();
    if (verification_json_) {
      const report::Json seconds = finished.data["made"]["seconds"];
      for (const char* key : {"report", "made", "failed"}) finished.data.erase(key);
      finished.data["seconds"] = seconds;
      std::fputs((finished.data.dump(2) + "\n").c_str(), stdout);
    } else {
      std::fputs(finished.epilogue.c_str(), stdout);
    }
    return failed ? 1 : 0;
  }

  void add_scene() {
    CLI::App* command =
        app_.add_subcommand("scene", "Prints a scene as TOML, to start a machine of your own");
    add_scene_choice(*command, scene_);
    command->callback([this] {
      work_ = [this] {
        std::fputs(carrier_track::write_scene(choose_scene(scene_).scene).c_str(), stdout);
        return 0;
      };
    });
  }

  void add_list() {
    CLI::App* command = app_.add_subcommand("list", "What there is");
    command->add_option("what", list_, "cases, questions, solvers or readings")
        ->required()
        ->check(CLI::IsMember({"cases", "questions", "problems", "solvers", "readings"}));
    command->add_option("--scene", list_scene_, "Of questions: a machine of your own, a TOML file");
    add_format(*command, list_json_);
    command->callback([this] { work_ = [this] { return list(list_, list_scene_, list_json_); }; });
  }

  void add_problems() {
    CLI::App* command = add_study([this] { return studies::problems_study(problems_scene_); });
    command->add_option("--scene", problems_scene_,
                        "A machine of your own, a TOML file, for the paper's cases");
  }

  void add_best_values() {
    CLI::App* command = app_.add_subcommand(
        "best-values", "The best known value of every question, looked for at length");
    command->alias("certify");  // as it was called
    command->add_option("--questions,--problems", best_values_.questions,
                        "A pattern such as robust-*-C4, or a part of their names");
    command->add_option("--seconds", best_values_.seconds,
                        "Begin nothing later; the same command then goes on");
    command->add_option("--out", best_values_.out, "The file of the values")->capture_default_str();
    command->callback([this] { work_ = [this] { return best_values(best_values_); }; });
  }

  void add_bench() {
    CLI::App* command = app_.add_subcommand("bench", "The speed measurements");
    add_format(*command, bench_json_);
    command->allow_extras();
    command->footer("Further flags are Google Benchmark's, such as --benchmark_filter=simulate");
    command->callback([this, command] {
      work_ = [this, command] { return bench(command->remaining(), bench_json_); };
    });
  }

  CLI::App app_{"ricochet: the fastest quiet speed of a braiding machine, and solvers put to it"};
  std::deque<StudyOptions> studies_;  // stay where they are
  std::string report_from_, report_out_;
  SimulateOptions simulate_;
  ThresholdOptions threshold_;
  studies::CalibrationOptions calibration_;
  studies::VerificationOptions verification_;
  std::optional<int> scene_index_;
  bool verification_json_ = false;
  std::string problems_scene_;
  BestValuesOptions best_values_;
  SceneChoice scene_;
  std::string list_, list_scene_;
  bool list_json_ = false;
  bool bench_json_ = false;
  std::function<int()> work_;
};

}  // namespace
}  // namespace ricochet::cli

int main(int argc, char** argv) {
  try {
    return ricochet::cli::Program().run(argc, argv);
  } catch (const ricochet::InputError& error) {
    std::fprintf(stderr, "ricochet: %s\n", error.what());
    return ricochet::cli::bad_input;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "ricochet: failed: %s\n", error.what());
    return 1;
  }
}
