#pragma once

#include <compare>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "ricochet/run.h"

namespace ricochet {

/// The common key of runs that differ only in instance and number: the unit of comparison.
struct Cell {
  std::string problem;
  std::string formulation;             ///< see Problem::name_of
  std::string perturbation = "plain";  ///< see all_perturbations()
  std::string solver;
  std::int64_t budget = 0;           ///< evaluations for each variable
  std::string gradient_price = "n";  ///< see PlanPart::gradient_prices

  auto operator<=>(const Cell&) const = default;
};

/// Identifies a run: two runs with the same key have the same results, whenever and wherever they
/// are made.
struct RunKey {
  Cell cell;
  int instance = 1;  ///< >= 0; 0 is the problem as stated
  int run = 0;       ///< >= 0; the number of the seed

  auto operator<=>(const RunKey&) const = default;
};

/// The key in words, for messages.
std::string name_of(const RunKey& key);

/// The key as one word, for command lines:
/// problem/formulation/perturbation/solver/budget/price/instance/run.
std::string address_of(const RunKey& key);

/// The key of such a word; nothing if it is none.
std::optional<RunKey> key_at(const std::string& address);

/// The data of a problem in a store, so that its runs can be scored without a simulation.
struct StoredProblem {
  std::string name;
  std::string family;
  std::string machine;  ///< empty if the problem has none
  std::int64_t variables = 0;
  std::int64_t constraints = 0;
  std::int64_t equalities = 0;
  double tolerance = 0;
  double best_known = 0;
  std::map<std::string, double> factors;        ///< of the machine: see Problem::factors
  std::map<std::string, double> findings = {};  ///< of its search, if its best value was not known
  std::string hash = {};                        ///< see planned_runs.h

  bool operator==(const StoredProblem&) const = default;
};

struct StoredSolver {
  std::string name;
  std::string version;
  std::string content = {};  ///< see Solver::content; empty also if an earlier ricochet made it

  bool operator==(const StoredSolver&) const = default;
};

/// The description of a campaign, written once when its store is made. Stores are parts of one
/// campaign if all of this except `made` is equal.
struct CampaignDescription {
  std::string plan;  ///< TOML text
  std::vector<StoredProblem> problems;
  std::vector<StoredSolver> solvers;
  std::map<std::string, std::string> program;  ///< version, commit, compiler, libraries
  std::map<std::string, std::string> made;     ///< machine, cores, date

  /// Of the problems, by name.
  std::map<std::string, std::string> hashes() const;

  bool operator==(const CampaignDescription&) const = default;
};

/// A run as it is read from a store. Of the record's trace only the last point has its x. Of the
/// points returned by the starts only the best is kept, in `returned`.
struct StoredRun {
  std::int64_t number;  ///< for `ricochet replay`
  RunKey key;
  RunRecord record;
};

/// The runs of a campaign in one SQLite file, whose tables are described in schema.sql. Every run
/// is a transaction: if the program is killed, all runs added before are kept. If the machine
/// crashes, the latest runs may be missing, but the file is intact. Only one process writes at a
/// time; others may read meanwhile. A closed store is this one file; an interruption closes it.
/// Beside a store whose program was killed by SIGKILL there are files with its name and -wal, -shm,
/// -lock; -wal is part of the store. The next open closes it, unless others read it or its folder
/// is read-only.
class Store {
 public:
  /// Makes a new file. Throws InputError if it exists or cannot be made.
  static Store create(const std::filesystem::path& file, const CampaignDescription& description);

  /// Makes a new file of the runs that `fill` passes to its argument, all or nothing. Throws as
  /// create() does, and OutputError if it cannot be written.
  using AddRun = std::function<void(const RunKey&, const RunRecord&)>;
  static void write(const std::filesystem::path& file, const CampaignDescription& description,
                    const std::function<void(const AddRun&)>& fill);

  /// The same in place of an existing file, which stays as it is until all is written.
  static void replace(const std::filesystem::path& file, const CampaignDescription& description,
                      const std::function<void(const AddRun&)>& fill);

  /// Rewrites a file that write() made without the gaps in its tables.
  static void pack(const std::filesystem::path& file);

  /// Opens a file to read it, which may be an archive, or to add runs. Throws InputError for a file
  /// that is missing, damaged (by SQLite's own integrity and foreign key checks, which take some
  /// seconds for a million runs), of another program, or of another version of the suite; for
  /// adding also if another process is adding runs. The file then stays unchanged.
  enum class For { reading, adding };
  static Store open(const std::filesystem::path& file, For purpose);

  Store(Store&&) noexcept;
  Store& operator=(Store&&) noexcept;
  ~Store();

  const CampaignDescription& description() const;

  /// Adds a run. Throws InputError if it already exists or the description lacks its problem or
  /// solver, OutputError if the disk is full; then the store stays unchanged.
  void add(const RunKey& key, const RunRecord& record);

  /// Closes a store that was opened for adding, which from now on can only be read.
  void finish();

  // Members that read runs throw InputError for one that differs from what was added: each run is
  // stored with its checksum.

  /// The keys of all runs in the store.
  std::set<RunKey> keys() const;
  std::int64_t size() const;

  /// Passes every run to `use`, by cell, then instance, then run.
  void each(const std::function<void(const StoredRun&)>& use) const;

  /// The run with this number; nothing if there is none.
  std::optional<StoredRun> find(std::int64_t number) const;

  /// The run with this key; nothing if there is none.
  std::optional<StoredRun> find(const RunKey& key) const;

  /// 16 hexadecimal digits that depend on every bit of description and runs, except times and other
  /// data that a repetition may change (`made`, numbers of runs, order of their arrival).
  std::string digest() const;

 private:
  struct Database;
  explicit Store(std::unique_ptr<Database> database);
  std::unique_ptr<Database> database_;
};

/// Says why runs may be missing in what is read from the file of a store: another process is adding
/// runs, or the file is a copy without the -wal that lay beside it. Empty if all runs are there.
std::string caution(const std::filesystem::path& file);

/// Joins stores into a new file. Throws InputError, naming the file and the difference, if one is
/// of another campaign, unless `united` makes one description of the two, or if two have the same
/// run with different results; then no file is made. Without `united` it keeps `made` of the first
/// store; to that it adds `made`, whose values are the later ones. Keeps the times of the first of
/// two equal runs.
using United =
    std::function<CampaignDescription(const CampaignDescription&, const CampaignDescription&)>;
void merge(const std::vector<std::filesystem::path>& parts, const std::filesystem::path& out,
           const United& united = nullptr, const std::map<std::string, std::string>& made = {});

}  // namespace ricochet
