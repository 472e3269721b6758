#include "src/identification/knock_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "problems/carrier_track/identification/knock_problem.h"
#include "problems/carrier_track/identification/next_speed.h"
#include "src/core/time_limit.h"
#include "src/identification/fit_start.h"

namespace ricochet::studies::identification {

using namespace carrier_track;

namespace {

constexpr std::int64_t steps_of_blurred = 8;
constexpr std::int64_t steps_of_sharp = 12;
constexpr int most_rounds = 8;

/// Two losses that differ by less belong to the same minimum.
constexpr double same_loss = 0.02;

/// ln of the friction over that of the best fit, where another fit starts.
constexpr double neighbours[] = {0, -0.08, 0.08, -0.04, 0.04};

/// The unknowns that are searched while the density is blurred: jitter and rates would only follow
/// the blur.
std::vector<Eigen::Index> of_motion(const KnockLoss& loss) {
  std::vector<Eigen::Index> result = {coordinate::restitution, coordinate::friction,
                                      coordinate::clearance, coordinate::phase,
                                      coordinate::speed_factor};
  if (loss.record().lag_deviation > 0) result.push_back(coordinate::lag);
  if (loss.record().has_strengths()) result.push_back(coordinate::gain);
  return result;
}

class Search {
 public:
  Search(const KnockLoss& loss, const Solver& solver) : loss_(loss), solver_(solver) {}

  /// Improves x at a blur. Returns the loss.
  double improve(Vector& x, double blur, std::int64_t steps) {
    const KnockCoordinates coordinates =
        knock_coordinates(loss_, x, blur, blur > 0 ? of_motion(loss_) : loss_.free());
    const Problem problem = knock_problem(loss_, coordinates, blur);
    const std::int64_t n = problem.dimension();
    Evaluator evaluator(problem, Budget{steps * (1 + n)});
    Random random(1);
    solver_.solve(evaluator, problem.start, random);
    if (evaluator.failure()) std::rethrow_exception(evaluator.failure());
    evaluations += static_cast<int>(evaluator.ledger().values + evaluator.ledger().derivatives);
    if (evaluator.best_shown() != nullptr) x = coordinates.at(*evaluator.best_shown());
    return loss_.at(x, blur);
  }

  int evaluations = 0;

 private:
  const KnockLoss& loss_;
  const Solver& solver_;
};

double median_of(std::vector<double> numbers) {
  const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
  std::ranges::nth_element(numbers, middle);
  return *middle;
}

/// Sets gain and scatter of strengths by those of the knocks over the nearest predicted impacts.
void set_gain(const KnockLoss& loss, Vector& x) {
  const KnockDensity density = loss.density(x, 1e-9);
  const std::vector<PredictedImpact>& impacts = density.impacts();
  if (impacts.empty()) return;
  std::vector<double> gains;
  for (const Knock& knock : loss.record().knocks) {
    auto impact = std::ranges::lower_bound(impacts, knock.time, {}, &PredictedImpact::time);
    if (impact == impacts.end() ||
        (impact != impacts.begin() &&
         knock.time - std::prev(impact)->time < impact->time - knock.time)) {
      --impact;
    }
    gains.push_back(std::log(*knock.strength) - impact->log_speed);
  }
  x[coordinate::gain] = median_of(gains);
  for (double& gain : gains) gain = std::abs(gain - x[coordinate::gain]);
  x[coordinate::scatter] = std::log(1.5 * median_of(gains) + 0.02);  // 1.5: of a Gaussian
}

/// Improves x without blur, in new coordinates every few steps, until that no longer helps. Returns
/// the loss.
double converge(Search& search, Vector& x) {
  double loss = std::numeric_limits<double>::infinity();
  for (int round = 0; round < most_rounds; ++round) {
    const double found = search.improve(x, 0, steps_of_sharp);
    if (found > loss - 0.1 * same_loss) return found;
    loss = found;
  }
  return loss;
}

/// Follows a loss from wide to no blur. Returns the loss without.
double descend(const KnockLoss& loss, Search& search, Vector& x,
               std::initializer_list<double> blurs) {
  for (const double blur : blurs) search.improve(x, blur, steps_of_blurred);
  if (loss.record().has_strengths()) set_gain(loss, x);
  return converge(search, x);
}

}  // namespace

double refine(const KnockLoss& loss, const Solver& solver, Vector& x) {
  Search search(loss, solver);
  return converge(search, x);
}

namespace {

/// Searches from everywhere; `best` is the best so far at any time.
void search_all(const KnockLoss& loss, Search& search, std::size_t starts, KnockFit& best) {
  Random random(1);
  double fits = 0;
  const double all = static_cast<double>(starts + 1 + std::size(neighbours));
  // Returns true if the best loss has been found again.
  const auto keep_better = [&](Vector x, std::initializer_list<double> blurs) {
    report_progress("fit of knocks", fits++ / all);
    const double found = descend(loss, search, x, blurs);
    const bool again = std::abs(found - best.loss) < same_loss;
    if (found < best.loss) {
      best.loss = found;
      best.x = x;
    }
    return again;
  };
  for (const Vector& x : fit_starts(loss, starts, random)) {
    if (keep_better(x, {0.06, 0.03, 0.015, 0.006})) break;
  }
  if (!loss.record().plate) {
    // Half a turn further the walls swap their roles: only a pull tells them apart.
    Vector twin = best.x;
    twin[coordinate::phase] += twin[coordinate::phase] > 0 ? -std::numbers::pi : std::numbers::pi;
    keep_better(twin, {0.006});
  }
  // Another minimum may be close by: where an impact appears or vanishes the loss jumps. Friction
  // decides that, and it is the constant that a wrong minimum shifts most.
  for (const double shift : neighbours) {
    Vector x = best.x;
    x[coordinate::friction] += shift;
    keep_better(x, {0.015, 0.006});
  }
  converge(search, best.x);
}

}  // namespace

KnockFit fit_knocks(const KnockLoss& loss, const Solver& solver, std::size_t starts) {
  Search search(loss, solver);
  KnockFit best{{}, {}, std::numeric_limits<double>::infinity(), 0, 0};
  try {
    search_all(loss, search, starts, best);
  } catch (const TimeLimitReached&) {
    if (best.x.size() == 0) throw;
    best.covariance = Matrix::Zero(knock_unknowns, knock_unknowns);
    best.evaluations = search.evaluations;
    best.complete = false;
    return best;
  }
  best.covariance = covariance_of(loss.information(best.x), loss.free());
  Vector slopes;
  best.loss = loss.at(best.x, 0, &slopes);
  const auto& free = loss.free();
  const Matrix directions = knock_coordinates(loss, best.x, 0, free).directions;
  best.excess = (directions.transpose() * slopes).squaredNorm() / 2;
  best.evaluations = search.evaluations;
  return best;
}

}  // namespace ricochet::studies::identification
