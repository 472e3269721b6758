#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "problems/carrier_track/problems/cases.h"
#include "problems/carrier_track/regimes/orbit_map.h"
#include "problems/carrier_track/regimes/regime_map.h"
#include "problems/carrier_track/scene/enum_names.h"
#include "ricochet/error.h"
#include "ricochet/recording.h"
#include "ricochet/scene.h"
#include "ricochet/threshold.h"
#include "src/benchmark/comparison/comparison_plan.h"
#include "src/benchmark/experiment/perturbations/perturbation.h"
#include "src/benchmark/export/formats.h"
#include "src/cli/agreement.h"
#include "src/cli/archive.h"
#include "src/cli/campaign.h"
#include "src/cli/command_line.h"
#include "src/cli/completion.h"
#include "src/cli/evaluate.h"
#include "src/cli/export.h"
#include "src/cli/identify.h"
#include "src/cli/list.h"
#include "src/cli/machine.h"
#include "src/cli/manual.h"
#include "src/cli/old_names.h"
#include "src/cli/other_program.h"
#include "src/cli/plan.h"
#include "src/cli/regimes.h"
#include "src/cli/report.h"
#include "src/cli/sample.h"
#include "src/cli/scene.h"
#include "src/cli/simulate.h"
#include "src/cli/site.h"
#include "src/cli/solve.h"
#include "src/cli/stored_runs.h"
#include "src/cli/threshold.h"
#include "src/report/json.h"

namespace ricochet::cli {
namespace {

using report::Json;

void add_scene_choice(CLI::App* command, SceneChoice& choice) {
  std::vector<std::string> cases;
  for (const carrier_track::Case& a_case : carrier_track::all_cases()) cases.push_back(a_case.id);
  command->add_option("--case", choice.case_id, "A case of the paper")
      ->type_name(fmt::format("CASE:{{{}}}", fmt::join(cases, ",")));
  command->add_option("--scene", choice.scene_file, "A machine file (TOML); - is standard input")
      ->type_name("FILE");
  add_settings(command, choice.settings);
}

void add_machine_file(CLI::App* command, SceneChoice& choice) {
  command->add_option("file", choice.scene_file, "A machine file (TOML); - is standard input")
      ->type_name("FILE")
      ->required();
  add_settings(command, choice.settings);
}

void add_request(CLI::App* command, QuietSpeedRequest& asked) {
  command->add_option("--fastest", asked.fastest, "End of the speed range [rad/s]")
      ->capture_default_str();
  command->add_option("--allow", asked.allow, "Limit: collisions in the window");
  command->add_option("--allow-per-turn", asked.allow_per_turn, "Limit: collisions per turn");
  command->add_option("--allow-energy", asked.allow_energy,
                      "Limit: energy [J] that the walls dissipate in the window");
  command->add_option("--allow-speed", asked.allow_speed,
                      "Limit: speed [m/s] of the fastest impact");
  command->add_option("--tolerance", asked.tolerance,
                      "Uncertainty of every constant [%]; prints the range of the answer");
}

std::vector<std::string> perturbations() {
  std::vector<std::string> names;
  for (const auto& perturbation : all_perturbations()) names.push_back(perturbation.name);
  return names;
}

class Program : public CommandLine {
 public:
  Program() {
    start_group("machine");
    add_machine();
    add_simulate();
    add_threshold();
    add_regimes();
    add_identify();
    add_scene();
    start_group("solve");
    add_list();
    add_solve();
    add_evaluate();
    add_compare();
    start_group("campaign");
    add_plan();
    add_run();
    add_stores();
    add_report();
    add_site();
    add_other(reproduction);
    for (const OtherCommand& other : other_commands) add_other(other);
    add_moved("trials", "calibrate --variants");
    add_descriptions();
  }

