#pragma once

#include <vector>

#include "problems/carrier_track/identification/knock_density.h"
#include "problems/carrier_track/identification/knock_record.h"
#include "problems/carrier_track/identification/knock_unknowns.h"
#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline identification {

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
