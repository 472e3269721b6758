#include "src/studies/calibration/convergence.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "ricochet/run.h"
#include "src/studies/calibration/fit.h"
#include "src/studies/paper/loss.h"

namespace ricochet::studies::calibration {

namespace {

using namespace carrier_track;

constexpr std::size_t looks = std::size(looked_at);

std::int64_t evaluations_at(const ConvergencePlan& plan, std::size_t look) {
  return static_cast<std::int64_t>(looked_at[look] * static_cast<double>(plan.evaluations));
}

/// One for each checkpoint. The evaluations are part of the kind, since the same search may first
/// be short.
std::vector<AskedFit> asked_of(const Parameterisation& parameterisation, const Solver& solver,
                               int seed, const ConvergencePlan& plan) {
  std::vector<AskedFit> asked;
  for (std::size_t look = 0; look < looks; ++look) {
    asked.push_back({fmt::format("converge, {} evaluations of {}, by {}, seed {}",
                                 evaluations_at(plan, look), plan.evaluations, solver.name, seed),
                     parameterisation,
                     {},
                     options_of({solver, {}, {}, plan.evaluations, seed}),
                     [](const Fit& fit) { return loss(fit.interpretation, fit.constants); }});
  }
  return asked;
}

std::vector<Fit> long_search(const Parameterisation& parameterisation, const Solver& solver,
                             int seed, const ConvergencePlan& plan) {
  const Problem problem = calibration_problem(parameterisation);
  const RunRecord record = run(problem, solver, Budget{plan.evaluations}, seed);
  if (!record.failure.empty()) throw std::runtime_error(problem.name + ": " + record.failure);
  const double loss = carrier_track::loss(parameterisation.interpretation, parameterisation.held);
  std::vector<Fit> fits;
  for (std::size_t look = 0; look < looks; ++look) {
    fits.push_back(best_within(evaluations_at(plan, look), record, parameterisation, loss));
  }
  return fits;
}

}  // namespace

const Fit& Convergence::best() const {
  return std::min_element(
             searches.begin(), searches.end(),
             [](const LongSearch& a, const LongSearch& b) { return a.last().loss < b.last().loss; })
      ->last();
}

std::vector<Fit> Convergence::as_good() const {
  std::vector<Fit> fits;
  for (const LongSearch& s : searches) {
    if (s.last().loss <= (1 + agreement) * best().loss) fits.push_back(s.last());
  }
  return fits;
}

double Convergence::spread(std::size_t look) const {
  double worst = 0;
  for (const LongSearch& s : searches) worst = std::max(worst, s.fits.at(look).loss);
  return worst / best().loss - 1;
}

std::optional<double> Convergence::agreed_from() const {
  std::optional<double> from;
  for (std::size_t look = looks; look-- > 0 && spread(look) <= agreement;) from = looked_at[look];
  return from;
}

std::vector<Convergence> converge(const std::vector<Parameterisation>& parameterisations,
                                  const ConvergencePlan& plan, FitStore& store) {
  std::vector<Convergence> all;
  std::vector<FitTask> tasks;
  for (const Parameterisation& parameterisation : parameterisations) {
    Convergence& one = all.emplace_back();
    one.parameterisation = parameterisation;
    one.evaluations = plan.evaluations;
    for (const Solver& solver : plan.solvers) {
      for (const int seed : plan.seeds) {
        one.searches.push_back({solver.name, seed, {}});
        tasks.push_back({asked_of(parameterisation, solver, seed, plan),
                         [=, &plan] { return long_search(parameterisation, solver, seed, plan); },
                         1});
      }
    }
  }
  auto fits = searched("searching until searches agree", tasks, store);
  auto next = fits.begin();
  for (Convergence& one : all) {
    for (LongSearch& search : one.searches) search.fits = std::move(*next++);
  }
  return all;
}

OrderOfPairs order_of_pairs(const std::vector<Convergence>& all) {
  OrderOfPairs result;
  for (std::size_t a = 0; a < all.size(); ++a) {
    for (std::size_t b = a + 1; b < all.size(); ++b) {
      int first = 0, second = 0;
      for (std::size_t s = 0; s < all[a].searches.size(); ++s) {
        const double difference = all[a].searches[s].last().loss - all[b].searches[s].last().loss;
        first += difference < 0 ? 1 : 0;
        second += difference > 0 ? 1 : 0;
      }
      ++result.all;
      if (first > 0 && second > 0) result.ties.emplace_back(a, b);
    }
  }
  return result;
}

}  // namespace ricochet::studies::calibration
