#pragma once

#include <cstdint>
#include <optional>
#include <unordered_set>

#include "src/core/evaluator.h"
#include "src/core/random.h"

/// What a plateau search sees of its problem.
namespace ricochet::drifting {

/// Neither is better.
bool tied(const Truth& a, const Truth& b);

/// A point of the unit cube and what it was taken for.
struct Seen {
  Vector u;
  Truth truth;
};

/// An evaluator seen through the unit cube, that remembers which points were asked for and which
/// was best. A value that is no number counts as infinitely bad.
class Sight {
 public:
  explicit Sight(Evaluator& evaluator);

  /// What the point is taken for, or nothing once the run is over.
  std::optional<Truth> look(const Vector& u);

  /// What is shown there at a smoothing width, with derivatives with respect to u; or nothing. No
  /// width where the problem has no such knob. Look, for one, is at what is judged.
  std::optional<Derivatives> slopes(const Vector& u, std::optional<double> width);

  /// The objective shown there at that width, or nothing.
  std::optional<double> objective(const Vector& u, std::optional<double> width);

  bool was_asked(const Vector& u) const { return asked_.contains(key_of(u)); }

  /// The point moved into the cube, and to 0 where the box has no width.
  Vector inside(const Vector& u) const;
  Vector to_unit(const Vector& x) const;
  Vector from_unit(const Vector& u) const;
  Vector uniform_point(Random& random) const;

  /// Constraints that were broken where it looked last.
  const std::vector<Eigen::Index>& broken() const { return broken_; }
  const std::optional<Seen>& best() const { return best_; }
  const Problem& problem() const { return evaluator_.problem(); }

 private:
  static std::uint64_t key_of(const Vector& u);
  void show(std::optional<double> width);

  Evaluator& evaluator_;
  Vector lower_, width_;
  std::optional<double> shown_;
  std::unordered_set<std::uint64_t> asked_;
  std::vector<Eigen::Index> broken_;
  std::optional<Seen> best_;
};

}  // namespace ricochet::drifting
