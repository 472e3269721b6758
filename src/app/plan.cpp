#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>
#include <variant>
#include <vector>

#include "embedded/default_plan.h"
#include "embedded/full_plan.h"
#include "embedded/outside_plan.h"
#include "embedded/plan_template.h"
#include "embedded/quick_plan.h"
#include "embedded/reference_plan.h"
#include "embedded/slurm_template.h"
#include "embedded/studies_plan.h"
#include "ricochet/error.h"
#include "solvers/adjustable_solver.h"
#include "solvers/outside/outside.h"
#include "src/app/campaign.h"
#include "src/app/command_line.h"
#include "src/app/other_program.h"
#include "src/core/names.h"
#include "src/core/progress.h"
#include "src/experiment/planned_runs.h"
#include "src/report/table.h"
#include "src/report/text.h"
#include "src/studies/suite/suite.h"

namespace ricochet::cli {

namespace {

using report::Json;

/// Of the parts check and slurm.
struct PlanOptions {
  std::string plan;
  bool json = false;
  int jobs = 8;
};

/// The options of a solver that are set and those that can still be; if it has many, only those
/// that are set.
Table option_table(const VariedSolver& varied) {
  constexpr std::size_t few = 20;
  Table table{"options", columns_named("name,value,usual,range")};
  const std::vector<SolverOption> known = ricochet::options_of(varied.of);
  for (const SolverOption& option : known) {
    const auto given = varied.options.find(option.name);
    Value value;
    if (given != varied.options.end()) {
      const auto* number = std::get_if<double>(&given->second);
      value = number != nullptr ? Value(*number) : one_line(std::get<std::string>(given->second));
    }
    if (is_missing(value) && known.size() > few) continue;
    table.add(option.name, value, option.usual, option.allowed());
  }
  return table;
}

int new_plan() {
  fmt::print("{}", embedded::plan_template);
  return 0;
}

int check_plan(const PlanOptions& options) {
  const Campaign campaign(plan_named(options.plan), catalogue_that_starts_nothing());
  const std::vector<std::string> programs = programs_of(campaign.plan());
  Json size = size_of(campaign);
  const Forecast forecast = forecast_of(campaign);
  size["seconds"] = forecast.search + forecast.runs + forecast.report;
  size["elapsed_seconds"] = forecast.seconds(cores());
  size["at_least"] = forecast.at_least;
  size["cores"] = cores();
  const std::vector<VariedSolver>& varied = campaign.plan().solvers;
  size["varied_solvers"] = report::list_of(varied, [](const VariedSolver& v) {
    return Json{{"name", v.name},
                {"of", v.of},
                {"options", json_rows_of(option_table(v))},
                {"known_options", ricochet::options_of(v.of).size()}};
  });
  size["programs"] = programs;
  if (options.json) {
    fmt::print("{}\n", size.dump(2));
  } else {
    fmt::print("{}; {}\n", in_words(size), in_words(forecast, cores()));
    for (const VariedSolver& v : varied) {
      const Table table = option_table(v);
      fmt::print("{}: {} with {} of {} options:\n", v.name, v.of, table.rows.size(),
                 ricochet::options_of(v.of).size());
      print_table(table, false);
    }
    for (const std::string& program : programs) {
      fmt::print("run would start: {}\n", one_line(program));
    }
    if (!programs.empty()) {
      fmt::print(
          "Programs are not started here: the numbers count all that they might be given.\n");
    }
  }
  return 0;
}

int slurm_script(const PlanOptions& options) {
  const std::string& plan = options.plan;
  const int jobs = options.jobs;
  if (jobs < 1 || jobs > 10'000) {
    throw InputError(fmt::format("--jobs {}: must be from 1 to 10000", jobs));
  }
  if (plan == "-") throw InputError("the jobs read the plan: it must be a file");
  const Campaign campaign(plan_named(plan), catalogue_that_starts_nothing());
  const std::vector<std::string> programs = programs_of(campaign.plan());
  Forecast forecast = forecast_of(campaign);
  forecast.runs /= jobs;
  forecast.report = 0;
  const double hours = forecast.seconds(1) / 3600;
  std::string notes;
  for (const std::string& program : programs) notes += "# It starts: " + one_line(program) + "\n";
  if (forecast.at_least)
    notes +=
        "# The time below is at least needed: what the programs take is not known before they "
        "run.\n";
  fmt::print("{}", report::with_slots(
                       embedded::slurm_template,
                       {{"plan", shell_quoted(plan)},
                        {"jobs", std::to_string(jobs)},
                        {"notes", notes},
                        {"allow", programs.empty() ? "" : " --allow-programs"},
                        {"hours", std::to_string(static_cast<int>(std::ceil(2 * hours + 0.1)))}}));
  return 0;
}

/// The plan of this name or file. It may include others, if `included` says how to read those.
Plan read_named_plan(const std::string& name, const PlanByName& included) {
  const std::vector<std::pair<std::string, const char*>> known_plans = {
      {"quick", embedded::quick_plan},         {"default", embedded::default_plan},
      {"reference", embedded::reference_plan}, {"studies", embedded::studies_plan},
      {"full", embedded::full_plan},           {"outside", embedded::outside_plan}};
  std::vector<std::string> names;
  for (const auto& [known, text] : known_plans) {
    if (name == known) return plan_from(text, name, included);
    names.push_back(known);
  }
  const std::vector<std::string> meant = near_names(name, names);
  if (!meant.empty() && !std::filesystem::exists(name)) {
    throw InputError(
        fmt::format("{}: there is no such file; did you mean {}?", name, meant.front()));
  }
  return read_plan(name, included);
}

}  // namespace

Plan plan_named(const std::string& name) {
  return read_named_plan(name, [](const std::string& other) { return read_named_plan(other, {}); });
}

void add_plan_file(CLI::App* command, std::string& plan) {
  add_value(command, "plan", plan,
            "A plan file (TOML), - for standard input; or quick, default, studies, reference, full",
            "PLAN:{quick,default,studies,reference,full}")
      ->required();
}

void add_plan(CommandLine& line) {
  CLI::App* command =
      line.add("plan", "Prepare a campaign: new, check FILE, sample ARCHIVE, slurm FILE",
               "  ricochet plan new > plan.toml\n"
               "  ricochet plan check plan.toml\n"
               "  ricochet plan slurm plan.toml --jobs 100 > campaign.sh");
  command->require_subcommand(1);
  CLI::App* fresh = line.add_part(command, "new", "Print a plan to start from");
  line.on_call(fresh, new_plan);
  CLI::App* check =
      line.add_part(command, "check", "Print what the plan would run, and for how long");
  const auto options = std::make_shared<PlanOptions>();
  add_plan_file(check, options->plan);
  add_format(check, options->json);
  line.on_call(check, [options] { return check_plan(*options); });
  add_sample(line, command);
  CLI::App* slurm = line.add_part(command, "slurm", "Print a job script for Slurm");
  add_plan_file(slurm, options->plan);
  add_value(slurm, "--jobs", options->jobs, "Number of jobs, of one core each");
  line.on_call(slurm, [options] { return slurm_script(*options); });
}

std::vector<std::string> programs_of(const Plan& plan) {
  std::vector<std::string> programs;
  for (const PlanPart& part : plan.parts) {
    for (const std::string& text : part.solvers) {
      const bool known = std::find(programs.begin(), programs.end(), text) != programs.end();
      if (!known && outside::is_outside(text)) programs.push_back(text);
    }
  }
  return programs;
}

Catalogue catalogue_that_starts_nothing() {
  Catalogue catalogue = studies::whole_catalogue();
  catalogue.own_solver = outside::unstarted_solver;
  return catalogue;
}

void announce_programs(const std::vector<std::string>& programs, bool allowed,
                       const std::string& origin) {
  if (programs.empty()) return;
  if (!allowed) {
    throw InputError(
        fmt::format("{}: names programs, which run with your rights: {}; add --allow-programs if "
                    "you trust them",
                    origin, fmt::join(programs, "; ")));
  }
  for (const std::string& program : programs) Progress::announce("starts " + program);
}

}  // namespace ricochet::cli
