#include "src/analysis/statistics/factorial_effects.h"

#include <Eigen/QR>
#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <map>
#include <stdexcept>

#include "ricochet/problem.h"
#include "src/analysis/statistics/intervals.h"

namespace ricochet {

namespace {

using Matrix = Eigen::MatrixXd;
using Sizes = std::vector<std::size_t>;

/// The sum-to-zero coding of one factor: the unit vector of the level, and -1 everywhere for the
/// last.
Vector coded(std::size_t level, std::size_t levels) {
  const auto columns = static_cast<Eigen::Index>(levels) - 1;
  const auto own = static_cast<Eigen::Index>(level);
  if (own == columns) return Vector::Constant(columns, -1);
  return Vector::Unit(columns, own);
}

/// All products of an entry of a and an entry of b.
Vector product(const Vector& a, const Vector& b) {
  const Matrix all = b * a.transpose();
  return all.reshaped();
}

/// A term of the model: the mean, a factor or an interaction of two, with its coefficients.
struct Term {
  Sizes factors;
  Eigen::Index first;
};

struct Model {
  Sizes levels_of_factors;
  std::vector<Term> terms;
  Eigen::Index coefficients = 0;

  /// The coding of a term at the given levels of the factors.
  Vector coded_at(const Term& term, const Sizes& levels) const {
    Vector row = Vector::Ones(1);
    for (std::size_t i = 0; i < term.factors.size(); ++i) {
      row = product(row, coded(levels[i], levels_of_factors[term.factors[i]]));
    }
    return row;
  }

  Vector row_of(const Response& response) const {
    Vector row(coefficients);
    for (const Term& term : terms) {
      Sizes levels;
      for (const std::size_t factor : term.factors) levels.push_back(response.levels[factor]);
      const Vector part = coded_at(term, levels);
      row.segment(term.first, part.size()) = part;
    }
    return row;
  }

  void add(const Sizes& factors) {
    terms.push_back({factors, coefficients});
    Eigen::Index columns = 1;
    for (const std::size_t factor : factors) {
      columns *= static_cast<Eigen::Index>(levels_of_factors[factor]) - 1;
    }
    coefficients += columns;
  }
};

Model model_of(const Sizes& levels_of_factors) {
  for (const std::size_t levels : levels_of_factors) {
    if (levels < 2) throw std::invalid_argument("factorial_effects: a factor needs two levels");
  }
  Model model{levels_of_factors, {}};
  model.add({});
  for (std::size_t f = 0; f < levels_of_factors.size(); ++f) model.add({f});
  for (std::size_t f = 0; f < levels_of_factors.size(); ++f) {
    for (std::size_t g = f + 1; g < levels_of_factors.size(); ++g) model.add({f, g});
  }
  return model;
}

void check(const Response& response, const Sizes& levels_of_factors) {
  bool fits = response.levels.size() == levels_of_factors.size() && std::isfinite(response.value);
  for (std::size_t f = 0; fits && f < levels_of_factors.size(); ++f) {
    fits = response.levels[f] < levels_of_factors[f];
  }
  if (!fits) throw std::invalid_argument("factorial_effects: a response does not fit");
}

/// Normal equations of least squares.
struct Equations {
  Matrix products;
  Vector responses;

  explicit Equations(Eigen::Index size)
      : products(Matrix::Zero(size, size)), responses(Vector::Zero(size)) {}

  Vector solution() const {
    const Eigen::ColPivHouseholderQR<Matrix> factored(products);
    if (!factored.isInvertible()) {
      throw std::invalid_argument(
          "factorial_effects: pairs of levels are missing, or are of one unit alone");
    }
    return factored.solve(responses);
  }
};

/// All combinations of levels of the term's factors, the last factor changing fastest.
std::vector<Sizes> combinations(const Term& term, const Sizes& levels_of_factors) {
  std::vector<Sizes> all = {{}};
  for (const std::size_t factor : term.factors) {
    std::vector<Sizes> longer;
    for (const Sizes& levels : all) {
      for (std::size_t level = 0; level < levels_of_factors[factor]; ++level) {
        longer.push_back(levels);
        longer.back().push_back(level);
      }
    }
    all = longer;
  }
  return all;
}

/// So that errors of rounding are not taken for an effect.
double rounded_effect(double effect) {
  return std::round(1e12 * effect) / 1e12;
}

}  // namespace

std::vector<FactorialEffect> factorial_effects(const std::vector<Response>& responses,
                                               const std::vector<std::size_t>& levels_of_factors,
                                               double confidence) {
  check_confidence(confidence);
  const Model model = model_of(levels_of_factors);
  std::map<std::size_t, Equations> units;
  Equations all(model.coefficients);
  for (const Response& response : responses) {
    check(response, levels_of_factors);
    const Vector row = model.row_of(response);
    Equations& unit = units.try_emplace(response.unit, model.coefficients).first->second;
    unit.products.noalias() += row * row.transpose();
    unit.responses += response.value * row;
  }
  if (units.size() < 2) throw std::invalid_argument("factorial_effects: two units are needed");
  for (const auto& unit : units) {
    all.products += unit.second.products;
    all.responses += unit.second.responses;
  }
  const Vector estimate = all.solution();
  const auto size = static_cast<double>(units.size());
  Matrix covariance = Matrix::Zero(model.coefficients, model.coefficients);
  for (const auto& unit : units) {
    Equations rest = all;
    rest.products -= unit.second.products;
    rest.responses -= unit.second.responses;
    const Vector change = rest.solution() - estimate;
    covariance.noalias() += (size - 1) / size * (change * change.transpose());
  }
  const double student =
      boost::math::quantile(boost::math::students_t(size - 1), (1 + confidence) / 2);
  std::vector<FactorialEffect> effects;
  for (const Term& term : model.terms) {
    for (const Sizes& levels : combinations(term, levels_of_factors)) {
      const Vector at = model.coded_at(term, levels);
      const double effect = at.dot(estimate.segment(term.first, at.size()));
      const double variance =
          at.dot(covariance.block(term.first, term.first, at.size(), at.size()) * at);
      const double half = student * std::sqrt(std::max(0.0, variance));
      effects.push_back({term.factors,
                         levels,
                         rounded_effect(effect),
                         {rounded_effect(effect - half), rounded_effect(effect + half)}});
    }
  }
  return effects;
}

}  // namespace ricochet
