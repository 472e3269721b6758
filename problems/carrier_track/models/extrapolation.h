#pragma once

#include <array>
#include <cstddef>

/// Extrapolation of a simple integration rule to a high order, for three variables.
/// Source: Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I, section II.9.
namespace ricochet::carrier_track::inline models {

inline constexpr std::size_t most_extrapolation_rows = 8;

using ExtrapolationState = std::array<double, 3>;

/// Changes of state over one step; each row divides the step into more pieces than the row before.
using ExtrapolationTable = std::array<ExtrapolationState, most_extrapolation_rows>;

/// The piece numbers and weights of a table.
struct ExtrapolationRule {
  std::array<int, most_extrapolation_rows> pieces{};
  /// 1 / (r - 1) of the Aitken-Neville scheme for each pair of rows; r is the ratio of their
  /// numbers of pieces, squared if the rule's error is a series in the square of the piece's
  /// length.
  std::array<std::array<double, most_extrapolation_rows>, most_extrapolation_rows> weight{};

  constexpr ExtrapolationRule(int spacing, bool even) {
    for (std::size_t j = 0; j < most_extrapolation_rows; ++j) {
      pieces[j] = 2 + spacing * static_cast<int>(j);
      for (std::size_t i = 0; i < j; ++i) {
        const double ratio = static_cast<double>(pieces[j]) / pieces[i];
        weight[j][i] = 1 / ((even ? ratio * ratio : ratio) - 1);
      }
    }
  }
};

/// Gragg's explicit midpoint rule in 2, 4, 6, ... pieces: k rows have order 2 k.
inline constexpr ExtrapolationRule midpoint_rule(2, true);

/// The linearly implicit Euler rule in 2, 3, 4, ... pieces: k rows have order k.
inline constexpr ExtrapolationRule euler_rule(1, false);

struct Extrapolated {
  ExtrapolationState change;
  ExtrapolationState error;  ///< estimated: the difference to one row less
};

/// Combines the first `rows` >= 2 rows of a table.
Extrapolated extrapolated(const ExtrapolationRule& rule, std::size_t rows,
                          ExtrapolationTable table);

/// The table of the midpoint rule over a step of `length` from `start`, where the state's rate is
/// `start_rate`; rate(state) is called pieces - 1 times a row. All rows advance together and are
/// independent, so that the processor works on several at a time.
template <class Rate>
ExtrapolationTable midpoint(Rate rate, const ExtrapolationState& start,
                            const ExtrapolationState& start_rate, double length, std::size_t rows) {
  ExtrapolationTable before{};
  ExtrapolationTable here;
  for (std::size_t j = 0; j < rows; ++j) {
    const double h = length / midpoint_rule.pieces[j];
    for (std::size_t i = 0; i < 3; ++i) here[j][i] = h * start_rate[i];
  }
  for (int piece = 1; piece < midpoint_rule.pieces[rows - 1]; ++piece) {
    for (std::size_t j = 0; j < rows; ++j) {
      if (midpoint_rule.pieces[j] <= piece) continue;
      const double h = length / midpoint_rule.pieces[j];
      const ExtrapolationState f =
          rate({start[0] + here[j][0], start[1] + here[j][1], start[2] + here[j][2]});
      for (std::size_t i = 0; i < 3; ++i) {
        const double next = before[j][i] + 2 * h * f[i];
        before[j][i] = here[j][i];
        here[j][i] = next;
      }
    }
  }
  return here;
}

}  // namespace ricochet::carrier_track::inline models
