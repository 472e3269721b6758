#include <array>
#include <cmath>

#include "problems/held_out/held_out.h"

namespace ricochet::held_out {

namespace {

using namespace classic;

constexpr const char* strd = "NIST, Statistical Reference Datasets, nonlinear regression";
constexpr const char* certified = "certified sum of squares and parameters of NIST";

/// The best known objective is half of the certified sum of squares.
Statement fit(const char* name, const char* source, Vector lower, Vector upper, Vector start,
              double sum_of_squares, Vector best_point, const char* provenance) {
  return stated("outside-fit", name, source, std::move(lower), std::move(upper), std::move(start),
                sum_of_squares / 2, std::move(best_point), provenance);
}

/// The residuals model(parameters, x) - y at each of the data.
template <std::size_t count, class Model>
auto residuals_of(std::array<double, count> x, std::array<double, count> y, Model model) {
  return [x, y, model]<class Scalar>(const Point<Scalar>& b) {
    std::array<Scalar, count> r;
    for (std::size_t i = 0; i < count; ++i) r[i] = model(b, x[i]) - y[i];
    return r;
  };
}

constexpr std::array<double, 14> misra_x = {77.6,  114.9, 141.1, 190.8, 239.9, 289.0, 332.8,
                                            378.4, 434.8, 477.3, 536.8, 593.1, 689.1, 760.0};
constexpr std::array<double, 14> misra_y = {10.07, 14.73, 17.94, 23.93, 29.61, 35.18, 40.02,
                                            44.82, 50.76, 55.05, 61.01, 66.40, 75.47, 81.78};

Problem misra_1a() {
  return from_residuals(
      fit("misra-1a", strd, Vector{{10, 1e-5}}, Vector{{1000, 0.01}}, Vector{{500, 1e-4}},
          0.12455138894, Vector{{238.94212918, 0.00055015643181}}, certified),
      residuals_of(misra_x, misra_y, []<class Scalar>(const Point<Scalar>& b, double x) {
        using std::exp;
        return Scalar(b[0] * (1.0 - exp(-b[1] * x)));
      }));
}

Problem misra_1d() {
  return from_residuals(
      fit("misra-1d", strd, Vector{{10, 1e-5}}, Vector{{1000, 0.01}}, Vector{{500, 1e-4}},
          0.056419295283, Vector{{437.36970754, 0.00030227324449}}, certified),
      residuals_of(misra_x, misra_y, []<class Scalar>(const Point<Scalar>& b, double x) {
        return Scalar(b[0] * b[1] * x / (1.0 + b[1] * x));
      }));
}

Problem dan_wood() {
  return from_residuals(fit("dan-wood", strd, Vector{{0.1, 1}}, Vector{{5, 8}}, Vector{{1, 5}},
                            0.0043173084083, Vector{{0.76886226176, 3.8604055871}}, certified),
                        residuals_of(std::array{1.309, 1.471, 1.490, 1.565, 1.611, 1.680},
                                     std::array{2.138, 3.421, 3.597, 4.340, 4.882, 5.660},
                                     []<class Scalar>(const Point<Scalar>& b, double x) {
                                       using std::pow;
                                       return Scalar(b[0] * pow(Scalar(x), b[1]));
                                     }));
}

Problem box_bod() {
  return from_residuals(fit("box-bod", strd, Vector{{1, 0.01}}, Vector{{500, 5}}, Vector{{1, 1}},
                            1168.0088766, Vector{{213.80940889, 0.54723748542}}, certified),
                        residuals_of(std::array{1.0, 2.0, 3.0, 5.0, 7.0, 10.0},
                                     std::array{109.0, 149.0, 149.0, 191.0, 213.0, 224.0},
                                     []<class Scalar>(const Point<Scalar>& b, double x) {
                                       using std::exp;
                                       return Scalar(b[0] * (1.0 - exp(-b[1] * x)));
                                     }));
}

Problem rat_42() {
  return from_residuals(
      fit("rat-42", strd, Vector{{10, 0, 0.001}}, Vector{{200, 10, 0.5}}, Vector{{100, 1, 0.1}},
          8.0565229338, Vector{{72.462237576, 2.6180768402, 0.067359200066}}, certified),
      residuals_of(
          std::array{9.0, 14.0, 21.0, 28.0, 42.0, 57.0, 63.0, 70.0, 79.0},
          std::array{8.930, 10.800, 18.590, 22.330, 39.350, 56.110, 61.730, 64.620, 67.080},
          []<class Scalar>(const Point<Scalar>& b, double x) {
            using std::exp;
            return Scalar(b[0] / (1.0 + exp(b[1] - b[2] * x)));
          }));
}

Problem rat_43() {
  std::array<double, 15> days;
  for (std::size_t i = 0; i < days.size(); ++i) days[i] = static_cast<double>(i + 1);
  return from_residuals(
      fit("rat-43", strd, Vector{{100, 1, 0.1, 0.1}}, Vector{{1000, 20, 3, 5}},
          Vector{{100, 10, 1, 1}}, 8786.4049080,
          Vector{{699.64151270, 5.2771253025, 0.75962938329, 1.2792483859}}, certified),
      residuals_of(days,
                   std::array{16.08, 33.83, 65.80, 97.20, 191.55, 326.20, 386.87, 520.53, 590.03,
                              651.92, 724.93, 699.56, 689.96, 637.56, 717.41},
                   []<class Scalar>(const Point<Scalar>& b, double x) {
                     using std::exp;
                     using std::pow;
                     return Scalar(b[0] / pow(Scalar(1.0 + exp(b[1] - b[2] * x)), 1.0 / b[3]));
                   }));
}

Problem thurber() {
  return from_residuals(
      fit("thurber", strd, Vector{{500, 500, 100, 10, 0.1, 0.1, 0.01}},
          Vector{{2000, 3000, 1000, 200, 2, 1, 0.2}}, Vector{{1000, 1000, 400, 40, 0.7, 0.3, 0.03}},
          5642.7082397,
          Vector{{1288.1396800, 1491.0792535, 583.23836877, 75.416644291, 0.96629502864,
                  0.39797285797, 0.049727297349}},
          certified),
      residuals_of(
          std::array{-3.067, -2.981, -2.921, -2.912, -2.840, -2.797, -2.702, -2.699, -2.633, -2.481,
                     -2.363, -2.322, -1.501, -1.460, -1.274, -1.212, -1.100, -1.046, -0.915, -0.714,
                     -0.566, -0.545, -0.400, -0.309, -0.109, -0.103, 0.010,  0.119,  0.377,  0.790,
                     0.963,  1.006,  1.115,  1.572,  1.841,  2.047,  2.200},
          std::array{80.574,   84.248,   87.264,   87.195,   89.076,   89.608,   89.868,   90.101,
                     92.405,   95.854,   100.696,  101.060,  401.672,  390.724,  567.534,  635.316,
                     733.054,  759.087,  894.206,  990.785,  1090.109, 1080.914, 1122.643, 1178.351,
                     1260.531, 1273.514, 1288.339, 1327.543, 1353.863, 1414.509, 1425.208, 1421.384,
                     1442.962, 1464.350, 1468.705, 1447.894, 1457.628},
          []<class Scalar>(const Point<Scalar>& b, double x) {
            return Scalar((b[0] + x * (b[1] + x * (b[2] + x * b[3]))) /
                          (1.0 + x * (b[4] + x * (b[5] + x * b[6]))));
          }));
}

Problem eckerle_4() {
  return from_residuals(
      fit("eckerle-4", strd, Vector{{0.1, 1, 400}}, Vector{{10, 50, 500}}, Vector{{1, 10, 500}},
          0.0014635887487, Vector{{1.5543827178, 4.0888321754, 451.54121844}}, certified),
      residuals_of(
          std::array{400.0, 405.0, 410.0, 415.0, 420.0, 425.0, 430.0, 435.0, 436.5,
                     438.0, 439.5, 441.0, 442.5, 444.0, 445.5, 447.0, 448.5, 450.0,
                     451.5, 453.0, 454.5, 456.0, 457.5, 459.0, 460.5, 462.0, 463.5,
                     465.0, 470.0, 475.0, 480.0, 485.0, 490.0, 495.0, 500.0},
          std::array{0.0001575, 0.0001699, 0.0002350, 0.0003102, 0.0004917, 0.0008710, 0.0017418,
                     0.0046400, 0.0065895, 0.0097302, 0.0149002, 0.0237310, 0.0401683, 0.0712559,
                     0.1264458, 0.2073413, 0.2902366, 0.3445623, 0.3698049, 0.3668534, 0.3106727,
                     0.2078154, 0.1164354, 0.0616764, 0.0337200, 0.0194023, 0.0117831, 0.0074357,
                     0.0022732, 0.0008800, 0.0004579, 0.0002345, 0.0001586, 0.0001143, 0.0000710},
          []<class Scalar>(const Point<Scalar>& b, double x) {
            using std::exp;
            const Scalar far = (x - b[2]) / b[1];
            return Scalar(b[0] / b[1] * exp(-0.5 * far * far));
          }));
}

/// Sums of three exponentials, from data that such a sum gives.
Problem lanczos() {
  std::array<double, 24> x, y;
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] = 0.05 * static_cast<double>(i);
    y[i] = 0.0951 * std::exp(-x[i]) + 0.8607 * std::exp(-3 * x[i]) + 1.5576 * std::exp(-5 * x[i]);
  }
  return from_residuals(
      fit("lanczos", strd, Vector{{0, 0, 0, 0, 0, 0}}, Vector{{10, 10, 10, 10, 10, 10}},
          Vector{{1.2, 0.3, 5.6, 5.5, 6.5, 7.6}}, 0, Vector{{0.0951, 1, 0.8607, 3, 1.5576, 5}},
          "closed form: every residual is 0 there"),
      residuals_of(x, y, []<class Scalar>(const Point<Scalar>& b, double t) {
        using std::exp;
        return Scalar(b[0] * exp(-b[1] * t) + b[2] * exp(-b[3] * t) + b[4] * exp(-b[5] * t));
      }));
}

