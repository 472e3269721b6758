#include <fmt/format.h>

#include <cstdio>
#include <set>
#include <string>
#include <vector>

#include "problems/carrier_track/problems/cases.h"
#include "problems/carrier_track/scene/enum_names.h"
#include "ricochet/error.h"
#include "ricochet/recording.h"
#include "ricochet/scene.h"
#include "ricochet/threshold.h"
#include "src/benchmark/comparison/study.h"
#include "src/benchmark/experiment/perturbations/perturbation.h"
#include "src/benchmark/export/formats.h"
#include "src/cli/campaign.h"
#include "src/cli/command_line.h"
#include "src/cli/completion.h"
#include "src/cli/evaluate.h"
#include "src/cli/export.h"
#include "src/cli/list.h"
#include "src/cli/machine.h"
#include "src/cli/manual.h"
#include "src/cli/old_names.h"
#include "src/cli/other_program.h"
#include "src/cli/plan.h"
#include "src/cli/simulate.h"
#include "src/cli/solve.h"
#include "src/cli/stored_runs.h"
#include "src/cli/threshold.h"
#include "src/core/folder_lock.h"
#include "src/report/drawn_chart.h"
#include "src/report/report.h"
#include "src/report/site/site.h"

namespace ricochet::cli {
namespace {

using report::Json;

void add_scene_choice(CLI::App* command, SceneChoice& choice) {
  std::vector<std::string> cases;
  for (const carrier_track::Case& a_case : carrier_track::all_cases()) cases.push_back(a_case.id);
  command->add_option("--case", choice.case_id, "A case of the paper")
      ->type_name(fmt::format("CASE:{{{}}}", fmt::join(cases, ",")));
  command
      ->add_option("--scene", choice.scene_file, "A machine of your own, a TOML file; - reads it")
      ->type_name("FILE");
}

void add_request(CLI::App* command, QuietSpeedRequest& asked) {
  command->add_option("--fastest", asked.fastest, "End of the speed range [rad/s]")
      ->capture_default_str();
  command->add_option("--allow", asked.allow, "Limit: collisions in the window");
  command->add_option("--allow-per-turn", asked.allow_per_turn, "Limit: collisions a turn");
  command->add_option("--allow-energy", asked.allow_energy,
                      "Limit: energy [J] that the walls take in the window");
  command->add_option("--allow-speed", asked.allow_speed,
                      "Limit: speed [m/s] of the fastest impact");
  command->add_option("--tolerance", asked.tolerance,
                      "How uncertain every constant is [%]: the range of the answer");
}

std::vector<std::string> perturbations() {
  std::vector<std::string> names;
  for (const auto& perturbation : all_perturbations()) names.push_back(perturbation.name);
  return names;
}

class Program : public CommandLine {
 public:
  Program() {
    add_other(reproduction);
    add_simulate();
    add_threshold();
    add_machine();
    add_scene();
    add_solve();
    add_compare();
    add_plan();
    add_run();
    add_stores();
    add_evaluate();
    add_list();
    add_report();
    for (const OtherCommand& other : other_commands) add_other(other);
    add_moved("trials", "calibrate --variants");
    add_descriptions();
  }

 private:
  void add_simulate() {
    CLI::App* command =
        add("simulate", "One run: impacts, peaks, count, certainty",
            "  ricochet simulate --case C1 --omega 5\n"
            "  ricochet simulate --scene machine.toml --plot path.svg --csv path.csv");
    add_scene_choice(command, simulate_.scene);
    add_format(command, simulate_.json);
    command->add_option("--omega", simulate_.omega, "Speed [rad/s] in place of the scene's");
    std::set<std::string> levels;
    for (const auto& [name, level] : carrier_track::fidelity_names()) levels.emplace(name);
    command->add_option("--fidelity", simulate_.fidelity, "Level of the model, for the scene's own")
        ->check(CLI::IsMember(levels));
    command->add_option("--smoothing", simulate_.smoothing, "Smoothing parameter of the surrogate")
        ->capture_default_str();
    command->add_option("--csv", simulate_.csv, "File for the path: time, position, velocity")
        ->type_name("FILE");
    command->add_option("--plot", simulate_.plot, "SVG file for a picture of the path")
        ->type_name("FILE");
    on_call(command, [this] { return simulate(simulate_); });
  }

