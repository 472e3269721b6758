#pragma once

namespace ricochet::carrier_track::inline problems {

/// The range of driver plate speeds [rad/s]. The paper's range is 0..18 rad/s; at 0 a window of
/// revolutions would never end.
inline constexpr double slowest_speed = 0.01;
inline constexpr double fastest_speed = 18.0;

}  // namespace ricochet::carrier_track::inline problems
