#include "problems/carrier_track/identification/knock_problem.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace ricochet::carrier_track::inline identification {
namespace {

/// Limits of the coordinates of KnockUnknowns: beyond them a simulation may take very long.
Vector lowest() {
  Vector x(knock_unknowns);
  x << -5, std::log(1e-4), std::log(1e-7), -100, -0.2, std::log(1e-7), -5, -20, -20, -40, -7, -12,
      -0.1, -1e-3;
  return x;
}

Vector highest() {
  Vector x(knock_unknowns);
  x << 4, std::log(0.999), std::log(1.0), 100, 0.2, 0, 10, 10, 20, 40, 1, 10, 0.1, 1e-3;
  return x;
}

}  // namespace

Vector KnockCoordinates::at(const Vector& z) const {
  return (centre + directions * z).cwiseMax(lowest()).cwiseMin(highest());
}

KnockCoordinates knock_coordinates(const KnockLoss& loss, const Vector& centre, double blur,
                                   const std::vector<Eigen::Index>& free) {
  const Matrix information = loss.information(centre, blur).information(free, free);
  const Eigen::SelfAdjointEigenSolver<Matrix> eigen(information);
  const double least = 1e-12 * eigen.eigenvalues().maxCoeff();
  const Vector scales = eigen.eigenvalues().cwiseMax(least).cwiseSqrt().cwiseInverse();
  KnockCoordinates result{centre, Matrix::Zero(knock_unknowns, information.cols())};
  result.directions(free, Eigen::all) = eigen.eigenvectors() * scales.asDiagonal();
  return result;
}

Problem knock_problem(const KnockLoss& loss, const KnockCoordinates& coordinates, double blur,
                      double reach) {
  const Eigen::Index n = coordinates.directions.cols();
  Problem problem;
  problem.name = "knocks";
  problem.source = "-ln likelihood of recorded knocks";
  problem.lower = Vector::Constant(n, -reach);
  problem.upper = Vector::Constant(n, reach);
  problem.start = Vector::Zero(n);
  problem.evaluate = [&loss, &coordinates, blur](const Vector& z) {
    return Values{loss.at(coordinates.at(z), blur), {}};
  };
  problem.differentiate = [&loss, &coordinates, blur](const Vector& z) {
    Vector slopes;
    const double value = loss.at(coordinates.at(z), blur, &slopes);
    return Derivatives{{value, {}}, coordinates.directions.transpose() * slopes, {}, {}};
  };
  return problem;
}

}  // namespace ricochet::carrier_track::inline identification
