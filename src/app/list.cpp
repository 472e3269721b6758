#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "problems/carrier_track/suite/machine.h"
#include "ricochet/error.h"
#include "ricochet/problem.h"
#include "ricochet/solver.h"
#include "src/app/command_line.h"
#include "src/core/names.h"
#include "src/report/json.h"
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

Json cases() {
  Json rows = Json::array();
  for (const Case& c : all_cases()) {
    rows.push_back({{"case", c.id},
                    {"restitution", c.restitution},
                    {"friction", c.friction},
                    {"disturbance", c.disturbance},
                    {"paper_threshold", c.claim.threshold},
                    {"paper_quiet_count", c.claim.quiet_count}});
  }
  return rows;
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

Json problems(const ListOptions& options) {
  Json rows = Json::array();
  std::optional<Solver> solver;
  if (!options.solver.empty()) solver = solver_named(options.solver, "--solver-accepts");
  for (const Family& family : families_of(options)) {
    for (const Problem& q : family.problems) {
      if (solver && !accepts_a_formulation(*solver, q)) continue;
      Json formulations = Json::array();
      bool derivatives = false;
      for (const Formulation& formulation : q.formulations()) {
        formulations.push_back(q.name_of(formulation));
        derivatives = derivatives || q.formulated(formulation).differentiate;
      }
      rows.push_back({{"problem", q.name},
                      {"dimension", q.dimension()},
                      {"constraints", q.constraints},
                      {"equalities", q.equalities},
                      {"formulations", formulations},
                      {"derivatives", derivatives},
                      {"best_known", q.best_known},
                      {"source", q.source}});
    }
  }
  return rows;
}

Json solvers() {
  Json rows = Json::array();
  const auto add = [&rows](const std::string& name, const Capabilities& capabilities,
                           const Json& stochastic, const Json& at_limit,
                           const std::string& version) {
    rows.push_back({{"solver", name},
                    {"variables", capabilities.variables_in_words()},
                    {"constraints", capabilities.constraints_in_words()},
                    {"needs", capabilities.needs_in_words()},
                    {"stochastic", stochastic},
                    {"at_limit", at_limit},
                    {"version", version}});
  };
  for (const Solver& s : all_solvers()) {
    const bool own = s.at_limit == AtLimit::own_point;
    add(s.name, s.capabilities, s.stochastic, own ? "its own point" : "best evaluated", s.version);
  }
  for (const MissingSolver& missing : missing_solvers()) {
    add(missing.solver, missing.capabilities, nullptr, nullptr,
        fmt::format("missing: built without {}", missing.library));
  }
  return rows;
}

Json interpretations() {
  Json rows = Json::array();
  const auto add = [&rows](const Interpretation& r) {
    rows.push_back({{"interpretation", name_of(r)},
                    {"constants", unknowns_of(r).size()},
                    {"default", r == default_interpretation().interpretation},
                    {"description", description_of(r)}});
  };
  for (const Interpretation& core : core_interpretations()) {
    add(core);
    for (const Interpretation& r : variations(core)) add(r);
  }
  return rows;
}

/// A cell as text: strings without quotes, lists as their length, a dash for missing values.
std::string cell(const Json& value) {
  if (value.is_array()) return std::to_string(value.size());
  if (value.is_number_float()) return fmt::format("{:.8g}", value.get<double>());
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  if (value.is_string()) return value.get<std::string>();
  return value.is_null() ? "-" : value.dump();
}

/// A column: the key of its cells, and its heading.
struct Column {
  std::string key, title;
};

/// Omits the columns that would make rows too long.
std::vector<Column> columns_of(const std::string& what, const Json& rows) {
  if (what == "problems") {
    return {{"problem", "problem"},           {"dimension", "n"},
            {"constraints", "constraints"},   {"equalities", "equalities"},
            {"formulations", "formulations"}, {"best_known", "best known"}};
  }
  std::vector<Column> columns;
  for (const auto& [key, value] : rows.front().items()) {
    columns.push_back({key, key == "constants" ? "n" : key});
  }
  return columns;
}

/// The columns of the terminal that standard output is; nothing if it is none, or does not say.
std::optional<std::size_t> terminal_width() {
  winsize size{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return std::nullopt;
  return size.ws_col;
}

/// Prints a line for each row, cut at the edge of the terminal; whole if there is none.
void print_table(const Json& rows, const std::vector<Column>& columns) {
  constexpr std::string_view cut = "...";
  const std::optional<std::size_t> longest = terminal_width();
  std::vector<std::size_t> widths;
  for (const Column& column : columns) {
    std::size_t width = column.title.size();
    for (const Json& row : rows) width = std::max(width, cell(row[column.key]).size());
    widths.push_back(width);
  }
  const auto print_line = [&](auto text) {
    std::string line;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      line += fmt::format("{:<{}}  ", text(columns[i]), widths[i]);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    if (longest && line.size() > *longest) {
      line.resize(*longest - std::min(*longest, cut.size()));
      line += cut;
    }
    fmt::print("{}\n", line);
  };
  print_line([](const Column& column) { return column.title; });
  for (const Json& row : rows) {
    print_line([&row](const Column& column) { return cell(row[column.key]); });
  }
}

int list(const ListOptions& options) {
  const std::string& what = options.what;
  const bool asks = what == "problems";
  for (const auto& [option, value] :
       {std::pair("--scene", options.scene_file), std::pair("--family", options.family),
        std::pair("--solver-accepts", options.solver)}) {
    if (asks || value.empty()) continue;
    throw InputError(fmt::format("{}: has problems alone, not {}", option, what));
  }
  if (!asks && !options.settings.empty()) {
    throw InputError(fmt::format("--set: has problems alone, not {}", what));
  }
  const Json rows = what == "cases"     ? cases()
                    : asks              ? problems(options)
                    : what == "solvers" ? solvers()
                                        : interpretations();
  if (options.json) {
    fmt::print("{}\n", rows.dump(2));
    return 0;
  }
  print_table(rows, columns_of(what, rows));
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
  command->add_option("--family", options->family, "Problems of this family")->type_name("FAMILY");
  command
      ->add_option("--solver-accepts", options->solver,
                   "Problems with a formulation that this solver accepts")
      ->type_name("SOLVER");
  add_format(command, options->json);
  line.on_call(command, [options] { return list(*options); });
}

}  // namespace ricochet::cli
