#pragma once

#include <ricochet/ricochet.h>
#include <sys/stat.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "ricochet/solver.h"
#include "src/core/instance.h"

namespace ricochet::outside {

/// The solver that the shared library at `path`, which contains a /, exports as ricochet_plugin;
/// see include/ricochet/ricochet.h. If it has no name, the file's name is used. The library is
/// loaded in another process to learn what it claims, and in this one when `solve` is first called;
/// it stays loaded until that process ends. An exception of the solver ends the run. Throws
/// InputError if the file is no library, the library is no such solver, or loading it crashes or
/// takes more than 10 s or 2 GB.
Solver plugin(const std::string& path);

/// One start of a solver that the shared library at `path` exports, as Solver::solve. Throws
/// std::runtime_error, naming the path, if the solver throws.
SolverTermination solve_by(const ricochet_solver& exported, const std::string& path,
                           Evaluator& evaluator, const Vector& start, Random& random);

/// What an external solver declares about itself.
struct Claims {
  std::string name, version;
  int takes_constraints = 0;  ///< 0: none; 1: inequalities; 2: equalities, too
  bool needs_derivatives = false;
  bool needs_residuals = false;
  bool stochastic = false;
};

/// A solver with these claims; its `solve` is left empty. Throws InputError, naming `source`, for a
/// name that cannot stand in a list of names, or a claim out of range.
Solver solver_as_claimed(const Claims& claims, const std::string& source);

/// What a user's solver consists of, as it was when it was added: files, by their bytes and not by
/// their names, and texts.
class Content {
 public:
  void add_text(std::string_view text);

  /// A file that cannot be read counts as an empty one.
  void add_file(const std::filesystem::path& file);

  /// 16 hexadecimal digits.
  std::string hash() const;

  /// The first of the files that is another one now; empty if all are as they were.
  std::string changed() const;

 private:
  struct File {
    std::filesystem::path path;
    struct stat status;
    std::uint64_t hash;
  };
  static File read(const std::filesystem::path& path);

  std::vector<File> files_;
  FnvHash hash_;
};

/// Where a command that is started in `folder` finds its program; empty if there is none.
std::filesystem::path program_of(const std::vector<std::string>& words,
                                 const std::filesystem::path& folder = {});

/// What a command that is started in `folder` consists of: its program, found on PATH, every file
/// that its further words name, also as --option=FILE, and the words that name none. A program of
/// the system, such as /usr/bin/python3, counts by its name only.
Content content_of_command(const std::vector<std::string>& words,
                           const std::filesystem::path& folder = {});

/// Returns true for a file below /usr, but not /usr/local, /bin, /sbin or /lib, wherever symbolic
/// links lead: the system's packages bring it, and an author does not edit it.
bool is_of_the_system(const std::filesystem::path& file);

}  // namespace ricochet::outside
