// What the drivers in C++ share, of engines that advance by steps: they read scenes, a JSON object
// a line, and write impacts, as docs/simulators.md says. A driver is one source file with a World:
// made by World(scene, step, threshold), it has step(force), position() and velocity(), and treats
// a contact slower than the threshold as one without restitution.
#pragma once

#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

using Json = nlohmann::json;

/// A scene in an engine's units: the body's mass is 1, and the lower wall is at 0.
/// x'' = force - friction sign(x') between the walls; x' -> -restitution x' at a wall.
struct Scene {
  static constexpr double far_away = 1e6;  ///< the upper wall of a track that is open above

  /// `units`: how many of the engine's are a metre.
  Scene(const Json& json, double units)
      : upper(json.at("upper").is_null()
                  ? far_away
                  : (json.at("upper").get<double>() - json.at("lower").get<double>()) * units),
        restitution_lower(json.at("restitution_lower")),
        restitution_upper(json.at("restitution_upper")),
        friction(json.at("friction").get<double>() * units / json.at("mass").get<double>()),
        position((json.at("position").get<double>() - json.at("lower").get<double>()) * units),
        velocity(json.at("velocity").get<double>() * units),
        unit_of_force(units / json.at("mass").get<double>()) {
    for (const Json& segment : json.at("force")) {
      segments.push_back({segment.at("from"), {}});
      for (const Json& term : segment.at("terms")) {
        segments.back().terms.push_back({term.at("amplitude"), term.at("phase")});
      }
    }
  }

  /// The sum of (a0 + a1 u + a2 u^2) cos(p0 + p1 u + p2 u^2), u [s] since the segment's start.
  double force(double time) const {
    auto segment = segments.end() - 1;
    while (segment != segments.begin() && segment->from > time) --segment;
    const double u = time - segment->from;
    double sum = 0;
    for (const auto& [a, p] : segment->terms) {
      sum += (a[0] + u * (a[1] + u * a[2])) * std::cos(p[0] + u * (p[1] + u * p[2]));
    }
    return sum * unit_of_force;
  }

  struct Term {
    std::array<double, 3> amplitude, phase;
  };
  struct Segment {
    double from;  ///< [s]
    std::vector<Term> terms;
  };

  double upper, restitution_lower, restitution_upper, friction, position, velocity;
  double unit_of_force;
  std::vector<Segment> segments;
};

/// What an engine likes.
struct Likes {
  double clearance;  ///< in its units of length
  double threshold;  ///< of the speed that the largest force gives in a step
  /// The threshold in its units if it cannot be set; the unit of length then makes it the one
  /// wanted.
  double fixed_threshold = 0;
};

/// Simulates a scene with steps of that length [s]. Impacts are read off the jumps of the velocity.
template <typename World>
void simulate(const Json& json, double step, const Likes& likes, Json& answer) {
  const Json& scales = json.at("scales");
  const double mass = json.at("mass");
  const double slow = likes.threshold * scales.at("force").get<double>() / mass * step;
  const double units = likes.fixed_threshold > 0
                           ? likes.fixed_threshold / slow
                           : likes.clearance / scales.at("length").get<double>();
  const Scene scene(json, units);
  const double threshold = slow * units;
  World world(scene, step, threshold);
  Json impacts = Json::array();
  double deepest = 0;
  int touched = 0;  // the wall in the last step: -1 lower, 1 upper
  const auto steps = static_cast<long>(std::ceil(json.at("duration").get<double>() / step));
  for (long k = 0; k < steps; ++k) {
    const double time = step * static_cast<double>(k);
    const double position = world.position();
    const double velocity = world.velocity();
    const double pushed = scene.force(time) * step;
    world.step(scene.force(time));
    const double jump = world.velocity() - velocity - pushed;
    const double unsure = 1e-4 * (std::abs(velocity) + std::abs(pushed));
    const bool touches = std::abs(jump) > 1.01 * scene.friction * step + unsure;
    const int wall = !touches ? 0 : jump > 0 ? -1 : 1;
    const double approach = wall * (velocity + pushed);
    const bool is_same = wall == touched && wall * velocity > 0;  // it is not yet thrown back
    if (approach > threshold && !is_same) {
      const double gap = wall < 0 ? position : scene.upper - position;
      const double since = std::clamp(gap / approach, 0.0, step);
      impacts.push_back({time + since, wall > 0 ? "upper" : "lower", approach / units});
    }
    touched = wall;
    deepest = std::max({deepest, -world.position(), world.position() - scene.upper});
  }
  answer["impacts"] = impacts;
  answer["deepest"] = deepest / units;
}

/// A driver's main(): answers all scenes of the standard input.
template <typename World>
int run_engine(int argc, char** argv, const Likes& likes) {
  const std::array<std::pair<std::string, double>, 3> levels = {
      {{"loose", 1.0 / 240}, {"usual", 1e-3}, {"tight", 1e-4}}};  // steps [s]
  const auto level = std::find_if(levels.begin(), levels.end(), [&](const auto& l) {
    return l.first == (argc > 1 ? argv[argc - 1] : "");
  });
  if (level == levels.end()) {
    std::cerr << "usage: " << argv[0] << " loose|usual|tight\n";
    return 2;
  }
  const auto processor_seconds = [] {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  };
  std::FILE* const answers = fdopen(dup(STDOUT_FILENO), "w");
  dup2(STDERR_FILENO, STDOUT_FILENO);  // what a library prints is no answer
  for (std::string line; std::getline(std::cin, line);) {
    const Json json = Json::parse(line);
    Json answer = {{"scene", json.at("scene")}};
    try {
      const double start = processor_seconds();
      simulate<World>(json, level->second, likes, answer);
      answer["seconds"] = processor_seconds() - start;
    } catch (const std::exception& error) {
      answer["error"] = error.what();
    }
    std::fprintf(answers, "%s\n", answer.dump().c_str());
    std::fflush(answers);
  }
  return 0;
}