 private:
  void add_simulate() {
    CLI::App* command =
        add("simulate", "Simulate one machine: impacts, peaks, count, certainty",
            "  ricochet simulate --case C1 --omega 5\n"
            "  ricochet simulate --scene machine.toml --plot path.svg --csv path.csv\n"
            "  ricochet simulate --scene machine.toml --set friction=0.3 --set 'omega=60 rpm'");
    add_scene_choice(command, simulate_.scene);
    add_format(command, simulate_.json);
    command->add_option("--omega", simulate_.omega, "Speed [rad/s] in place of the scene's");
    std::set<std::string> levels;
    for (const auto& [name, level] : carrier_track::fidelity_names()) levels.emplace(name);
    command
        ->add_option("--fidelity", simulate_.fidelity,
                     "Level of the model, in place of the scene's")
        ->check(CLI::IsMember(levels));
    command->add_option("--smoothing", simulate_.smoothing, "Smoothing parameter of the surrogate")
        ->capture_default_str();
    command->add_option("--csv", simulate_.csv, "CSV file for the path: time, position, velocity")
        ->type_name("FILE");
    command->add_option("--plot", simulate_.plot, "SVG file for a chart of the path")
        ->type_name("FILE");
    on_call(command, [this] { return simulate(simulate_); });
  }

  void add_threshold() {
    CLI::App* command = add("threshold", "Find the fastest quiet speed, to 1e-3 rad/s",
                            "  ricochet threshold --scene machine.toml --plot staircase.svg\n"
                            "  ricochet threshold --all --format json");
    add_scene_choice(command, threshold_.scene);
    add_format(command, threshold_.json);
    command->add_flag("--all", threshold_.all, "Every case of the paper");
    add_request(command, threshold_.asked);
    command->add_option("--plot", threshold_.plot, "SVG file for a chart of the counts")
        ->type_name("FILE");
    on_call(command, [this] { return threshold(threshold_); });
  }

  void add_regimes() {
    CLI::App* command =
        add("regimes", "Show what the carrier does in the long run, over the speed",
            "  ricochet regimes --case C1\n"
            "  ricochet regimes --scene machine.toml --to 10 --plot regimes.svg\n"
            "  ricochet regimes --case C1 --over restitution=0.05..0.95 --plot map.svg\n"
            "  ricochet regimes --scene machine.toml --over 'clearance=0.5..2 mm'\n"
            "  ricochet regimes --case C2 --omega 12 --starts 1000");
    add_scene_choice(command, regimes_.scene);
    add_format(command, regimes_.json);
    command->add_option("--from", regimes_.range.from, "Start of the speed range [rad/s]")
        ->capture_default_str();
    command->add_option("--to", regimes_.range.to, "End of the speed range [rad/s]")
        ->capture_default_str();
    command
        ->add_option("--plot", regimes_.plot,
                     "SVG file for a chart of the collisions a turn; with --over: for a map")
        ->type_name("FILE");
    CLI::Option* over =
        command
            ->add_option(
                "--over", regimes_.over,
                "Follow every border over a constant: " +
                    fmt::format("{}", fmt::join(carrier_track::continuation_constants(), ", ")))
            ->type_name("CONSTANT=FROM..TO");
    command
        ->add_option(
            "--values", regimes_.values,
            fmt::format("Values of that constant to solve the regimes at; default: {}, or {} "
                        "under a disturbance, where each takes up to some seconds",
                        carrier_track::usual_values, carrier_track::few_values))
        ->needs(over);
    command
        ->add_option("--csv", regimes_.csv, "CSV file for the points of the borders, in SI units")
        ->type_name("FILE")
        ->needs(over);
    CLI::Option* starts =
        command
            ->add_option("--starts", regimes_.starts,
                         "Sample so many starts at one speed: which motions do they lead to?")
            ->excludes(over);
    command->add_option("--omega", regimes_.omega, "That speed [rad/s], in place of the scene's")
        ->needs(starts);
    command->add_option("--seed", regimes_.sampled.seed, "Seed of the random starts")
        ->capture_default_str()
        ->needs(starts);
    command
        ->add_option("--height", regimes_.sampled.height,
                     "Highest start [m] above the lower wall; default: the clearance")
        ->needs(starts);
    command
        ->add_option("--start-speed", regimes_.sampled.fastest,
                     "Fastest start [m/s]; default: from the machine")
        ->needs(starts);
    on_call(command, [this] { return regimes(regimes_); });
  }

