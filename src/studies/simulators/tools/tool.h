// What the drivers in C++ of the impact test share: they read scenes, a JSON object a line, and
// write impacts, as docs/impact-test.md says. A driver is one source file that includes this
// header, defines `Result simulate(const Scene&, const Call&)`, and ends with `int main(int argc,
// char** argv) { return impact_test::run(argc, argv, simulate); }`.
#pragma once

#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace impact_test {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// (a0 + a1 u + a2 u^2) cos(p0 + p1 u + p2 u^2), u [s] since the start of its segment.
struct Term {
  std::array<double, 3> amplitude;  ///< [N], [N/s], [N/s^2]
  std::array<double, 3> phase;      ///< [rad], [rad/s], [rad/s^2]
};

/// The force from a time on, until the next segment.
struct Segment {
  double from;  ///< [s]
  std::vector<Term> terms;

  double force(double time) const {
    const double u = time - from;
    double sum = 0;
    for (const auto& [a, p] : terms) {
      sum += (a[0] + u * (a[1] + u * a[2])) * std::cos(p[0] + u * (p[1] + u * p[2]));
    }
    return sum;
  }
};

/// mass x'' = force - friction sign(x') between the walls; x' -> -restitution x' at a wall.
struct Scene {
  std::string name;
  double mass;                                  ///< [kg]
  double lower, upper;                          ///< [m], walls; upper may be infinity
  double restitution_lower, restitution_upper;  ///< Newton's
  double friction;                              ///< [N], set-valued at rest
  double position, velocity;                    ///< [m], [m/s], at the start
  double duration;                              ///< [s]
  double slowest;                               ///< [m/s]; slower impacts are not scored
  std::vector<Segment> segments;

  double end_of(std::size_t segment) const {
    return segment + 1 < segments.size() ? std::min(segments[segment + 1].from, duration)
                                         : duration;
  }
  const Segment& segment_at(double time) const {
    const auto next = std::upper_bound(segments.begin(), segments.end(), time,
                                       [](double t, const Segment& s) { return t < s.from; });
    return next == segments.begin() ? segments.front() : *(next - 1);
  }
  double force(double time) const { return segment_at(time).force(time); }

  /// The largest |amplitude polynomial|, summed over the terms: no force is larger [N].
  double largest_force() const {
    return largest([](const Segment& s, double u) {
      double sum = 0;
      for (const auto& [a, p] : s.terms) sum += std::abs(a[0] + u * (a[1] + u * a[2]));
      return sum;
    });
  }
  /// The highest frequency of the force [rad/s].
  double fastest() const {
    return largest([](const Segment& s, double u) {
      double fastest = 0;
      for (const auto& [a, p] : s.terms) fastest = std::max(fastest, std::abs(p[1] + 2 * u * p[2]));
      return fastest;
    });
  }
  /// A step that samples the fastest force twenty times a period, and the duration fifty times [s].
  double longest_step() const {
    return std::min(duration / 50, 2 * M_PI / 20 / std::max(fastest(), 1e-9));
  }
  /// The clearance; a millimetre, or the start's height, without an upper wall [m].
  double length() const {
    return upper < infinity ? upper - lower : std::max(1e-3, position - lower);
  }
  /// The speed that the force gives over that length [m/s].
  double speed() const {
    return std::max(std::abs(velocity), std::sqrt(2 * largest_force() / mass * length()));
  }

 private:
  template <typename Measure>
  double largest(const Measure& measure) const {
    double largest = 0;
    for (std::size_t k = 0; k < segments.size(); ++k) {
      const double span = end_of(k) - segments[k].from;
      for (const double u : {0.0, span / 2, span}) {
        largest = std::max(largest, measure(segments[k], u));
      }
    }
    return largest;
  }
};

struct Impact {
  double time;  ///< [s]
  bool on_upper;
  double speed;  ///< [m/s], of approach, > 0
};

struct Result {
  std::vector<Impact> impacts;
  double deepest = 0;              ///< [m], deepest penetration of a wall
  std::array<double, 2> end = {};  ///< position [m] and velocity [m/s]
};

/// The tool cannot express a scene; the text says why.
struct Cannot : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// How the driver was called: METHOD LEVEL, or LEVEL.
struct Call {
  std::string method;
  int level;  ///< 0 loose, 1 usual, 2 tight

  double pick(double loose, double usual, double tight) const {
    return std::array{loose, usual, tight}[level];
  }
};

inline Scene scene_of(const nlohmann::json& json) {
  const auto number = [&](const char* key) { return json.at(key).get<double>(); };
  Scene scene{json.at("scene").get<std::string>(),
              number("mass"),
              json.at("lower").is_null() ? -infinity : number("lower"),
              json.at("upper").is_null() ? infinity : number("upper"),
              number("restitution_lower"),
              number("restitution_upper"),
              number("friction"),
              number("position"),
              number("velocity"),
              number("duration"),
              number("slowest"),
              {}};
  for (const auto& part : json.at("force")) {
    Segment segment{part.at("from").get<double>(), {}};
    for (const auto& term : part.at("terms")) {
      segment.terms.push_back({term.at("amplitude").get<std::array<double, 3>>(),
                               term.at("phase").get<std::array<double, 3>>()});
    }
    scene.segments.push_back(segment);
  }
  return scene;
}

/// Processor time of this program [s].
inline double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Answers all scenes of the standard input by simulate(scene, call).
template <typename Simulate>
int run(int argc, char** argv, const Simulate& simulate) {
  const std::array<std::string, 3> levels = {"loose", "usual", "tight"};
  const auto level = std::find(levels.begin(), levels.end(), argc > 1 ? argv[argc - 1] : "");
  if (level == levels.end()) {
    std::cerr << "usage: " << argv[0] << " [METHOD] loose|usual|tight\n";
    return 2;
  }
  std::FILE* const answers = fdopen(dup(STDOUT_FILENO), "w");
  dup2(STDERR_FILENO, STDOUT_FILENO);  // what a library prints is no answer
  const Call call{argc > 2 ? argv[1] : "", static_cast<int>(level - levels.begin())};
  for (std::string line; std::getline(std::cin, line);) {
    const auto json = nlohmann::json::parse(line);
    nlohmann::json answer = {{"scene", json.at("scene")}};
    try {
      const Scene scene = scene_of(json);
      const double start = processor_seconds();
      const Result result = simulate(scene, call);
      const double seconds = processor_seconds() - start;
      answer["impacts"] = nlohmann::json::array();
      for (const Impact& impact : result.impacts) {
        answer["impacts"].push_back(
            {impact.time, impact.on_upper ? "upper" : "lower", impact.speed});
      }
      answer["seconds"] = seconds;
      answer["deepest"] = result.deepest;
      answer["end"] = result.end;
    } catch (const Cannot& reason) {
      answer["cannot"] = reason.what();
    } catch (const std::exception& error) {
      answer["error"] = error.what();
    }
    std::fprintf(answers, "%s\n", answer.dump().c_str());
    std::fflush(answers);
  }
  return 0;
}

}  // namespace impact_test
