#include "src/research/limits/front_search.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "src/core/progress.h"
#include "src/core/seed.h"

namespace ricochet::studies::limits {
namespace {

using namespace carrier_track;
using calibration::AskedFit;

/// One in this many members of the population begins on the front with fewer parameters.
constexpr std::size_t handed_on = 2;  // a half

double threshold_error(const Fit& fit) {
  return goals_of(judged_by_thresholds(fit.interpretation, fit.constants)).threshold_error;
}

/// The request for a point of one front of a chain, both by index.
AskedFit asked_point(const Parameterisation& parameterisation, const FrontChain& chain,
                     std::size_t number, std::size_t point) {
  std::string sizes;
  for (std::size_t k = 0; k <= number; ++k) sizes += fmt::format("-{}", chain.free[k].size());
  return {fmt::format("front{}, point {}, seed {}", sizes, point, chain.seed), parameterisation, "",
          fmt::format("{} generations of {}", chain.generations, chain.population),
          threshold_error};
}

/// Returns points of a front, evenly spaced in its order by rising error.
std::vector<Vector> starts_from(const ChainedFront* before,
                                const Parameterisation& parameterisation, std::size_t most) {
  std::vector<Vector> starts;
  if (before == nullptr) return starts;
  std::vector<Fit> fits = before->fits;
  std::ranges::stable_sort(fits, {}, &Fit::loss);
  const std::size_t size = std::min(most, fits.size());
  for (std::size_t k = 0; k < size; ++k) {
    starts.push_back(point_of(parameterisation, fits[k * fits.size() / size].constants));
  }
  return starts;
}

std::vector<Fit> fits_of(const Parameterisation& parameterisation, const FrontChain& chain,
                         std::size_t number, const ChainedFront* before, FitStore& store) {
  std::vector<Fit> fits;
  while (auto fit = store.find(asked_point(parameterisation, chain, number, fits.size()))) {
    fits.push_back(std::move(*fit));
  }
  if (!fits.empty()) return fits;
  const SeveralGoals problem{
      static_cast<Eigen::Index>(parameterisation.free.size()), goal_reference().size(),
      [&](const Vector& u) {
        return goal_vector(goals_of(judged_by_thresholds(parameterisation.interpretation,
                                                         constants_at(parameterisation, u))));
      }};
  const auto name = fmt::format("{} of {}", parameterisation.free.size(),
                                name_of(parameterisation.interpretation));
  const auto most = static_cast<std::size_t>(chain.population) / handed_on;
  const Front front = nsga2_front(
      problem, {chain.population, chain.generations, seed_of(name, "front", 0, chain.seed),
                starts_from(before, parameterisation, most)});
  std::vector<AskedFit> asked;
  for (const FrontPoint& point : front) {
    fits.push_back({parameterisation.interpretation, parameterisation.free,
                    constants_at(parameterisation, point.u), point.goals[0], ""});
    asked.push_back(asked_point(parameterisation, chain, number, asked.size()));
  }
  store.add(asked, fits);
  return fits;
}

ChainedFront front_of(const FrontChain& chain, std::size_t number, const ChainedFront* before,
                      FitStore& store) {
  ChainedFront front{
      parameterisation_of(chain.interpretation, chain.free[number]), chain.seed, {}, {}};
  front.fits = fits_of(front.parameterisation, chain, number, before, store);
  for (const Fit& fit : front.fits) {
    front.goals.push_back(goals_of(judged_by_thresholds(fit.interpretation, fit.constants)));
  }
  return front;
}

}  // namespace

Vector goal_vector(const GoalValues& goals) {
  Vector vector(4);
  vector << goals.threshold_error, goals.counts_missed + goals.count_distance, goals.impurity,
      goals.examples_missed;
  return vector;
}

Vector goal_reference() {
  Vector reference(4);
  reference << 0.3, 10, 1, 10;
  return reference;
}

double ChainedFront::dominated_share() const {
  Front front;
  for (const GoalValues& values : goals) add(front, {{}, goal_vector(values)});
  return hypervolume(front, goal_reference()) / goal_reference().prod();
}

std::vector<ChainedFront> searched_fronts(const std::vector<FrontChain>& chains, FitStore& store) {
  std::vector<std::vector<ChainedFront>> by_chain(chains.size());
  double work = 0;
  for (const FrontChain& chain : chains) work += static_cast<double>(chain.free.size());
  Progress progress("fronts", work);
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, chains.size(), 1),
      [&](const tbb::blocked_range<std::size_t>& range) {
        for (std::size_t i = range.begin(); i != range.end(); ++i) {
          for (std::size_t k = 0; k < chains[i].free.size(); ++k) {
            const ChainedFront* before = k == 0 ? nullptr : &by_chain[i].back();
            by_chain[i].push_back(front_of(chains[i], k, before, store));
            progress.advance(1);
          }
        }
      },
      tbb::simple_partitioner());
  std::vector<ChainedFront> all;
  for (std::vector<ChainedFront>& chain : by_chain) {
    std::ranges::move(chain, std::back_inserter(all));
  }
  return all;
}

}  // namespace ricochet::studies::limits
