#pragma once

#include <span>
#include <string>
#include <vector>

#include "ricochet/scene.h"

/// A machine as a list of numbers, so that it crosses the border of a WebAssembly module.
namespace ricochet::live {

using carrier_track::Scene;

/// One number of the list.
struct FlatField {
  std::string table, key;            ///< of a machine file
  std::string unit;                  ///< "1" for a number without unit, "" for a choice
  std::string remark;                ///< what it means
  std::string range;                 ///< allowed numbers: "> 0", ">= 0", "0..1" or ""
  std::vector<std::string> choices;  ///< of a choice, whose number is its place; else empty
  bool required;                     ///< in a machine file
};

/// The fields of a machine file in its order, without [across] and speed profiles. Window and
/// contact_speed may be missing, which is NaN: exactly one of window.revolutions and window.seconds
/// is given.
std::vector<FlatField> flat_fields();

/// The numbers of a scene without `across` and profile; those two are left out.
std::vector<double> numbers_of(const Scene& scene);

/// The scene of these numbers, of which there are as many as flat_fields(). Throws InputError for a
/// choice that there is not, for a window without a length or with two, and as check() does; it
/// names the scene "machine".
Scene scene_of(std::span<const double> numbers);

}  // namespace ricochet::live