  void add_threshold() {
    CLI::App* command = add("threshold", "The fastest quiet speed, to 1e-3 rad/s",
                            "  ricochet threshold --scene machine.toml --plot staircase.svg\n"
                            "  ricochet threshold --all --format json");
    add_scene_choice(command, threshold_.scene);
    add_format(command, threshold_.json);
    command->add_flag("--all", threshold_.all, "Every case of the paper");
    add_request(command, threshold_.asked);
    command->add_option("--plot", threshold_.plot, "SVG file for a picture of the staircase")
        ->type_name("FILE");
    on_call(command, [this] { return threshold(threshold_); });
  }

  void add_machine() {
    CLI::App* command = add("machine", "A machine of your own: new, check FILE, advise FILE",
                            "  ricochet machine new > machine.toml\n"
                            "  ricochet machine check machine.toml\n"
                            "  ricochet machine advise machine.toml --tolerance 5");
    command->require_subcommand(1);
    CLI::App* fresh = command->add_subcommand("new", "Prints a file to start from");
    on_call(fresh, [] { return new_machine(); });
    CLI::App* check = command->add_subcommand(
        "check", "Every field with unit and range, and what looks like a slip");
    check->add_option("file", machine_file_, "The machine, a TOML file; - reads it")
        ->type_name("FILE")
        ->required();
    on_call(check, [this] { return check_machine(machine_file_); });
    CLI::App* advise = command->add_subcommand(
        "advise", "How fast it may turn, as a page: staircase, paths, wear, what to change");
    advise->add_option("file", machine_file_, "The machine, a TOML file; - reads it")
        ->type_name("FILE")
        ->required();
    advise->add_option("--out", advice_out_, "Folder for the page")
        ->type_name("FOLDER")
        ->capture_default_str();
    add_request(advise, advice_);
    on_call(advise, [this] { return advise_machine(machine_file_, advice_, advice_out_); });
  }

  void add_scene() {
    CLI::App* command = add("scene", "Prints a scene as TOML, to start a machine of your own",
                            "  ricochet scene --case C1 > machine.toml");
    add_scene_choice(command, scene_);
    on_call(command, [this] {
      std::fputs(carrier_track::write_scene(choose_scene(scene_).scene).c_str(), stdout);
      return 0;
    });
  }

  void add_solve() {
    CLI::App* command =
        add("solve", "One run of one solver on one problem, watched and judged",
            "  ricochet solve nlopt-cobyla top-speed-C1 --formulation penalised-count\n"
            "  ricochet solve fireworks profile-count-8-C4 --budget 10000 --plot trace.svg\n"
            "  ricochet solve ./mine.so count-C1\n"
            "  ricochet solve 'python3 mine.py' count-C1");
    command
        ->add_option("solver", solve_.solver,
                     "One of ricochet list solvers; or your own, a library or a program")
        ->required()
        ->type_name("SOLVER");
    command->add_option("problem", solve_.problem, "One of ricochet list problems")
        ->required()
        ->type_name("QUESTION");
    command->add_option("--formulation", solve_.formulation,
                        "That it is shown; else the first it accepts");
    command->add_option("--perturbation", solve_.perturbation, "That disturbs what it is shown")
        ->type_name(fmt::format("FEATURE:{{{}}}", fmt::join(perturbations(), ",")))
        ->capture_default_str();
    command->add_option("--budget", solve_.budget, "Evaluations")->capture_default_str();
    command->add_option("--instance", solve_.instance, "0: as stated; others: in another box")
        ->capture_default_str();
    command->add_option("--seed", solve_.seed, "Number of the run")->capture_default_str();
    command->add_option("--trace", solve_.trace, "CSV file for the improvements")
        ->type_name("FILE");
    command->add_option("--plot", solve_.plot, "SVG file for a picture of them")->type_name("FILE");
    add_limits(command, solve_.limits);
    add_format(command, solve_.json);
    on_call(command, [this] { return solve(solve_); });
  }