Problem puromycin() {
  return from_residuals(
      fit("puromycin", "Bates and Watts (1988), doi 10.1002/9780470316757, treated cells",
          Vector{{10, 0.001}}, Vector{{1000, 2}}, Vector{{100, 0.5}}, 1195.4488144393592,
          Vector{{212.68374314333943, 0.06412128168228612}},
          "published: 1195; digits by Newton's method"),
      residuals_of(
          std::array{0.02, 0.02, 0.06, 0.06, 0.11, 0.11, 0.22, 0.22, 0.56, 0.56, 1.10, 1.10},
          std::array{76.0, 47.0, 97.0, 107.0, 123.0, 139.0, 159.0, 152.0, 191.0, 201.0, 207.0,
                     200.0},
          []<class Scalar>(const Point<Scalar>& b, double x) {
            return Scalar(b[0] * x / (b[1] + x));
          }));
}

/// The states of a system of differential equations at `count` equal steps of time, each of ten
/// steps of the classical Runge-Kutta method.
template <std::size_t count, std::size_t states, class Scalar, class Slope>
std::array<Scalar, count * states> states_over_time(std::array<Scalar, states> y, double step,
                                                    const Slope& slope) {
  constexpr int steps = 10;
  const double h = step / steps;
  const auto moved = [](const std::array<Scalar, states>& from,
                        const std::array<Scalar, states>& along, double by) {
    std::array<Scalar, states> to = from;
    for (std::size_t k = 0; k < states; ++k) to[k] += by * along[k];
    return to;
  };
  std::array<Scalar, count * states> all;
  for (std::size_t i = 0; i < count; ++i) {
    for (int s = 0; s < steps; ++s) {
      const auto a = slope(y), b = slope(moved(y, a, h / 2)), c = slope(moved(y, b, h / 2)),
                 d = slope(moved(y, c, h));
      for (std::size_t k = 0; k < states; ++k) {
        y[k] += h / 6 * (a[k] + 2.0 * b[k] + 2.0 * c[k] + d[k]);
      }
    }
    for (std::size_t k = 0; k < states; ++k) all[i * states + k] = y[k];
  }
  return all;
}

