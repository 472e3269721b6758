// Box2D, in single precision: a disc on a prismatic joint, whose motor is friction, between boxes.
#include <box2d/box2d.h>

#include "engine.h"

struct World {
  static constexpr float thick = 10, away = 1 + thick + b2_polygonRadius;  // boxes have a skin
  float length;
  b2World world{{0, 0}};
  b2Body* body;

  World(const Scene& scene, float step_length, float threshold) : length(step_length) {
    b2BodyDef definition;
    b2Body* walls = world.CreateBody(&definition);
    definition.type = b2_dynamicBody;
    definition.position.x = scene.position;
    definition.linearVelocity.x = scene.velocity;
    body = world.CreateBody(&definition);
    b2FixtureDef fixture;
    fixture.restitutionThreshold = threshold;
    fixture.density = 1 / b2_pi;
    b2CircleShape disc;
    disc.m_radius = 1;
    fixture.shape = &disc;
    body->CreateFixture(&fixture);
    b2PolygonShape box;
    fixture.shape = &box;
    box.SetAsBox(thick, thick, {-away, 0}, 0);
    fixture.restitution = scene.restitution_lower;
    walls->CreateFixture(&fixture);
    box.SetAsBox(thick, thick, {static_cast<float>(scene.upper) + away, 0}, 0);
    fixture.restitution = scene.restitution_upper;
    walls->CreateFixture(&fixture);
    b2PrismaticJointDef joint;
    joint.Initialize(walls, body, body->GetPosition(), {1, 0});
    joint.collideConnected = joint.enableMotor = true;
    joint.maxMotorForce = scene.friction;
    world.CreateJoint(&joint);
  }
  void step(float force) {
    body->ApplyForceToCenter({force, 0}, true);
    world.Step(length, 8, 3);
  }
  double position() const { return body->GetPosition().x; }
  double velocity() const { return body->GetLinearVelocity().x; }
};

int main(int argc, char** argv) {
  return run_engine<World>(argc, argv, {4, 6});
}
