#pragma once

#include <vector>

#include "problems/carrier_track/identification/knock_record.h"
#include "problems/carrier_track/identification/knock_unknowns.h"
#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline identification {

/// The density of knocks per second, and per unit of log strength if strengths are recorded, that
/// a point of the unknowns predicts: spurious ones at a uniform rate, and around every predicted
/// impact a Gaussian of the jitter, which holds the share of records in which the impact appears.
/// While the sensor is deaf after a knock nothing is expected but the impact of that knock. Of a
/// strength at the record's saturation only that it is reached is known.
///
/// `blur` [rad] >= 0, an angle of the driver plate, widens the Gaussians, to sqrt(jitter^2 + (blur
/// / speed)^2): far from the solution a wide density is what a solver can follow.
class KnockDensity {
 public:
  /// The impacts must be in order of time.
  KnockDensity(const KnockRecord& record, std::vector<PredictedImpact> impacts, const Vector& x,
               double blur);

  /// The logarithm of the density at a knock. Adds its derivatives, times `factor`, to `slopes` if
  /// it is not null; length knock_unknowns.
  double log_at(const Knock& knock, Vector* slopes, double factor = 1) const;

  /// The expected number of knocks, and its derivatives.
  double expected(Vector* slopes) const;

  /// The expected information on the unknowns in a record, and the covariance of the score, which
  /// is smaller: an impact appears at most once, which the density does not know. Both are
  /// knock_unknowns x knock_unknowns.
  struct Information {
    Matrix information, score;
  };
  Information information() const;

  const std::vector<PredictedImpact>& impacts() const { return impacts_; }

  /// The share of records in which an impact appears, in [0, 1].
  double recorded_share(const PredictedImpact& impact) const;

 private:
  double margin(const PredictedImpact& impact) const;
  double wall_share(const PredictedImpact& impact) const;

  /// What an impact adds to the density at a knock. Adds its derivatives to `slopes`.
  double bump(const Knock& knock, const PredictedImpact& impact, Vector* slopes) const;

  /// The density at a knock, and the derivatives of its logarithm, which may be empty.
  struct Explained {
    double density;
    Vector slopes;
  };

  /// Of all knocks if the sensor has a dead time; otherwise empty.
  std::vector<Explained> explained(bool slopes) const;

  /// The part of an impact's Gaussian that the sensor hears, with its derivatives by the impact's
  /// time [1/s] and by the logarithm of the jitter, and by all unknowns through the shares of the
  /// knocks that are its own.
  struct Heard {
    double part, by_time, by_jitter;
    Vector by_owner;
  };

  /// A knock makes the sensor deaf to an impact by the probability that it is another's.
  Heard heard(const PredictedImpact& impact, const std::vector<Explained>& explained) const;
  void add(Vector* slopes, const PredictedImpact& impact, double by_time,
           double by_log_speed) const;
  double width(double time) const;

  const KnockRecord& record_;
  std::vector<PredictedImpact> impacts_;
  KnockUnknowns at_;
  double blur_;                ///< [rad]
  double strength_range_ = 1;  ///< of log strengths; 1 without
  bool strengths_;
};

/// What a fit minimises: -ln of the likelihood of a record, as of independent points of a
/// KnockDensity, and of weak prior knowledge: unknowns that the record says nothing about stay near
/// the scene's.
class KnockLoss {
 public:
  /// `record` must outlive it. The scene must be of fidelity impact.
  KnockLoss(const Scene& scene, const KnockRecord& record);

  /// The loss at a point of the unknowns. Writes its derivatives, of length knock_unknowns, to
  /// `slopes` if it is not null. `blur`: see KnockDensity.
  double at(const Vector& x, double blur, Vector* slopes = nullptr) const;

  /// The density that a point predicts.
  KnockDensity density(const Vector& x, double blur = 0) const;

  /// The information of the record and of the prior knowledge at a point.
  KnockDensity::Information information(const Vector& x, double blur = 0) const;

  /// The coordinates that are fitted; the others keep their values of guess().
  const std::vector<Eigen::Index>& free() const { return free_; }

  /// Slower impacts [m/s] are far below the detection limit of a point.
  double slowest(const Vector& x) const;

  /// Where the prior knowledge is centred.
  const Vector& guess() const { return guess_; }
  const Scene& scene() const { return scene_; }
  const KnockRecord& record() const { return record_; }

 private:
  double prior(const Vector& x, Vector* slopes) const;

  Scene scene_;
  const KnockRecord& record_;
  Vector guess_;
  Vector deviations_;  ///< of the prior knowledge, infinite where there is none
  std::vector<Eigen::Index> free_;
};

}  // namespace ricochet::carrier_track::inline identification
