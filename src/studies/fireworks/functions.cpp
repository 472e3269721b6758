#ifdef RICOCHET_HAS_PAGMO
#include <fmt/format.h>

#include <memory>
#include <pagmo/problems/cec2013.hpp>
#endif

#include <cmath>
#include <map>
#include <numbers>

#include "src/studies/fireworks/study.h"

namespace ricochet::studies::fireworks {

namespace {

using Function = double (*)(const Vector&);

double sphere(const Vector& x) {
  return x.squaredNorm();
}

double rosenbrock(const Vector& x) {
  const Eigen::Index m = x.size() - 1;
  return (100 * (x.tail(m).array() - x.head(m).array().square()).square() +
          (x.head(m).array() - 1).square())
      .sum();
}

double rastrigin(const Vector& x) {
  return (x.array().square() - 10 * (2 * std::numbers::pi * x.array()).cos() + 10).sum();
}

double griewank(const Vector& x) {
  double product = 1;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    product *= std::cos(x[i] / std::sqrt(static_cast<double>(i + 1)));
  }
  return 1 + x.squaredNorm() / 4000 - product;
}

double ellipse(const Vector& x) {
  double sum = 0;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const double place = static_cast<double>(i) / static_cast<double>(x.size() - 1);
    sum += std::pow(1e4, place) * x[i] * x[i];
  }
  return sum;
}

double cigar(const Vector& x) {
  return x[0] * x[0] + 1e4 * x.tail(x.size() - 1).squaredNorm();
}

double tablet(const Vector& x) {
  return 1e4 * x[0] * x[0] + x.tail(x.size() - 1).squaredNorm();
}

double schwefel(const Vector& x) {
  return ((x[0] - x.array().square()).square() + (x.array() - 1).square()).sum();
}

double ackley(const Vector& x) {
  const double n = static_cast<double>(x.size());
  const double waves = (2 * std::numbers::pi * x.array()).cos().sum() / n;
  return 20 + std::numbers::e - 20 * std::exp(-0.2 * std::sqrt(x.squaredNorm() / n)) -
         std::exp(waves);
}

Problem on_the_box(std::string name, Eigen::Index n) {
  Problem problem;
  problem.name = std::move(name);
  problem.source = "Tan and Zhu 2010";
  problem.lower = Vector::Constant(n, -100);
  problem.upper = Vector::Constant(n, 100);
  problem.start = Vector::Constant(n, 40);
  return problem;
}

}  // namespace

Problem benchmark_function(const std::string& name, Eigen::Index n) {
  static const std::map<std::string, Function> functions = {
      {"Sphere", sphere},     {"Rosenbrock", rosenbrock}, {"Rastrigin", rastrigin},
      {"Griewank", griewank}, {"Ellipse", ellipse},       {"Cigar", cigar},
      {"Tablet", tablet},     {"Schwefel", schwefel},     {"Ackley", ackley}};
  Problem problem = on_the_box(name, n);
  problem.evaluate = [function = functions.at(name)](const Vector& x) {
    return Values{function(x), {}};
  };
  return problem;
}

Problem shifted_sphere(double shift, Eigen::Index n) {
  Problem problem = on_the_box("shifted sphere", n);
  problem.evaluate = [shift](const Vector& x) {
    return Values{(x.array() - shift).square().sum(), {}};
  };
  return problem;
}

#ifdef RICOCHET_HAS_PAGMO
Problem cec2013(unsigned number, unsigned n) {
  const auto function = std::make_shared<const pagmo::cec2013>(number, n);
  Problem problem = on_the_box(fmt::format("cec2013-{}", number), n);
  problem.source = "CEC 2013, as pagmo has it";
  problem.start = Vector::Zero(n);
  // -1400 for function 1, in steps of 100 without 0, to 1400 for function 28 (Liang, Qu, Suganthan
  // and Hernandez-Diaz, Technical Report 201212, Zhengzhou University, 2013).
  const double best = number <= 14 ? 100.0 * number - 1500 : 100.0 * number - 1400;
  problem.evaluate = [function, best](const Vector& x) {
    return Values{function->fitness({x.begin(), x.end()})[0] - best, {}};
  };
  return problem;
}
#endif

}  // namespace ricochet::studies::fireworks
