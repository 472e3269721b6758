#pragma once

#include <string>

#include "problems/classic/formula.h"

namespace ricochet::classic {

/// The known optimum of a problem of Hock and Schittkowski.
struct Optimum {
  double value;
  Vector point;
  std::string provenance;
  bool everywhere = false;  ///< inside the box, and best on all of R^n; see Problem::rotates
};

/// The statement of problem `number`; `author` as in the source, or empty.
Statement hock_schittkowski(int number, const std::string& author, Vector lower, Vector upper,
                            Vector start, Optimum optimum);

/// The problem with its first `equations` constraints as equations.
Problem with_equations(Problem problem, Eigen::Index equations);

inline constexpr const char* in_closed_form = "closed form, published";

template <class Scalar>
Scalar square(const Scalar& t) {
  return t * t;
}

template <class Scalar>
Scalar cubed(const Scalar& t) {
  return t * t * t;
}

}  // namespace ricochet::classic
