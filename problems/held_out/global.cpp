#include <cmath>
#include <numbers>

#include "problems/held_out/held_out.h"

namespace ricochet::held_out {

namespace {

using namespace classic;
using std::numbers::e;
using std::numbers::pi;

constexpr const char* survey = "Jamil and Yang (2013), doi 10.1504/IJMMNO.2013.055204";

/// In the box [lower, upper]^n. A box around a best point at its centre is cut at 3/5 of its lower
/// half, and a run begins at 4/5 of every width, as in the family "classic".
Statement function(const char* name, Eigen::Index n, double lower, double upper, double best,
                   const Vector& best_point, const char* provenance) {
  const Vector least = Vector::Constant(n, lower), most = Vector::Constant(n, upper);
  return stated("outside-global", name, survey, least, most, least + 0.8 * (most - least), best,
                best_point, provenance);
}

Problem bohachevsky() {
  return from_formula(
      function("bohachevsky", 2, -60, 100, 0, Vector::Zero(2), "closed form: no term is negative"),
      []<class Scalar>(const Point<Scalar>& x) {
        using std::cos;
        return Scalar(x[0] * x[0] + 2.0 * x[1] * x[1] + 0.3 * (1.0 - cos(3 * pi * x[0])) +
                      0.4 * (1.0 - cos(4 * pi * x[1])));
      });
}

Problem easom() {
  return from_formula(function("easom", 2, -100, 100, -1, Vector::Constant(2, pi),
                               "closed form: each factor is largest there"),
                      []<class Scalar>(const Point<Scalar>& x) {
                        using std::cos;
                        using std::exp;
                        const Scalar a = x[0] - pi, b = x[1] - pi;
                        return Scalar(-cos(x[0]) * cos(x[1]) * exp(-a * a - b * b));
                      });
}

Problem drop_wave() {
  return from_formula(function("drop-wave", 2, -3.072, 5.12, -1, Vector::Zero(2),
                               "closed form: the quotient of the largest by the least"),
                      []<class Scalar>(const Point<Scalar>& x) {
                        using std::cos;
                        using std::sqrt;
                        const Scalar squares = x.squaredNorm();
                        if (squares == 0.0) return Scalar(-1);
                        return Scalar(-(1.0 + cos(12.0 * sqrt(squares))) / (0.5 * squares + 2.0));
                      });
}

Problem eggholder() {
  return from_formula(
      function("eggholder", 2, -512, 512, -959.64066272085,
               Vector{
                   {512, 404.23180514},
               },
               "published: -959.6407; digits by Newton's method along the edge"),
      []<class Scalar>(const Point<Scalar>& x) {
        using std::abs;
        using std::sin;
        using std::sqrt;
        const Scalar y = x[1] + 47.0;
        return Scalar(-y * sin(sqrt(abs(x[0] / 2.0 + y))) - x[0] * sin(sqrt(abs(x[0] - y))));
      });
}

Problem schaffer_2() {
  return from_formula(function("schaffer-2", 2, -60, 100, 0, Vector::Zero(2),
                               "closed form: the quotient is least there"),
                      []<class Scalar>(const Point<Scalar>& x) {
                        using std::sin;
                        const Scalar a = x[0] * x[0], b = x[1] * x[1];
                        const Scalar wave = sin(a - b), far = 1.0 + 0.001 * (a + b);
                        return Scalar(0.5 + (wave * wave - 0.5) / (far * far));
                      });
}

Problem levy_13() {
  return from_formula(
      function("levy-13", 2, -10, 10, 0, Vector::Ones(2), "closed form: no term is negative"),
      []<class Scalar>(const Point<Scalar>& x) {
        using std::sin;
        const auto square_of_sine = [](const Scalar& t) { return Scalar(sin(t) * sin(t)); };
        const Scalar a = x[0] - 1.0, b = x[1] - 1.0;  // the sines' periods are whole there
        return Scalar(square_of_sine(3 * pi * a) + a * a * (1.0 + square_of_sine(3 * pi * b)) +
                      b * b * (1.0 + square_of_sine(2 * pi * b)));
      });
}

Problem shubert() {
  return from_formula(
      function("shubert", 2, -10, 10, -186.7309088310239, Vector{{-7.083506407, 4.858056878}},
               "published: -186.7309; digits by Newton's method, one of eighteen"),
      []<class Scalar>(const Point<Scalar>& x) {
        using std::cos;
        Scalar product(1);
        for (const Scalar& t : x) {
          Scalar sum(0);
          for (int i = 1; i <= 5; ++i) sum += double(i) * cos((i + 1.0) * t + double(i));
          product *= sum;
        }
        return product;
      });
}

Problem michalewicz() {
  Statement statement =
      function("michalewicz-5", 5, 0, pi, -4.687658179088148,
               Vector{{2.202905521, 1.570796327, 1.284991568, 1.923058470, 1.720469797}},
               "published: -4.687658; digits by Newton's method");
  return from_formula(statement, []<class Scalar>(const Point<Scalar>& x) {
    using std::pow;
    using std::sin;
    Scalar sum(0);
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      const Scalar wave = sin(static_cast<double>(i + 1) * x[i] * x[i] / pi);
      Scalar power(1);
      for (int k = 0; k < 20; ++k) power *= wave;
      sum -= sin(x[i]) * power;
    }
    return sum;
  });
}

Problem salomon() {
  return from_formula(
      function("salomon-5", 5, -60, 100, 0, Vector::Zero(5), "closed form: no term is negative"),
      []<class Scalar>(const Point<Scalar>& x) {
        using std::cos;
        using std::sqrt;
        const Scalar squares = x.squaredNorm();
        if (squares == 0.0) return Scalar(0);
        const Scalar r = sqrt(squares);
        return Scalar(1.0 - cos(2 * pi * r) + 0.1 * r);
      });
}

Problem mccormick() {
  Statement statement =
      function("mccormick", 2, -1.5, 4, -std::numbers::sqrt3 / 2 - pi / 3,
               Vector{{0.5 - pi / 3, -0.5 - pi / 3}}, "closed form: both derivatives are 0 there");
  statement.lower[1] = -3;
  statement.start[1] = -3 + 0.8 * 7;
  return from_formula(statement, []<class Scalar>(const Point<Scalar>& x) {
    using std::sin;
    const Scalar apart = x[0] - x[1];
    return Scalar(sin(x[0] + x[1]) + apart * apart - 1.5 * x[0] + 2.5 * x[1] + 1.0);
  });
}

Problem cosine_mixture() {
  return from_formula(function("cosine-mixture-4", 4, -0.6, 1, -0.4, Vector::Zero(4),
                               "closed form: each term is least there"),
                      []<class Scalar>(const Point<Scalar>& x) {
                        using std::cos;
                        Scalar sum(0);
                        for (const Scalar& t : x) sum += t * t - 0.1 * cos(5 * pi * t);
                        return sum;
                      });
}

Problem alpine_2() {
  constexpr double best = 7.917052684666206;  // tan x = -2 x
  return from_formula(
      function("alpine-2-3", 3, 0.01, 10, -std::pow(std::sqrt(best) * std::sin(best), 3),
               Vector::Constant(3, best), "closed form: tan x = -2 x in every coordinate"),
      []<class Scalar>(const Point<Scalar>& x) {
        using std::sin;
        using std::sqrt;
        Scalar product(-1);
        for (const Scalar& t : x) product *= sqrt(t) * sin(t);
        return product;
      });
}

Problem hosaki() {
  Statement statement =
      function("hosaki", 2, 0, 5, -52.0 / 3 / (e * e), Vector{{4, 2}}, "closed form: a product");
  statement.upper[1] = 6;
  statement.start[1] = 4.8;
  return from_formula(statement, []<class Scalar>(const Point<Scalar>& x) {
    using std::exp;
    const Scalar& a = x[0];
    return Scalar((1.0 + a * (-8.0 + a * (7.0 + a * (-7.0 / 3 + a / 4.0)))) * x[1] * x[1] *
                  exp(-x[1]));
  });
}

}  // namespace

std::vector<Problem> global_problems() {
  return {bohachevsky(),    easom(),    drop_wave(),   eggholder(), schaffer_2(),
          levy_13(),        shubert(),  michalewicz(), salomon(),   mccormick(),
          cosine_mixture(), alpine_2(), hosaki()};
}

}  // namespace ricochet::held_out
