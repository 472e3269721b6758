#include "problems/carrier_track/gradients/gauge_rows.h"

#include <Eigen/QR>
#include <cmath>

namespace ricochet::carrier_track::inline gradients {

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
