#include "src/research/impact_test/scored_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "src/core/seed.h"
#include "src/research/impact_test/scene_kind.h"

namespace ricochet::studies::impact_test {
namespace {

using namespace carrier_track;
using report::Json;

/// The latest time up to `good_until` [s] in a wide enough gap between impacts; nothing if there is
/// none after a scored impact.
std::optional<double> good_end(const TestScene& scene, const Conditioned& known) {
  Truth impacts = known.impacts;
  const double clear = clear_of_the_end * mean_time_between(scene, impacts);
  if (known.good_until == scene.duration && !impacts.empty() &&
      scene.duration - impacts.back().time >= clear) {
    if (scored_impacts(scene, impacts) <= most_impacts) return scene.duration;
  }
  double next = known.good_until;
  while (!impacts.empty()) {
    const double last = impacts.back().time;
    const int scored = scored_impacts(scene, impacts);
    if (scored == 0) break;
    if (scored <= most_impacts && next - last >= 2 * clear) return (last + next) / 2;
    next = last;
    impacts.pop_back();
  }
  return std::nullopt;
}

double fastest_of(const std::vector<Impact>& impacts) {
  double fastest = 0;
  for (const Impact& i : impacts) fastest = std::max(fastest, i.speed);
  return fastest;
}

double rounded_to_three_digits(double x) {
  const double unit = std::pow(10, std::floor(std::log10(x)) - 2);
  return std::round(x / unit) * unit;
}

const char* name_of(Wall wall) {
  return wall == Wall::upper ? "upper" : "lower";
}

}  // namespace

std::optional<ScoredScene> scored_scene(Scene machine, double slowest_share, Random& random) {
  machine.counting_limit = 2 * least_slowest;
  const auto all = exact_impacts(test_scene(machine));
  if (!all || all->empty()) return std::nullopt;
  machine.counting_limit =
      std::max(rounded_to_three_digits(slowest_share * fastest_of(*all)), least_slowest);
  const auto known = conditioned_truth(test_scene(machine), random);
  if (!known) return std::nullopt;
  const auto end = good_end(test_scene(machine), *known);
  if (!end) return std::nullopt;
  machine.window = Seconds{*end};
  ScoredScene scored{0, test_scene(machine), machine, known->impacts};
  std::erase_if(scored.truth, [&](const TrueImpact& i) { return i.time > *end; });
  return scored;
}

ScoredScene drawn_scene(int seed, int index) {
  const auto kinds = static_cast<int>(scene_kinds().size());
  const SceneKind& kind = scene_kinds()[static_cast<std::size_t>(index % kinds)];
  const int difficulty = 1 + index / kinds % difficulties;
  Random random(seed_of("impact-test", kind.name, seed, index));
  Draw draw(random);
  for (;;) {
    const DrawnScene drawn = kind.draw(draw, difficulty);
    auto scored = scored_scene(drawn.machine, drawn.slowest_share, random);
    if (!scored) continue;
    scored->seed = seed;
    scored->scene.scene = fmt::format("{}-{:05}", kind.name, index);
    scored->scene.kind = kind.name;
    scored->scene.difficulty = difficulty;
    return std::move(*scored);
  }
}

Json json_of(const ScoredScene& scored) {
  Json line = scored.scene;
  line["impacts"] = report::list_of(scored.truth, [](const TrueImpact& i) -> Json {
    return {i.time, name_of(i.wall), i.speed, i.time_sensitivity, i.speed_sensitivity};
  });
  line["seed"] = scored.seed;
  line["machine"] = write_scene(scored.machine);
  return line;
}

ScoredScene scored_scene_of(const Json& line) {
  ScoredScene scored;
  scored.seed = line.at("seed").get<int>();
  scored.scene = line.get<TestScene>();
  scored.machine = parse_scene(line.at("machine").get<std::string>(), "machine");
  for (const Json& i : line.at("impacts")) {
    const Wall wall = i.at(1) == "upper" ? Wall::upper : Wall::lower;
    scored.truth.push_back({i.at(0), wall, i.at(2), i.at(3), i.at(4)});
  }
  return scored;
}

}  // namespace ricochet::studies::impact_test
