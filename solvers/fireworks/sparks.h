#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "ricochet/problem.h"
#include "ricochet/random.h"

/// How the point x of a firework becomes that of a spark. `moved` are the coordinates that change.
/// A spark may lie outside the box.
namespace ricochet::fireworks {

/// How many draws the offsets of a spark use.
enum class Offsets {
  each,  ///< one draw for each coordinate, as equation (26) is printed
  one,   ///< the same draw for all, as in Tan & Zhu
};

/// Adds amplitude * unit_k * U(-1, 1) to the coordinates: equation (26).
void displace(Vector& x, std::span<const Eigen::Index> moved, double amplitude, const Vector& unit,
              Offsets offsets, Random& random);

/// Multiplies the coordinates by one g ~ N(1, 1): equation (27). Biased towards the origin.
void multiply(Vector& x, std::span<const Eigen::Index> moved, Random& random);

/// Adds (best - x) e to the coordinates, with one e ~ N(0, 1): the Gaussian spark of EFWA.
void approach(Vector& x, std::span<const Eigen::Index> moved, const Vector& best, Random& random);

/// Adds the mean of the best sparks less the mean of the worst ones: the guiding spark (Li, Zheng
/// and Tan, IEEE Transactions on Evolutionary Computation 21 (2017) 153). A row of `sparks` is a
/// point; `order` lists the rows from the best to the worst; a part `share` in (0, 1] of them is
/// taken from either end, at least one. Adds `times` this difference.
void guide(Vector& x, const Eigen::Ref<const Matrix>& sparks, std::span<const Eigen::Index> order,
           double share, double times = 1);

/// The mean of the best sparks that guide() takes.
Vector mean_of_best(const Eigen::Ref<const Matrix>& sparks, std::span<const Eigen::Index> order,
                    double share);

/// The value of equation (24) if a firework's share of sparks is within its limits.
enum class ThirdBranch {
  rounded_share,  ///< round(S_i), as in Tan & Zhu
  as_printed,     ///< round(a m), as the paper prints it: the fewest, whatever the share
};

/// The spark counts of fireworks that all have the same fitness.
enum class TiedShare {
  most,   ///< each the most, as in (23): 200 sparks of 5 fireworks, others get about 50
  equal,  ///< each the same part of m
};

struct SparkCountOptions {
  double sparks = 50;    ///< m of (23): the total that the fireworks share
  double fewest = 0.04;  ///< a of (24): no firework has fewer than round(a m) sparks, which is >= 1
  double most = 0.8;     ///< b of (24): and none more than round(b m); a < b < 1
  double epsilon =
      2.2e-16;  ///< of (23), in the unit of the objective; the papers only call it small
  ThirdBranch third_branch = ThirdBranch::rounded_share;
  TiedShare tied = TiedShare::most;
};

/// Equations (23) and (24): the number of sparks of each firework. `fitness` holds a finite number
/// for each, lower is better.
std::vector<int> spark_counts(const Vector& fitness, const SparkCountOptions& options);

/// The largest possible number of sparks of n fireworks in all.
int most_sparks(int fireworks, const SparkCountOptions& options);

/// Throws std::invalid_argument for options that contradict each other or allow a firework without
/// sparks.
void check(const SparkCountOptions& options);

/// The published number of sparks for a budget of 300,000 evaluations, at which it was published,
/// or more; for fewer evaluations so that sparks and generations shrink by the same factor, but at
/// least 5: 300 sparks become 5, 17 and 55 for budgets of 100, 1,000 and 10,000 evaluations. Ours.
int scaled_sparks(int published, std::int64_t budget);

// Explosion amplitudes: how far sparks lie from their firework.

/// The unit of the amplitudes.
enum class AmplitudeUnit {
  of_x,        ///< the units of x, whatever the width of the box
  box_widths,  ///< the width of the box, coordinate by coordinate
};

/// Equation (25): amplitude * (f_i - best + epsilon) / (sum of f - best + epsilon). `fitness` holds
/// a finite number for each firework, lower is better. The amplitude of the best one is almost 0.
Vector explosion_amplitudes(const Vector& fitness, double amplitude, double epsilon);

/// The lower bound of EFWA's amplitudes, in their unit.
struct AmplitudeFloor {
  double first = 0;  ///< at the beginning, A_init
  double last = 0;   ///< when the budget is spent, A_final; 0 <= last <= first

