#include "problems/classic/hock_schittkowski.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace ricochet::classic {

namespace {

/// Problems that share their objective, or their model: of each list one cluster.
const std::vector<std::vector<int>>& alike() {
  static const std::vector<std::vector<int>> lists = {
      {1, 2, 15, 16, 17, 20, 58},  // Rosenbrock's valley
      {36, 37},                    // the largest box
      {51, 52, 53},                // squares under three linear equations
      {68, 69},                    // a control chart
      {74, 75},                    // two generators
      {78, 80, 81},                // a product under three equations
      {86, 117},                   // a convex problem and its dual
      {88, 89, 90, 91, 92},        // a heated rod
      {95, 96, 97, 98},            // other limits
      {101, 102, 103},             // a geometric program with another exponent
      {111, 112},                  // a chemical equilibrium, in logarithms and in moles
  };
  return lists;
}

std::string cluster_of(int number) {
  for (const std::vector<int>& list : alike()) {
    if (std::ranges::find(list, number) != list.end()) return fmt::format("hs-{}", list.front());
  }
  return fmt::format("hs-{}", number);
}

}  // namespace

std::vector<Problem> hock_schittkowski_problems() {
  std::vector<Problem> problems;
  for (const auto& part :
       {hock_schittkowski_valley(), hock_schittkowski_2(), hock_schittkowski_3(),
        hock_schittkowski_4(), hock_schittkowski_5(), hock_schittkowski_6(), hock_schittkowski_8(),
        hock_schittkowski_fits(), hock_schittkowski_plants(), hock_schittkowski_networks(),
        hock_schittkowski_dual(), hock_schittkowski_heat(), hock_schittkowski_geometric()}) {
    problems.insert(problems.end(), part.begin(), part.end());
  }
  const auto number = [](const Problem& problem) { return std::stoi(problem.name.substr(3)); };
  std::sort(problems.begin(), problems.end(),
            [number](const Problem& a, const Problem& b) { return number(a) < number(b); });
  return problems;
}

Statement hock_schittkowski(int number, const std::string& author, Vector lower, Vector upper,
                            Vector start, Optimum optimum) {
  return {.name = fmt::format("hs-{}", number),
          .source = fmt::format("Hock and Schittkowski (1981), doi 10.1007/978-3-642-48320-2, "
                                "problem {}{}{}",
                                number, author.empty() ? "" : ", of ", author),
          .lower = std::move(lower),
          .upper = std::move(upper),
          .start = std::move(start),
          .best_known = optimum.value,
          .best_point = std::move(optimum.point),
          .provenance = std::move(optimum.provenance),
          .rotates = optimum.everywhere,
          .start_scales = {1},
          .cluster = cluster_of(number)};
}

Problem with_equations(Problem problem, Eigen::Index equations) {
  problem.equalities = equations;
  return problem;
}

Statement nonnegative(const char* name, const char* source, double lower, double upper,
                      Vector best) {
  const Eigen::Index n = best.size();
  return {.name = fmt::format("classic-{}-{}", name, n),
          .source = source,
          .lower = Vector::Constant(n, lower),
          .upper = Vector::Constant(n, upper),
          .start = Vector::Constant(n, lower + 0.8 * (upper - lower)),
          .best_known = 0,
          .best_point = std::move(best),
          .provenance = "closed form: no term is negative, and all are 0 there",
          .rotates = true};
}

namespace {

using std::numbers::sqrt3;

/// Rosenbrock's valley, the objective of all problems of this file.
constexpr auto valley = []<class Scalar>(const Point<Scalar>& x) {
  const Scalar across = x[1] - x[0] * x[0];
  const Scalar along = 1.0 - x[0];
  return Scalar(100.0 * across * across + along * along);
};

Problem hs_1() {
  return from_formula(hock_schittkowski(1, "Betts", Vector{{-10, -1.5}}, Vector{{10, 10}},
                                        Vector{{-2, 1}}, {0, Vector{{1, 1}}, in_closed_form, true}),
                      valley);
}

Problem hs_2() {
  const double a = std::sqrt(598.0 / 1200);
  const double b = 400 * a * a * a;
  const double x = 2 * a * std::cos(std::acos(1 / b) / 3);
  const double across = 1.5 - x * x;
  return from_formula(
      hock_schittkowski(
          2, "Betts", Vector{{-10, 1.5}}, Vector{{10, 10}}, Vector{{-2, 1}},
          {100 * across * across + (1 - x) * (1 - x), Vector{{x, 1.5}}, in_closed_form}),
      valley);
}

Problem hs_15() {
  return from_formulas(
      hock_schittkowski(15, "Betts", Vector{{-10, -10}}, Vector{{0.5, 10}}, Vector{{-2, 1}},
                        {306.5, Vector{{0.5, 2}}, in_closed_form}),
      valley, []<class Scalar>(const Point<Scalar>& x) {
        return std::array<Scalar, 2>{1.0 - x[0] * x[1], -x[0] - x[1] * x[1]};
      });
}

Problem hs_16() {
  return from_formulas(
      hock_schittkowski(16, "", Vector{{-0.5, -10}}, Vector{{0.5, 1}}, Vector{{-2, 1}},
                        {0.25, Vector{{0.5, 0.25}}, in_closed_form}),
      valley, []<class Scalar>(const Point<Scalar>& x) {
        return std::array<Scalar, 2>{-x[0] - x[1] * x[1], -x[0] * x[0] - x[1]};
      });
}

Problem hs_17() {
  return from_formulas(hock_schittkowski(17, "", Vector{{-0.5, -10}}, Vector{{0.5, 1}},
                                         Vector{{-2, 1}}, {1, Vector{{0, 0}}, in_closed_form}),
                       valley, []<class Scalar>(const Point<Scalar>& x) {
                         return std::array<Scalar, 2>{x[0] - x[1] * x[1], x[1] - x[0] * x[0]};
                       });
}

Problem hs_20() {
  const double within = std::nextafter(sqrt3 / 2, 1.0);  // sqrt3 / 2 is rounded down
  return from_formulas(
      hock_schittkowski(20, "", Vector{{-0.5, -10}}, Vector{{0.5, 10}}, Vector{{-2, 1}},
                        {81.5 - 25 * sqrt3, Vector{{0.5, within}}, in_closed_form}),
      valley, []<class Scalar>(const Point<Scalar>& x) {
        return std::array<Scalar, 3>{-x[0] - x[1] * x[1], -x[0] * x[0] - x[1],
                                     1.0 - x[0] * x[0] - x[1] * x[1]};
      });
}

Problem hs_58() {
  return from_formulas(
      hock_schittkowski(
          58, "", Vector{{-2, -10}}, Vector{{0.5, 10}}, Vector{{-2, 1}},
          {3.1903367442647417, Vector{{-0.7861513777574234, 0.6180339887498949}},
           "closed form, x_1^2 = x_2 and x_1^2 + x_2^2 = 1; published: 3.19033354957, near it"}),
      valley, []<class Scalar>(const Point<Scalar>& x) {
        return std::array<Scalar, 3>{x[0] - x[1] * x[1], x[1] - x[0] * x[0],
                                     1.0 - x[0] * x[0] - x[1] * x[1]};
      });
}

}  // namespace

std::vector<Problem> hock_schittkowski_valley() {
  return {hs_1(), hs_2(), hs_15(), hs_16(), hs_17(), hs_20(), hs_58()};
}

}  // namespace ricochet::classic
