#include "src/studies/calibration/convergence.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <stdexcept>

#include "src/campaign/progress.h"
#include "src/core/run.h"

namespace ricochet::studies::calibration {
namespace {

using namespace carrier_track;

constexpr std::size_t looks = std::size(looked_at);

std::int64_t evaluations_at(const ConvergencePlan& plan, std::size_t look) {
  return static_cast<std::int64_t>(looked_at[look] * static_cast<double>(plan.evaluations));
}

/// One for each look.
std::vector<std::string> keys_of(const Freedom& freedom, const Solver& solver, int seed,
                                 const ConvergencePlan& plan) {
  std::vector<std::string> keys;
  for (std::size_t look = 0; look < looks; ++look) {
    const auto kind =
        fmt::format("converge-{}-of-{}", evaluations_at(plan, look), plan.evaluations);
    keys.push_back(key_of(kind, freedom, {solver, {}, {}, plan.evaluations, seed}, ""));
  }
  return keys;
}

std::vector<Fit> searched(const Freedom& freedom, const Solver& solver, int seed,
                          const ConvergencePlan& plan) {
  const Problem problem = calibration_problem(freedom);
  const RunRecord record = run(problem, solver, Budget{plan.evaluations}, seed);
  if (!record.failure.empty()) throw std::runtime_error(problem.name + ": " + record.failure);
  std::vector<Fit> fits;
  for (std::size_t look = 0; look < looks; ++look) {
    Fit fit{freedom.reading, freedom.freed, freedom.held, 0, ""};
    const Vector start = point_of(freedom, freedom.held);
    fit.misfit = problem.evaluate(start).objective;
    for (const Improvement& found : record.trace) {
      if (found.evaluations > evaluations_at(plan, look)) break;
      if (found.truth.objective >= fit.misfit) continue;
      fit.misfit = found.truth.objective;
      fit.constants = constants_at(freedom, found.x);
    }
    fits.push_back(std::move(fit));
  }
  return fits;
}

std::vector<Fit> known_or_searched(const Freedom& freedom, const Solver& solver, int seed,
                                   const ConvergencePlan& plan, FitStore& store) {
  const std::vector<std::string> keys = keys_of(freedom, solver, seed, plan);
  std::vector<Fit> fits;
  for (const std::string& key : keys) {
    if (auto known = store.find(key)) fits.push_back(std::move(*known));
  }
  if (fits.size() == keys.size()) return fits;
  fits = searched(freedom, solver, seed, plan);
  for (std::size_t look = 0; look < looks; ++look) store.add(keys[look], fits[look]);
  return fits;
}

}  // namespace

const Fit& Convergence::best() const {
  return std::min_element(searches.begin(), searches.end(),
                          [](const LongSearch& a, const LongSearch& b) {
                            return a.last().misfit < b.last().misfit;
                          })
      ->last();
}

std::vector<Fit> Convergence::as_good() const {
  std::vector<Fit> fits;
  for (const LongSearch& s : searches) {
    if (s.last().misfit <= (1 + agreement) * best().misfit) fits.push_back(s.last());
  }
  return fits;
}

double Convergence::spread(std::size_t look) const {
  double worst = 0;
  for (const LongSearch& s : searches) worst = std::max(worst, s.fits.at(look).misfit);
  return worst / best().misfit - 1;
}

std::optional<double> Convergence::agreed_from() const {
  std::optional<double> from;
  for (std::size_t look = looks; look-- > 0 && spread(look) <= agreement;) from = looked_at[look];
  return from;
}

std::vector<Convergence> converge(const std::vector<Freedom>& freedoms, const ConvergencePlan& plan,
                                  FitStore& store) {
  std::vector<Convergence> all;
  for (const Freedom& freedom : freedoms) {
    Convergence& one = all.emplace_back();
    one.freedom = freedom;
    one.evaluations = plan.evaluations;
    for (const Solver& solver : plan.solvers) {
      for (const int seed : plan.seeds) one.searches.push_back({solver.name, seed, {}});
    }
  }
  const std::size_t each = plan.solvers.size() * plan.seeds.size();
  Progress progress("searching until searches agree", static_cast<double>(all.size() * each));
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, all.size() * each, 1),
      [&](const tbb::blocked_range<std::size_t>& range) {
        for (std::size_t i = range.begin(); i != range.end(); ++i) {
          LongSearch& search = all[i / each].searches[i % each];
          search.fits =
              known_or_searched(freedoms[i / each], plan.solvers[i % each / plan.seeds.size()],
                                search.seed, plan, store);
          progress.advance(1);
        }
      },
      tbb::simple_partitioner());
  return all;
}

OrderOfPairs order_of_pairs(const std::vector<Convergence>& all) {
  OrderOfPairs result;
  for (std::size_t a = 0; a < all.size(); ++a) {
    for (std::size_t b = a + 1; b < all.size(); ++b) {
      int first = 0, second = 0;
      for (std::size_t s = 0; s < all[a].searches.size(); ++s) {
        const double difference =
            all[a].searches[s].last().misfit - all[b].searches[s].last().misfit;
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
