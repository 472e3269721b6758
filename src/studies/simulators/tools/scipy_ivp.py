"""SciPy's solve_ivp with events that end the integration. As its manual advises: a direction for
each event, and max_step, because events are looked for between steps."""

import numpy as np
import tool
from scipy.integrate import solve_ivp


def event(motion, which):
    def value(t, y):
        return motion.values(t, y)[which]

    value.terminal, value.direction = True, -1
    return value


def simulate(scene, call):
    tolerance = call.pick(1e-4, 1e-6, 1e-10)
    motion = tool.Motion(scene, tolerance)
    absolute = [tolerance * scene.length, tolerance * scene.speed]
    while not motion.over():
        solution = solve_ivp(
            motion.rates,
            (motion.time, motion.end()),
            motion.state,
            method=call.method,
            events=[event(motion, which) for which in range(3)],
            rtol=tolerance,
            atol=absolute,
            first_step=min(motion.first_step(), motion.end() - motion.time),
            max_step=motion.longest_step(),
        )
        if solution.status < 0:
            raise RuntimeError(solution.message)
        hit = [which for which in range(3) if len(solution.t_events[which])]
        motion.proceed(solution.t[-1], solution.y[:, -1], hit[0] if hit else -1)
    return motion.result


np.seterr(all="ignore")
tool.run(simulate)
