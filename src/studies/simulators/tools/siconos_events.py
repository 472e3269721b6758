"""Siconos, event-driven, with LsodarOSI: without friction."""

import siconos.kernel as sk
import tool
from tool_siconos import UNITS, Body, model


def simulate(in_metres, call):
    scene = in_metres.in_units(*UNITS)
    if scene.friction > 0:
        raise tool.Cannot("no friction in event-driven simulations")
    body = Body(scene)
    simulation = sk.EventDriven(model(scene, body), sk.TimeDiscretisation(0, scene.longest_step))
    integrator = sk.LsodarOSI()
    simulation.insertIntegrator(integrator)
    simulation.insertNonSmoothProblem(sk.LCP(), sk.SICONOS_OSNSP_ED_IMPACT)
    simulation.insertNonSmoothProblem(sk.LCP(), sk.SICONOS_OSNSP_ED_SMOOTH_ACC)
    tolerance = call.pick(1e-6, 1e-8, 1e-10)
    integrator.setTol(1, tolerance, tolerance * scene.length)
    simulation.setToleranceED(call.pick(1e-5, 1e-6, 1e-7))
    simulation.initialize()
    integrator.setMaxNstep(1000000)
    result = tool.Result()
    while simulation.hasNextEvent():
        simulation.advanceToEvent()
        before = body.velocity()[0]
        simulation.processEvents()
        if before * (body.velocity()[0] - before) < 0:
            wall = "upper" if before > 0 else "lower"
            result.impacts.append([simulation.startingTime(), wall, abs(before)])
    result.end = [body.q()[0], body.velocity()[0]]
    return result.from_units(*UNITS)


tool.run(simulate)
