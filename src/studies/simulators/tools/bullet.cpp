// Bullet: a sphere between two planes, free along one axis. Restitution is the wall's, as Bullet
// multiplies those of both bodies; friction is the motor of a slider that holds the body at rest
// with at most that force.
#include <btBulletDynamicsCommon.h>

#include "engine.h"

struct World {
  World(const impact_test::Scene& scene, double step_length, double threshold)
      : length(step_length), upper_plane(btVector3(-1, 0, 0), -radius - scene.upper) {
    world.setGravity(btVector3(0, 0, 0));
    world.getSolverInfo().m_restitutionVelocityThreshold = threshold;
    world.getSolverInfo().m_splitImpulsePenetrationThreshold = 0;  // no speed from a penetration
    body.translate(btVector3(scene.position, 0, 0));
    body.setLinearVelocity(btVector3(scene.velocity, 0, 0));
    body.setLinearFactor(btVector3(1, 0, 0));
    body.setAngularFactor(0);
    body.setRestitution(1);
    body.setContactProcessingThreshold(0);  // no contact before they touch
    body.setActivationState(DISABLE_DEACTIVATION);
    lower.setRestitution(scene.restitution_lower);
    upper.setRestitution(scene.restitution_upper);
    world.addRigidBody(&body);
    world.addRigidBody(&lower);
    if (scene.upper < impact_test::infinity) world.addRigidBody(&upper);
    slider.setLowerLinLimit(1);  // above the upper one: without limits
    slider.setUpperLinLimit(-1);
    slider.setPoweredLinMotor(true);
    slider.setMaxLinMotorForce(scene.friction);
    if (scene.friction > 0) world.addConstraint(&slider);
  }
  void step(double force) {
    body.applyCentralForce(btVector3(force, 0, 0));
    world.stepSimulation(length, 0);
  }
  double position() const { return body.getWorldTransform().getOrigin().x(); }
  double velocity() const { return body.getLinearVelocity().x(); }

  static constexpr double radius = 1;
  double length;
  btSphereShape sphere{radius};
  btStaticPlaneShape lower_plane{btVector3(1, 0, 0), -radius}, upper_plane;
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
  return impact_test::run_engine<World>(argc, argv, {10, 1.2});
}