/// Fits the parameters of `model` to what it gives with the true ones.
template <class Model>
Problem recovered(const char* name, const char* source, Vector lower, Vector upper, Vector start,
                  const Vector& truth, const Model& model) {
  const Vector data = detail::values_of(model, truth);
  return from_residuals(fit(name, source, std::move(lower), std::move(upper), std::move(start), 0,
                            truth, "closed form: the data are the model's with these parameters"),
                        [data, model]<class Scalar>(const Point<Scalar>& x) {
                          auto r = detail::listed(model(x));
                          for (Eigen::Index i = 0; i < r.size(); ++i) r[i] -= data[i];
                          return r;
                        });
}

Problem lotka_volterra() {
  return recovered(
      "lotka-volterra", "Lotka (1925) and Volterra (1926): prey and predators",
      Vector{{0.1, 0.1, 0.1, 0.1}}, Vector{{3, 3, 3, 3}}, Vector{{2, 2, 2, 2}},
      Vector{{1.1, 0.6, 0.7, 0.5}}, []<class Scalar>(const Point<Scalar>& p) {
        return states_over_time<12, 2, Scalar>(
            {Scalar(2), Scalar(1)}, 0.6, [&p](const std::array<Scalar, 2>& y) {
              const Scalar met = y[0] * y[1];
              return std::array<Scalar, 2>{p[0] * y[0] - p[1] * met, p[2] * met - p[3] * y[1]};
            });
      });
}

