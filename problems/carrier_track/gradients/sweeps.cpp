#include "problems/carrier_track/gradients/sweeps.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace ricochet::carrier_track::inline gradients {

namespace {

/// Rows along given directions of the knots' speeds.
template <int size>
class DirectionRows : public TangentRows<size> {
 public:
  using Directions = Eigen::Matrix<double, Eigen::Dynamic, size>;

  /// The arguments must outlive the rows.
  DirectionRows(const ProfileMotion& motion, const Directions& speeds)
      : motion_(motion), speeds_(speeds) {}

  void enter(std::size_t knot) {
    auto& [angle, speed, slope] = this->ramp;
    const auto of = [&](std::size_t k) { return speeds_.row(static_cast<Eigen::Index>(k)); };
    for (; knot_ < knot; ++knot_) angle += 0.5 * motion_.span(knot_) * (of(knot_) + of(knot_ + 1));
    speed = of(knot);
    slope = (of(knot + 1) - of(knot)) / motion_.span(knot);
  }

 private:
  const ProfileMotion& motion_;
  const Directions& speeds_;
  std::size_t knot_ = 0;
};

/// What a sweep forward says of every leg: the derivatives of its start, its duration, and the time
/// and state at its end.
template <int size>
class MovedLegs {
 public:
  using Dual = ceres::Jet<double, size>;

  MovedLegs(const ProfileMotion& motion, const std::vector<LinearLeg<double>>& legs,
            const std::vector<EventTerm>& terms)
      : motion_(motion), legs_(legs), terms_(terms), moved_(motion.size()) {}

  void ended(std::size_t i, const TangentRow<size>& start, const TangentRow<size>& later,
             const TangentRow<size>& state) {
    const LinearLeg<double>& leg = legs_[i];
    const auto& curvature = terms_[i].curvature;
    const TangentRow<size> time = start + later;
    const LegEnd end = motion_.leg(i).end;
    const double velocity = end == LegEnd::impact ? motion_.leg(i).direction : end == LegEnd::cut;
    moved_[i] = {dual(leg.start, start),
                 dual(leg.duration, later),
                 dual(leg.velocity, velocity * state),
                 dual(leg.by_time, curvature(0, 0) * time + curvature(0, 1) * state),
                 dual(leg.by_state, curvature(1, 0) * time + curvature(1, 1) * state),
                 leg.release};
  }

  /// The flights, but for what complete() adds.
  std::vector<LinearLeg<Dual>> legs() && { return std::move(moved_); }

 private:
  template <class Tangent>
  static Dual dual(double value, const Tangent& tangent) {
    return {value, tangent.transpose()};
  }

  const ProfileMotion& motion_;
  const std::vector<LinearLeg<double>>& legs_;
  const std::vector<EventTerm>& terms_;
  std::vector<LinearLeg<Dual>> moved_;
};

/// The response of a leg, as duals along the directions of its start and duration.
template <class Local, class Dual>
LegResponse<Dual> chained(const LegResponse<Local>& response, const LinearLeg<Dual>& leg) {
  const auto dual = [&](const Local& of, double rate) {
    return Dual(of.a, of.v[0] * leg.ramp.angle.v + of.v[1] * leg.ramp.speed.v +
                          of.v[2] * leg.ramp.slope.v + of.v[3] * leg.start.v +
                          rate * leg.duration.v);
  };
  const auto each = [&](const Motion<Local>& by) {
    return Motion<Dual>{dual(by.position, by.velocity.a), dual(by.velocity, by.acceleration.a), {}};
  };
  return {each(response.by_angle), each(response.by_speed), each(response.by_slope),
          each(response.by_start)};
}

}  // namespace

SecondSweep::SecondSweep(const ProfileMotion& motion, const std::vector<LinearLeg<double>>& legs,
                         const std::vector<EventTerm>& terms)
    : motion_(motion), legs_(legs), terms_(terms), responses_(motion.size()) {
  for (std::size_t i = 0; i < motion.size(); ++i) {
    if (motion.leg(i).rests) continue;
    const auto& [angle, speed, slope] = legs[i].ramp;
    responses_[i] =
        motion.response(i, Local(legs[i].start, 3),
                        PlateRamp<Local>{Local(angle, 0), Local(speed, 1), Local(slope, 2)});
  }
}