  void add_limits(CLI::App* command, Limits& limits) {
    command->add_option("--run-seconds", limits.seconds, "After which a run is killed")
        ->capture_default_str();
    command->add_option("--run-megabytes", limits.megabytes, "Memory that a run may take")
        ->capture_default_str();
  }

  void add_compare() {
    CLI::App* command =
        add("compare",
            "Solvers against each other: who solves what, in which formulation, at what cost",
            "  ricochet compare --quick\n"
            "  ricochet compare --problems 'hs-*' --solvers 'nlopt-*' --budget 100,1000\n"
            "  ricochet compare --solver ./mine.so --solver 'python3 mine.py' --solvers 'nlopt-*'");
    StudyOptions& options =
        add_study_options(command, {"comparison", "Fewer instances and evaluations", nullptr});
    on_call(command, [this, &options] { return compare(comparison_, options.quick, options.out); });
    command->add_option("--problems", comparison_.problems,
                        "Patterns, with commas between; else the default comparison's");
    command->add_option("--solvers", comparison_.solvers, "Patterns")->capture_default_str();
    command
        ->add_option("--solver", comparison_.added_solvers,
                     "One more, such as your own, a library or a program; may be repeated")
        ->type_name("SOLVER")
        ->allow_extra_args(false);
    command
        ->add_option("--formulations", comparison_.formulations,
                     "Patterns, such as *count or penalised*")
        ->capture_default_str();
    command
        ->add_option("--smoothings", comparison_.smoothings,
                     "Smoothing parameters of surrogates, beside the usual one")
        ->delimiter(',');
    command->add_option("--budget", comparison_.budgets, "Evaluations for each variable")
        ->delimiter(',');
    command->add_option("--instances", comparison_.instances, "Of every problem")
        ->capture_default_str();
    add_limits(command, comparison_.limits);
  }

  void add_plan() {
    CLI::App* command = add("plan", "What a campaign runs: new, check FILE, slurm FILE",
                            "  ricochet plan new > plan.toml\n"
                            "  ricochet plan check plan.toml\n"
                            "  ricochet plan slurm plan.toml --jobs 100 > campaign.sh");
    command->require_subcommand(1);
    CLI::App* fresh = command->add_subcommand("new", "Prints a plan to start from");
    on_call(fresh, [] { return new_plan(); });
    CLI::App* check = command->add_subcommand("check", "What it would run, and for how long");
    add_plan_file(check);
    add_format(check, plan_json_);
    on_call(check, [this] { return check_plan(run_.plan, plan_json_); });
    CLI::App* slurm = command->add_subcommand("slurm", "Prints a script for the Slurm manager");
    add_plan_file(slurm);
    slurm->add_option("--jobs", slurm_jobs_, "So many, of one core each")->capture_default_str();
    on_call(slurm, [this] { return slurm_script(run_.plan, slurm_jobs_); });
  }

  void add_plan_file(CLI::App* command) {
    command
        ->add_option("plan", run_.plan,
                     "A plan, a TOML file, - reads it; or quick, default, full, which come along")
        ->type_name("PLAN")
        ->required();
  }

  void add_run() {
    CLI::App* command = add("run", "Carries out a plan; every finished run is kept at once",
                            "  ricochet run plan.toml --out mine\n"
                            "  ricochet run plan.toml --out mine --resume\n"
                            "  ricochet run plan.toml --out part-3 --shard 3/8\n"
                            "  mpirun -n 64 ricochet run plan.toml --out mine");
    add_plan_file(command);
    command->add_option("--out", run_.out, "Folder for its store, runs.sqlite")
        ->type_name("FOLDER")
        ->capture_default_str();
    command->add_option("--shard", run_.shard, "Only the I-th of N shares of the runs")
        ->type_name("I/N")
        ->capture_default_str();
    command->add_flag("--resume", run_.resume, "Go on with what is there");
    command->add_option("--jobs", run_.jobs, "Runs at once; 0: one on every core")
        ->capture_default_str();
    command->add_option("--serve", run_.serve, "What this process does under MPI")
        ->check(CLI::IsMember({"store", "runs"}))
        ->group("");  // hidden
    on_call(command, [this] { return run_plan(run_); });
  }

