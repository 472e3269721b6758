#include "solvers/adjustable_solver.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "ricochet/error.h"
#include "solvers/fireworks/fireworks.h"
#include "solvers/library_solvers.h"
#include "solvers/mads.h"
#include "solvers/nlopt.h"
#include "solvers/pagmo.h"
#include "src/core/names.h"

namespace ricochet {

bool SolverOption::allows(const OptionValue& value) const {
  if (const auto* word = std::get_if<std::string>(&value)) {
    return std::any_of(words.begin(), words.end(),
                       [&](const std::string& known) { return known == "*" || known == *word; });
  }
  return words.empty() && contains(range, std::get<double>(value));
}

std::string SolverOption::allowed() const {
  if (words.empty()) return in_words(range);
  const bool any = std::find(words.begin(), words.end(), "*") != words.end();
  return any ? "a text" : fmt::format("\"{}\"", fmt::join(words, "\", \""));
}

namespace {

AdjustableSolver adjustable_solver(const std::string& name) {
  std::vector<std::string> names;
  for (AdjustableSolver& solver : adjustable_solvers()) {
    if (solver.name == name) return std::move(solver);
    names.push_back(solver.name);
  }
  throw InputError(
      fmt::format("{}: no such solver has options; {}", name, what_instead(name, names)));
}

void check(const AdjustableSolver& solver, const std::string& name, const OptionValue& value) {
  std::vector<std::string> names;
  for (const SolverOption& option : solver.options) {
    if (option.name == name) {
      if (option.allows(value)) return;
      throw InputError(fmt::format("{} = {}: must be {}", name, text_of(value), option.allowed()));
    }
    names.push_back(option.name);
  }
  throw InputError(
      fmt::format("{}: {} has no such option; {}", name, solver.name, what_instead(name, names)));
}

void add(std::vector<AdjustableSolver>& all, std::vector<AdjustableSolver> more) {
  all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

}  // namespace

std::vector<AdjustableSolver> adjustable_solvers() {
  std::vector<AdjustableSolver> all = fireworks::adjustable_family();
  add(all, adjustable_mads());
  add(all, adjustable_nlopt());
#ifdef RICOCHET_HAS_IPOPT
  add(all, adjustable_ipopt());
#endif
#ifdef RICOCHET_HAS_CERES
  all.push_back(adjustable_ceres_lbfgs());
  all.push_back(adjustable_ceres_least_squares());
#endif
#ifdef RICOCHET_HAS_PAGMO
  add(all, adjustable_pagmo_cmaes());
  all.push_back(adjustable_pagmo_xnes());
  add(all, adjustable_pagmo_de());
  all.push_back(adjustable_pagmo_gaco());
  all.push_back(adjustable_pagmo_compass_search());
  all.push_back(adjustable_pagmo_constrained_de());
#endif
#ifdef RICOCHET_HAS_DLIB
  all.push_back(adjustable_dlib());
#endif
#ifdef RICOCHET_HAS_TAO
  add(all, adjustable_tao());
#endif
  return all;
}

Solver varied(const std::string& of, const std::string& name, const GivenOptions& given) {
  const AdjustableSolver adjustable = adjustable_solver(of);
  for (const auto& [option, value] : given) check(adjustable, option, value);
  try {
    Solver solver = adjustable.with(given);
    solver.name = name;
    solver.version += ", " + of;
    for (const auto& [option, value] : given) {
      solver.version += fmt::format(" {} {}", option, text_of(value));
    }
    return solver;
  } catch (const std::invalid_argument& error) {  // contradictory or unusable options
    throw InputError(error.what());
  }
}

std::vector<SolverOption> options_of(const std::string& solver) {
  return adjustable_solver(solver).options;
}

}  // namespace ricochet
