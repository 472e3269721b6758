#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "problems/own/program.h"

namespace SQLite {  // NOLINT(readability-identifier-naming): that library's
class Database;
}

namespace ricochet::own {

/// Which evaluation of a program: of one point, and where values are noisy, the first, second, ...
/// that a run asked for there. Without noise a point has one evaluation, which all runs share.
struct EvaluationKey {
  std::string run = {};  ///< empty without noise
  std::int64_t attempt = 0;
};

/// A point whose values are asked for, where they are told; in the coordinates of the file.
struct AskedPoint {
  std::int64_t id;
  EvaluationKey key;
  Vector x;
  bool derivatives;
  bool told;  ///< its values are there
};

/// How often evaluations failed for one reason.
struct FailureCount {
  std::string reason;
  std::int64_t evaluations;
};

/// The evaluations of a problem, in a file (SQLite), each kept as soon as it is there: a process
/// that is killed loses the one that it was making. Several processes may use one file: each opens
/// it when it first asks, and a process that forks others should have closed it.
/// Evaluations of a program that was another one then are kept beside, and not found.
class EvaluationStore {
 public:
  /// The file is opened, or made, when it is first needed. All functions throw InputError if it is
  /// no such file or cannot be written.
  EvaluationStore(std::filesystem::path file, std::string content);
  ~EvaluationStore();
  EvaluationStore(const EvaluationStore&) = delete;
  EvaluationStore& operator=(const EvaluationStore&) = delete;

  void close();

  /// The evaluation, if it is there with all that is asked for.
  std::optional<Given> find(const ProblemFile& file, const EvaluationKey& key, const Vector& x,
                            bool derivatives);

  /// Keeps it, and returns what is kept: what another process has kept meanwhile, if it has all
  /// that was asked for.
  Given keep(const ProblemFile& file, const EvaluationKey& key, const Vector& x, bool derivatives,
             const Given& given);

  /// Asks for the values at a point. Returns its number: that which it has, if it was asked for.
  std::int64_t ask(const EvaluationKey& key, const Vector& x, bool derivatives);

  /// All points that were asked for, in that order.
  std::vector<AskedPoint> asked();

  /// Forgets what is kept of a point, so that it can be told again.
  void forget(const AskedPoint& point);

  /// Forgets all evaluations if none ever succeeded: then the program's surroundings failed.
  /// Returns how many.
  std::int64_t forget_if_all_failed();

  /// The numbers of evaluations that failed by reason, the most frequent first.
  std::vector<FailureCount> failures();

 private:
  SQLite::Database& database();

  const std::filesystem::path file_;
  const std::string content_;
  int owner_ = 0;  // process that opened it; 0: none has
  std::unique_ptr<SQLite::Database> database_;
  std::mutex mutex_;
};

}  // namespace ricochet::own
