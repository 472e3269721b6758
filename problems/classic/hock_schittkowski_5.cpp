#include <array>
#include <cmath>
#include <numbers>

#include "problems/classic/hock_schittkowski.h"

namespace ricochet::classic {
namespace {

using std::numbers::sqrt2;

Problem hs_45() {
  const Vector upper{{1, 2, 3, 4, 5}};
  return from_formula(hock_schittkowski(45, "", Vector::Zero(5), upper, Vector::Constant(5, 2),
                                        {1, upper, in_closed_form}),
                      []<class Scalar>(const Point<Scalar>& x) {
                        return Scalar(2.0 - x[0] * x[1] * x[2] * x[3] * x[4] / 120.0);
                      });
}

Problem hs_46() {
  return with_equations(
      from_formulas(
          hock_schittkowski(46, "", Vector::Constant(5, -10), Vector::Constant(5, 10),
                            Vector{{sqrt2 / 2, 1.75, 0.5, 2, 2}},
                            {0, Vector::Ones(5), in_closed_form, true}),
          []<class Scalar>(const Point<Scalar>& x) {
            return square(x[0] - x[1]) + square(x[2] - 1.0) + square(square(x[3] - 1.0)) +
                   square(cubed(x[4] - 1.0));
          },
          []<class Scalar>(const Point<Scalar>& x) {
            using std::sin;
            return std::array<Scalar, 2>{x[0] * x[0] * x[3] + sin(x[3] - x[4]) - 1.0,
                                         x[1] + square(x[2] * x[2] * x[3]) - 2.0};
          }),
      2);
}

/// The second term of the objective is printed as a third power, which has no minimum at the
/// published point; the authors' programs have a second power, and so has this.
Problem hs_47() {
  return with_equations(
      from_formulas(
          hock_schittkowski(47, "", Vector::Constant(5, -10), Vector::Constant(5, 10),
                            Vector{{2, sqrt2, -1, 2 - sqrt2, 0.5}},
                            {0, Vector::Ones(5), in_closed_form, true}),
          []<class Scalar>(const Point<Scalar>& x) {
            return square(x[0] - x[1]) + square(x[1] - x[2]) + square(square(x[2] - x[3])) +
                   square(square(x[3] - x[4]));
          },
          []<class Scalar>(const Point<Scalar>& x) {
            return std::array<Scalar, 3>{x[0] + x[1] * x[1] + cubed(x[2]) - 3.0,
                                         x[1] - x[2] * x[2] + x[3] - 1.0, x[0] * x[4] - 1.0};
          }),
      3);
}

Problem hs_48() {
  return with_equations(
      from_formulas(
          hock_schittkowski(48, "", Vector::Constant(5, -10), Vector::Constant(5, 10),
                            Vector{{3, 5, -3, 2, -2}}, {0, Vector::Ones(5), in_closed_form, true}),
          []<class Scalar>(const Point<Scalar>& x) {
            return square(x[0] - 1.0) + square(x[1] - x[2]) + square(x[3] - x[4]);
          },
          []<class Scalar>(const Point<Scalar>& x) {
            return std::array<Scalar, 2>{x[0] + x[1] + x[2] + x[3] + x[4] - 5.0,
                                         x[2] - 2.0 * (x[3] + x[4]) + 3.0};
          }),
      2);
}

Problem hs_49() {
  return with_equations(from_formulas(
                            hock_schittkowski(49, "", Vector::Constant(5, -20),
                                              Vector::Constant(5, 20), Vector{{10, 7, 2, -3, 0.8}},
                                              {0, Vector::Ones(5), in_closed_form, true}),
                            []<class Scalar>(const Point<Scalar>& x) {
                              return square(x[0] - x[1]) + square(x[2] - 1.0) +
                                     square(square(x[3] - 1.0)) + square(cubed(x[4] - 1.0));
                            },
                            []<class Scalar>(const Point<Scalar>& x) {
                              return std::array<Scalar, 2>{x[0] + x[1] + x[2] + 4.0 * x[3] - 7.0,
                                                           x[2] + 5.0 * x[4] - 6.0};
                            }),
                        2);
}

Problem hs_50() {
  return with_equations(from_formulas(
                            hock_schittkowski(50, "", Vector::Constant(5, -50),
                                              Vector::Constant(5, 50), Vector{{35, -31, 11, 5, -5}},
                                              {0, Vector::Ones(5), in_closed_form, true}),
                            []<class Scalar>(const Point<Scalar>& x) {
                              return square(x[0] - x[1]) + square(x[1] - x[2]) +
                                     square(square(x[2] - x[3])) + square(x[3] - x[4]);
                            },
                            []<class Scalar>(const Point<Scalar>& x) {
                              return std::array<Scalar, 3>{x[0] + 2.0 * x[1] + 3.0 * x[2] - 6.0,
                                                           x[1] + 2.0 * x[2] + 3.0 * x[3] - 6.0,
                                                           x[2] + 2.0 * x[3] + 3.0 * x[4] - 6.0};
                            }),
                        3);
}

/// Problems 51 to 53: x_2 should equal `stretch` times x_1, and x_1 + 3 x_2 must equal `sum`.
Problem linear_equations(int number, double stretch, double sum, const Vector& start,
                         Optimum optimum) {
  return with_equations(from_formulas(
                            hock_schittkowski(number, "", Vector::Constant(5, -10),
                                              Vector::Constant(5, 10), start, std::move(optimum)),
                            [=]<class Scalar>(const Point<Scalar>& x) {
                              return square(stretch * x[0] - x[1]) + square(x[1] + x[2] - 2.0) +
                                     square(x[3] - 1.0) + square(x[4] - 1.0);
                            },
                            [=]<class Scalar>(const Point<Scalar>& x) {
                              return std::array<Scalar, 3>{x[0] + 3.0 * x[1] - sum,
                                                           x[2] + x[3] - 2.0 * x[4], x[1] - x[4]};
                            }),
                        3);
}

Problem hs_51() {
  return linear_equations(51, 1, 4, Vector{{2.5, 0.5, 2, -1, 0.5}},
                          {0, Vector::Ones(5), in_closed_form, true});
}

Problem hs_52() {
  return linear_equations(
      52, 4, 0, Vector::Constant(5, 2),
      {1859.0 / 349, Vector{{-33, 11, 180, -158, 11}} / 349, in_closed_form, true});
}

Problem hs_53() {
  return linear_equations(53, 1, 0, Vector::Constant(5, 2),
                          {176.0 / 43, Vector{{-33, 11, 27, -5, 11}} / 43, in_closed_form, true});
}

Problem hs_77() {
  return with_equations(
      from_formulas(
          hock_schittkowski(77, "", Vector::Constant(5, -10), Vector::Constant(5, 10),
                            Vector::Constant(5, 2),
                            {0.24150512879017869,
                             Vector{{1.1661721897092985, 1.1821113888027044, 1.3802570431454597,
                                     1.5060362736230457, 0.6109201960430908}},
                             "published: 0.24150513; digits by Newton's method"}),
          []<class Scalar>(const Point<Scalar>& x) {
            return square(x[0] - 1.0) + square(x[0] - x[1]) + square(x[2] - 1.0) +
                   square(square(x[3] - 1.0)) + square(cubed(x[4] - 1.0));
          },
          []<class Scalar>(const Point<Scalar>& x) {
            using std::sin;
            return std::array<Scalar, 2>{x[0] * x[0] * x[3] + sin(x[3] - x[4]) - 2.0 * sqrt2,
                                         x[1] + square(x[2] * x[2] * x[3]) - (8.0 + sqrt2)};
          }),
      2);
}

/// The equality constraints of problems 78, 80 and 81.
constexpr auto three_equations = []<class Scalar>(const Point<Scalar>& x) {
  return std::array<Scalar, 3>{x.squaredNorm() - 10.0, x[1] * x[2] - 5.0 * x[3] * x[4],
                               cubed(x[0]) + cubed(x[1]) + 1.0};
};

Problem hs_78() {
  return with_equations(
      from_formulas(
          hock_schittkowski(78, "", Vector::Constant(5, -10), Vector::Constant(5, 10),
                            Vector{{-2, 1.5, 2, -1, -1}},
                            {-2.9197004089636787,
                             Vector{{-1.717143570394382, 1.5957096901835544, 1.8272457529271946,
                                     -0.7636430781841304, -0.7636430781841304}},
                             "published: -2.91970041; digits by Newton's method"}),
          []<class Scalar>(const Point<Scalar>& x) { return x.prod(); }, three_equations),
      3);
}

Problem hs_79() {
  return with_equations(
      from_formulas(
          hock_schittkowski(79, "", Vector::Constant(5, -10), Vector::Constant(5, 10),
                            Vector::Constant(5, 2),
                            {0.07877682087105692,
                             Vector{{1.1911274563110514, 1.3626031649617423, 1.4728179315120877,
                                     1.635016619167993, 1.6790814361664075}},
                             "published: 0.0787768209; digits by Newton's method"}),
          []<class Scalar>(const Point<Scalar>& x) {
            return square(x[0] - 1.0) + square(x[0] - x[1]) + square(x[1] - x[2]) +
                   square(square(x[2] - x[3])) + square(square(x[3] - x[4]));
          },
          []<class Scalar>(const Point<Scalar>& x) {
            return std::array<Scalar, 3>{x[0] + x[1] * x[1] + cubed(x[2]) - (2.0 + 3.0 * sqrt2),
                                         x[1] - x[2] * x[2] + x[3] + (2.0 - 2.0 * sqrt2),
                                         x[0] * x[4] - 2.0};
          }),
      3);
}

/// The statement of problems 80 and 81, which have the same optimum.
Statement exponential_of_product(int number) {
  const Vector upper{{2.3, 2.3, 3.2, 3.2, 3.2}};
  return hock_schittkowski(number, "", -upper, upper, Vector{{-2, 2, 2, -1, -1}},
                           {0.05394984777027198,
                            Vector{{-1.7171435703943823, 1.5957096901835546, 1.8272457529271946,
                                    -0.7636430781841305, -0.7636430781841305}},
                            "published: 0.0539498478; digits by Newton's method"});
}

Problem hs_80() {
  return with_equations(from_formulas(
                            exponential_of_product(80),
                            []<class Scalar>(const Point<Scalar>& x) {
                              using std::exp;
                              return Scalar(exp(x.prod()));
                            },
                            three_equations),
                        3);
}

Problem hs_81() {
  return with_equations(
      from_formulas(
          exponential_of_product(81),
          []<class Scalar>(const Point<Scalar>& x) {
            using std::exp;
            return Scalar(exp(x.prod()) - 0.5 * square(cubed(x[0]) + cubed(x[1]) + 1.0));
          },
          three_equations),
      3);
}

Problem hs_83() {
  return from_formulas(
      hock_schittkowski(
          83, "", Vector{{78, 33, 27, 27, 27}}, Vector{{102, 45, 45, 45, 45}},
          Vector{{78, 33, 27, 27, 27}},
          {-30665.538671783317, Vector{{78, 33, 29.995256025681623, 45, 36.77581290578815}},
           "published: -30665.53867; digits by Newton's method"}),
      []<class Scalar>(const Point<Scalar>& x) {
        return 5.3578547 * x[2] * x[2] + 0.8356891 * x[0] * x[4] + 37.293239 * x[0] - 40792.141;
      },
      []<class Scalar>(const Point<Scalar>& x) {
        const Scalar first =
            85.334407 + 0.0056858 * x[1] * x[4] + 0.0006262 * x[0] * x[3] - 0.0022053 * x[2] * x[4];
        const Scalar second =
            80.51249 + 0.0071317 * x[1] * x[4] + 0.0029955 * x[0] * x[1] + 0.0021813 * x[2] * x[2];
        const Scalar third =
            9.300961 + 0.0047026 * x[2] * x[4] + 0.0012547 * x[0] * x[2] + 0.0019085 * x[2] * x[3];
        return std::array<Scalar, 6>{-first,       90.0 - second,  20.0 - third,
                                     first - 92.0, second - 110.0, third - 25.0};
      });
}

Problem hs_84() {
  return from_formulas(
      hock_schittkowski(84, "", Vector{{0, 1.2, 20, 9, 6.5}}, Vector{{1000, 2.4, 60, 9.3, 7}},
                        Vector{{2.52, 2, 37.5, 9.25, 6.8}},
                        {-5280335.133214757, Vector{{4.537430974655399, 2.4, 60, 9.3, 7}},
                         "published: -5280335.133; digits by Newton's method"}),
      []<class Scalar>(const Point<Scalar>& x) {
        return 24345.0 + x[0] * (8720288.849 - 150512.5253 * x[1] + 156.6950325 * x[2] -
                                 476470.3222 * x[3] - 729482.8271 * x[4]);
      },
      []<class Scalar>(const Point<Scalar>& x) {
        const std::array<Scalar, 3> sums{
            x[0] * (-145421.402 + 2931.1506 * x[1] - 40.427932 * x[2] + 5106.192 * x[3] +
                    15711.36 * x[4]),
            x[0] * (-155011.1084 + 4360.53352 * x[1] + 12.9492344 * x[2] + 10236.884 * x[3] +
                    13176.786 * x[4]),
            x[0] * (-326669.5104 + 7390.68412 * x[1] - 27.8986976 * x[2] + 16643.076 * x[3] +
                    30988.146 * x[4])};
        return std::array<Scalar, 6>{-sums[0],           -sums[1],           -sums[2],
                                     sums[0] - 294000.0, sums[1] - 294000.0, sums[2] - 277200.0};
      });
}

}  // namespace

std::vector<Problem> hock_schittkowski_5() {
  return {hs_45(), hs_46(), hs_47(), hs_48(), hs_49(), hs_50(), hs_51(), hs_52(),
          hs_53(), hs_77(), hs_78(), hs_79(), hs_80(), hs_81(), hs_83(), hs_84()};
}

}  // namespace ricochet::classic
