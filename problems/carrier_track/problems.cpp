#include "problems/carrier_track/problems.h"

#include <algorithm>

#include "problems/carrier_track/collisions.h"
#include "problems/carrier_track/surrogate.h"

namespace ricochet::carrier_track {
namespace {

Problem speed_problem(std::string name, std::string source) {
  Problem problem;
  problem.name = std::move(name);
  problem.source = std::move(source);
  problem.lower = Vector::Constant(1, slowest_speed);
  problem.upper = Vector::Constant(1, fastest_speed);
  problem.start = Vector::Constant(1, (slowest_speed + fastest_speed) / 2);
  return problem;
}

}  // namespace

Problem count_problem(const Case& a_case, const Scene& reading) {
  Problem problem = speed_problem("count-" + a_case.id, "collision count, equations (31)-(33)");
  problem.evaluate = [scene = scene_of(a_case, reading)](const Vector& x) {
    return Values{objective(at_speed(scene, x[0]), 0.0), {}};
  };
  return problem;
}

Problem surrogate_problem(const Case& a_case, const Scene& reading, double width) {
  Problem problem =
      speed_problem("surrogate-" + a_case.id, "smooth surrogate of the collision count");
  const Scene scene = scene_of(a_case, reading);
  problem.evaluate = [scene, width](const Vector& x) {
    return Values{objective(at_speed(scene, x[0]), width), {}};
  };
  problem.differentiate = [scene, width](const Vector& x) {
    const Slope s = surrogate_slope(at_speed(scene, x[0]), width);
    return Derivatives{{s.value, {}}, Vector::Constant(1, s.slope), Matrix(0, 1)};
  };
  problem.truth = [scene](const Vector& x) {
    return Truth{objective(at_speed(scene, x[0]), 0.0), 0.0};
  };
  return problem;
}

Problem top_speed_problem(const Case& a_case, const Scene& reading, double limit) {
  Problem problem =
      speed_problem("top-speed-" + a_case.id, "fastest speed whose collision count is quiet");
  problem.constraints = 1;
  problem.evaluate = [scene = scene_of(a_case, reading), limit](const Vector& x) {
    return Values{-x[0], Vector::Constant(1, objective(at_speed(scene, x[0]), 0.0) - limit)};
  };
  return problem;
}

Problem top_speed_surrogate_problem(const Case& a_case, const Scene& reading, double limit,
                                    double width) {
  Problem problem = speed_problem("top-speed-surrogate-" + a_case.id,
                                  "fastest speed whose smooth surrogate is quiet");
  problem.constraints = 1;
  const Scene scene = scene_of(a_case, reading);
  problem.evaluate = [scene, limit, width](const Vector& x) {
    return Values{-x[0], Vector::Constant(1, objective(at_speed(scene, x[0]), width) - limit)};
  };
  problem.differentiate = [scene, limit, width](const Vector& x) {
    const Slope s = surrogate_slope(at_speed(scene, x[0]), width);
    return Derivatives{{-x[0], Vector::Constant(1, s.value - limit)},
                       Vector::Constant(1, -1.0),
                       Matrix::Constant(1, 1, s.slope)};
  };
  problem.truth = [scene, limit](const Vector& x) {
    return Truth{-x[0], std::max(0.0, objective(at_speed(scene, x[0]), 0.0) - limit)};
  };
  return problem;
}

std::vector<Problem> problems_of(const Case& a_case, const Scene& reading) {
  const double limit =
      quiet_limit(quiet_count(scene_of(a_case, reading), a_case.claim, ScanOptions{}));
  return {count_problem(a_case, reading), surrogate_problem(a_case, reading, default_width),
          top_speed_problem(a_case, reading, limit),
          top_speed_surrogate_problem(a_case, reading, limit, default_width)};
}

void certify(std::vector<Problem>& problems, const SpeedScan& scan, double limit) {
  std::optional<double> fewest;
  std::optional<double> fastest;
  for (std::size_t k = 0; k < scan.counts.size(); ++k) {
    if (scan.omega(k) < slowest_speed) continue;
    if (scan.counts[k] <= limit) fastest = scan.omega(k);
    fewest = std::min<double>(fewest.value_or(scan.counts[k]), scan.counts[k]);
  }
  for (Problem& problem : problems) {
    if (problem.constraints == 0) problem.best_known = fewest;
    if (problem.constraints > 0 && fastest) problem.best_known = -*fastest;
  }
}

}  // namespace ricochet::carrier_track
