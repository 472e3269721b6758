#include "solvers/plateau_search/drift.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <vector>

#include "solvers/plateau_search/archive.h"
#include "solvers/plateau_search/shape.h"

namespace ricochet::drifting {
namespace {

constexpr double target = 2.0 / 11;          // share of successes that keeps the step's size
constexpr double success_memory = 1.0 / 12;  // weight of the last step in that share
constexpr double some_coordinates = 0.5;     // share of the steps that move only some
constexpr double least_step = 1e-9;          // of the box
constexpr std::size_t archive_size = 300;
constexpr int candidates = 10;
constexpr std::size_t ancestors = 5;  // a failure is a point worse than the last but so many

/// A step before its size is settled.
struct Draw {
  Vector z;  // what it was shaped from
  Vector u;  // where it leads
};

class Drift {
 public:
  Drift(Sight& sight, Seen& at, double step, Random& random)
      : sight_(sight),
        at_(at),
        random_(random),
        n_(at.u.size()),
        size_(static_cast<double>(n_)),
        step_(step),
        shape_(n_),
        path_(Vector::Zero(n_)),
        normals_(static_cast<std::size_t>(sight.problem().constraints), Vector::Zero(n_)),
        archive_(n_, archive_size),
        before_{at.truth} {}

  bool go(std::int64_t patience) {
    for (std::int64_t idle = 0; idle < patience && step_ > least_step; ++idle) {
      const Draw draw = chosen();
      if (sight_.was_asked(draw.u)) continue;
      const auto truth = sight_.look(draw.u);
      if (!truth) return false;
      if (screens()) archive_.add(draw.u, *truth);
      if (better(*truth, at_.truth)) idle = -1;
      learn(draw, *truth);
    }
    return true;
  }

 private:
  bool screens() const { return !normals_.empty(); }

  Draw drawn() {
    Draw draw{normal(n_, random_), {}};
    Vector step = shape_.shaped(draw.z);
    if (uniform(random_) < some_coordinates) {
      const double share = std::max(1.0, size_ * uniform(random_) * uniform(random_)) / size_;
      Vector moves(n_);
      for (double& move : moves) move = uniform(random_) < share ? 1 : 0;
      const auto any = static_cast<Eigen::Index>(uniform(random_) * size_);
      if (moves.sum() == 0) moves[any] = 1;
      step = step.cwiseProduct(moves) * std::sqrt(size_ / moves.sum());
    }
    draw.u = sight_.inside(at_.u + step_ * step);
    return draw;
  }

  Draw chosen() {
    Draw best = drawn();
    if (!screens() || archive_.empty()) return best;
    for (int k = 1; k < candidates; ++k) {
      Draw other = drawn();
      if (better(archive_.foretold(other.u), archive_.foretold(best.u))) best = std::move(other);
    }
    return best;
  }

  void learn(const Draw& draw, const Truth& truth) {
    const Vector step = (draw.u - at_.u) / step_;
    if (at_.truth.violation <= 0 && !sight_.broken().empty()) {
      turn_away(step);
      return;
    }
    const bool success = !better(at_.truth, truth);
    successes_ = (1 - success_memory) * successes_ + (success ? success_memory : 0);
    const double growth = (successes_ - target) / (1 - target) / (1 + size_ / 2);
    if (success) {
      move(draw, step, truth);
    } else if (before_.size() == ancestors && better(before_.front(), truth)) {
      shrink(draw.z);
    }
    step_ = std::min(1.0, step_ * std::exp(growth));
  }

  void move(const Draw& draw, const Vector& step, const Truth& truth) {
    if (better(truth, at_.truth)) {
      before_.push_back(truth);
      if (before_.size() > ancestors) before_.pop_front();
    }
    at_ = {draw.u, truth};
    const double fading = 2 / (size_ + 2);
    path_ = (1 - fading) * path_ + std::sqrt(fading * (2 - fading)) * step;
    shape_.stretch(path_, 2 / (size_ * size_ + 6));
  }

  void shrink(const Vector& z) {
    const double square = z.squaredNorm();
    if (2 * square <= 1) return;
    shape_.shrink(z, std::min(0.4 / (std::pow(size_, 1.6) + 1), 1 / (2 * square - 1)));
  }

  /// Makes steps shorter towards the constraints that this one broke.
  void turn_away(const Vector& step) {
    const double fading = 1 / (size_ + 2);
    const double share = 0.1 / (size_ + 2) / static_cast<double>(sight_.broken().size());
    for (const Eigen::Index j : sight_.broken()) {
      Vector& away = normals_[static_cast<std::size_t>(j)];
      away = (1 - fading) * away + fading * step;
      shape_.flatten(away, share);
    }
  }

  Sight& sight_;
  Seen& at_;
  Random& random_;
  Eigen::Index n_;
  double size_;
  double step_;
  double successes_ = target;
  Shape shape_;
  Vector path_;
  std::vector<Vector> normals_;  // of the constraints, as learnt from steps that broke them
  Archive archive_;
  std::deque<Truth> before_;  // each better than the one before it
};

}  // namespace

bool drift(Sight& sight, Seen& at, const DriftLimits& limits, Random& random) {
  return Drift(sight, at, limits.step, random).go(limits.patience);
}

}  // namespace ricochet::drifting