  void add_identify() {
    CLI::App* command = add(
        "identify", "Fit restitution, friction and clearance to recorded knocks",
        "  ricochet identify knocks.csv --scene machine.toml --speed speed.csv --marks marks.csv\n"
        "  ricochet identify knocks.csv --scene machine.toml --omega 5 --plot residuals.svg");
    command
        ->add_option("knocks", identify_.files.knocks,
                     "CSV file: time [s] of each knock; perhaps strength, omega [rad/s]")
        ->type_name("FILE")
        ->required();
    command
        ->add_option("--scene", identify_.scene_file, "A machine file (TOML); - is standard input")
        ->type_name("FILE");
    command->add_option("--omega", identify_.files.omega, "Constant speed of the plate [rad/s]");
    command
        ->add_option("--speed", identify_.files.speed,
                     "CSV file: time [s], omega [rad/s] of the plate; linear in between")
        ->type_name("FILE");
    command
        ->add_option("--marks", identify_.files.marks, "CSV file: time [s] of marks on the plate")
        ->type_name("FILE");
    command->add_option("--mark-angle", identify_.files.mark_angle, "Angle alpha [rad] at a mark")
        ->capture_default_str();
    command->add_option("--solver", identify_.solver, "Solver that takes gradients")
        ->type_name("SOLVER")
        ->capture_default_str();
    command->add_option("--fastest", identify_.fastest, "End of the speed range [rad/s]")
        ->capture_default_str();
    command->add_option("--out", identify_.out, "Machine file (TOML) for the fitted machine")
        ->type_name("FILE");
    command->add_option("--plot", identify_.plot, "SVG file for a chart of the residuals")
        ->type_name("FILE");
    add_format(command, identify_.json);
    on_call(command, [this] { return identify(identify_); });
  }

  void add_machine() {
    CLI::App* command = add("machine", "Describe your own machine: new, check FILE, advise FILE",
                            "  ricochet machine new > machine.toml\n"
                            "  ricochet machine check machine.toml\n"
                            "  ricochet machine advise machine.toml --tolerance 5");
    command->require_subcommand(1);
    CLI::App* fresh =
        command->add_subcommand("new", "Print a machine file to start from")->group("Commands");
    on_call(fresh, [] { return new_machine(); });
    CLI::App* check =
        command
            ->add_subcommand("check", "List every field with unit and range, and likely mistakes")
            ->group("Commands");
    add_machine_file(check, machine_);
    on_call(check, [this] { return check_machine(machine_); });
    CLI::App* advise =
        command->add_subcommand("advise", "Write a page: how fast it may turn, and what to change")
            ->group("Commands");
    add_machine_file(advise, machine_);
    advise->add_option("--out", advice_out_, "Folder for the page")
        ->type_name("FOLDER")
        ->capture_default_str();
    add_request(advise, advice_);
    on_call(advise, [this] { return advise_machine(machine_, advice_, advice_out_); });
  }

  void add_scene() {
    CLI::App* command = add("scene", "Print a scene as a machine file",
                            "  ricochet scene --case C1 > machine.toml\n"
                            "  ricochet scene --scene machine.toml --set 'path_radius=80 mm'");
    add_scene_choice(command, scene_);
    on_call(command, [this] { return print_scene(scene_); });
  }

