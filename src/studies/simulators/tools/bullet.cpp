// Bullet: a sphere between two planes, free along one axis. Friction is a slider's motor.
#include <btBulletDynamicsCommon.h>

#include "engine.h"

struct World {
  World(const Scene& scene, double step_length, double threshold)
      : length(step_length), upper_plane({-1, 0, 0}, -radius - scene.upper) {
    world.setGravity({0, 0, 0});
    world.getSolverInfo().m_restitutionVelocityThreshold = threshold;
    world.getSolverInfo().m_splitImpulsePenetrationThreshold = 0;  // no speed from a penetration
    body.translate({scene.position, 0, 0});
    body.setLinearVelocity({scene.velocity, 0, 0});
    body.setLinearFactor({1, 0, 0});
    body.setAngularFactor(0);
    body.setRestitution(1);
    body.setContactProcessingThreshold(0);  // no contact before they touch
    body.setActivationState(DISABLE_DEACTIVATION);
    lower.setRestitution(scene.restitution_lower);
    upper.setRestitution(scene.restitution_upper);
    for (btRigidBody* each : {&body, &lower, &upper}) world.addRigidBody(each);
    slider.setPoweredLinMotor(true);
    slider.setMaxLinMotorForce(scene.friction);
    if (scene.friction > 0) world.addConstraint(&slider);
  }
  void step(double force) {
    body.applyCentralForce({force, 0, 0});
    world.stepSimulation(length, 0);
  }
  double position() const { return body.getWorldTransform().getOrigin().x(); }
  double velocity() const { return body.getLinearVelocity().x(); }

  static constexpr double radius = 1;
  double length;
  btSphereShape sphere{radius};
  btStaticPlaneShape lower_plane{{1, 0, 0}, -radius}, upper_plane;
  btRigidBody body{1, nullptr, &sphere}, lower{0, nullptr, &lower_plane};
  btRigidBody upper{0, nullptr, &upper_plane};
  btSliderConstraint slider{body, btTransform::getIdentity(), true};
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world{&dispatcher, &broadphase, &solver, &configuration};
};

int main(int argc, char** argv) {
  return run_engine<World>(argc, argv, {10, 1.2});
}
