#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>

#include "problems/classic/classic.h"

namespace ricochet::classic {

namespace {

constexpr double centre = 0.3;
constexpr double rim = 0.005;  // of the plateau: the bowl at a distance of 0.1

/// Called at every evaluation; the result is added to the objective, the entries of the gradient
/// and the residuals.
using Defect = std::function<double(const Vector&)>;

double bowl_at(const Vector& x) {
  return (x.array() - centre).square().sum() / 2;
}

double no_defect(const Vector&) {
  return 0;
}

/// Half the sum of (x_i - 0.3)^2 on [0, 1]^2 with a defect, from 0.9; its true objective has none.
Problem bowl(const std::string& name, const std::string& what, const Defect& defect) {
  Problem problem;
  problem.name = "pathological-" + name;
  problem.source = what;
  problem.lower = Vector::Zero(2);
  problem.upper = Vector::Ones(2);
  problem.start = Vector::Constant(2, 0.9);
  problem.evaluate = [defect](const Vector& x) { return Values{defect(x) + bowl_at(x), {}}; };
  problem.differentiate = [defect](const Vector& x) {
    const double more = defect(x);
    return Derivatives{{more + bowl_at(x), {}}, x.array() - centre + more, Matrix(0, 2)};
  };
  problem.residuals = [defect](const Vector& x) {
    return Residuals{x.array() - centre + defect(x), Matrix::Identity(2, 2)};
  };
  problem.true_values = [](const Vector& x) { return TrueValues{bowl_at(x), 0}; };
  problem.best_known = 0;
  problem.best_point = Vector::Constant(2, centre);
  problem.provenance = fmt::format("{}: no term is negative, and all are 0 there", closed_form);
  problem.rotates = true;
  problem.gradient_cost = 1;
  problem.hazardous = true;
  return problem;
}

/// Is not a number, or infinite, in a half-plane that holds the start.
Defect where_far(double value) {
  return [value](const Vector& x) { return x.sum() > 1.2 ? value : 0; };
}

/// Does something in a half-plane beyond the best point.
Defect where_near(const std::function<void()>& does) {
  return [does](const Vector& x) {
    if (x.sum() < 0.4) does();
    return 0.0;
  };
}

Problem plateau() {
  Problem problem =
      bowl("plateau", "a bowl of radius 0.1 around the best point, and flat beyond", no_defect);
  problem.evaluate = [](const Vector& x) { return Values{std::min(bowl_at(x), rim), {}}; };
  problem.differentiate = [](const Vector& x) {
    const double height = bowl_at(x);
    const Vector slope = height < rim ? Vector(x.array() - centre) : Vector::Zero(2);
    return Derivatives{{std::min(height, rim), {}}, slope, Matrix(0, 2)};
  };
  problem.residuals = nullptr;
  problem.true_values = nullptr;
  return problem;
}

/// Lowest at a discontinuity, beyond which the objective is higher by 1.
Problem cliff() {
  Problem problem = bowl("cliff", "x - 0.3 + y, and 1 more where x < 0.3", no_defect);
  const auto value = [](const Vector& x) {
    return x[0] < centre ? 1 + x[0] - centre + x[1] : x[0] - centre + x[1];
  };
  problem.evaluate = [value](const Vector& x) { return Values{value(x), {}}; };
  problem.differentiate = [value](const Vector& x) {
    return Derivatives{{value(x), {}}, Vector::Ones(2), Matrix(0, 2)};
  };
  problem.residuals = nullptr;
  problem.true_values = nullptr;
  problem.best_point = Vector{{centre, 0}};
  problem.provenance = fmt::format("{}: at least 0 on both sides, and 0 there", closed_form);
  problem.rotates = false;
  return problem;
}

/// Its constraint, 1 + x^2 + y^2 <= 0, holds nowhere: no run solves it, and it has no best point.
Problem infeasible() {
  Problem problem = bowl("infeasible", "a bowl with a constraint that holds nowhere", no_defect);
  problem.constraints = 1;
  problem.evaluate = [](const Vector& x) {
    return Values{bowl_at(x), Vector::Constant(1, 1 + x.squaredNorm())};
  };
  problem.differentiate = [evaluate = problem.evaluate](const Vector& x) {
    return Derivatives{evaluate(x), x.array() - centre, 2 * x.transpose()};
  };
  problem.residuals = nullptr;
  problem.true_values = nullptr;
  problem.best_point.reset();
  problem.provenance = "a lower bound: no point is feasible";
  problem.rotates = false;
  return problem;
}

Problem one_choice() {
  Problem problem = bowl("one-choice", "a bowl in whose box x can only be 0.3", no_defect);
  problem.lower[0] = problem.upper[0] = problem.start[0] = centre;
  problem.rotates = false;
  return problem;
}

Problem hangs() {
  Problem problem = bowl("hangs", "a bowl that never answers where x + y < 0.4", where_near([] {
                           while (true) std::this_thread::sleep_for(std::chrono::seconds(1));
                         }));
  problem.longest_run = 2;
  return problem;
}

}  // namespace

Family pathological_family() {
  using Number = std::numeric_limits<double>;
  return {
      "pathological",
      {bowl("no-number", "a bowl, not a number where x + y > 1.2", where_far(Number::quiet_NaN())),
       bowl("infinite", "a bowl, infinite where x + y > 1.2", where_far(Number::infinity())),
       plateau(), cliff(), infeasible(), one_choice(),
       bowl("throws", "a bowl that throws where x + y < 0.4",
            where_near([] { throw std::runtime_error("the model broke"); })),
       hangs(), bowl("crashes", "a bowl that ends the process where x + y < 0.4", where_near([] {
                       std::abort();
                     }))}};
}

}  // namespace ricochet::classic