  void add_solve() {
    CLI::App* command =
        add("solve", "Run one solver on one problem and score it",
            "  ricochet solve nlopt-cobyla top-speed-C1 --formulation penalised-count\n"
            "  ricochet solve fireworks profile-count-8-C4 --budget 10000 --plot trace.svg\n"
            "  ricochet solve nlopt-slsqp profile-count-8-scene --scene machine.toml\n"
            "  ricochet solve ./mine.so count-C1\n"
            "  ricochet solve 'python3 mine.py' count-C1");
    command
        ->add_option("solver", solve_.solver,
                     "A name of `ricochet list solvers`, a shared library or a program")
        ->required()
        ->type_name("SOLVER");
    command->add_option("problem", solve_.problem, "A name of `ricochet list problems`")
        ->required()
        ->type_name("PROBLEM");
    add_scene_file(command, solve_.scene_file, solve_.settings);
    command->add_option("--formulation", solve_.formulation,
                        "Formulation of the problem; default: the first that the solver accepts");
    command->add_option("--perturbation", solve_.perturbation, "Perturbation of the problem")
        ->type_name(fmt::format("PERTURBATION:{{{}}}", fmt::join(perturbations(), ",")))
        ->capture_default_str();
    command->add_option("--budget", solve_.budget, "Evaluations")->capture_default_str();
    command
        ->add_option("--instance", solve_.instance,
                     "0: the original problem; 1, 2, ...: moved and reflected")
        ->capture_default_str();
    command->add_option("--seed", solve_.seed, "Number of the run, which gives its random numbers")
        ->capture_default_str();
    command->add_option("--trace", solve_.trace, "CSV file for the improvements")
        ->type_name("FILE");
    command->add_option("--plot", solve_.plot, "SVG file for a chart of the improvements")
        ->type_name("FILE");
    add_limits(command, solve_.limits);
    add_format(command, solve_.json);
    on_call(command, [this] { return solve(solve_); });
  }

  /// Problems of the user's machine in place of the suite's.
  void add_scene_file(CLI::App* command, std::string& file, std::vector<std::string>& settings) {
    command
        ->add_option("--scene", file,
                     "A machine file (TOML): problems of this machine, whose names end in -scene")
        ->type_name("FILE");
    add_settings(command, settings);
  }

  void add_limits(CLI::App* command, Limits& limits) {
    command
        ->add_option("--run-seconds", limits.seconds,
                     "Longest time of a run [s]; then it is killed")
        ->capture_default_str();
    command->add_option("--run-megabytes", limits.megabytes, "Most memory of a run [MB]")
        ->capture_default_str();
  }

  void add_compare() {
    CLI::App* command =
        add("compare", "Compare solvers: success rates, costs and ranks, as a report",
            "  ricochet compare --quick\n"
            "  ricochet compare --problems 'hs-*' --solvers 'nlopt-*' --budget 100,1000\n"
            "  ricochet compare --scene machine.toml --problems 'top-speed-*' --quick\n"
            "  ricochet compare --solver ./mine.so --solver 'python3 mine.py' --solvers 'nlopt-*'\n"
            "  ricochet compare --solver ./mine.so --against archive\n"
            "  ricochet compare --stores archive mine/runs.sqlite");
    StudyOptions& options =
        add_study_options(command, {"comparison", "Fewer instances and evaluations", nullptr});
    on_call(command, [this, &options] {
      if (!stores_.empty()) return compare_stores(stores_[0], stores_[1], stores_json_);
      if (!against_.empty()) {
        return compare_against(against_, comparison_.added_solvers, options.out);
      }
      return compare(comparison_, compared_, options.quick, options.out);
    });
    add_scene_file(command, compared_.scene_file, compared_.settings);
    CLI::Option* against =
        command
            ->add_option("--against", against_,
                         "Run only the solvers of --solver, on the problems and beside the runs of "
                         "this archive; archive: that of the reference, which is included")
            ->type_name("ARCHIVE");
    CLI::Option* stores =
        command
            ->add_option(
                "--stores", stores_,
                "Print how far two stores, or archives, order their entries alike, and which "
                "entries changed")
            ->type_name("FILE")
            ->expected(2);
    add_format(command, stores_json_);
    command->get_option("--format")->needs(stores);
    command
        ->add_option("--problems", comparison_.problems,
                     "Patterns, separated by commas; default: 48 problems of 1 to 32 variables")
        ->type_name("PROBLEMS");
    command->add_option("--solvers", comparison_.solvers, "Patterns, separated by commas")
        ->type_name("SOLVERS")
        ->capture_default_str();
    command
        ->add_option("--solver", comparison_.added_solvers,
                     "A further solver: a shared library or a program; may be repeated")
        ->type_name("SOLVER")
        ->allow_extra_args(false);
    command
        ->add_option("--formulations", comparison_.formulations,
                     "Patterns, such as *count or penalised*")
        ->capture_default_str();
    command
        ->add_option("--smoothings", comparison_.smoothings,
                     "Further smoothing parameters of the surrogate")
        ->delimiter(',');
    command->add_option("--budget", comparison_.budgets, "Evaluations for each variable")
        ->delimiter(',');
    command->add_option("--instances", comparison_.instances, "Instances of every problem")
        ->capture_default_str();
    add_limits(command, comparison_.limits);
    for (const char* option : {"--scene", "--set", "--problems", "--solvers", "--formulations",
                               "--smoothings", "--budget", "--instances", "--quick", "--stores"}) {
      against->excludes(command->get_option(option));
    }
  }

