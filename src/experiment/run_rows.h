#pragma once

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "ricochet/solver.h"
#include "src/experiment/store.h"
#include "src/experiment/store_file.h"

namespace ricochet {

/// A number of consecutive starts that ended for the same reason.
struct RepeatedTermination {
  std::string reason;
  std::int64_t starts = 0;
};

/// Termination reasons without points; equal ones in a row are one entry.
std::vector<RepeatedTermination> repeated(const std::vector<SolverTermination>& terminations);

/// The reverse: one entry for each start.
std::vector<SolverTermination> expanded(const std::vector<RepeatedTermination>& terminations);

/// The runs in the tables of schema.sql. The caller opens transactions. Throws Damage if a run was
/// changed since it was added, and the exceptions of SQLite.
class RunRows {
 public:
  /// The database must outlive it.
  explicit RunRows(SQLite::Database& database);

  /// Throws InputError if the problem or the solver is not in the campaign. After a failure, call
  /// forget().
  void add(const RunKey& key, const RunRecord& record);

  /// Clears the cache of looked-up rows, because a transaction that is rolled back has made some of
  /// them.
  void forget();

  std::set<RunKey> keys();
  std::int64_t size();
  void each(const std::function<void(const StoredRun&)>& use);
  std::optional<StoredRun> find(std::int64_t number);
  std::optional<StoredRun> find(const RunKey& key);

 private:
  std::map<Cell, std::int64_t> cells();
  std::optional<std::int64_t> known_cell(const Cell& cell);
  std::int64_t cell(const Cell& cell);
  std::int64_t reason(const std::string& text);
  StoredRun read(std::int64_t number, const Use& row, const Cell& cell);
  StoredRun read(const Use& row, const Cell& cell);
  std::vector<Improvement> trace(std::int64_t run);
  std::vector<RepeatedTermination> terminations(std::int64_t run);

  SQLite::Database& database_;
  std::map<Cell, std::int64_t> cells_;
  std::map<std::string, std::int64_t> reasons_;

  SQLite::Statement number_of_problem_, number_of_solver_, number_of_cell_, number_of_reason_;
  SQLite::Statement add_cell_, add_reason_, add_run_, add_improvement_, add_exit_;
  SQLite::Statement cells_there_, keys_of_cell_, runs_there_;
  SQLite::Statement runs_of_cell_, run_of_number_, run_of_key_, trace_, exits_;
};

/// Writes the description into the tables of schema.sql, which must be empty. The caller opens the
/// transaction. Throws InputError if two problems or two solvers have the same name.
void add_description(SQLite::Database& database, const CampaignDescription& description);

/// Reads the description. Throws Damage if it differs from what was written, and the exceptions of
/// SQLite.
CampaignDescription description_in(SQLite::Database& database);

}  // namespace ricochet
