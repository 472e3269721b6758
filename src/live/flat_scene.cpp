#include "src/live/flat_scene.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string_view>
#include <variant>

#include "problems/carrier_track/scene/scene_fields.h"
#include "ricochet/error.h"

namespace ricochet::live {
namespace {

using carrier_track::PlateSpeed;
using carrier_track::Revolutions;
using carrier_track::SceneField;
using carrier_track::Seconds;
using carrier_track::SpeedKnot;
using carrier_track::Walls;

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// Lists the fields of a table.
struct FieldList {
  std::string table;
  std::vector<FlatField>& fields;

  void add(const SceneField& field, std::string_view suffix = "",
           std::vector<std::string> choices = {}) const {
    fields.push_back({table, std::string(field.key) + std::string(suffix), std::string(field.unit),
                      std::string(field.remark), std::string(field.range.brief), std::move(choices),
                      field.presence == Presence::required});
  }

  void operator()(const SceneField& field, double /*x*/) const { add(field); }
  void operator()(const SceneField& field, Walls<const double> /*x*/) const {
    add(field, "_lower");
    add(field, "_upper");
  }
  void operator()(const SceneField& field,
                  PlateSpeed<const double, const std::vector<SpeedKnot<double>>> /*x*/) const {
    add(field);
  }
  void operator()(const SceneField& field, const std::optional<double>& /*x*/) const { add(field); }
  void operator()(const SceneField& field, bool /*x*/) const { add(field, "", {"false", "true"}); }
  template <class Enum>
  void operator()(const SceneField& field, Enum x) const {
    std::vector<std::string> names;
    for (const auto& [name, value] : names_of(x)) names.emplace_back(name);
    add(field, "", std::move(names));
  }
};

struct NumberList {
  std::vector<double>& numbers;

  void operator()(const SceneField& /*field*/, double x) const { numbers.push_back(x); }
  void operator()(const SceneField& /*field*/, Walls<const double> x) const {
    numbers.push_back(x.lower);
    numbers.push_back(x.upper);
  }
  void operator()(const SceneField& /*field*/,
                  PlateSpeed<const double, const std::vector<SpeedKnot<double>>> speed) const {
    numbers.push_back(speed.omega);
  }
  void operator()(const SceneField& /*field*/, const std::optional<double>& x) const {
    numbers.push_back(x.value_or(missing));
  }
  void operator()(const SceneField& /*field*/, bool x) const { numbers.push_back(x ? 1 : 0); }
  template <class Enum>
  void operator()(const SceneField& /*field*/, Enum x) const {
    double place = 0;
    for (const auto& choice : names_of(x)) {
      if (choice.second == x) break;
      ++place;
    }
    numbers.push_back(place);
  }
};

/// Gives each member its number, one after the other.
struct NumberReader {
  std::span<const double>& numbers;

  double next() const {
    const double x = numbers.front();
    numbers = numbers.subspan(1);
    return x;
  }

  void operator()(const SceneField& /*field*/, double& x) const { x = next(); }
  void operator()(const SceneField& /*field*/, Walls<double> x) const {
    x.lower = next();
    x.upper = next();
  }
  void operator()(const SceneField& /*field*/,
                  PlateSpeed<double, std::vector<SpeedKnot<double>>> speed) const {
    speed.omega = next();
  }
  void operator()(const SceneField& /*field*/, std::optional<double>& x) const {
    const double given = next();
    x = std::isnan(given) ? std::nullopt : std::optional(given);
  }
  void operator()(const SceneField& field, bool& x) const { x = choice(field, 2) == 1; }
  template <class Enum>
  void operator()(const SceneField& field, Enum& x) const {
    const auto& names = names_of(x);
    x = names[choice(field, names.size())].second;
  }

  std::size_t choice(const SceneField& field, std::size_t choices) const {
    const double place = next();
    if (!(place >= 0 && place < static_cast<double>(choices))) {
      throw InputError("machine: " + std::string(field.key) + ": there is no such choice");
    }
    return static_cast<std::size_t>(place);
  }
};

constexpr SceneField revolutions{"revolutions", "1", "of the driver plate, that are simulated",
                                 carrier_track::ranges::positive};
constexpr SceneField seconds{"seconds", "s", "that are simulated", carrier_track::ranges::positive};

void read_window(const NumberReader& read, Scene& scene) {
  const double turns = read.next(), time = read.next();
  if (std::isnan(turns) == std::isnan(time)) {
    throw InputError("machine: window: must have one of revolutions and seconds");
  }
  if (std::isnan(time)) {
    scene.window = Revolutions{turns};
  } else {
    scene.window = Seconds{time};
  }
}

}  // namespace

std::vector<FlatField> flat_fields() {
  std::vector<FlatField> fields;
  const Scene any;
  visit_scene_fields(FieldList{"scene", fields}, any);
  const FieldList window{"window", fields};
  window.add(revolutions);
  window.add(seconds);
  visit_count_fields(FieldList{"count", fields}, any);
  visit_model_fields(FieldList{"model", fields}, any);
  return fields;
}

std::vector<double> numbers_of(const Scene& scene) {
  std::vector<double> numbers;
  const NumberList list{numbers};
  visit_scene_fields(list, scene);
  const auto* turns = std::get_if<Revolutions>(&scene.window);
  numbers.push_back(turns != nullptr ? turns->count : missing);
  numbers.push_back(turns != nullptr ? missing : std::get<Seconds>(scene.window).count);
  visit_count_fields(list, scene);
  visit_model_fields(list, scene);
  return numbers;
}

Scene scene_of(std::span<const double> numbers) {
  Scene scene;
  const NumberReader read{numbers};
  visit_scene_fields(read, scene);
  read_window(read, scene);
  visit_count_fields(read, scene);
  visit_model_fields(read, scene);
  check(scene, "machine");
  return scene;
}

}  // namespace ricochet::live
