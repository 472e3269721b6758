#include "solvers/fireworks/loser_out_fireworks.h"

#include <algorithm>
#include <stdexcept>
#include <tuple>
#include <vector>

#include "solvers/fireworks/population.h"
#include "solvers/fireworks/sparks.h"

namespace ricochet::fireworks {

namespace {

constexpr double largest_reach = 1000;

struct Firework {
  Vector x;
  TrueValues worth;
  double amplitude = 1;  // in box widths
};

class Tournament {
 public:
  Tournament(Evaluator& evaluator, const LoserOutFireworksOptions& options, Random& random)
      : evaluator_(evaluator),
        options_(options),
        random_(random),
        box_(evaluator.lower(), evaluator.upper()),
        sparks_(evaluator, options.sparks + options.guiding_sparks),
        ranked_(static_cast<std::size_t>(options.sparks)),
        order_(static_cast<std::size_t>(options.sparks)) {}

  /// Each returns false once the evaluator refuses.
  bool begin(const Vector& start);
  bool next_generation();

 private:
  bool begin_anew(Firework& firework);
  bool explode(Firework& firework);
  bool add_spark(const Firework& firework);
  void guide_spark(const Firework& firework);
  bool replace_losers(const std::vector<TrueValues>& before);
  void rank_sparks();

  Evaluator& evaluator_;
  const LoserOutFireworksOptions& options_;
  Random& random_;
  Box box_;
  std::vector<Firework> fireworks_;
  Population sparks_;  // of one firework, the guiding ones last
  std::vector<std::tuple<double, double, Eigen::Index>> ranked_;  // sorted: better(), then index
  std::vector<Eigen::Index> order_;  // without the guiding one: from the best to the worst
  Vector spark_;
};

/// Evaluates the firework at its place and resets its amplitude to the initial one.
bool Tournament::begin_anew(Firework& firework) {
  const auto values = evaluator_.values(firework.x);
  if (!values) return false;
  firework.worth = worth_of(*values, evaluator_.equalities());
  firework.amplitude = 1;
  return true;
}

bool Tournament::begin(const Vector& start) {
  fireworks_.resize(static_cast<std::size_t>(options_.fireworks));
  for (Firework& firework : fireworks_) {
    firework.x = start;
    if (&firework != &fireworks_.front()) box_.draw(firework.x, random_);
    if (!begin_anew(firework)) return false;
  }
  return true;
}

void Tournament::rank_sparks() {
  for (std::size_t i = 0; i < ranked_.size(); ++i) {
    const auto spark = static_cast<Eigen::Index>(i);
    ranked_[i] = {sparks_.worth(spark).violation, sparks_.worth(spark).objective, spark};
  }
  std::sort(ranked_.begin(), ranked_.end());
  for (std::size_t i = 0; i < ranked_.size(); ++i) order_[i] = std::get<2>(ranked_[i]);
}

/// Brings the spark back into the box and evaluates it.
bool Tournament::add_spark(const Firework& firework) {
  if (options_.redraw_near) {
    box_.bring_near(spark_, firework.x, firework.amplitude, random_);
  } else {
    box_.bring_back(spark_, options_.mapping, random_);
  }
  return sparks_.add(spark_);
}

void Tournament::guide_spark(const Firework& firework) {
  const auto sparks = sparks_.points().topRows(options_.sparks);
  if (options_.reach > 0) {
    spark_ = mean_of_best(sparks, order_, options_.guiding_share);
    guide(spark_, sparks, order_, options_.guiding_share, options_.reach * share(random_));
  } else {
    spark_ = firework.x;
    guide(spark_, sparks, order_, options_.guiding_share);
  }
}

bool Tournament::explode(Firework& firework) {
  sparks_.clear();
  for (int k = 0; k < options_.sparks; ++k) {
    spark_ = firework.x;
    displace(spark_, box_.free(), firework.amplitude, box_.width(), Offsets::each, random_);
    if (!add_spark(firework)) return false;
  }
  rank_sparks();
  for (int k = 0; k < options_.guiding_sparks; ++k) {
    guide_spark(firework);
    if (!add_spark(firework)) return false;
  }

  const Eigen::Index best = best_of(sparks_.worths(), Ties::first, random_);
  const bool improved = better(sparks_.worth(best), firework.worth);
  if (improved) {
    firework.x = sparks_.point(best);
    firework.worth = sparks_.worth(best);
  }
  firework.amplitude = options_.steps.next(firework.amplitude, improved);
  return true;
}

bool Tournament::replace_losers(const std::vector<TrueValues>& before) {
  std::vector<TrueValues> worths = before;
  for (const Firework& firework : fireworks_) worths.push_back(firework.worth);
  const Vector fitness = fitness_of(worths);
  const double best = fitness.tail(options_.fireworks).minCoeff();
  const double generations_left =
      static_cast<double>(evaluator_.remaining()) /
      (static_cast<double>(options_.fireworks) * (options_.sparks + options_.guiding_sparks));
  for (Eigen::Index i = 0; i < options_.fireworks; ++i) {
    if (!loses(fitness[i], fitness[options_.fireworks + i], best, generations_left)) continue;
    Firework& loser = fireworks_[static_cast<std::size_t>(i)];
    box_.draw(loser.x, random_);
    if (!begin_anew(loser)) return false;
  }
  return true;
}

bool Tournament::next_generation() {
  std::vector<TrueValues> before;
  for (const Firework& firework : fireworks_) before.push_back(firework.worth);
  for (Firework& firework : fireworks_) {
    if (!explode(firework)) return false;
  }
  return replace_losers(before);
}

}  // namespace

LoserOutFireworksOptions multi_guiding_options() {
  return {.guiding_sparks = 10, .reach = 1.5, .redraw_near = true};
}

bool loses(double before, double now, double best, double generations_left) {
  const double progress = before - now;
  return progress > 0 && progress * generations_left < now - best;
}

Solver loser_out_fireworks(std::string name, const LoserOutFireworksOptions& options) {
  check_number("fireworks", options.fireworks);
  check_number("sparks", options.sparks);
  check_number("guiding_sparks", options.guiding_sparks);
  if (!(options.reach >= 0 && options.reach <= largest_reach)) {
    throw std::invalid_argument("reach: must be in [0, 1000]");
  }
  check(options.steps);
  if (!(options.guiding_share > 0 && options.guiding_share <= 1)) {
    throw std::invalid_argument("guiding_share: must be in (0, 1]");
  }
  return member(std::move(name),
                [options](Evaluator& evaluator, const Vector& start, Random& random) {
                  LoserOutFireworksOptions used = options;
                  if (used.scaled) used.sparks = scaled_sparks(used.sparks, evaluator.remaining());
                  Tournament tournament(evaluator, used, random);
                  if (!tournament.begin(start)) return;
                  while (tournament.next_generation()) {
                  }
                });
}

}  // namespace ricochet::fireworks
