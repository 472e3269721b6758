#pragma once

#include <array>
#include <cstddef>

namespace ricochet::carrier_track::inline models {

/// Bodies between hard walls, side by side, so that one instruction serves several of them: what
/// HardWallMotion holds of each, at constant speed under steady friction. SI units.
struct Lanes {
  static constexpr std::size_t size = 8;
  using Row = std::array<double, size>;

  // Events.
  static constexpr double none = 0;
  static constexpr double turned = 1;
  static constexpr double struck = 2;
  static constexpr double rested = 3;  ///< and set out in its direction, or to the window's end

  // What does not change while a body moves.
  alignas(64) Row steady{};  ///< of the forces
  alignas(64) Row friction{};
  alignas(64) std::array<Row, 2> frequency{};  ///< of the harmonics
  alignas(64) Row wall_lower{};
  alignas(64) Row wall_upper{};
  alignas(64) Row restitution_lower{};
  alignas(64) Row restitution_upper{};
  alignas(64) Row duration{};

  // What does.
  alignas(64) Row time{};
  alignas(64) Row origin{};  ///< the wall last touched, or the start
  alignas(64) Row offset{};  ///< from there
  alignas(64) Row velocity{};
  alignas(64) Row direction{};  ///< +1, -1; 0: a body at rest, or none
  alignas(64) Row wall{};       ///< that is touched: +1 the upper, -1 the lower, 0 none
  alignas(64) std::array<Row, 2> cosine{};
  alignas(64) std::array<Row, 2> sine{};
  alignas(64) Row evaluations{};  ///< of the flight, by fly()

  // What the last call of fly() has done.
  alignas(64) Row event{};
  alignas(64) Row elapsed{};  ///< [s], of a body with an event
  alignas(64) Row speed{};    ///< of approach, of a body that struck

  int harmonics = 2;  ///< how many of them act, 1 or 2, on every body
};

/// Lets every body fly to its next event where that is a turning point or an impact within the
/// window, and go on from there, and bodies at rest, where there are many of them, wait until they
/// set out or the window ends; event none, and no other change, for any other body. All bits are
/// those of HardWallMotion, on any machine. A body that turns and is held by friction has direction
/// 0; whether one that struck comes to rest is left to the caller.
void fly(Lanes& lanes);

}  // namespace ricochet::carrier_track::inline models
