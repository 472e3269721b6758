#include "src/benchmark/experiment/store/description_rows.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <set>
#include <string>

#include "ricochet/error.h"
#include "src/benchmark/experiment/store/sqlite_values.h"
#include "src/benchmark/experiment/store/stored_parts.h"

namespace ricochet {
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
    Use(add_problem)
        .with(++number, problem.name, problem.family, problem.machine, problem.variables,
              problem.constraints, problem.equalities, problem.tolerance, problem.best_known,
              problem.hash)
        .execute();
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
  SQLite::Statement problems(
      database,
      "SELECT number, name, family, machine, variables, constraints, "
      "equalities, tolerance, best_known, hash FROM problem ORDER BY number");
  Use problem(problems);
  while (problem.next()) {
    const std::int64_t number = problem.integer(0);
    in_row("problem", number, [&] {
      description.problems.push_back({problem.text(1), problem.text(2), problem.text(3),
                                      problem.count(4), problem.count(5), problem.count(6),
                                      problem.number(7), problem.number(8),
                                      numbers_in(database, "factor", number),
                                      numbers_in(database, "finding", number), problem.text(9)});
      check(description.problems.back());
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

}  // namespace ricochet
