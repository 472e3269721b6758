// Open Dynamics Engine: a sphere on a slider, whose motor is friction, between two planes.
#include <ode/ode.h>

#include "engine.h"

struct World {
  World(const Scene& of, double step, double slow) : scene(of), length(step), threshold(slow) {
    dWorldSetContactMaxCorrectingVel(world, threshold);  // what is deep in a wall is not thrown out
    dGeomSetBody(sphere, body);
    dBodySetPosition(body, scene.position, 0, 0);
    dBodySetLinearVel(body, scene.velocity, 0, 0);
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
    collide(upper, scene.restitution_upper);
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

  const Scene& scene;
  double length, threshold;
  dWorldID world = (dInitODE2(0), dWorldCreate());
  dSpaceID space = dSimpleSpaceCreate(nullptr);
  dJointGroupID contacts = dJointGroupCreate(0);
  dBodyID body = dBodyCreate(world);  // of mass 1
  dGeomID sphere = dCreateSphere(space, 1), lower = dCreatePlane(space, 1, 0, 0, -1);
  dGeomID upper = dCreatePlane(space, -1, 0, 0, -1 - scene.upper);
};

int main(int argc, char** argv) {
  return run_engine<World>(argc, argv, {1, 1.2});
}
