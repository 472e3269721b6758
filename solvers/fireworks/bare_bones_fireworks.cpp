#include "solvers/fireworks/bare_bones_fireworks.h"

#include "solvers/fireworks/fitness.h"
#include "solvers/fireworks/member.h"
#include "solvers/fireworks/spark.h"

namespace ricochet::fireworks {
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
  while (true) {
    Vector spark, best;
    TrueValues best_worth;
    for (int k = 0; k < options.sparks; ++k) {
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