Problem epidemic() {
  return recovered("epidemic", "Kermack and McKendrick (1927), doi 10.1098/rspa.1927.0118",
                   Vector{{0.05, 0.01, 1e-4}}, Vector{{3, 2, 0.2}}, Vector{{1.5, 1, 0.05}},
                   Vector{{0.8, 0.25, 0.01}}, []<class Scalar>(const Point<Scalar>& p) {
                     return states_over_time<15, 2, Scalar>(
                         {Scalar(1.0 - p[2]), p[2]}, 2, [&p](const std::array<Scalar, 2>& y) {
                           const Scalar infected = p[0] * y[0] * y[1];
                           return std::array<Scalar, 2>{-infected, infected - p[1] * y[1]};
                         });
                   });
}

Problem oscillator() {
  return recovered(
      "oscillator", "a damped oscillator with a cubic spring, from its own path",
      Vector{{0.2, 0, 0, -2, -2}}, Vector{{4, 1, 2, 2, 2}}, Vector{{2, 0.5, 0.5, 1, 0}},
      Vector{{1.3, 0.15, 0.4, 1.2, -0.3}}, []<class Scalar>(const Point<Scalar>& p) {
        return states_over_time<20, 2, Scalar>(
            {p[3], p[4]}, 0.4, [&p](const std::array<Scalar, 2>& y) {
              return std::array<Scalar, 2>{
                  y[1], -p[0] * p[0] * y[0] - 2.0 * p[1] * y[1] - p[2] * y[0] * y[0] * y[0]};
            });
      });
}

}  // namespace

std::vector<Problem> fit_problems() {
  std::vector<Problem> problems = {
      misra_1a(),  misra_1d(), dan_wood(),  box_bod(),        rat_42(),   rat_43(),    thurber(),
      eckerle_4(), lanczos(),  puromycin(), lotka_volterra(), epidemic(), oscillator()};
  for (Problem& problem : problems) {
    if (problem.name.find("misra") != std::string::npos) problem.cluster = "outside-fit-misra";
  }
  return problems;
}

}  // namespace ricochet::held_out
