"""A scene as Siconos has it. Restitution is the impact law's, for each wall. Friction is that of a
floor, with coefficient 1, on which the body is pressed with that force."""

import numpy as np
import siconos.kernel as sk

# Siconos has one tolerance for distances, speeds and accelerations, which it compares at slightly
# different times. 1e-7 of these units are 1e-10 m, 1e-6 m/s and 1e-2 m/s^2.
UNITS = 1e3, 1e4  # in a metre, in a second


class Body(sk.LagrangianLinearTIDS):
    """Along the track, and, if there is friction, off the floor."""

    def __init__(self, scene):
        more = [0.0] if scene.friction > 0 else []
        mass = np.eye(1 + len(more))
        super().__init__([scene.position] + more, [scene.velocity] + more, mass)
        self.scene, self.contacts = scene, {}
        self.allocateFExt()

    def computeFExt(self, time, *_):
        self.fExt()[0] = self.scene.force(time)
        self.fExt()[1:] = -self.scene.friction


def model(scene, body):
    system = sk.NonSmoothDynamicalSystem(0, scene.duration)
    system.insertDynamicalSystem(body)
    surfaces = [("lower", [1.0, 0.0], -scene.lower, scene.restitution_lower, 0)]
    if scene.upper < np.inf:
        surfaces.append(("upper", [-1.0, 0.0], scene.upper, scene.restitution_upper, 0))
    if scene.friction > 0:
        surfaces.append(("floor", [0.0, 1.0], 0.0, 0, 1))
    for name, normal, offset, restitution, friction in surfaces:
        if scene.friction > 0:
            law = sk.NewtonImpactFrictionNSL(restitution, 0.0, friction, 2)
            relation = sk.LagrangianLinearTIR(np.array([normal, normal[::-1]]), [offset, 0.0])
        else:
            law = sk.NewtonImpactNSL(restitution)
            relation = sk.LagrangianLinearTIR(np.array([normal[:1]]), [offset])
        body.contacts[name] = sk.Interaction(law, relation)
        system.link(body.contacts[name], body)
    return system