  /// Adds the commands for a campaign's store.
  void add_stores() {
    CLI::App* merge = add("merge", "Joins the stores of a campaign's shards",
                          "  ricochet merge runs.sqlite part-*/runs.sqlite");
    merge->add_option("out", store_, "The new store")->type_name("FILE")->required();
    merge->add_option("parts", store_parts_, "Stores of the same campaign")
        ->type_name("FILE")
        ->required();
    on_call(merge, [this] { return merge_stores(store_parts_, store_); });
    CLI::App* digest = add("digest", "What a store has in 16 digits, times left out",
                           "  ricochet digest mine/runs.sqlite");
    digest->add_option("store", store_, "")->type_name("FILE")->required();
    on_call(digest, [this] { return print_digest(store_); });
    CLI::App* again = add("replay", "A run of a store once more: is it the same, to the last bit?",
                          "  ricochet replay mine/runs.sqlite 17");
    again->add_option("store", store_, "")->type_name("FILE")->required();
    again->add_option("run", replayed_, "Its number there")->required();
    add_format(again, replay_json_);
    on_call(again, [this] { return replay(store_, replayed_, replay_json_); });
    add_export();
  }

  void add_export() {
    std::string examples =
        "  ricochet export mine/runs.sqlite --format csv --out tables\n"
        "  ricochet export mine/runs.sqlite --format iohanalyzer --out for-iohanalyzer\n"
        "Formats:\n";
    std::vector<std::string> names;
    for (const exports::Format& format : exports::all_formats()) {
      names.push_back(format.name);
      examples += fmt::format("  {:11}  {}\n", format.name, format.about);
    }
    CLI::App* command = add(
        "export", "What a store has, for other tools: tables, IOHanalyzer, COCO",
        examples + "Parquet is none of them: no library here writes it. DuckDB makes it of CSV.");
    command->add_option("store", export_.store, "")->type_name("FILE")->required();
    command->add_option("--format", export_.format, "One of them")
        ->type_name(fmt::format("FORMAT:{{{}}}", fmt::join(names, ",")))
        ->required();
    command->add_option("--out", export_.out, "Folder, new or empty")
        ->type_name("FOLDER")
        ->required();
    on_call(command, [this] { return export_store(export_); });
  }

  void add_evaluate() {
    CLI::App* command = add(
        "evaluate", "A problem for an optimiser outside: points in, values out, as JSON lines",
        "  ricochet evaluate profile-count-8-C4 --formulation surrogate --instance 1 --describe\n"
        "  echo '[5.0]' | ricochet evaluate top-speed-C1\n"
        "  ricochet evaluate hs-71 --derivatives < points.jsonl > values.jsonl\n"
        "A line in is [1, 2], {\"x\": [1, 2]} or {\"x\": [1, 2], \"derivatives\": true}.");
    command->add_option("problem", evaluate_.problem, "One of ricochet list problems")
        ->required()
        ->type_name("QUESTION");
    command
        ->add_option("--scene", evaluate_.scene_file,
                     "The problem is asked of a machine of your own, a TOML file")
        ->type_name("FILE");
    command->add_option("--formulation", evaluate_.formulation,
                        "That it is shown in; else as it is judged");
    command->add_option("--instance", evaluate_.instance, "0: as stated; others: in another box")
        ->capture_default_str();
    command->add_flag("--derivatives", evaluate_.derivatives,
                      "Gradient and Jacobian, too, where a line does not say");
    command->add_flag("--replay", evaluate_.replay,
                      "Every point twice: are the answers the same to the last bit?");
    command->add_flag("--describe", evaluate_.describe, "What is asked, in one line; no points");
    on_call(command, [this] { return evaluate(evaluate_); });
  }

  void add_list() {
    CLI::App* command = add("list", "List cases, problems, solvers or interpretations",
                            "  ricochet list problems --family top-speed\n"
                            "  ricochet list problems --solver-accepts nlopt-slsqp --format json");
    command->add_option("what", list_.what, "cases, problems, solvers or interpretations")
        ->required()
        ->check([](const std::string& what) { return renaming_of(what); })
        ->check(CLI::IsMember({"cases", "problems", "solvers", "interpretations"}));
    command
        ->add_option("--scene", list_.scene_file, "Of problems: a machine of your own, a TOML file")
        ->type_name("FILE");
    command->add_option("--family", list_.family, "Of problems: those of this family")
        ->type_name("FAMILY");
    command
        ->add_option("--solver-accepts", list_.solver,
                     "Of problems: those with a formulation that this solver accepts")
        ->type_name("SOLVER");
    add_format(command, list_.json);
    on_call(command, [this] { return list(list_); });
  }