  void add_plan() {
    CLI::App* command =
        add("plan", "Prepare a campaign: new, check FILE, sample ARCHIVE, slurm FILE",
            "  ricochet plan new > plan.toml\n"
            "  ricochet plan check plan.toml\n"
            "  ricochet plan slurm plan.toml --jobs 100 > campaign.sh");
    command->require_subcommand(1);
    CLI::App* fresh =
        command->add_subcommand("new", "Print a plan to start from")->group("Commands");
    on_call(fresh, [] { return new_plan(); });
    CLI::App* check =
        command->add_subcommand("check", "Print what the plan would run, and for how long")
            ->group("Commands");
    add_plan_file(check);
    add_format(check, plan_json_);
    on_call(check, [this] { return check_plan(run_.plan, plan_json_); });
    CLI::App* sample =
        command
            ->add_subcommand("sample",
                             "Print a sample of an archive's problems, evenly over difficulty, and "
                             "how far its ranking agrees with that of all")
            ->group("Commands");
    sample->add_option("archive", against_, "An archive; archive: that of the reference")
        ->type_name("ARCHIVE")
        ->required();
    sample->add_option("--share", sample_share_, "Of each family; at least three problems")
        ->capture_default_str();
    add_format(sample, plan_json_);
    on_call(sample, [this] { return sample_problems(against_, sample_share_, plan_json_); });
    CLI::App* slurm =
        command->add_subcommand("slurm", "Print a job script for Slurm")->group("Commands");
    add_plan_file(slurm);
    slurm->add_option("--jobs", slurm_jobs_, "Number of jobs, of one core each")
        ->capture_default_str();
    on_call(slurm, [this] { return slurm_script(run_.plan, slurm_jobs_); });
  }

  void add_plan_file(CLI::App* command) {
    command
        ->add_option("plan", run_.plan,
                     "A plan file (TOML), - for standard input; or quick, default, reference, full")
        ->type_name("PLAN:{quick,default,reference,full}")
        ->required();
  }

  void add_allowance(CLI::App* command, bool& allowed) {
    command->add_flag("--allow-programs", allowed,
                      "Start the programs and shared libraries that the file names as solvers");
  }

  void add_run() {
    CLI::App* command = add("run", "Run a plan; every finished run is stored at once",
                            "  ricochet run plan.toml --out mine\n"
                            "  ricochet run plan.toml --out mine --resume\n"
                            "  ricochet run plan.toml --out part-3 --shard 3/8\n"
                            "  mpirun -n 64 ricochet run plan.toml --out mine");
    add_plan_file(command);
    command->add_option("--out", run_.out, "Folder of the store, runs.sqlite")
        ->type_name("FOLDER")
        ->capture_default_str();
    command->add_option("--shard", run_.shard, "Only the I-th of N parts of the runs")
        ->type_name("I/N")
        ->capture_default_str();
    CLI::Option* resume =
        command->add_flag("--resume", run_.resume, "Continue the campaign in this folder");
    command
        ->add_option(
            "--from", run_.from,
            "Take over the runs of another store whose problem and solver are the same; may "
            "be repeated")
        ->type_name("STORE")
        ->allow_extra_args(false)
        ->excludes(resume);
    add_allowance(command, run_.allow_programs);
    command->add_option("--jobs", run_.jobs, "Runs in parallel; 0: as many as cores")
        ->capture_default_str();
    command->add_option("--serve", run_.serve, "What this process does under MPI")
        ->check(CLI::IsMember({"store", "runs"}))
        ->group("");  // hidden
    on_call(command, [this] { return run_plan(run_); });
  }

