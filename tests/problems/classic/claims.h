#pragma once

#include "ricochet/run.h"
#include "src/core/difference.h"
#include "src/core/instance.h"
#include "tests/support/files.h"
#include "tests/support/test.h"

/// What every problem of a list must fulfil.
namespace ricochet::classic {

/// The problem of this name.
inline Problem named(const std::vector<Problem>& problems, const std::string& name) {
  const auto found = std::ranges::find(problems, name, &Problem::name);
  if (found == problems.end()) throw std::invalid_argument("no problem " + name);
  return *found;
}

/// The lines of a table beside the tests that are of problems of this kind, in their cells.
inline std::vector<std::vector<std::string>> lines_published(const std::string& table,
                                                             const std::string& kind) {
  std::vector<std::vector<std::string>> rows;
  for (const std::string& line :
       lines_of(text_of(fs::path(RICOCHET_SOURCE) / "tests/problems/classic" / table))) {
    if (!line.starts_with(kind)) continue;
    rows.emplace_back();
    std::istringstream cells(line + ",");
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
  }
  return rows;
}

/// Objective and constraints as one vector.
inline Vector all_of(const Values& values) {
  Vector all(1 + values.constraints.size());
  all << values.objective, values.constraints;
  return all;
}

/// A random point of the box, a tenth as far from the best point as the box reaches: beyond, some
/// values are so large that differences of them are none.
inline Vector point_near_best(const Problem& problem, Random& random) {
  return 0.9 * *problem.best_point + 0.1 * uniform_point(problem, random);
}

/// The columns of a Jacobian agree with differences of the function, to `tolerance` of the column's
/// largest entry, and to what rounding of the function leaves of them.
template <class Function>
void expect_columns(const Problem& problem, const Vector& x, const Matrix& jacobian,
                    Function function, double tolerance) {
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const auto along = [&](double t) -> Vector {
      Vector moved = x;
      moved[i] = t;
      return function(moved);
    };
    const double width = problem.upper[i] - problem.lower[i];
    Vector found(jacobian.rows());
    for (Eigen::Index k = 0; const Difference& d : differences(along, x[i], 1e-3 * width)) {
      found[k++] = d.slope;
    }
    const double size = std::max(jacobian.col(i).cwiseAbs().maxCoeff(), 1e-12);
    const double rounding = 1e-12 * function(x).cwiseAbs().maxCoeff() / width;
    EXPECT_LE((jacobian.col(i) - found).cwiseAbs().maxCoeff(), tolerance * size + rounding)
        << "column " << i << "\n"
        << jacobian.col(i).transpose() << "\n"
        << found.transpose();
  }
}

}  // namespace ricochet::classic
