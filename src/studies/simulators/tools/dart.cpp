// DART: a box on a prismatic joint, which has Coulomb friction, between two boxes.
#include <dart/dart.hpp>

#include "engine.h"

using namespace dart;

struct World {
  World(const Scene& scene, double step_length, double /*threshold*/) {
    world->setTimeStep(step_length);
    world->getConstraintSolver()->setCollisionDetector(collision::DARTCollisionDetector::create());
    const auto skeleton = dynamics::Skeleton::create("body");
    dynamics::BodyNode* body;
    std::tie(joint, body) = skeleton->createJointAndBodyNodePair<dynamics::PrismaticJoint>();
    joint->setAxis(Eigen::Vector3d::UnitX());
    joint->setPosition(0, scene.position);
    joint->setVelocity(0, scene.velocity);
    joint->setCoulombFriction(0, scene.friction);
    add_box(body, 1);
    world->addSkeleton(skeleton);
    add_wall("lower", -size, scene.restitution_lower);
    add_wall("upper", scene.upper + size, scene.restitution_upper);
  }
  void step(double force) {
    joint->setForce(0, force);
    world->step();
  }
  void add_box(dynamics::BodyNode* body, double restitution) {
    const auto box = std::make_shared<dynamics::BoxShape>(Eigen::Vector3d::Constant(size));
    body->createShapeNodeWith<dynamics::CollisionAspect, dynamics::DynamicsAspect>(box);
    body->getShapeNode(0)->getDynamicsAspect()->setRestitutionCoeff(restitution);
  }
  void add_wall(const char* name, double middle, double restitution) {
    const auto wall = dynamics::Skeleton::create(name);
    const auto [weld, body] = wall->createJointAndBodyNodePair<dynamics::WeldJoint>();
    weld->setTransformFromParentBodyNode(Eigen::Isometry3d(Eigen::Translation3d(middle, 0, 0)));
    add_box(body, restitution);
    world->addSkeleton(wall);
  }
  double position() const { return joint->getPosition(0); }
  double velocity() const { return joint->getVelocity(0); }

  static constexpr double size = 10;
  simulation::WorldPtr world = simulation::World::create();
  dynamics::PrismaticJoint* joint;
};

int main(int argc, char** argv) {
  return run_engine<World>(argc, argv, {1, 3, 0.1});
}
