// Box2D, in single precision: a disc on a prismatic joint between two boxes. Restitution is the
// wall's, as Box2D takes the larger of two; friction is the joint's motor, which holds the body at
// rest with at most that force.
#include <box2d/box2d.h>

#include "engine.h"

struct World {
  World(const impact_test::Scene& scene, double step_length, double threshold_speed)
      : length(step_length), threshold(threshold_speed) {
    b2BodyDef definition;
    b2Body* walls = world.CreateBody(&definition);
    add_wall(walls, -away, scene.restitution_lower);
    add_wall(walls, std::min(scene.upper, 1e6) + away, scene.restitution_upper);
    definition.type = b2_dynamicBody;
    definition.position.x = scene.position;
    definition.linearVelocity.x = scene.velocity;
    definition.fixedRotation = true;
    definition.allowSleep = false;
    body = world.CreateBody(&definition);
    b2CircleShape disc;
    disc.m_radius = radius;
    add(body, disc, 0);
    const b2MassData mass = {1, {0, 0}, 1};
    body->SetMassData(&mass);
    b2PrismaticJointDef joint;
    joint.Initialize(walls, body, body->GetPosition(), {1, 0});
    joint.collideConnected = joint.enableMotor = true;
    joint.maxMotorForce = scene.friction;
    world.CreateJoint(&joint);
  }
  void step(double force) {
    body->ApplyForceToCenter({static_cast<float>(force), 0}, true);
    world.Step(length, 8, 3);
  }
  void add(b2Body* to, const b2Shape& shape, double restitution) {
    b2FixtureDef fixture;
    fixture.shape = &shape;
    fixture.restitution = restitution;
    fixture.restitutionThreshold = threshold;
    to->CreateFixture(&fixture);
  }
  void add_wall(b2Body* walls, double middle, double restitution) {
    b2PolygonShape box;
    box.SetAsBox(thick, thick, {static_cast<float>(middle), 0}, 0);
    add(walls, box, restitution);
  }
  double position() const { return body->GetPosition().x; }
  double velocity() const { return body->GetLinearVelocity().x; }

  // The surfaces of boxes have a skin that keeps discs away.
  static constexpr float radius = 1, thick = 10, away = radius + thick + b2_polygonRadius;
  float length, threshold;
  b2World world{{0, 0}};
  b2Body* body;
};

int main(int argc, char** argv) {
  return impact_test::run_engine<World>(argc, argv, {4, 6});
}
