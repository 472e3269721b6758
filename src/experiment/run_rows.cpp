#include "src/experiment/run_rows.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <utility>

#include "ricochet/error.h"
#include "src/experiment/merge.h"
#include "src/experiment/store_file.h"
#include "src/experiment/stored_fields.h"

namespace ricochet {

namespace {

/// All columns of a run except its number.
constexpr const char* columns =
    "cell, instance, run, problem, solver_name, own_instance, own_run, seed, evaluations_allowed, "
    "seconds_allowed, values_asked, derivatives_asked, hessians_asked, charged, refused, seconds, "
    "termination_reason, failure, best_x, returned_x, returned_objective, returned_violation, "
    "checksum";

std::string runs_where(const char* condition) {
  return fmt::format("SELECT {}, number FROM run WHERE {}", columns, condition);
}

/// What is kept of a run's checksum: 8 bits if it is of an archive, where runs have no seed. The
/// archive has a checksum of its own.
std::uint64_t kept(std::uint64_t checksum, const RunRecord& record) {
  return record.seed == 0 ? checksum & 0xffU : checksum;
}

std::optional<std::int64_t> first_number(Use& use) {
  if (!use.next()) return std::nullopt;
  return use.integer(0);
}

}  // namespace

RunRows::RunRows(SQLite::Database& database)
    : database_(database),
      number_of_problem_(database, "SELECT number FROM problem WHERE name = ?"),
      number_of_solver_(database, "SELECT number FROM solver WHERE name = ?"),
      number_of_cell_(
          database,
          "SELECT number FROM cell WHERE problem = ? AND formulation = ? AND perturbation = ? AND "
          "solver = ? AND budget = ? AND gradient_price = ?"),
      number_of_reason_(database, "SELECT number FROM reason WHERE text = ?"),
      add_cell_(
          database,
          "INSERT INTO cell (problem, formulation, perturbation, solver, budget, gradient_price) "
          "VALUES (?, ?, ?, ?, ?, ?)"),
      add_reason_(database, "INSERT INTO reason (text) VALUES (?)"),
      add_run_(database, fmt::format("INSERT INTO run ({}) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, "
                                     "?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
                                     columns)),
      add_improvement_(database, "INSERT INTO improvement VALUES (?, ?, ?, ?, ?, ?)"),
      add_exit_(database, "INSERT INTO termination VALUES (?, ?, ?, ?)"),
      cells_there_(
          database,
          "SELECT problem.name, formulation, perturbation, solver.name, budget, gradient_price, "
          "cell.number FROM cell JOIN problem ON problem.number = cell.problem "
          "JOIN solver ON solver.number = cell.solver"),
      keys_of_cell_(database,
                    "SELECT instance, run FROM run WHERE cell = ? ORDER BY instance, run"),
      runs_there_(database, "SELECT count(*) FROM run"),
      runs_of_cell_(database, runs_where("cell = ? ORDER BY instance, run")),
      run_of_number_(database, runs_where("number = ?")),
      run_of_key_(database, runs_where("cell = ? AND instance = ? AND run = ?")),
      trace_(database,
             "SELECT evaluations, seconds, objective, violation FROM improvement WHERE run = ? "
             "ORDER BY step"),
      exits_(database,
             "SELECT reason.text, starts FROM termination JOIN reason ON reason.number = "
             "termination.reason "
             "WHERE run = ? ORDER BY step") {}

void RunRows::forget() {
  cells_.clear();
  reasons_.clear();
}

std::optional<std::int64_t> RunRows::known_cell(const Cell& cell) {
  if (const auto known = cells_.find(cell); known != cells_.end()) return known->second;
  const auto problem = first_number(Use(number_of_problem_).with(cell.problem));
  if (!problem) throw InputError("the campaign has no problem " + cell.problem);
  const auto solver = first_number(Use(number_of_solver_).with(cell.solver));
  if (!solver) throw InputError("the campaign has no solver " + cell.solver);
  const auto number = first_number(Use(number_of_cell_)
                                       .with(*problem, cell.formulation, cell.perturbation, *solver,
                                             cell.budget, cell.gradient_price));
  if (number) cells_[cell] = *number;
  return number;
}

std::int64_t RunRows::cell(const Cell& cell) {
  if (const auto known = known_cell(cell)) return *known;
  const auto problem = first_number(Use(number_of_problem_).with(cell.problem));
  const auto solver = first_number(Use(number_of_solver_).with(cell.solver));
  Use(add_cell_)
      .with(*problem, cell.formulation, cell.perturbation, *solver, cell.budget,
            cell.gradient_price)
      .execute();
  return cells_[cell] = database_.getLastInsertRowid();
}

std::int64_t RunRows::reason(const std::string& text) {
  if (const auto known = reasons_.find(text); known != reasons_.end()) return known->second;
  if (const auto number = first_number(Use(number_of_reason_).with(text))) {
    return reasons_[text] = *number;
  }
  Use(add_reason_).with(text).execute();
  return reasons_[text] = database_.getLastInsertRowid();
}

void RunRows::add(const RunKey& key, const RunRecord& record) {
  if (const std::string wrong = impossibility(record); !wrong.empty()) {
    throw InputError(fmt::format("{} says what cannot be: {}", name_of(key), wrong));
  }
  const std::vector<RepeatedTermination> terminations = repeated(record.terminations);
  const Ledger& ledger = record.ledger;
  const Vector* best_x = record.trace.empty() ? nullptr : &record.trace.back().x;
  const ReturnedPoint* over = record.returned ? &*record.returned : nullptr;
  Use(add_run_)
      .with(cell(key.cell), key.instance, key.run, record.problem, record.solver, record.instance,
            record.run, static_cast<std::int64_t>(record.seed), record.budget.evaluations,
            record.budget.seconds, ledger.values, ledger.derivatives, ledger.hessians,
            ledger.charged, ledger.refused, ledger.seconds,
            static_cast<int>(record.termination_reason), record.failure, best_x,
            over != nullptr ? &over->x : nullptr,
            over != nullptr ? &over->true_values.objective : nullptr,
            over != nullptr ? &over->true_values.violation : nullptr,
            static_cast<std::int64_t>(kept(checksum(key, record, terminations), record)))
      .execute();
  const std::int64_t run = database_.getLastInsertRowid();
  std::int64_t step = 0;
  for (const Improvement& one : record.trace) {
    Use(add_improvement_)
        .with(run, step++, one.evaluations, one.seconds, one.true_values.objective,
              one.true_values.violation)
        .execute();
  }
  step = 0;
  for (const RepeatedTermination& exit : terminations) {
    Use(add_exit_).with(run, step++, reason(exit.reason), exit.starts).execute();
  }
}

std::map<Cell, std::int64_t> RunRows::cells() {
  std::map<Cell, std::int64_t> cells;
  Use row(cells_there_);
  while (row.next()) {
    const std::int64_t number = row.integer(6);
    in_row("cell", number, [&] {
      const Cell cell = {row.text(0), row.text(1),    row.text(2),
                         row.text(3), row.integer(4), row.text(5)};
      if (cell.budget < 0) throw Damage(fmt::format("budget is {}: must be >= 0", cell.budget));
      cells[cell] = number;
    });
  }
  return cells;
}

std::set<RunKey> RunRows::keys() {
  std::set<RunKey> keys;
  for (const auto& [cell, number] : cells()) {
    Use row(keys_of_cell_);
    row.with(number);
    while (row.next()) {
      const int instance = row.count(0);
      keys.insert(keys.end(), {cell, instance, row.count(1)});
    }
  }
  return keys;
}

std::int64_t RunRows::size() {
  Use row(runs_there_);
  return first_number(row).value();
}

void RunRows::each(const std::function<void(const StoredRun&)>& use) {
  for (const auto& [cell, number] : cells()) {
    Use row(runs_of_cell_);
    row.with(number);
    while (row.next()) use(read(row, cell));
  }
}

std::optional<StoredRun> RunRows::find(std::int64_t number) {
  Use row(run_of_number_);
  if (!row.with(number).next()) return std::nullopt;
  const std::int64_t number_of_cell = row.integer(0);
  for (const auto& [cell, its_number] : cells()) {
    if (its_number == number_of_cell) return read(row, cell);
  }
  throw Damage(fmt::format("run {} is of no cell", number));
}

std::optional<StoredRun> RunRows::find(const RunKey& key) {
  const auto number = known_cell(key.cell);
  if (!number) return std::nullopt;
  Use row(run_of_key_);
  if (!row.with(*number, key.instance, key.run).next()) return std::nullopt;
  return read(row, key.cell);
}

StoredRun RunRows::read(const Use& row, const Cell& cell) {
  const std::int64_t number = row.integer(23);
  return in_row("run", number, [&] { return read(number, row, cell); });
}

StoredRun RunRows::read(std::int64_t number, const Use& row, const Cell& cell) {
  StoredRun stored = {number, {cell, row.count(1), row.count(2)}, {}};
  RunRecord& record = stored.record;
  record.problem = row.text(3);
  record.solver = row.text(4);
  record.instance = row.count(5);
  record.run = row.count(6);
  record.seed = static_cast<std::uint64_t>(row.integer(7));
  record.budget = {row.integer(8), row.number(9)};
  record.ledger = {row.integer(10), row.integer(11), row.integer(12),
                   row.integer(13), row.integer(14), row.number(15)};
  record.termination_reason = static_cast<TerminationReason>(row.integer(16));
  record.failure = row.text(17);
  record.trace = trace(stored.number);
  if (!record.trace.empty()) record.trace.back().x = row.point(18);
  if (!row.is_null(19)) {
    record.returned = ReturnedPoint{row.point(19), {row.number(20), row.number(21)}};
  }
  const std::vector<RepeatedTermination> ended = terminations(stored.number);
  // Before the terminations are expanded: the number of starts may be damaged.
  const auto stated = static_cast<std::uint64_t>(row.integer(22));
  if (kept(stated, record) != kept(checksum(stored.key, record, ended), record)) {
    throw Damage("it is not what was added");
  }
  std::int64_t starts = 0;
  for (const RepeatedTermination& exit : ended) {
    if (exit.starts < 1 || exit.starts > most_starts - starts) {
      throw Damage(fmt::format("starts: must be >= 1, and of one run at most {}", most_starts));
    }
    starts += exit.starts;
  }
  record.terminations = expanded(ended);
  if (const std::string wrong = impossibility(record); !wrong.empty()) throw Damage(wrong);
  return stored;
}

std::vector<Improvement> RunRows::trace(std::int64_t run) {
  std::vector<Improvement> trace;
  Use row(trace_);
  row.with(run);
  while (row.next()) {
    in_row("improvement of run", run, [&] {
      trace.push_back({row.integer(0), row.number(1), {row.number(2), row.number(3)}, {}});
    });
  }
  return trace;
}

std::vector<RepeatedTermination> RunRows::terminations(std::int64_t run) {
  std::vector<RepeatedTermination> terminations;
  Use row(exits_);
  row.with(run);
  while (row.next()) {
    in_row("termination of run", run, [&] {
      terminations.push_back({row.text(0), row.integer(1)});
    });
  }
  return terminations;
}

namespace {

template <class Named>
void check_names(const std::vector<Named>& all, const char* what) {
  std::set<std::string> names;
  for (const Named& one : all) {
    if (!names.insert(one.name).second) {
      throw InputError(std::string("the campaign has two ") + what + " named " + one.name);
    }
  }
}

std::map<std::string, std::string> notes_in(SQLite::Database& database, const std::string& about) {
  std::map<std::string, std::string> notes;
  SQLite::Statement statement(database, "SELECT name, value FROM note WHERE about = ?");
  Use row(statement);
  row.with(about);
  while (row.next()) notes[row.text(0)] = row.text(1);
  return notes;
}

/// Reads the table of factors or of findings.
std::map<std::string, double> numbers_in(SQLite::Database& database, const std::string& table,
                                         std::int64_t problem) {
  std::map<std::string, double> numbers;
  SQLite::Statement statement(database, "SELECT name, value FROM " + table + " WHERE problem = ?");
  Use row(statement);
  row.with(problem);
  while (row.next()) numbers[row.text(0)] = row.number(1);
  return numbers;
}

/// Throws Damage for what no problem has.
void check(const StoredProblem& problem) {
  if (problem.variables == 0) throw Damage("variables is 0: must be >= 1");
  if (problem.equalities > problem.constraints) {
    throw Damage(fmt::format("equalities is {}: must be from 0 to {}, the number of constraints",
                             problem.equalities, problem.constraints));
  }
  if (!(problem.tolerance >= 0) || !std::isfinite(problem.tolerance)) {
    throw Damage(fmt::format("tolerance is {}: must be >= 0", problem.tolerance));
  }
  if (!std::isfinite(problem.best_known)) {
    throw Damage(fmt::format("best_known is {}: must be a number", problem.best_known));
  }
}

}  // namespace

void add_description(SQLite::Database& database, const CampaignDescription& description) {
  check_names(description.problems, "problems");
  check_names(description.solvers, "solvers");
  SQLite::Statement plan(database, "INSERT INTO campaign VALUES (?, ?)");
  Use(plan).with(description.plan, static_cast<std::int64_t>(checksum(description))).execute();
  SQLite::Statement note(database, "INSERT INTO note VALUES (?, ?, ?)");
  for (const auto& [name, value] : description.program) {
    Use(note).with(std::string("program"), name, value).execute();
  }
  for (const auto& [name, value] : description.made) {
    Use(note).with(std::string("made"), name, value).execute();
  }
  SQLite::Statement add_problem(database,
                                "INSERT INTO problem VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  SQLite::Statement add_factor(database, "INSERT INTO factor VALUES (?, ?, ?)");
  SQLite::Statement add_finding(database, "INSERT INTO finding VALUES (?, ?, ?)");
  int number = 0;
  for (const StoredProblem& problem : description.problems) {
    Use row(add_problem);
    row.with(++number);
    visit_columns([&](const Field& /*field*/, const auto& x) { row.with(x); }, problem);
    row.execute();
    for (const auto& [name, value] : problem.factors) {
      Use(add_factor).with(number, name, value).execute();
    }
    for (const auto& [name, value] : problem.findings) {
      Use(add_finding).with(number, name, value).execute();
    }
  }
  SQLite::Statement add_solver(database, "INSERT INTO solver VALUES (?, ?, ?)");
  number = 0;
  for (const StoredSolver& solver : description.solvers) {
    Use(add_solver).with(++number, solver.name, solver.version).execute();
    if (solver.content.empty()) continue;
    Use(note).with(std::string("content"), solver.name, solver.content).execute();
  }
}

CampaignDescription description_in(SQLite::Database& database) {
  CampaignDescription description;
  SQLite::Statement campaigns(database, "SELECT plan, checksum FROM campaign");
  Use campaign(campaigns);
  if (!campaign.next()) throw Damage("table campaign has no row");
  description.plan = campaign.text(0);
  description.program = notes_in(database, "program");
  description.made = notes_in(database, "made");
  const StoredProblem none;
  std::string columns = "number";
  visit_columns([&](const Field& field, const auto&) { (columns += ", ") += field.key; }, none);
  SQLite::Statement problems(database, "SELECT " + columns + " FROM problem ORDER BY number");
  Use row(problems);
  while (row.next()) {
    const std::int64_t number = row.integer(0);
    in_row("problem", number, [&] {
      StoredProblem& problem = description.problems.emplace_back();
      int column = 0;
      visit_columns([&](const Field& /*field*/, auto& x) { row.read(++column, x); }, problem);
      problem.factors = numbers_in(database, "factor", number);
      problem.findings = numbers_in(database, "finding", number);
      check(problem);
    });
  }
  auto contents = notes_in(database, "content");
  SQLite::Statement solvers(database, "SELECT name, version FROM solver ORDER BY number");
  Use solver(solvers);
  while (solver.next()) {
    description.solvers.push_back({solver.text(0), solver.text(1), contents[solver.text(0)]});
  }
  if (static_cast<std::uint64_t>(campaign.integer(1)) != checksum(description)) {
    throw Damage("table campaign: the description is not what was written");
  }
  if (campaign.next()) throw Damage("table campaign has more than one row");
  return description;
}

std::vector<RepeatedTermination> repeated(const std::vector<SolverTermination>& terminations) {
  std::vector<RepeatedTermination> repeated;
  for (const SolverTermination& exit : terminations) {
    if (repeated.empty() || repeated.back().reason != exit.reason) {
      repeated.push_back({exit.reason, 0});
    }
    ++repeated.back().starts;
  }
  return repeated;
}

std::vector<SolverTermination> expanded(const std::vector<RepeatedTermination>& terminations) {
  std::vector<SolverTermination> expanded;
  for (const RepeatedTermination& exit : terminations) {
    expanded.resize(expanded.size() + static_cast<std::size_t>(exit.starts), {exit.reason});
  }
  return expanded;
}

}  // namespace ricochet
