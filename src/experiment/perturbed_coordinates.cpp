#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

#include "ricochet/random.h"
#include "src/experiment/perturbations.h"

namespace ricochet {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

class Binary : public PerturbedCalls {
 public:
  Values values(const Problem& shown, const Vector& x) override {
    return answered(shown.evaluate(x), shown.equalities);
  }
  Derivatives derivatives(const Problem& shown, const Vector& x) override {
    Derivatives told = shown.differentiate(x);
    told.values = answered(std::move(told.values), shown.equalities);
    told.jacobian.setZero();
    return told;
  }
  Matrix hessian(const Problem& shown, const Vector& x, double objective_factor,
                 const Vector& multipliers) override {
    return shown.lagrangian_hessian(x, objective_factor, Vector::Zero(multipliers.size()));
  }

 private:
  static Values answered(Values told, Eigen::Index equalities) {
    for (Eigen::Index k = 0; k < told.constraints.size(); ++k) {
      double& constraint = told.constraints[k];
      constraint = violation_of(constraint, k < equalities) == 0 ? 0 : 1;
    }
    return told;
  }
};

class Infinite : public PerturbedCalls {
 public:
  Values values(const Problem& shown, const Vector& x) override {
    Values told = shown.evaluate(x);
    if (broken(shown, told)) told.objective = infinity;
    return told;
  }
  Derivatives derivatives(const Problem& shown, const Vector& x) override {
    Derivatives told = shown.differentiate(x);
    if (broken(shown, told.values)) {
      told.values.objective = infinity;
      told.gradient.setConstant(not_a_number);
    }
    return told;
  }
  Residuals residuals(const Problem& shown, const Vector& x) override {
    Residuals told = shown.residuals(x);
    if (broken(shown, shown.evaluate(x))) {
      told.values.setConstant(infinity);
      told.jacobian.setConstant(not_a_number);
    }
    return told;
  }
  Matrix hessian(const Problem& shown, const Vector& x, double objective_factor,
                 const Vector& multipliers) override {
    Matrix told = shown.lagrangian_hessian(x, objective_factor, multipliers);
    if (objective_factor != 0 && broken(shown, shown.evaluate(x))) told.setConstant(not_a_number);
    return told;
  }

 private:
  static bool broken(const Problem& shown, const Values& told) {
    const Vector inequalities = told.constraints.tail(shown.constraints - shown.equalities);
    return true_values_of({told.objective, inequalities}).violation != 0;
  }
};

}  // namespace

Perturbation binary_constraints() {
  return {"binary-constraints",
          "a constraint is 0 where it holds and 1 elsewhere, without a magnitude",
          [](const Problem& problem) { return problem.constraints > 0; },
          [](const Problem& shown, std::uint64_t) {
            return perturbed_by(std::make_shared<Binary>(), shown);
          }};
}

Perturbation infinite_where_infeasible() {
  return {"infinite-where-infeasible", "the objective is infinite where an inequality is broken",
          [](const Problem& problem) { return problem.constraints > problem.equalities; },
          [](const Problem& shown, std::uint64_t) {
            return perturbed_by(std::make_shared<Infinite>(), shown);
          }};
}

namespace {

/// An orthogonal map from a problem's own coordinates to those that are shown. Columns are vectors.
class Turn {
 public:
  Turn() = default;
  virtual ~Turn() = default;
  Turn(const Turn&) = delete;
  Turn& operator=(const Turn&) = delete;

  virtual Matrix shown(const Matrix& own) const = 0;
  virtual Vector own(const Vector& shown) const = 0;
};

/// The shown coordinate i is signs[i] times the problem's own coordinate order[i].
class SignedOrder : public Turn {
 public:
  SignedOrder(std::vector<Eigen::Index> order, Vector signs)
      : order_(std::move(order)), signs_(std::move(signs)) {}

  Matrix shown(const Matrix& own) const override {
    Matrix result(own.rows(), own.cols());
    for (Eigen::Index j = 0; j < own.cols(); ++j) {  // there may be none
      for (Eigen::Index i = 0; i < own.rows(); ++i) result(i, j) = signs_[i] * own(at(i), j);
    }
    return result;
  }
  Vector own(const Vector& shown) const override {
    Vector result(shown.size());
    for (Eigen::Index i = 0; i < shown.size(); ++i) result[at(i)] = signs_[i] * shown[i];
    return result;
  }

 private:
  Eigen::Index at(Eigen::Index i) const { return order_[static_cast<std::size_t>(i)]; }

  std::vector<Eigen::Index> order_;
  Vector signs_;
};

class Rotation : public Turn {
 public:
  explicit Rotation(Matrix matrix) : matrix_(std::move(matrix)) {}

  Matrix shown(const Matrix& own) const override { return matrix_ * own; }
  Vector own(const Vector& shown) const override { return matrix_.transpose() * shown; }

 private:
  Matrix matrix_;
};

/// A turn about a centre, which is mapped to itself.
struct Frame {
  std::shared_ptr<const Turn> turn;
  Vector centre;

