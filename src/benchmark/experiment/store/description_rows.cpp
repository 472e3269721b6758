#include "src/store/description_rows.h"

#include <cstdint>
#include <set>
#include <string>

#include "src/core/error.h"
#include "src/store/sqlite_values.h"
#include "src/store/stored_parts.h"

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

std::map<std::string, double> factors_in(SQLite::Database& database, std::int64_t question) {
  std::map<std::string, double> factors;
  SQLite::Statement statement(database, "SELECT name, value FROM factor WHERE question = ?");
  Use row(statement);
  row.with(question);
  while (row.next()) factors[row.text(0)] = row.number(1);
  return factors;
}

}  // namespace

void add_description(SQLite::Database& database, const CampaignDescription& description) {
  check_names(description.questions, "questions");
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
  SQLite::Statement add_question(database,
                                 "INSERT INTO question VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)");
  SQLite::Statement add_factor(database, "INSERT INTO factor VALUES (?, ?, ?)");
  int number = 0;
  for (const StoredQuestion& question : description.questions) {
    Use(add_question)
        .with(++number, question.name, question.family, question.machine, question.variables,
              question.constraints, question.equalities, question.tolerance, question.best_known)
        .execute();
    for (const auto& [name, value] : question.factors) {
      Use(add_factor).with(number, name, value).execute();
    }
  }
  SQLite::Statement add_solver(database, "INSERT INTO solver VALUES (?, ?, ?)");
  number = 0;
  for (const StoredSolver& solver : description.solvers) {
    Use(add_solver).with(++number, solver.name, solver.version).execute();
  }
}

CampaignDescription description_in(SQLite::Database& database) {
  CampaignDescription description;
  SQLite::Statement campaigns(database, "SELECT plan, checksum FROM campaign");
  Use campaign(campaigns);
  if (!campaign.next()) throw Damage("the description is missing");
  description.plan = campaign.text(0);
  description.program = notes_in(database, "program");
  description.made = notes_in(database, "made");
  SQLite::Statement questions(database,
                              "SELECT number, name, family, machine, variables, constraints, "
                              "equalities, tolerance, best_known FROM question ORDER BY number");
  Use question(questions);
  while (question.next()) {
    description.questions.push_back({question.text(1), question.text(2), question.text(3),
                                     question.integer(4), question.integer(5), question.integer(6),
                                     question.number(7), question.number(8),
                                     factors_in(database, question.integer(0))});
  }
  SQLite::Statement solvers(database, "SELECT name, version FROM solver ORDER BY number");
  Use solver(solvers);
  while (solver.next()) description.solvers.push_back({solver.text(0), solver.text(1)});
  if (static_cast<std::uint64_t>(campaign.integer(1)) != checksum(description)) {
    throw Damage("the description is not what was written");
  }
  return description;
}

}  // namespace ricochet