  /// A_init - (A_init - A_final) / E sqrt((2 E - t) t) after t of E evaluations, 0 <= t <= E
  /// (Zheng, Janecek and Tan, CEC 2013, doi 10.1109/CEC.2013.6557813).
  double after(double evaluations, double budget) const;
};

/// An amplitude that grows while its firework improves, and declines otherwise (Zheng, Janecek, Li
/// and Tan, CEC 2014, doi 10.1109/CEC.2014.6900485).
struct AmplitudeSteps {
  double growth = 1.2;   ///< >= 1
  double decline = 0.9;  ///< in (0, 1]

  double next(double amplitude, bool better) const {
    return amplitude * (better ? growth : decline);
  }
};

/// Throws std::invalid_argument for steps out of range.
void check(const AmplitudeSteps& steps);

/// Uniform in [0, 1), in steps of 2^-53. Like uniform(), in a third of the time: random draws are
/// most of the cost of a spark.
inline double share(Random& random) {
  return static_cast<double>(static_cast<std::int64_t>(random() >> 11)) * 0x1p-53;
}

/// Uniform in [-1, 1).
inline double two_sided(Random& random) {
  return 2 * share(random) - 1;
}

/// One of 0, ..., count - 1; count >= 1.
inline std::size_t one_of(std::size_t count, Random& random) {
  return static_cast<std::size_t>(share(random) * static_cast<double>(count));
}

/// True with probability 1/2.
inline bool toss(Random& random) {
  return (random() >> 63) != 0;
}

/// How many of d coordinates a spark moves, and which.
enum class Moved {
  all,      ///< every one
  rounded,  ///< round(d U(0, 1)) of them, drawn without replacement: maybe none (Tan & Zhu's paper)
  ceiled,   ///< ceil(d U(0, 1)) of them: at least one (Tan & Zhu's program)
  coins,    ///< each with probability 1/2: maybe none (EFWA, dynFWA)
};

/// Draws the coordinates that each spark moves, from those given.
class Coordinates {
 public:
  explicit Coordinates(std::vector<Eigen::Index> all) : all_(std::move(all)) {}

  /// The coordinates that move, in any order; valid until the next call.
  std::span<const Eigen::Index> draw(Moved moved, Random& random);

 private:
  /// Draws `count` coordinates without replacement and moves them to the front.
  std::span<const Eigen::Index> first(std::size_t count, Random& random);

  std::vector<Eigen::Index> all_;
};

/// How a coordinate outside the box is brought back; one inside stays as it is.
enum class Mapping {
  modulo,  ///< lower + |x| mod (upper - lower), equation (28): just outside [-a, a] maps to near 0
  redraw,  ///< uniform in the box, as in EFWA and its successors
};

/// A problem's box. Coordinates of width 0 are fixed, the others free.
class Box {
 public:
  Box(const Vector& lower, const Vector& upper);

  const Vector& lower() const { return lower_; }
  const Vector& upper() const { return upper_; }
  const Vector& width() const { return width_; }
  const std::vector<Eigen::Index>& free() const { return free_; }

  /// Makes x, of the right length, uniform in the box.
  void draw(Vector& x, Random& random) const;

  /// Brings x back into the box, coordinate by coordinate.
  void bring_back(Vector& x, Mapping mapping, Random& random) const;

  /// Draws each coordinate of x outside the box again: uniform where the box and the centre, which
  /// is in the box, +- amplitude box widths overlap.
  void bring_near(Vector& x, const Vector& centre, double amplitude, Random& random) const;

 private:
  double drawn(Eigen::Index k, Random& random) const;

  Vector lower_, upper_, width_;
  std::vector<Eigen::Index> free_;
};

}  // namespace ricochet::fireworks