  /// Adds the commands for a campaign's store.
  void add_stores() {
    CLI::App* again = add("replay", "Repeat a stored run and compare it bit by bit",
                          "  ricochet replay mine/runs.sqlite 17\n"
                          "  ricochet replay archive "
                          "top-speed-C1/count/plain/bisection/100/n/1/0");
    again
        ->add_option("store", store_,
                     "A store, runs.sqlite; archive: that of the reference, which is included")
        ->type_name("FILE")
        ->required();
    again
        ->add_option("run", replayed_,
                     "Number of the run, or problem/formulation/perturbation/solver/budget/price/"
                     "instance/seed, as a comparison's own view writes it")
        ->type_name("RUN")
        ->required();
    add_allowance(again, run_.allow_programs);
    add_format(again, replay_json_);
    on_call(again, [this] { return replay(store_, replayed_, run_.allow_programs, replay_json_); });
    CLI::App* merge = add("merge", "Join the stores of a campaign's shards",
                          "  ricochet merge runs.sqlite part-*/runs.sqlite");
    merge->add_option("out", store_, "The new store")->type_name("FILE")->required();
    merge->add_option("parts", store_parts_, "Stores of the same campaign")
        ->type_name("FILE")
        ->required();
    on_call(merge, [this] { return merge_stores(store_parts_, store_); });
    CLI::App* digest = add("digest", "Print a hash of a store's runs, times left out",
                           "  ricochet digest mine/runs.sqlite");
    digest->add_option("store", store_, "A store, runs.sqlite")->type_name("FILE")->required();
    on_call(digest, [this] { return print_digest(store_); });
    CLI::App* submission =
        add("submit", "Pack runs of a store, checked and compressed, as an archive",
            "  ricochet submit mine/runs.sqlite --out mine.archive --citation CITATION.cff\n"
            "  ricochet merge all.sqlite reports/archive/reference.archive mine.archive");
    submission->add_option("store", submit_.store, "A store, runs.sqlite")
        ->type_name("FILE")
        ->required();
    submission->add_option("--out", submit_.out, "The archive")->type_name("FILE")->required();
    submission
        ->add_option(
            "--solvers", submit_.solvers,
            "Patterns, separated by commas; default: the solvers that are not of the suite")
        ->type_name("SOLVERS");
    submission->add_option("--citation", submit_.citation, "How to cite the solver: a CITATION.cff")
        ->type_name("FILE");
    add_allowance(submission, submit_.allow_programs);
    on_call(submission, [this] { return submit(submit_); });
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
    CLI::App* command =
        add("export", "Export a store: tables, IOHanalyzer, COCO",
            examples + "For Parquet, convert the CSV files, for instance with DuckDB.");
    command->add_option("store", export_.store, "A store, runs.sqlite")
        ->type_name("FILE")
        ->required();
    command->add_option("--format", export_.format, "One of these formats")
        ->type_name(fmt::format("FORMAT:{{{}}}", fmt::join(names, ",")))
        ->required();
    command->add_option("--out", export_.out, "Folder, new or empty")
        ->type_name("FOLDER")
        ->required();
    on_call(command, [this] { return export_store(export_); });
  }

