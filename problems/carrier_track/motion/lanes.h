#pragma once

#include <array>
#include <cstddef>

namespace ricochet::carrier_track::inline models {

/// The states of several bodies between hard walls, processed by one instruction: the data of
/// HardWallMotion for each, at constant speed under steady friction. SI units.
struct Lanes {
  static constexpr std::size_t size = 8;
  using Row = std::array<double, size>;

  // Events.
  static constexpr double none = 0;
  static constexpr double turned = 1;
  static constexpr double struck = 2;
  static constexpr double rested = 3;  ///< the rest has ended: the body moves, or the window ends

  // Constant while a body moves.
  alignas(64) Row steady{};  ///< of the forces
  alignas(64) Row friction{};
  alignas(64) std::array<Row, 2> frequency{};  ///< of the harmonics
  alignas(64) Row wall_lower{};
  alignas(64) Row wall_upper{};
  alignas(64) Row restitution_lower{};
  alignas(64) Row restitution_upper{};
  alignas(64) Row duration{};

  // Variable.
  alignas(64) Row time{};
  alignas(64) Row origin{};  ///< the wall last touched, or the start
  alignas(64) Row offset{};  ///< relative to origin
  alignas(64) Row velocity{};
  alignas(64) Row direction{};  ///< +1, -1; 0: a body at rest, or none
  alignas(64) Row wall{};       ///< the wall touched: +1 the upper, -1 the lower, 0 none
  alignas(64) std::array<Row, 2> cosine{};
  alignas(64) std::array<Row, 2> sine{};
  alignas(64) Row evaluations{};  ///< of the flight, by fly()

  // The results of the last call of fly().
  alignas(64) Row event{};
  alignas(64) Row elapsed{};  ///< [s], of a body with an event
  alignas(64) Row speed{};    ///< of approach, of a body that struck

  int harmonics = 2;        ///< number that act on every body, 1 or 2
  int flights = 1;          ///< the most in one call: bodies that turn or rest together may move on
  std::size_t used = size;  ///< no body is in the lanes from this one on
};

/// Moves every body to its next event, if that is a turning point or an impact within the window,
/// and sets its state after the event. If many bodies are at rest, they rest until they start to
/// move or the window ends. Any other body has event none and does not change. All bits are those
/// of HardWallMotion, on any machine. A body that turns and is held by friction has direction 0.
/// The caller decides whether a body that struck comes to rest.
void fly(Lanes& lanes);

}  // namespace ricochet::carrier_track::inline models
