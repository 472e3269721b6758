#include "src/identification/knock_fit.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "problems/carrier_track/identification/knock_problem.h"
#include "ricochet/error.h"
#include "src/core/time_limit.h"

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
  if (best.x.size() == 0) {
    throw InputError(
        "no start of the fit can be improved, since the impacts that it predicts depend on the "
        "constants without limit: put a restitution, friction and clearance that are nearer to the "
        "machine's into its file");
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

namespace {

constexpr int draws = 40;
constexpr int angles = 90;
constexpr double angle_width = 0.07;  // [rad], of a predicted knock
constexpr double background = 0.05;   // density of spurious knocks over that of an impact's peak

/// What the driver plate has turned [rad] since the record's start, by recorded speeds.
class PlateAngle {
 public:
  explicit PlateAngle(const KnockRecord& record) : record_(record) {}

  /// Times must rise from call to call.
  double at(double time) {
    angle_ += angle_between(record_.speed, time_, time);
    time_ = time;
    return angle_;
  }

 private:
  const KnockRecord& record_;
  double time_ = record_.from;
  double angle_ = 0;
};

std::vector<double> plate_angles(const KnockRecord& record) {
  PlateAngle plate(record);
  std::vector<double> result;
  for (const Knock& knock : record.knocks) result.push_back(plate.at(knock.time));
  return result;
}

/// The factor of all speeds at which the knocks recur best at the same two angles of the plate:
/// impacts come once on either wall in a turn.
double best_speed_factor(const std::vector<double>& knocks) {
  const double turned = std::max(1.0, knocks.back() - knocks.front());
  constexpr double widest = 0.03;
  const double step = 0.25 / turned;
  double best = 1;
  double most = 0;
  for (double offset = 0; offset <= widest; offset += step) {
    check_time_limit();
    report_progress("speed of the record", offset / widest);
    for (const double factor : {1 - offset, 1 + offset}) {
      std::complex<double> sum = 0;
      for (const double angle : knocks) sum += std::polar(1.0, 2 * factor * angle);
      // What fits equally well is taken for nearer to 1.
      if (std::abs(sum) <= 1.02 * most) continue;
      most = std::abs(sum);
      best = factor;
    }
  }
  return best;
}

struct Guess {
  double score;
  Vector x;
};

/// How well impacts at these angles of the plate, moved back by `phase`, explain the knocks.
double score_of(const std::vector<double>& knocks, const std::vector<double>& impacts,
                double phase) {
  double sum = 0;
  auto first = impacts.begin();
  for (const double knock : knocks) {
    double density = background;
    while (first != impacts.end() && *first - phase < knock - 4 * angle_width) ++first;
    for (auto impact = first; impact != impacts.end(); ++impact) {
      const double z = (*impact - phase - knock) / angle_width;
      if (z > 4) break;
      density += std::exp(-z * z / 2);
    }
    sum += std::log(density);
  }
  // Impacts that no knock shows cost as much as the density says.
  return sum - static_cast<double>(impacts.size());
}

Vector drawn(const Vector& guess, bool as_given, Random& random) {
  Vector x = guess;
  if (as_given) return within_limits(x);
  const Vector u = uniform_point(Vector::Constant(3, -1), Vector::Constant(3, 1), random);
  x[coordinate::restitution] += 1.5 * u[0];
  x[coordinate::friction] += 0.7 * u[1];
  x[coordinate::clearance] += 0.9 * u[2];
  return within_limits(x);
}

}  // namespace

std::vector<Vector> fit_starts(const KnockLoss& loss, std::size_t most, Random& random) {
  const KnockRecord& record = loss.record();
  const std::vector<double> knocks = plate_angles(record);
  const double factor =
      record.plate ? std::exp(loss.guess()[coordinate::speed_factor]) : best_speed_factor(knocks);
  std::vector<double> turned;
  for (const double angle : knocks) turned.push_back(factor * angle);
  const double slowest = loss.scene().counting_limit;
  std::vector<Guess> guesses;
  for (int k = 0; k < draws; ++k) {
    report_progress("starts of the fit", k / static_cast<double>(draws));
    Vector x = drawn(loss.guess(), k == 0, random);
    x[coordinate::speed_factor] = std::log(factor);
    PlateAngle plate(record);
    std::vector<double> impacts;
    for (const PredictedImpact& impact : plain_impacts(loss.scene(), record, x, slowest)) {
      impacts.push_back(factor * plate.at(impact.time));
    }
    Guess best{-std::numeric_limits<double>::infinity(), x};
    for (int i = 0; i < (record.plate ? 1 : angles); ++i) {
      check_time_limit();
      const double phase = 2 * std::numbers::pi * i / angles;
      const double score = score_of(turned, impacts, phase);
      if (score <= best.score) continue;
      best.score = score;
      best.x[coordinate::phase] = loss.guess()[coordinate::phase] + phase;
    }
    guesses.push_back(best);
  }
  std::ranges::stable_sort(guesses, std::greater(), &Guess::score);
  std::vector<Vector> starts;
  for (std::size_t k = 0; k < std::min(most, guesses.size()); ++k) starts.push_back(guesses[k].x);
  return starts;
}

}  // namespace ricochet::studies::identification
