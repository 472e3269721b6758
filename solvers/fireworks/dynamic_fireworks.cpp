#include "solvers/fireworks/dynamic_fireworks.h"

#include <stdexcept>

#include "solvers/fireworks/population.h"
#include "solvers/fireworks/sparks.h"

namespace ricochet::fireworks {

namespace {

class DynamicShow {
 public:
  DynamicShow(Evaluator& evaluator, const DynamicFireworksOptions& options, Random& random)
      : options_(options),
        random_(random),
        box_(evaluator.lower(), evaluator.upper()),
        coordinates_(box_.free()),
        population_(evaluator, options.fireworks + most_sparks(options.fireworks, options.counts)) {
  }

  /// Each returns false once the evaluator refuses.
  bool begin(const Vector& start);
  bool explode();

  void select();

 private:
  const DynamicFireworksOptions& options_;
  Random& random_;
  Box box_;
  Coordinates coordinates_;
  Population population_;      // the fireworks first; after select() the best one is first
  Eigen::Index core_ = 0;      // the best firework
  double core_amplitude_ = 1;  // in box widths
  Vector spark_;
};

bool DynamicShow::begin(const Vector& start) {
  spark_ = start;
  for (int i = 0; i < options_.fireworks; ++i) {
    if (i > 0) box_.draw(spark_, random_);
    if (!population_.add(spark_)) return false;
  }
  core_ = best_of(population_.worths(), options_.selection.ties, random_);
  return true;
}

bool DynamicShow::explode() {
  const Vector fitness = fitness_of(population_.worths());
  const std::vector<int> counts = spark_counts(fitness, options_.counts);
  Vector amplitudes = explosion_amplitudes(fitness, options_.amplitude, options_.counts.epsilon);
  amplitudes[core_] = core_amplitude_;
  for (Eigen::Index i = 0; i < options_.fireworks; ++i) {
    for (int k = 0; k < counts[static_cast<std::size_t>(i)]; ++k) {
      spark_ = population_.point(i);
      displace(spark_, coordinates_.draw(options_.moved, random_), amplitudes[i], box_.width(),
               Offsets::each, random_);
      box_.bring_back(spark_, options_.mapping, random_);
      if (options_.redraw_clones && spark_ == population_.point(i)) box_.draw(spark_, random_);
      if (!population_.add(spark_)) return false;
    }
  }
  return true;
}

void DynamicShow::select() {
  const TrueValues before = population_.worth(core_);
  population_.keep(selected(population_.points(), population_.worths(), options_.fireworks,
                            options_.selection, random_));
  core_ = 0;
  core_amplitude_ = options_.steps.next(core_amplitude_, better(population_.worth(core_), before));
}

}  // namespace

Solver dynamic_fireworks(std::string name, const DynamicFireworksOptions& options) {
  check_number("fireworks", options.fireworks);
  check(options.counts);
  check(options.steps);
  if (!(options.amplitude >= 0)) throw std::invalid_argument("amplitude: must be >= 0");
  return member(std::move(name),
                [options](Evaluator& evaluator, const Vector& start, Random& random) {
                  DynamicShow show(evaluator, options, random);
                  if (!show.begin(start)) return;
                  while (show.explode()) show.select();
                });
}

BareBonesFireworksOptions tuned_options() {
  return {.sparks = 2, .steps = {.decline = 0.8}, .neutral_moves = true};
}

namespace {

void explode_until_refused(const BareBonesFireworksOptions& options, Evaluator& evaluator,
                           const Vector& start, Random& random) {
  const Box box(evaluator.lower(), evaluator.upper());
  const Eigen::Index equalities = evaluator.equalities();
  Vector firework = start;
  auto values = evaluator.values(firework);
  if (!values) return;
  TrueValues worth = worth_of(*values, equalities);
  double amplitude = 1;
  const int sparks =
      options.scaled ? scaled_sparks(options.sparks, evaluator.remaining()) : options.sparks;
  while (true) {
    Vector spark, best;
    TrueValues best_worth;
    for (int k = 0; k < sparks; ++k) {
      spark = firework;
      displace(spark, box.free(), amplitude, box.width(), Offsets::each, random);
      box.bring_back(spark, options.mapping, random);
      values = evaluator.values(spark);
      if (!values) return;
      const TrueValues spark_worth = worth_of(*values, equalities);
      if (k > 0 && !better(spark_worth, best_worth)) continue;
      best = spark;
      best_worth = spark_worth;
    }
    const bool improved = better(best_worth, worth);
    if (improved || (options.neutral_moves && !better(worth, best_worth))) {
      firework = best;
      worth = best_worth;
    }
    amplitude = options.steps.next(amplitude, improved);
  }
}

}  // namespace

Solver bare_bones_fireworks(std::string name, const BareBonesFireworksOptions& options) {
  check_number("sparks", options.sparks);
  check(options.steps);
  return member(std::move(name),
                [options](Evaluator& evaluator, const Vector& start, Random& random) {
                  explode_until_refused(options, evaluator, start, random);
                });
}

}  // namespace ricochet::fireworks