template <int size>
Eigen::Matrix<double, Eigen::Dynamic, size> SecondSweep::sweep(
    const Eigen::Matrix<double, Eigen::Dynamic, size>& directions) const {
  using Dual = ceres::Jet<double, size>;
  DirectionRows<size> rows(motion_, directions);
  MovedLegs<size> moved(motion_, legs_, terms_);
  sweep_forward(motion_, legs_, rows, moved);
  std::vector<LinearLeg<Dual>> legs = std::move(moved).legs();
  std::vector<Dual> speeds;
  for (Eigen::Index k = 0; k < directions.rows(); ++k) {
    const double speed = motion_.speed(static_cast<std::size_t>(k));
    speeds.emplace_back(speed, directions.row(k).transpose());
  }
  complete(motion_, motion_.ramps<Dual>(speeds), legs,
           [&](std::size_t i) { return chained(responses_[i], legs[i]); });
  Eigen::Matrix<double, Eigen::Dynamic, size> result(directions.rows(), size);
  const std::vector<Dual> gradient = swept_back(motion_, legs);
  for (Eigen::Index k = 0; k < directions.rows(); ++k) {
    result.row(k) = gradient[static_cast<std::size_t>(k)].v.transpose();
  }
  return result;
}

Matrix SecondSweep::along(const Matrix& directions) const {
  if (directions.cols() == 1) return sweep<1>(directions);
  constexpr int block = 8;
  Matrix result(directions.rows(), directions.cols());
  for (Eigen::Index first = 0; first < directions.cols(); first += block) {
    const Eigen::Index size = std::min<Eigen::Index>(block, directions.cols() - first);
    Eigen::Matrix<double, Eigen::Dynamic, block> some(directions.rows(), block);
    some << directions.middleCols(first, size), Matrix::Zero(directions.rows(), block - size);
    result.middleCols(first, size) = sweep<block>(some).leftCols(size);
  }
  return result;
}

GaugeRows::GaugeRows(const ProfileMotion& motion, const ShapedKnots& knots, const Vector& widths)
    : motion_(motion), knots_(knots), widths_(widths), later_(Vector::Zero(widths.size() + 1)) {
  for (Eigen::Index k = widths.size(); k-- > 0;) {
    later_[k] = std::hypot(later_[k + 1], knots.share[k] * widths[k]);
  }
  share_[7] = later_[0];
  append(0);
  ramp.speed = next_;
  append(1);
}

void GaugeRows::enter(std::size_t knot) {
  for (; knot_ < knot; ++knot_) {
    ramp.angle += 0.5 * motion_.span(knot_) * (ramp.speed + next_);
    ramp.speed = next_;
    append(static_cast<Eigen::Index>(knot_ + 2));
  }
  ramp.slope = (next_ - ramp.speed) / motion_.span(knot_);
}

void GaugeRows::append(Eigen::Index knot) {
  TangentRow<8>* const rows[] = {&time, &position, &velocity, &ramp.angle, &ramp.speed, &share_};
  // The last direction, that of the share of later knots, splits into this knot and the rest.
  const double here = knots_.share[knot] * widths_[knot] / later_[knot];
  const double rest = later_[knot + 1] / later_[knot];
  Eigen::Matrix<double, 8, 7> columns;
  for (int i = 0; i < 6; ++i) {
    TangentRow<8>& row = *rows[i];
    columns.col(i) << row.head<7>().transpose(), here * row[7];
    row[7] *= rest;
  }
  const double speed = knots_.speeds[knot];
  columns.col(6) = -speed * columns.col(5);
  columns(7, 6) += knots_.scale * widths_[knot];
  next_[7] = -speed * share_[7];
  const Eigen::HouseholderQR<Eigen::Matrix<double, 8, 7>> turned(columns);
  const Eigen::Matrix<double, 7, 7> coordinates =
      turned.matrixQR().topRows<7>().triangularView<Eigen::Upper>();
  for (int i = 0; i < 6; ++i) rows[i]->head<7>() = coordinates.col(i).transpose();
  next_.head<7>() = coordinates.col(6).transpose();
}

}  // namespace ricochet::carrier_track::inline gradients
