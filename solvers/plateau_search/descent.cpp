#include "solvers/plateau_search/descent.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <vector>

namespace ricochet::drifting {
namespace {

constexpr int most_steps = 100;
constexpr int most_idle = 20;
constexpr int most_trials = 6;       // of one step's length
constexpr double gain = 0.01;        // in the units of the objective
constexpr double first_step = 0.3;   // of the box, in the coordinate that moves most
constexpr double least_step = 1e-6;  // of the box
constexpr double slope_share = 1e-4;

/// Powell's update, which keeps B positive definite. `s` is the step, `w` what it did to the
/// gradient.
void update(Matrix& b, const Vector& s, const Vector& w) {
  const Vector bs = b * s;
  const double bent = s.dot(bs);
  const double seen = s.dot(w);
  const double share = seen < 0.2 * bent ? 0.8 * bent / (bent - seen) : 1;
  const Vector r = share * w + (1 - share) * bs;
  if (bent > 0 && s.dot(r) > 0) b += r * r.transpose() / s.dot(r) - bs * bs.transpose() / bent;
}

/// Where a step led.
struct Trial {
  Vector u;
  double objective;
  bool lower;
};

class Descent {
 public:
  Descent(Sight& sight, std::optional<double> width) : sight_(sight), width_(width) {}

  std::optional<double> from(Vector& best) {
    Vector u = best;
    auto here = sight_.slopes(u, width_);
    if (!here) return std::nullopt;
    double lowest = here->values.objective;
    double mark = lowest;  // the last one that was a gain
    int idle = 0;
    for (int k = 0; here && k < most_steps && idle < most_idle; ++k) {
      if (!usable(*here)) return lowest;
      if (fresh_) begin(here->gradient);
      const Vector p = model_step(b_, here->gradient, u);
      const bool ends = !p.allFinite() || !(p.dot(here->gradient) < 0);
      if (!ends && p.cwiseAbs().maxCoeff() < least_step) return lowest;
      if (ends && fresh_) return lowest;
      const auto trial = ends ? std::nullopt : shortened(u, p, *here);
      if (!ends && !trial) return std::nullopt;
      if (ends || (!trial->lower && !fresh_)) {
        fresh_ = true;
        ++idle;
        continue;
      }
      fresh_ = !trial->lower;
      idle = trial->objective < mark - gain ? 0 : idle + 1;
      mark = idle == 0 ? trial->objective : mark;
      const auto there = sight_.slopes(trial->u, width_);
      if (there) update(b_, trial->u - u, there->gradient - here->gradient);
      here = there;
      u = trial->u;
      if (trial->objective < lowest) {
        lowest = trial->objective;
        best = u;
      }
    }
    return here ? std::optional(lowest) : std::nullopt;
  }

 private:
  static bool usable(const Derivatives& here) {
    return std::isfinite(here.values.objective) && here.gradient.allFinite() &&
           here.gradient.norm() > 0;
  }

  void begin(const Vector& g) {
    b_ = Matrix::Identity(g.size(), g.size()) * (g.cwiseAbs().maxCoeff() / first_step);
  }

  /// The step, or a shorter one: the first that is lower, by the parabola through what is known.
  std::optional<Trial> shortened(const Vector& u, const Vector& p, const Derivatives& here) {
    Trial trial{u, 0, false};
    double length = 1;
    for (int k = 0; k < most_trials && !trial.lower; ++k) {
      trial.u = (u + length * p).cwiseMax(0.0).cwiseMin(1.0);
      const auto objective = sight_.objective(trial.u, width_);
      if (!objective) return std::nullopt;
      const double slope = length * here.gradient.dot(p);
      const double rise = *objective - here.values.objective;
      trial.objective = *objective;
      trial.lower = std::isfinite(rise) && rise <= slope_share * slope;
      const double least = std::isfinite(rise) ? -slope / (2 * (rise - slope)) : 0;
      length *= std::clamp(least, 0.1, 0.5);
    }
    return trial;
  }

  Sight& sight_;
  std::optional<double> width_;
  Matrix b_;
  bool fresh_ = true;
};

}  // namespace

Vector model_step(const Matrix& b, const Vector& g, const Vector& u) {
  Vector p = Vector::Zero(u.size());
  std::vector<Eigen::Index> free;
  for (Eigen::Index i = 0; i < u.size(); ++i) {
    if (!((u[i] <= 0 && g[i] > 0) || (u[i] >= 1 && g[i] < 0))) free.push_back(i);
  }
  while (!free.empty()) {
    const Vector slope = g + b * p;
    const Vector q = Matrix(b(free, free)).llt().solve(Vector(-slope(free)));
    std::vector<Eigen::Index> still;
    Vector met = p;
    for (std::size_t k = 0; k < free.size(); ++k) {
      const Eigen::Index i = free[k];
      const double end = u[i] + q[static_cast<Eigen::Index>(k)];
      if (end > 0 && end < 1) {
        still.push_back(i);
      } else {
        met[i] = (end >= 1 ? 1 : 0) - u[i];
      }
    }
    if (still.size() == free.size()) {
      p(free) = q;
      return p;
    }
    p = met;
    free = still;
  }
  return p;
}

std::optional<double> descend(Sight& sight, Vector& u, std::optional<double> width) {
  return Descent(sight, width).from(u);
}

}  // namespace ricochet::drifting
