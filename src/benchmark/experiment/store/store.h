#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "src/core/run.h"
#include "src/store/run_key.h"

namespace ricochet {

/// What a store knows of a question, so that nothing need be simulated to judge its runs.
struct StoredQuestion {
  std::string name;
  std::string family;
  std::string machine;  ///< empty where it is asked of none
  std::int64_t variables = 0;
  std::int64_t constraints = 0;
  std::int64_t equalities = 0;
  double tolerance = 0;
  double best_known = 0;
  std::map<std::string, double> factors;  ///< of the machine: see Question::factors

  bool operator==(const StoredQuestion&) const = default;
};

struct StoredSolver {
  std::string name;
  std::string version;

  bool operator==(const StoredSolver&) const = default;
};

/// What a campaign is, written once when its store is made. Stores are parts of one campaign where
/// all of this but `made` is the same.
struct CampaignDescription {
  std::string plan;  ///< TOML text
  std::vector<StoredQuestion> questions;
  std::vector<StoredSolver> solvers;
  std::map<std::string, std::string> program;  ///< version, commit, compiler, libraries
  std::map<std::string, std::string> made;     ///< machine, cores, date

  bool operator==(const CampaignDescription&) const = default;
};

/// A run as it is read from a store. Of the record's trace only the last point has its x, of the
/// exits no points are kept, but the best is `handed_over`.
struct StoredRun {
  std::int64_t number;  ///< by which `ricochet replay` asks for it
  RunKey key;
  RunRecord record;
};

/// The runs of a campaign in one SQLite file, whose tables are described in schema.sql. Every run
/// is a transaction of its own: whenever the program is killed, all runs added before are there.
/// Where the machine dies, too, the latest may be missing, and the file is whole. Only one process
/// writes at a time; others may read meanwhile. A closed store is this one file; beside one that
/// was killed are others, with its name and -wal, -shm, -lock, and the first belongs to it.
class Store {
 public:
  /// Makes a new file. Throws InputError where there is one, or where there can be none.
  static Store create(const std::filesystem::path& file, const CampaignDescription& description);

  /// Opens a file to read it, or to add runs. Throws InputError for a file that is missing, damaged
  /// (by SQLite's own integrity and foreign key checks, which take some seconds for a million
  /// runs), of another program, or of another version of the schema; for adding also where another
  /// process does so at this moment. Such a file stays untouched.
  enum class For { reading, adding };
  static Store open(const std::filesystem::path& file, For purpose);

  Store(Store&&) noexcept;
  Store& operator=(Store&&) noexcept;
  ~Store();

  const CampaignDescription& description() const;

  /// Adds a run. Throws InputError where it is there already, or of a question or solver that the
  /// description lacks, OutputError where the disk takes no more; then all is as before.
  void add(const RunKey& key, const RunRecord& record);

  // What reads runs throws InputError where it finds one that differs from what was added: each is
  // kept with its checksum.

  /// The runs that are there.
  std::set<RunKey> keys() const;
  std::int64_t size() const;

  /// Hands over every run, by cell, then instance, then run.
  void each(const std::function<void(const StoredRun&)>& use) const;

  /// Nothing where there is no run of this number.
  std::optional<StoredRun> find(std::int64_t number) const;

  /// 16 hexadecimal digits that depend on every bit of description and runs, but for times and what
  /// else a repetition may change (`made`, numbers of runs, order of their arrival).
  std::string digest() const;

 private:
  struct Database;
  explicit Store(std::unique_ptr<Database> database);
  std::unique_ptr<Database> database_;
};

/// Joins stores of parts of one campaign into a new file. Throws InputError, naming the file and
/// what differs, where one is of another campaign, or where two have the same run with different
/// results; then no file is made. What `made` the first is kept, as are the times of the first of
/// two equal runs.
void merge(const std::vector<std::filesystem::path>& parts, const std::filesystem::path& out);

}  // namespace ricochet
