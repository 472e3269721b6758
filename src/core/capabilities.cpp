#include "ricochet/capabilities.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

namespace ricochet {
namespace {

bool has_room(const Problem& problem) {
  return (problem.upper.array() > problem.lower.array()).any();
}

bool accepts_constraints(const Capabilities& capabilities, const Problem& problem) {
  if (problem.constraints == 0) return !capabilities.needs_constraints;
  switch (capabilities.constraints) {
    case Capabilities::Constraints::none:
      return false;
    case Capabilities::Constraints::inequalities:
      return problem.equalities == 0;
    case Capabilities::Constraints::all:
      return true;
  }
  return false;
}

}  // namespace

bool Capabilities::accept(const Problem& problem) const {
  const Eigen::Index n = problem.dimension();
  return n >= least_variables && n <= most_variables && has_room(problem) &&
         accepts_constraints(*this, problem) &&
         (derivatives < Order::gradient || problem.differentiate) &&
         (derivatives < Order::hessian || problem.lagrangian_hessian) &&
         (!needs_residuals || problem.residuals) && (!needs_smoothing || problem.smoothed);
}

std::string Capabilities::variables_in_words() const {
  if (least_variables == most_variables) return fmt::format("{}", least_variables);
  if (most_variables == any_number) {
    return least_variables == 1 ? "any number" : fmt::format("{} or more", least_variables);
  }
  return least_variables == 1 ? fmt::format("up to {}", most_variables)
                              : fmt::format("{} to {}", least_variables, most_variables);
}

std::string Capabilities::constraints_in_words() const {
  switch (constraints) {
    case Constraints::none:
      return "none";
    case Constraints::inequalities:
      return needs_constraints ? "needs inequalities" : "inequalities";
    case Constraints::all:
      return needs_constraints ? "needs some" : "all";
  }
  return "";
}

std::string Capabilities::needs_in_words() const {
  std::vector<const char*> needs;
  if (derivatives == Order::gradient) needs.push_back("gradients");
  if (derivatives == Order::hessian) needs.push_back("Hessians");
  if (needs_residuals) needs.push_back("residuals");
  if (needs_smoothing) needs.push_back("smoothing");
  return needs.empty() ? "nothing" : fmt::format("{}", fmt::join(needs, ", "));
}

}  // namespace ricochet