  Vector own(const Vector& x) const {
    Vector result = turn->own(x - centre);
    result += centre;
    return result;
  }
  Vector shown(const Vector& own) const { return centre + turn->shown(own - centre); }
};

class Turned : public PerturbedCalls {
 public:
  explicit Turned(Frame frame) : frame_(std::move(frame)) {}

  Values values(const Problem& shown, const Vector& x) override {
    return shown.evaluate(frame_.own(x));
  }
  Derivatives derivatives(const Problem& shown, const Vector& x) override {
    Derivatives told = shown.differentiate(frame_.own(x));
    told.gradient = turned(told.gradient);
    told.jacobian = turned(told.jacobian.transpose()).transpose();
    return told;
  }
  Residuals residuals(const Problem& shown, const Vector& x) override {
    Residuals told = shown.residuals(frame_.own(x));
    told.jacobian = turned(told.jacobian.transpose()).transpose();
    return told;
  }
  Matrix hessian(const Problem& shown, const Vector& x, double objective_factor,
                 const Vector& multipliers) override {
    const Matrix own = shown.lagrangian_hessian(frame_.own(x), objective_factor, multipliers);
    return turned(turned(own).transpose());
  }
  TrueValues true_values(const Problem& shown, const Vector& x) override {
    return shown.true_values(frame_.own(x));
  }

 private:
  Matrix turned(const Matrix& own) const { return frame_.turn->shown(own); }

  Frame frame_;
};

/// Everything except the box and the names of the variables, which depend on the turn.
Problem functions_in(const Frame& frame, const Problem& shown) {
  Problem result = perturbed_by(std::make_shared<Turned>(frame), shown);
  result.start = frame.shown(shown.start);
  if (shown.best_point) result.best_point = frame.shown(*shown.best_point);
  return result;
}

Problem in_signed_order(const std::vector<Eigen::Index>& order, const Vector& signs,
                        const Problem& shown) {
  const Frame frame{std::make_shared<SignedOrder>(order, signs), Vector::Zero(signs.size())};
  Problem result = functions_in(frame, shown);
  const Vector a = frame.shown(shown.lower);
  const Vector b = frame.shown(shown.upper);
  result.lower = a.cwiseMin(b);
  result.upper = a.cwiseMax(b);
  for (std::size_t i = 0; i < shown.variables.size(); ++i) {
    result.variables[i] = shown.variables[static_cast<std::size_t>(order[i])];
  }
  if (shown.smoothed) {
    result.smoothed = [smoothed = shown.smoothed, order, signs](double width) {
      return in_signed_order(order, signs, smoothed(width));
    };
  }
  return result;
}

Problem in_rotation(const Frame& frame, const Problem& shown) {
  Problem result = functions_in(frame, shown);
  result.lower = shown.lower.cwiseMin(result.start);
  result.upper = shown.upper.cwiseMax(result.start);
  result.variables.clear();
  if (shown.smoothed) {
    result.smoothed = [smoothed = shown.smoothed, frame](double width) {
      return in_rotation(frame, smoothed(width));
    };
  }
  return result;
}

std::vector<Eigen::Index> as_stated(Eigen::Index n) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(n));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  return order;
}

/// Uniform in 0, ..., below - 1.
std::size_t drawn_below(std::size_t below, Draws& draws) {
  return static_cast<std::size_t>(draws.uniform() * static_cast<double>(below));
}

}  // namespace

Perturbation permuted() {
  return {"permuted", "the variables come in another order, none where it was",
          [](const Problem& problem) { return problem.dimension() > 1; },
          [](const Problem& shown, std::uint64_t seed) {
            Draws draws(key_of(seed, "permuted"));
            std::vector<Eigen::Index> order = as_stated(shown.dimension());
            for (std::size_t k = order.size() - 1; k > 0; --k) {
              std::swap(order[k], order[drawn_below(k, draws)]);
            }
            return in_signed_order(order, Vector::Ones(shown.dimension()), shown);
          }};
}

Perturbation reflected() {
  return {"reflected", "variables, each with probability 1/2 and one at least, change their sign",
          [](const Problem&) { return true; },
          [](const Problem& shown, std::uint64_t seed) {
            Draws draws(key_of(seed, "reflected"));
            const Eigen::Index n = shown.dimension();
            Vector signs(n);
            for (double& sign : signs) sign = draws.uniform() < 0.5 ? -1 : 1;
            signs[static_cast<Eigen::Index>(drawn_below(static_cast<std::size_t>(n), draws))] = -1;
            return in_signed_order(as_stated(n), signs, shown);
          }};
}

Perturbation rotated() {
  return {"rotated", "turned about the best point by a uniformly random orthogonal matrix",
          [](const Problem& problem) { return problem.rotates && problem.dimension() > 1; },
          [](const Problem& shown, std::uint64_t seed) {
            Random random(key_of(seed, "rotated"));
            const Frame frame{std::make_shared<Rotation>(random_turn(shown.dimension(), random)),
                              shown.best_point.value()};
            return in_rotation(frame, shown);
          }};
}

}  // namespace ricochet
