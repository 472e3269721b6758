// Open Dynamics Engine: a sphere on a slider between two planes. Restitution is a contact's bounce;
// friction is the slider's motor, which holds the body at rest with at most that force.
#include <ode/ode.h>

#include "engine.h"

struct World {
  World(const impact_test::Scene& scene_of, double step_length, double threshold_speed)
      : scene(scene_of), length(step_length), threshold(threshold_speed) {
    dWorldSetContactMaxCorrectingVel(world, threshold);  // what is deep in a wall is not thrown out
    dMass mass;
    dMassSetSphereTotal(&mass, 1, radius);
    dBodySetMass(body, &mass);
    dBodySetPosition(body, scene.position, 0, 0);
    dBodySetLinearVel(body, scene.velocity, 0, 0);
    dGeomSetBody(sphere, body);
    const dJointID slider = dJointCreateSlider(world, nullptr);
    dJointAttach(slider, body, nullptr);
    dJointSetSliderAxis(slider, 1, 0, 0);
    dJointSetSliderParam(slider, dParamFMax, scene.friction);  // towards a speed of zero
  }
  ~World() {
    dJointGroupDestroy(contacts);
    dSpaceDestroy(space);
    dWorldDestroy(world);
  }
  void step(double force) {
    collide(lower, scene.restitution_lower);
    if (scene.upper < impact_test::infinity) collide(upper, scene.restitution_upper);
    dBodyAddForce(body, force, 0, 0);
    dWorldStep(world, length);
    dJointGroupEmpty(contacts);
  }
  void collide(dGeomID wall, double restitution) {
    dContact contact = {};
    if (dCollide(sphere, wall, 1, &contact.geom, sizeof contact) == 0) return;
    contact.surface = {dContactBounce, 0, 0, 0, 0, 0, restitution, threshold};
    dJointAttach(dJointCreateContact(world, contacts, &contact), body, nullptr);
  }
  double position() const { return dBodyGetPosition(body)[0]; }
  double velocity() const { return dBodyGetLinearVel(body)[0]; }

  static constexpr double radius = 1;
  const impact_test::Scene& scene;
  double length, threshold;
  int started = dInitODE2(0);
  dWorldID world = dWorldCreate();
  dSpaceID space = dSimpleSpaceCreate(nullptr);
  dJointGroupID contacts = dJointGroupCreate(0);
  dBodyID body = dBodyCreate(world);
  dGeomID sphere = dCreateSphere(space, radius), lower = dCreatePlane(space, 1, 0, 0, -radius);
  dGeomID upper = dCreatePlane(space, -1, 0, 0, -radius - std::min(scene.upper, 1e9));
};

int main(int argc, char** argv) {
  return impact_test::run_engine<World>(argc, argv, {1, 1.2});
}
