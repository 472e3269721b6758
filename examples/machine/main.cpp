#include <ricochet/error.h>
#include <ricochet/machine.h>

#include <cstdio>

using namespace ricochet::carrier_track;

/// Prints the impacts of a machine at its own speed, and its fastest quiet speed.
int main(int argc, char** argv) {
  try {
    Scene scene = read_scene(argc > 1 ? argv[1] : "machine.toml");
    const Recording recording = simulate(scene);
    std::printf("%d collisions at %g rad/s%s\n", recording.count, scene.omega,
                recording.certainty.certain ? "" : " (not certain)");
    for (const Impact& impact : recording.impacts) {
      std::printf("  %.4f s: %.4f m/s\n", impact.time, impact.speed);
    }
    const QuietSpeed answer = quiet_speed(scene);
    if (!answer.fastest_quiet) return 1;
    std::printf("fastest_quiet %.3f\n", *answer.fastest_quiet);
  } catch (const ricochet::InputError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
  return 0;
}