  void add_report() {
    CLI::App* command = add("report", "Draws a report again, or all of a folder, from the data",
                            "  ricochet report reports/reproduction\n"
                            "  ricochet report reports\n"
                            "  ricochet report reports/reference --out elsewhere");
    command->add_option("folder", report_from_, "Where its data.json is, or the reports are")
        ->type_name("FOLDER")
        ->required();
    command->add_option("--out", report_out_, "Another folder for what is drawn")
        ->type_name("FOLDER");
    on_call(command, [this] {
      const std::string& out = report_out_.empty() ? report_from_ : report_out_;
      const FolderLock alone(out);
      auto failures = site::redraw_site(report_from_, out);
      if (!failures) {
        failures = report::redraw_report(report_from_, out).failures;
        const std::vector<std::string> above = site::write_site_above(out);
        failures->insert(failures->end(), above.begin(), above.end());
      }
      report::require_none(*failures);
      return 0;
    });
  }

  /// All arguments after the command are passed to the other program, including --help.
  void add_other(const OtherCommand& other) {
    CLI::App* command = add(other.command, other.summary);
    if (other.command == std::string("best-values")) command->alias("certify");  // its old name
    command->set_help_flag();
    for (CLI::Option* option : command->get_options()) command->remove_option(option);
    command->prefix_command();
    on_call(command, [other, command]() -> int { hand_over(other, command->remaining()); });
  }

  /// Adds the old name of a command, which fails with an error that gives the new one.
  void add_moved(const std::string& command, const std::string& now) {
    CLI::App* moved = add(command, "Is now: ricochet " + now);
    moved->group("");  // hidden
    moved->allow_extras();
    on_call(moved, [command, now]() -> int {
      throw InputError(fmt::format("{}: is now: ricochet {}", command, now));
    });
  }

  /// Adds the commands that print what is installed beside the program: its manual, and completions
  /// for the shells.
  void add_descriptions() {
    CLI::App* command = add("describe", "Prints the manual, or the completion of a shell");
    command->group("");  // hidden
    command->add_option("formulation", description_, "What to print")
        ->required()
        ->check(CLI::IsMember({"man", "bash", "zsh", "fish"}));
    on_call(command, [this] {
      const Json commands = every_description();
      std::fputs(
          (description_ == "man" ? manual(commands) : completion(description_, commands)).c_str(),
          stdout);
      return 0;
    });
  }

  /// Includes the commands of the other programs, if these can be called.
  Json every_description() const {
    Json commands = description();
    for (const OtherCommand& other : {reproduction, other_commands[0]}) {
      const Json others = Json::parse(output_of(other, "describe"), nullptr, false);
      if (others.is_discarded()) continue;
      for (const Json& theirs : others) {
        for (Json& own : commands) {
          if (own["name"] == theirs["name"]) own = theirs;
        }
      }
    }
    return commands;
  }

  SolveOptions solve_;
  studies::ComparisonOptions comparison_;
  RunOptions run_;
  bool plan_json_ = false;
  int slurm_jobs_ = 8;
  std::string store_;
  std::vector<std::string> store_parts_;
  std::int64_t replayed_ = 0;
  bool replay_json_ = false;
  ExportOptions export_;
  EvaluateOptions evaluate_;
  SimulateOptions simulate_;
  ThresholdOptions threshold_;
  SceneChoice scene_;
  std::string machine_file_;
  QuietSpeedRequest advice_;
  std::string advice_out_ = "reports/advice";
  ListOptions list_;
  std::string description_;
  std::string report_from_, report_out_;
};

}  // namespace
}  // namespace ricochet::cli

int main(int argc, char** argv) {
  return ricochet::cli::Program().run(argc, argv);
}
