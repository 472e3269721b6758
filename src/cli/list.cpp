#include "src/cli/list.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "problems/carrier_track/paper/cases.h"
#include "problems/carrier_track/paper/fitted_reading.h"
#include "problems/families.h"
#include "solvers/acceptance.h"
#include "solvers/solvers.h"
#include "src/core/error.h"
#include "src/core/near_names.h"
#include "src/report/json.h"

namespace ricochet::cli {
namespace {

using namespace carrier_track;
using report::Json;

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

Solver solver_named(const std::string& name) {
  std::vector<std::string> known;
  for (const Solver& solver : all_solvers()) {
    if (solver.name == name) return solver;
    known.push_back(solver.name);
  }
  throw InputError(fmt::format("--solver-accepts {}: there is no such solver; {}", name,
                               what_instead(name, known)));
}

/// Those of the families asked for.
std::vector<Family> families_of(const ListOptions& options) {
  std::vector<Family> families = all_families(options.scene_file);
  if (options.family.empty()) return families;
  std::vector<std::string> known;
  for (const Family& family : families) {
    if (family.name == options.family) return {family};
    known.push_back(family.name);
  }
  throw InputError(fmt::format("--family {}: there is no such family; {}", options.family,
                               what_instead(options.family, known)));
}

bool accepts_a_form(const Solver& solver, const Question& question) {
  const std::vector<Form> forms = question.forms();
  return std::any_of(forms.begin(), forms.end(),
                     [&](const Form& form) { return solver.accepts(question.problem(form)); });
}

Json questions(const ListOptions& options) {
  Json rows = Json::array();
  std::optional<Solver> solver;
  if (!options.solver.empty()) solver = solver_named(options.solver);
  for (const Family& family : families_of(options)) {
    for (const Question& q : family.questions) {
      if (solver && !accepts_a_form(*solver, q)) continue;
      Json forms = Json::array();
      bool derivatives = false;
      for (const Form& form : q.forms()) {
        forms.push_back(q.name_of(form));
        derivatives = derivatives || q.problem(form).differentiate;
      }
      rows.push_back({{"question", q.name()},
                      {"dimension", q.stated.dimension()},
                      {"constraints", q.stated.constraints},
                      {"equalities", q.stated.equalities},
                      {"forms", forms},
                      {"derivatives", derivatives},
                      {"best_known", q.stated.best_known},
                      {"source", q.stated.source}});
    }
  }
  return rows;
}

Json solvers() {
  Json rows = Json::array();
  for (const Solver& s : all_solvers()) {
    const Acceptance acceptance = acceptance_of(s);
    rows.push_back({{"solver", s.name},
                    {"variables", acceptance.variables},
                    {"constraints", acceptance.constraints},
                    {"needs", acceptance.needs},
                    {"stochastic", s.stochastic},
                    {"version", s.version}});
  }
  for (const MissingSolver& missing : missing_solvers()) {
    rows.push_back({{"solver", missing.solver},
                    {"variables", nullptr},
                    {"constraints", nullptr},
                    {"needs", nullptr},
                    {"stochastic", nullptr},
                    {"version", fmt::format("missing: built without {}", missing.library)}});
  }
  return rows;
}

Json readings() {
  Json rows = Json::array();
  const auto add = [&rows](const Reading& r) {
    rows.push_back({{"reading", name_of(r)},
                    {"constants", open_of(r).size()},
                    {"default", r == default_reading().reading},
                    {"description", description_of(r)}});
  };
  for (const Reading& core : core_readings()) {
    add(core);
    for (const Reading& r : variations(core)) add(r);
  }
  return rows;
}

/// A cell as text: strings without quotes, of lists their length, a dash for what is missing.
std::string cell(const Json& value) {
  if (value.is_array()) return std::to_string(value.size());
  if (value.is_number_float()) return fmt::format("{:.8g}", value.get<double>());
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  if (value.is_string()) return value.get<std::string>();
  return value.is_null() ? "-" : value.dump();
}

/// A column: the key of its cells, and what stands above them.
struct Column {
  std::string key, title;
};

/// Without the columns that would make rows too long.
std::vector<Column> columns_of(const std::string& what, const Json& rows) {
  if (what == "questions" || what == "problems") {
    return {{"question", "question"},     {"dimension", "n"}, {"constraints", "constraints"},
            {"equalities", "equalities"}, {"forms", "forms"}, {"best_known", "best known"}};
  }
  std::vector<Column> columns;
  for (const auto& [key, value] : rows.front().items()) {
    columns.push_back({key, key == "constants" ? "n" : key});
  }
  return columns;
}

/// A line a row, of no more than 100 columns: the last cell is cut.
void print_table(const Json& rows, const std::vector<Column>& columns) {
  constexpr std::size_t longest = 100;
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
    if (line.size() > longest) line = line.substr(0, longest - 3) + "...";
    fmt::print("{}\n", line);
  };
  print_line([](const Column& column) { return column.title; });
  for (const Json& row : rows) {
    print_line([&row](const Column& column) { return cell(row[column.key]); });
  }
}

}  // namespace

int list(const ListOptions& options) {
  const std::string& what = options.what;
  const bool asks = what == "questions" || what == "problems";
  for (const auto& [option, value] :
       {std::pair("--scene", options.scene_file), std::pair("--family", options.family),
        std::pair("--solver-accepts", options.solver)}) {
    if (asks || value.empty()) continue;
    throw InputError(fmt::format("{}: has questions alone, not {}", option, what));
  }
  const Json rows = what == "cases"     ? cases()
                    : asks              ? questions(options)
                    : what == "solvers" ? solvers()
                                        : readings();
  if (options.json) {
    fmt::print("{}\n", rows.dump(2));
    return 0;
  }
  print_table(rows, columns_of(what, rows));
  return 0;
}

}  // namespace ricochet::cli
