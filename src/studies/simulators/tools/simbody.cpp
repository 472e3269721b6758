// Simbody: a body that translates between two hard stops, with the time stepper for unilateral
// contacts. Friction is that of a floor, with coefficient 1, on which the body is pressed.
#include <Simbody.h>

#include "engine.h"

struct World {
  World(const Scene& scene, double step_length, double threshold)
      : length(step_length), pressing(-scene.friction) {
    const SimTK::MobilizerQIndex x(0);
    matter.adoptUnilateralContact(new SimTK::HardStopLower(body, x, 0, scene.restitution_lower));
    matter.adoptUnilateralContact(
        new SimTK::HardStopUpper(body, x, scene.upper, scene.restitution_upper));
    if (scene.friction > 0) {
      matter.adoptUnilateralContact(new SimTK::PointPlaneContact(
          matter.updGround(), SimTK::YAxis, 0, body, SimTK::Vec3(0), 0, 1, 1, 0));
    }
    SimTK::State state = system.realizeTopology();
    body.setOneQ(state, 0, scene.position);
    body.setOneU(state, 0, scene.velocity);
    // The other solver, PLUS, sticks here where the force exceeds friction.
    stepper.setImpulseSolverType(SimTK::SemiExplicitEulerTimeStepper::PGS);
    stepper.setDefaultImpactCaptureVelocity(threshold);
    stepper.setDefaultImpactMinCORVelocity(threshold);
    stepper.initialize(state);
    static std::FILE* const quiet = std::freopen("/dev/null", "w", stdout);  // it tells all
    std::cout.setstate(quiet == nullptr ? std::ios::goodbit : std::ios::failbit);
  }
  void step(double force) {
    forces.setAllMobilityForces(stepper.updState(), SimTK::Vector(SimTK::Vec3(force, pressing, 0)));
    stepper.stepTo(stepper.getTime() + length);
  }
  double position() const { return body.getOneQ(stepper.getState(), 0); }
  double velocity() const { return body.getOneU(stepper.getState(), 0); }

  double length, pressing;
  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter{system};
  SimTK::GeneralForceSubsystem subsystem{system};
  SimTK::Force::DiscreteForces forces{subsystem, matter};
  SimTK::Body::Rigid unit_mass{SimTK::MassProperties(1, SimTK::Vec3(0), SimTK::Inertia(1))};
  SimTK::MobilizedBody::Translation body{matter.updGround(), unit_mass};
  SimTK::SemiExplicitEulerTimeStepper stepper{system};
};

int main(int argc, char** argv) {
  return run_engine<World>(argc, argv, {1, 1.2});
}
