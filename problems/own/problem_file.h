#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ricochet/problem.h"

/// Problems of a user's own: a file (TOML) describes the box, the constraints and the program that
/// computes the values.
namespace ricochet::own {

enum class Goal { minimise, maximise };
enum class Scale { linear, logarithmic };

/// The file that an executable reads a point from: numbers with blanks between them, as NOMAD
/// writes it, or Dakota's standard format, version 6.
enum class PointFormat { numbers, dakota };

/// An inequality holds where its value is <= 0, an equality where it is 0, and a binary constraint,
/// of which no more is known, where its value is 0 (true in JSON).
enum class ConstraintKind { inequality, equality, binary };

struct FileVariable {
  std::string name;
  std::string unit = {};
  double lower = 0, upper = 0;
  std::optional<double> start = {};  ///< empty: in the middle, on its scale
  Scale scale = Scale::linear;

  bool operator==(const FileVariable&) const = default;
};

struct FileConstraint {
  std::string name;
  ConstraintKind kind = ConstraintKind::inequality;

  bool operator==(const FileConstraint&) const = default;
};

/// What computes the values. One of command, executable and library, or told.
struct FileProgram {
  std::string command = {};     ///< started once; answers lines of JSON
  std::string executable = {};  ///< started for each point, with the name of a file
  std::string library = {};     ///< a shared library with ricochet_evaluate()
  bool told = false;  ///< nothing here computes them: points are asked for, and their values told
  std::vector<std::string> outputs = {};  ///< of the executable, in order; empty: the usual ones
  PointFormat format = PointFormat::numbers;  ///< of the executable's file
  bool derivatives = false;                   ///< gives gradient and Jacobian, too
  std::optional<std::int64_t> gradient_cost;  ///< of those beside the value [evaluations]; empty: n
  std::int64_t residuals = 0;                 ///< so many; 0: the objective is no sum of squares
  double seconds = 60;                  ///< allowed for an evaluation, with the program's start
  double megabytes = 2000;              ///< allowed besides those of ricochet
  std::vector<std::string> files = {};  ///< that it reads: other values where one is changed

  bool operator==(const FileProgram&) const = default;
};

struct ProblemFile {
  std::string name;
  std::string unit = {};
  Goal goal = Goal::minimise;
  bool noise = false;  ///< values differ from one evaluation of a point to the next
  bool jumps = false;  ///< values jump, as counts do
  std::optional<double> best_known = {};  ///< as the goal has it
  double tolerance = 1e-6;                ///< of the objective
  FileProgram program;
  std::vector<FileVariable> variables;
  std::vector<FileConstraint> constraints = {};

  std::filesystem::path path = {};  ///< of the file; no field of it

  /// The constraints in the order of Problem: equalities first. Indices into `constraints`.
  std::vector<std::size_t> order() const;

  /// Coordinates that a solver sees, in which a logarithmic variable is its natural logarithm, from
  /// those of the program, and back. Back, a bound is the bound of the file to the last bit.
  Vector seen(const Vector& stated) const;
  Vector stated(const Vector& seen) const;

  bool operator==(const ProblemFile&) const = default;
};

/// Whether the text, where a name of a problem may stand, is a problem file: it ends in ".toml".
bool is_problem_file(const std::string& text);

/// Reads a problem file; starts nothing. Throws InputError with file, line, key, value and allowed
/// range.
ProblemFile read_problem_file(const std::filesystem::path& path);

/// The same from a text; messages name it `path`, and the program's files are looked for beside it.
ProblemFile problem_file_from(const std::string& text, const std::filesystem::path& path);

/// The file as text, which reads back to the same.
std::string text_of(const ProblemFile& file);

}  // namespace ricochet::own
