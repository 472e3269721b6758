#include "src/studies/limits/front_search.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "src/campaign/progress.h"
#include "src/core/seed.h"

namespace ricochet::studies::limits {
namespace {

using namespace carrier_track;

/// So many of the population begin where the front with fewer constants is.
constexpr std::size_t handed_on = 2;  // a half

/// Of the point of that number in the front of that number of a chain.
std::string key_for(const Freedom& freedom, const FrontChain& chain, std::size_t number,
                    std::size_t point) {
  std::string sizes;
  for (std::size_t k = 0; k <= number; ++k) sizes += fmt::format("-{}", chain.freed[k].size());
  const auto kind =
      fmt::format("front{}-{}x{}-point-{}", sizes, chain.generations, chain.population, point);
  return calibration::key_of(kind, freedom, {{}, {}, {}, chain.generations, chain.seed}, "");
}

/// Of a front evenly many by rising error.
std::vector<Vector> starts_from(const ChainedFront* before, const Freedom& freedom,
                                std::size_t most) {
  std::vector<Vector> starts;
  if (before == nullptr) return starts;
  std::vector<Fit> fits = before->fits;
  std::ranges::stable_sort(fits, {}, &Fit::misfit);
  const std::size_t size = std::min(most, fits.size());
  for (std::size_t k = 0; k < size; ++k) {
    starts.push_back(point_of(freedom, fits[k * fits.size() / size].constants));
  }
  return starts;
}

std::vector<Fit> fits_of(const Freedom& freedom, const FrontChain& chain, std::size_t number,
                         const ChainedFront* before, FitStore& store) {
  std::vector<Fit> fits;
  while (auto fit = store.find(key_for(freedom, chain, number, fits.size()))) {
    fits.push_back(std::move(*fit));
  }
  if (!fits.empty()) return fits;
  const SeveralGoals problem{static_cast<Eigen::Index>(freedom.freed.size()),
                             goal_reference().size(), [&](const Vector& u) {
                               return goal_vector(goals_of(judged_by_thresholds(
                                   freedom.reading, constants_at(freedom, u))));
                             }};
  const auto name = fmt::format("{} of {}", freedom.freed.size(), name_of(freedom.reading));
  const auto most = static_cast<std::size_t>(chain.population) / handed_on;
  const Front front = nsga2_front(
      problem, {chain.population, chain.generations, seed_of(name, "front", 0, chain.seed),
                starts_from(before, freedom, most)});
  std::vector<std::pair<std::string, Fit>> kept;
  for (const FrontPoint& point : front) {
    fits.push_back(
        {freedom.reading, freedom.freed, constants_at(freedom, point.u), point.goals[0], ""});
    kept.emplace_back(key_for(freedom, chain, number, kept.size()), fits.back());
  }
  store.add(kept);
  return fits;
}

ChainedFront front_of(const FrontChain& chain, std::size_t number, const ChainedFront* before,
                      FitStore& store) {
  ChainedFront front{freedom_of(chain.reading, chain.freed[number]), chain.seed, {}, {}};
  front.fits = fits_of(front.freedom, chain, number, before, store);
  for (const Fit& fit : front.fits) {
    front.goals.push_back(goals_of(judged_by_thresholds(fit.reading, fit.constants)));
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
  for (const FrontChain& chain : chains) work += static_cast<double>(chain.freed.size());
  Progress progress("fronts", work);
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, chains.size(), 1),
      [&](const tbb::blocked_range<std::size_t>& range) {
        for (std::size_t i = range.begin(); i != range.end(); ++i) {
          for (std::size_t k = 0; k < chains[i].freed.size(); ++k) {
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
