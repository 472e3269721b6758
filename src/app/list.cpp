#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "problems/carrier_track/suite/machine.h"
#include "ricochet/error.h"
#include "ricochet/problem.h"
#include "ricochet/solver.h"
#include "src/app/command_line.h"
#include "src/core/names.h"
#include "src/report/json.h"
#include "src/report/table.h"
#include "src/studies/paper/interpretation.h"
#include "src/studies/suite/suite.h"

namespace ricochet::cli {
namespace {

using namespace carrier_track;
using report::Json;

struct ListOptions {
  std::string what;                   ///< cases, problems, solvers or interpretations
  std::string scene_file;             ///< problems of this machine; empty for the paper's
  std::vector<std::string> settings;  ///< of --set
  std::string family;                 ///< problems of this family; empty for all
  std::string solver;  ///< problems that it accepts in some formulation; empty for all
  bool json = false;
};

Table cases() {
  Table table{"cases", columns_named("case,restitution,friction,disturbance,paper_threshold,"
                                     "paper_quiet_count")};
  for (const Case& c : all_cases()) {
    table.add(c.id, c.restitution, c.friction, c.disturbance, c.claim.threshold,
              c.claim.quiet_count);
  }
  return table;
}

/// Returns the selected families.
std::vector<Family> families_of(const ListOptions& options) {
  std::vector<Family> families = suite_families(options.scene_file, options.settings);
  if (options.family.empty()) return families;
  std::vector<std::string> known;
  for (const Family& family : families) {
    if (family.name == options.family) return {family};
    known.push_back(family.name);
  }
  throw InputError(fmt::format("--family {}: there is no such family; {}", options.family,
                               what_instead(options.family, known)));
}

bool accepts_a_formulation(const Solver& solver, const Problem& problem) {
  const std::vector<Formulation> formulations = problem.formulations();
  return std::any_of(formulations.begin(), formulations.end(), [&](const Formulation& formulation) {
    return solver.accepts(problem.formulated(formulation));
  });
}

/// With the number of formulations.
Table problem_table(const std::vector<Problem>& problems) {
  Table table{"problems",
              {{"problem"},
               {"dimension", "n"},
               {"constraints"},
               {"equalities"},
               {"formulations"},
               {"derivatives"},
               {"best_known", "best known", ".8g"},
               {"source"}}};
  for (const Problem& problem : problems) {
    const std::vector<Formulation> formulations = problem.formulations();
    const bool derivatives = std::ranges::any_of(formulations, [&](const Formulation& each) {
      return static_cast<bool>(problem.formulated(each).differentiate);
    });
    table.add(problem.name, problem.dimension(), problem.constraints, problem.equalities,
              formulations.size(), derivatives, problem.best_known, problem.source);
  }
  return table;
}

int list_problems(const ListOptions& options) {
  std::optional<Solver> solver;
  if (!options.solver.empty()) solver = solver_named(options.solver, "--solver-accepts");
  std::vector<Problem> problems;
  for (const Family& family : families_of(options)) {
    std::ranges::copy_if(
        family.problems, std::back_inserter(problems),
        [&](const Problem& problem) { return !solver || accepts_a_formulation(*solver, problem); });
  }
  const Table table = problem_table(problems);
  if (!options.json) {
    print_table(only(table, {"problem", "dimension", "constraints", "equalities", "formulations",
                             "best_known"}),
                false);
    return 0;
  }
  Json rows = json_rows_of(table);
  for (std::size_t i = 0; i < problems.size(); ++i) {
    rows[i]["formulations"] = report::list_of(
        problems[i].formulations(),
        [&](const Formulation& formulation) { return problems[i].name_of(formulation); });
  }
  fmt::print("{}\n", rows.dump(2));
  return 0;
}

Table solvers() {
  Table table{"solvers",
              columns_named("solver,variables,constraints,needs,stochastic,at_limit,version")};
  const auto add = [&table](const std::string& name, const Capabilities& can,
                            const std::optional<bool>& stochastic,
                            const std::optional<std::string>& at_limit,
                            const std::string& version) {
    table.add(name, can.variables_in_words(), can.constraints_in_words(), can.needs_in_words(),
              stochastic, at_limit, version);
  };
  for (const Solver& s : all_solvers()) {
    const bool own = s.at_limit == AtLimit::own_point;
    add(s.name, s.capabilities, s.stochastic, own ? "its own point" : "best evaluated", s.version);
  }
  for (const MissingSolver& missing : missing_solvers()) {
    add(missing.solver, missing.capabilities, {}, {},
        fmt::format("missing: built without {}", missing.library));
  }
  return table;
}

Table interpretations() {
  Table table{"interpretations",
              {{"interpretation"}, {"constants", "n"}, {"default"}, {"description"}}};
  const auto add = [&table](const Interpretation& r) {
    table.add(name_of(r), unknowns_of(r).size(), r == default_interpretation().interpretation,
              description_of(r));
  };
  for (const Interpretation& core : core_interpretations()) {
    add(core);
    for (const Interpretation& r : variations(core)) add(r);
  }
  return table;
}

int list(const ListOptions& options) {
  const std::string& what = options.what;
  const bool asks = what == "problems";
  for (const auto& [option, given] : {std::pair("--scene", !options.scene_file.empty()),
                                      std::pair("--set", !options.settings.empty()),
                                      std::pair("--family", !options.family.empty()),
                                      std::pair("--solver-accepts", !options.solver.empty())}) {
    if (asks || !given) continue;
    throw InputError(fmt::format("{}: has problems alone, not {}", option, what));
  }
  if (asks) return list_problems(options);
  print_table(what == "cases"     ? cases()
              : what == "solvers" ? solvers()
                                  : interpretations(),
              options.json);
  return 0;
}

}  // namespace

void add_list(CommandLine& line) {
  CLI::App* command =
      line.add("list", "List cases, problems, solvers or interpretations",
               "  ricochet list problems --family top-speed\n"
               "  ricochet list problems --solver-accepts nlopt-slsqp --format json");
  const auto options = std::make_shared<ListOptions>();
  command->add_option("what", options->what, "cases, problems, solvers or interpretations")
      ->required()
      ->check(CLI::IsMember({"cases", "problems", "solvers", "interpretations"}));
  add_scene_file(command, options->scene_file, options->settings);
  add_value(command, "--family", options->family, "Problems of this family", "FAMILY");
  add_value(command, "--solver-accepts", options->solver,
            "Problems with a formulation that this solver accepts", "SOLVER");
  add_format(command, options->json);
  line.on_call(command, [options] { return list(*options); });
}

}  // namespace ricochet::cli