  void add_evaluate() {
    CLI::App* command = add(
        "evaluate", "Evaluate a problem at points, as JSON lines",
        "  ricochet evaluate profile-count-8-C4 --formulation surrogate --instance 1 --describe\n"
        "  echo '[5.0]' | ricochet evaluate top-speed-C1\n"
        "  ricochet evaluate hs-71 --derivatives < points.jsonl > values.jsonl\n"
        "An input line is [1, 2], {\"x\": [1, 2]} or {\"x\": [1, 2], \"derivatives\": true}. Many "
        "points\n"
        "at once are [[1, 2], [3, 4]] or {\"x\": [[1, 2], [3, 4]]}: the answer has a list for each "
        "key.");
    command->add_option("problem", evaluate_.problem, "A name of `ricochet list problems`")
        ->required()
        ->type_name("PROBLEM");
    add_scene_file(command, evaluate_.scene_file, evaluate_.settings);
    command->add_option("--formulation", evaluate_.formulation,
                        "Formulation of the problem; default: the true objective");
    command
        ->add_option("--instance", evaluate_.instance,
                     "0: the original problem; 1, 2, ...: moved and reflected")
        ->capture_default_str();
    command->add_flag("--derivatives", evaluate_.derivatives, "Print gradient and Jacobian, too");
    command->add_flag("--replay", evaluate_.replay,
                      "Evaluate every point twice and compare bit by bit");
    command->add_flag("--describe", evaluate_.describe,
                      "Print the problem in one line; evaluate nothing");
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
    add_scene_file(command, list_.scene_file, list_.settings);
    command->add_option("--family", list_.family, "Problems of this family")->type_name("FAMILY");
    command
        ->add_option("--solver-accepts", list_.solver,
                     "Problems with a formulation that this solver accepts")
        ->type_name("SOLVER");
    add_format(command, list_.json);
    on_call(command, [this] { return list(list_); });
  }

  void add_report() {
    CLI::App* command =
        add("report", "Draw a report again from its data, or all reports of a folder",
            "  ricochet report reports/reproduction\n"
            "  ricochet report reports\n"
            "  ricochet report reports/reference --out elsewhere");
    command->add_option("folder", report_from_, "Folder of data.json, or of the reports")
        ->type_name("FOLDER")
        ->required();
    command->add_option("--out", report_out_, "Another folder for the pages")->type_name("FOLDER");
    on_call(command, [this] { return draw_again(report_from_, report_out_); });
  }

  void add_site() {
    CLI::App* command = add("site", "Write all reports and documents as a site for a static host",
                            "  ricochet site --out pages\n"
                            "  ricochet site reports --out pages");
    command->add_option("folder", site_from_, "Folder of the reports")
        ->type_name("FOLDER")
        ->capture_default_str();
    command->add_option("--out", site_out_, "Folder for the site: new, empty or an earlier site")
        ->type_name("FOLDER")
        ->required();
    on_call(command, [this] { return write_site(site_from_, site_out_); });
  }

  /// All arguments after the command are passed to the other program, including --help.
  void add_other(const OtherCommand& other) {
    start_group(other.group);
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
    command->add_option("form", description_, "What to print")
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
  std::string against_;
  std::vector<std::string> stores_;
  bool stores_json_ = false;
  double sample_share_ = 0.15;
  SubmitOptions submit_;
  RunOptions run_;
  bool plan_json_ = false;
  int slurm_jobs_ = 8;
  std::string store_;
  std::vector<std::string> store_parts_;
  std::string replayed_;
  bool replay_json_ = false;
  ExportOptions export_;
  EvaluateOptions evaluate_;
  SimulateOptions simulate_;
  ThresholdOptions threshold_;
  RegimesOptions regimes_;
  IdentifyOptions identify_;
  SceneChoice scene_;
  SceneChoice machine_;
  SceneChoice compared_;
  QuietSpeedRequest advice_;
  std::string advice_out_ = "reports/advice";
  ListOptions list_;
  std::string description_;
  std::string report_from_, report_out_;
  std::string site_from_ = "reports/reference", site_out_;
};

}  // namespace
}  // namespace ricochet::cli

int main(int argc, char** argv) {
  return ricochet::cli::Program().run(argc, argv);
}
