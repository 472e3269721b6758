#pragma once

#include <string>
#include <vector>

#include "problems/classic/formula.h"
#include "ricochet/problem.h"

/// The 116 test problems of Hock and Schittkowski, Test Examples for Nonlinear Programming Codes
/// (1981), doi 10.1007/978-3-642-48320-2, "hs-<number>", with their numbers (82, 94 and 115 do not
/// exist), bounds and starts. Bounds are the box's; if the source has none, the box is wide enough
/// to contain the start and to keep the optimum. Inequalities, >= 0 in the source, are negated, and
/// equations come first. A start outside its own bounds is moved to the nearest point within.
namespace ricochet::classic {

/// All of them, in the order of their numbers.
std::vector<Problem> hock_schittkowski_problems();

/// Problems on Rosenbrock's valley.
std::vector<Problem> hock_schittkowski_valley();

/// The others with two variables.
std::vector<Problem> hock_schittkowski_2();

/// Of three variables.
std::vector<Problem> hock_schittkowski_3();

/// Of four variables.
std::vector<Problem> hock_schittkowski_4();

/// Of five variables.
std::vector<Problem> hock_schittkowski_5();

/// Of six and seven variables.
std::vector<Problem> hock_schittkowski_6();

/// Of eight variables and more.
std::vector<Problem> hock_schittkowski_8();

/// Fits to data.
std::vector<Problem> hock_schittkowski_fits();

/// Plants of the chemical industry.
std::vector<Problem> hock_schittkowski_plants();

/// Electrical networks.
std::vector<Problem> hock_schittkowski_networks();

/// A convex problem and its dual.
std::vector<Problem> hock_schittkowski_dual();

/// The control of heat.
std::vector<Problem> hock_schittkowski_heat();

/// Geometric programs.
std::vector<Problem> hock_schittkowski_geometric();

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

/// The statement of "classic-<name>-<n>", for a function that is nonnegative on R^n and 0 at
/// `best`, on [lower, upper]^n.
Statement nonnegative(const char* name, const char* source, double lower, double upper,
                      Vector best);

}  // namespace ricochet::classic
