// DART: a box on a prismatic joint between two boxes. Restitution is the wall's, as DART multiplies
// those of both bodies; friction is the joint's own Coulomb friction.
#include <dart/dart.hpp>

#include "engine.h"

struct World {
  World(const impact_test::Scene& scene, double step_length, double /*threshold*/) {
    world->setTimeStep(step_length);
    world->setGravity(Eigen::Vector3d::Zero());
    world->getConstraintSolver()->setCollisionDetector(
        dart::collision::DARTCollisionDetector::create());
    const auto skeleton = dart::dynamics::Skeleton::create("body");
    const auto [slider, body] =
        skeleton->createJointAndBodyNodePair<dart::dynamics::PrismaticJoint>();
    joint = slider;
    joint->setAxis(Eigen::Vector3d::UnitX());
    joint->setPosition(0, scene.position);
    joint->setVelocity(0, scene.velocity);
    joint->setCoulombFriction(0, scene.friction);
    body->setMass(1);
    add_box(body, 1);
    world->addSkeleton(skeleton);
    add_wall("lower", -size, scene.restitution_lower);
    if (scene.upper < impact_test::infinity) {
      add_wall("upper", scene.upper + size, scene.restitution_upper);
    }
  }
  void step(double force) {
    joint->setForce(0, force);
    world->step();
  }
  void add_box(dart::dynamics::BodyNode* body, double restitution) {
    const auto shape = std::make_shared<dart::dynamics::BoxShape>(Eigen::Vector3d::Constant(size));
    body->createShapeNodeWith<dart::dynamics::CollisionAspect, dart::dynamics::DynamicsAspect>(
            shape)
        ->getDynamicsAspect()
        ->setRestitutionCoeff(restitution);
  }
  void add_wall(const char* name, double middle, double restitution) {
    const auto wall = dart::dynamics::Skeleton::create(name);
    const auto [weld, body] = wall->createJointAndBodyNodePair<dart::dynamics::WeldJoint>();
    weld->setTransformFromParentBodyNode(Eigen::Isometry3d(Eigen::Translation3d(middle, 0, 0)));
    add_box(body, restitution);
    world->addSkeleton(wall);
  }
  double position() const { return joint->getPosition(0); }
  double velocity() const { return joint->getVelocity(0); }

  static constexpr double size = 10;
  dart::simulation::WorldPtr world = dart::simulation::World::create();
  dart::dynamics::PrismaticJoint* joint;
};

int main(int argc, char** argv) {
  return impact_test::run_engine<World>(argc, argv, {1, 3, 0.1});
}
