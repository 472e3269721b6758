#pragma once

#include <optional>

namespace ricochet::carrier_track::inline events {

/// Reports every local maximum of x to an observer, when the body starts to move down from it. A
/// plateau counts once, at its start.
template <class Scalar>
class PeakWatch {
 public:
  /// The body starts or continues to move in `direction`, -1 or +1.
  template <class SomeObserver>
  void moves(int direction, SomeObserver& observer) {
    if (direction < 0 && summit_) observer.peak(summit_->time, summit_->position);
    summit_.reset();
    rising_ = direction > 0;
  }

  /// The body has stopped or reversed at `time` [s] and `position` [m].
  void stops(const Scalar& time, const Scalar& position) {
    if (rising_ && !summit_) summit_ = Summit{time, position};
  }

 private:
  struct Summit {
    Scalar time, position;
  };

  bool rising_ = false;
  std::optional<Summit> summit_;
};

}  // namespace ricochet::carrier_track::inline events
