// MuJoCo: a sphere on a slide joint, which has dry friction, between two planes. Its contacts are
// springs and dampers: by solref, one takes twelve steps and returns the restitution.
#include <mujoco/mujoco.h>

#include <sstream>

#include "engine.h"

struct World {
  World(const Scene& scene, double step_length, double /*threshold*/) {
    std::ostringstream xml;
    xml.precision(17);
    xml << "<mujoco><option timestep='" << step_length << "' gravity='0 0 0'/><worldbody>";
    const double frequency = 0.25 / step_length;
    const auto add_wall = [&](double position, int normal, double restitution) {
      const double loss = -std::log(std::max(restitution, 1e-9));
      const double damping = loss / std::hypot(loss, M_PI);  // ratio
      xml << "<geom type='plane' size='9 9 9' condim='1' solimp='.9999 .9999 1' pos='" << position
          << " 0 0' zaxis='" << normal << " 0 0' solref='" << -frequency * frequency << ' '
          << -2 * damping * frequency << "'/>";
    };
    add_wall(-1, +1, scene.restitution_lower);
    add_wall(scene.upper + 1, -1, scene.restitution_upper);
    xml << "<body><joint type='slide' axis='1 0 0' frictionloss='" << scene.friction
        << "'/><geom type='sphere' size='1' mass='1' condim='1'/></body></worldbody></mujoco>";
    const std::string text = xml.str();
    static mjVFS files;
    mj_defaultVFS(&files);
    mj_makeEmptyFileVFS(&files, "scene.xml", static_cast<int>(text.size()));
    text.copy(static_cast<char*>(files.filedata[0]), text.size());
    model.reset(mj_loadXML("scene.xml", &files, nullptr, 0));
    if (!model) throw std::runtime_error("MuJoCo refuses the model");
    data.reset(mj_makeData(model.get()));
    data->qpos[0] = scene.position;
    data->qvel[0] = scene.velocity;
  }
  void step(double force) {
    data->qfrc_applied[0] = force;
    mj_step(model.get(), data.get());
  }
  double position() const { return data->qpos[0]; }
  double velocity() const { return data->qvel[0]; }

  std::unique_ptr<mjModel, void (*)(mjModel*)> model{nullptr, mj_deleteModel};
  std::unique_ptr<mjData, void (*)(mjData*)> data{nullptr, mj_deleteData};
};

int main(int argc, char** argv) {
  return run_engine<World>(argc, argv, {1, 4});
}
