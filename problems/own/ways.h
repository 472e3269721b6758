#pragma once

#include <filesystem>
#include <memory>

#include "problems/own/problem_file.h"
#include "problems/own/program.h"

namespace ricochet::own {

/// One process that evaluates points, each in the coordinates of the file.
class Way {
 public:
  virtual ~Way() = default;
  /// Throws std::exception, with the program's last words, if the evaluation fails; the process may
  /// not be used again then.
  virtual Given evaluate(const Vector& x, bool derivatives) = 0;
  /// Whether the calling thread made it.
  virtual bool is_of_this_thread() const = 0;
};

/// Starts the program of the file, which must outlive it: a command, an executable or a library.
std::unique_ptr<Way> way_of(const ProblemFile& file);

/// The folder of the file, in which the program runs.
std::filesystem::path folder_of(const ProblemFile& file);

}  // namespace ricochet::own
