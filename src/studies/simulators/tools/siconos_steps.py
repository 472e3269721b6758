"""Siconos, Moreau-Jean time stepping."""

import siconos.kernel as sk
import tool
from tool_siconos import UNITS, Body, model


def simulate(in_metres, call):
    scene = in_metres.in_units(*UNITS)
    body = Body(scene)
    step = call.pick(1 / 240, 1e-3, 1e-4) * UNITS[1]
    simulation = sk.TimeStepping(model(scene, body), sk.TimeDiscretisation(0, step))
    simulation.insertIntegrator(sk.MoreauJeanOSI(0.5))
    simulation.insertNonSmoothProblem(sk.FrictionContact(2) if scene.friction > 0 else sk.LCP())
    result = tool.Result()
    while simulation.hasNextEvent():
        time, speed = simulation.startingTime(), body.velocity()[0]
        wall = "upper" if speed > 0 else "lower"
        simulation.computeOneStep()
        contact = body.contacts.get(wall)
        if contact and contact.lambda_(1)[0] > 0 and abs(speed) > scene.slowest / 4:
            result.impacts.append([time, wall, abs(speed)])
        simulation.nextStep()
        depths = [-contact.y(0)[0] for contact in body.contacts.values()]
        result.deepest = max([result.deepest] + depths)
    result.end = [body.q()[0], body.velocity()[0]]
    return result.from_units(*UNITS)


tool.run(simulate)
