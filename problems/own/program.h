#pragma once

#include <limits>
#include <string>
#include <string_view>

#include "problems/own/problem_file.h"
#include "solvers/outside/line_solver.h"

namespace ricochet::own {

using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

inline constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// What a program gave at a point. What it did not give is NaN, and what it was not asked for is
/// empty; constraints are in the order of the file, a binary one 0 where it holds, else 1.
struct Given {
  double objective = 0;
  Vector constraints;
  Vector gradient;
  Rows jacobian;  ///< constraints x n
  Vector residuals;
  Rows residual_jacobian;    ///< residuals x n
  double seconds = 0;        ///< of the wall clock
  std::string failure = {};  ///< why the evaluation has no values; empty: it has
};

/// All NaN, of the sizes that the file says. Residuals are always given where there are some.
Given nothing_given(const ProblemFile& file, bool derivatives);

/// The numbers of what was given, as bytes: every bit of them.
std::string bytes_of(const Given& given);

/// Reads them again into what has these sizes. Returns false if it has others.
bool read_bytes(std::string_view bytes, Given& given);

/// The values in a line of JSON, as `ricochet evaluate` answers. Throws InputError if it has not
/// what is needed, and std::runtime_error with its reason if it says that there are none.
Given given_in_line(const ProblemFile& file, std::string_view line, bool derivatives);

/// The values among numbers in the order of the file's outputs, in text as C, Fortran and others
/// write it; after a number that is alone on its line a word may stand, as in Dakota's results.
/// Throws InputError if they are not as many as needed.
Given given_in_numbers(const ProblemFile& file, const std::string& text);

/// Makes the value of each binary constraint, in the order of the file, 0 where it holds, else 1.
void make_binary(const ProblemFile& file, Vector& constraints);

double half_sum_of_squares(const Vector& residuals);

class Way;

/// The program of a problem file, in one process for each thread that evaluates. A process that
/// fails is ended with all that it started, and another is started for the next point.
class Program {
 public:
  /// Starts nothing. Throws InputError if there is no such program.
  explicit Program(ProblemFile file);
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  /// Evaluates a point, in the file's coordinates; a failure is part of what is returned.
  Given evaluate(const Vector& x, bool derivatives);

  /// What is started, for people: "python3 mine.py".
  std::string command() const;

  /// Hash of all that the values depend on: the program and the files that the problem file names,
  /// its constraints and the parts that are given.
  std::string content() const { return content_; }

 private:
  const ProblemFile file_;
  std::string content_;
  outside::WaitingProcesses<Way> waiting_;
};

}  // namespace ricochet::own
