#include "solvers/acceptance.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <vector>

namespace ricochet {
namespace {

constexpr Eigen::Index most_variables = 64;

/// What a problem has to offer; its functions are never called.
struct Offer {
  Eigen::Index variables = 2;
  Eigen::Index inequalities = 0;
  Eigen::Index equalities = 0;
  bool gradients = false;
  bool hessians = false;
  bool residuals = false;
  bool width = false;
};

Problem problem_of(const Offer& offer) {
  Problem problem;
  problem.name = "offer";
  problem.lower = Vector::Zero(offer.variables);
  problem.upper = Vector::Ones(offer.variables);
  problem.start = Vector::Zero(offer.variables);
  problem.equalities = offer.equalities;
  problem.constraints = offer.equalities + offer.inequalities;
  problem.evaluate = [](const Vector&) { return Values{}; };
  if (offer.gradients) problem.differentiate = [](const Vector&) { return Derivatives{}; };
  if (offer.hessians) {
    problem.lagrangian_hessian = [](const Vector&, double, const Vector&) { return Matrix(); };
  }
  if (offer.residuals) problem.residuals = [](const Vector&) { return Residuals{}; };
  if (offer.width) problem.smoothed = [](double) { return Problem{}; };
  return problem;
}

bool takes(const Solver& solver, const Offer& offer) {
  return solver.accepts(problem_of(offer));
}

std::string needs_of(const Offer& offer) {
  std::string needs = offer.residuals   ? "residuals"
                      : offer.hessians  ? "Hessians"
                      : offer.gradients ? "gradients"
                                        : "nothing";
  if (offer.width) needs = offer.gradients ? needs + " and a width" : "a width";
  return needs;
}

/// The offer of least that the solver takes.
Offer least_offer(const Solver& solver) {
  for (const bool width : {false, true}) {
    for (const int kind : {0, 1, 2, 3}) {  // nothing, gradients, Hessians with them, residuals
      for (const Eigen::Index inequalities : {0, 1}) {
        for (const Eigen::Index variables : {2, 1, 3, 4}) {
          Offer offer{.variables = variables, .inequalities = inequalities};
          offer.gradients = kind == 1 || kind == 2;
          offer.hessians = kind == 2;
          offer.residuals = kind == 3;
          offer.width = width;
          if (takes(solver, offer)) return offer;
        }
      }
    }
  }
  throw std::logic_error(solver.name + " takes no problem");
}

std::string variables_of(const Solver& solver, Offer offer) {
  std::vector<Eigen::Index> taken;
  for (offer.variables = 1; offer.variables <= most_variables; ++offer.variables) {
    if (takes(solver, offer)) taken.push_back(offer.variables);
  }
  const Eigen::Index least = taken.front();
  const Eigen::Index most = taken.back();
  if (least == most) return fmt::format("{}", least);
  if (most < most_variables) {
    return least == 1 ? fmt::format("up to {}", most) : fmt::format("{} to {}", least, most);
  }
  return least == 1 ? "any number" : fmt::format("{} or more", least);
}

std::string constraints_of(const Solver& solver, Offer offer) {
  if (offer.inequalities > 0) return "needs inequalities";
  offer.inequalities = 1;
  if (!takes(solver, offer)) return "none";
  offer.equalities = 1;
  return takes(solver, offer) ? "all" : "inequalities";
}

}  // namespace

Acceptance acceptance_of(const Solver& solver) {
  const Offer least = least_offer(solver);
  return {variables_of(solver, least), constraints_of(solver, least), needs_of(least)};
}

}  // namespace ricochet
