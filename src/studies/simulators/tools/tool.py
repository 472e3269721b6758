"""What the drivers in Python share: the loop over scenes, and the motion between
events.

A driver ends with `tool.run(simulate)`; simulate(scene, call) returns a Result.
"""

import bisect
import copy
import json
import math
import os
import sys
import time

LEVELS = ("loose", "usual", "tight")


class Cannot(Exception):
    """The tool cannot express a scene; the text says why."""


class Result:
    def __init__(self):
        self.impacts = []  # [time s, "lower" or "upper", speed of approach m/s]
        self.deepest = 0.0  # m, deepest penetration of a wall
        self.end = [0.0, 0.0]  # m, m/s

    def from_units(self, metre, second):
        """The result of a scene that was simulated in_units() of these."""
        self.impacts = [[t / second, wall, v / metre * second] for t, wall, v in self.impacts]
        self.deepest /= metre
        self.end = [self.end[0] / metre, self.end[1] / metre * second]
        return self


class Call:
    """How the driver was called: METHOD LEVEL, or LEVEL."""

    def __init__(self, words):
        self.method = words[0] if len(words) > 1 else ""
        self.level = LEVELS.index(words[-1])

    def pick(self, loose, usual, tight):
        return (loose, usual, tight)[self.level]


class Scene:
    """mass x'' = force - friction sign(x') between the walls; x' -> -restitution x' at a wall."""

    def __init__(self, text):
        self.__dict__.update({key: text[key] for key in text if key not in ("force", "scales")})
        self.upper = math.inf if text["upper"] is None else text["upper"]
        # m, m/s, N, and s: a step that samples the fastest force twenty times a period
        self.length, self.speed = text["scales"]["length"], text["scales"]["speed"]
        self.largest_force, self.longest_step = text["scales"]["force"], text["scales"]["step"]
        self.starts = [part["from"] for part in text["force"]]
        self.segments = [
            [term["amplitude"] + term["phase"] for term in part["terms"]] for part in text["force"]
        ]

    def in_units(self, metre, second):
        """The scene with so many units of length in a metre and of time in a second, and with the
        body's mass as the unit of mass."""
        scene, force = copy.copy(self), metre / second**2 / self.mass
        units = {"position lower upper length": metre, "velocity slowest speed": metre / second,
                 "duration longest_step": second, "friction largest_force": force}
        for keys, unit in units.items():
            for key in keys.split():
                setattr(scene, key, getattr(self, key) * unit)
        scene.mass = 1.0
        scene.starts = [start * second for start in self.starts]
        scale = [force / second**k for k in range(3)] + [1 / second**k for k in range(3)]
        scene.segments = [
            [[x * y for x, y in zip(term, scale)] for term in terms] for terms in self.segments
        ]
        return scene

    def end_of(self, segment):
        return min(self.starts[segment + 1 : segment + 2] + [self.duration])

    def force(self, t, segment=None):
        """[N]; of a given segment, or of the one at time t [s]."""
        if segment is None:
            segment = max(0, bisect.bisect_right(self.starts, t) - 1)
        u = t - self.starts[segment]
        return sum(
            (a + u * (b + u * c)) * math.cos(p + u * (q + u * r))
            for a, b, c, p, q, r in self.segments[segment]
        )


class Motion:
    """Between events the body flies, with friction against its direction, or it rests.

    A driver integrates rates() from time and state, at most until end(), while all of values() stay
    positive: one that falls through zero is an event. It then calls proceed() with the state there.
    """

    SHORTEST_SPAN = 1e-12  # s, that tools integrate
    AT_ONCE = 1e-10  # s
    MOST_AT_ONCE = 100

    def __init__(self, scene, tolerance):
        """A body that leaves a wall while a force holds it there rests, if the height of its flight
        is lost in the tool's tolerance, relative to the clearance, and if its impacts are not
        scored; or if the height is lost in rounding."""
        self.scene, self.result = scene, Result()
        self.time, self.state = 0.0, [scene.position, scene.velocity]
        farthest = max(abs(scene.lower), abs(scene.lower + scene.length))
        rounding = 1e3 * sys.float_info.epsilon * farthest
        self.rest_speed = max(
            min(math.sqrt(tolerance) * scene.speed, scene.slowest / 4),
            math.sqrt(2 * rounding * scene.largest_force / scene.mass),
        )
        self.segment, self.at_once = 0, 0
        self._settle(False)

    def over(self):
        return self.time >= self.scene.duration

    def end(self):
        return self.scene.end_of(self.segment)

    def rates(self, t, y):
        if not self.moves:
            return [0.0, 0.0]
        force = self.scene.force(t, self.segment)
        return [y[1], (force - self.direction * self.scene.friction) / self.scene.mass]

    def values(self, t, y):
        """In flight: distances from the walls, and the speed if there is friction. At rest: what is
        missing to a force that moves the body. 1 for what does not exist."""
        scene = self.scene
        if not self.moves:
            return [self._hold(t), 1.0, 1.0]
        above = scene.upper - y[0] if scene.upper < math.inf else 1.0
        return [y[0] - scene.lower, above, self.direction * y[1] if scene.friction > 0 else 1.0]

    def proceed(self, t, y, which):
        """To the event `which` at time t and state y; -1: to end(), without an event."""
        t = self.end() if which < 0 or self.end() - t < self.SHORTEST_SPAN else t
        self.at_once = self.at_once + 1 if t - self.time < self.AT_ONCE else 0
        if self.at_once > self.MOST_AT_ONCE:
            raise RuntimeError("the tool finds one event for ever")
        self.time, self.state = t, [float(y[0]), float(y[1])]
        if t == self.end() and not self.over():
            self.segment += 1
        released = not self.moves and which >= 0
        if self.moves and which >= 0:
            self._arrive(which)
        if not self.moves or which >= 0:
            self._settle(released)
        self.result.end = self.state

    def longest_step(self):
        """At rest that of the scene; in flight no longer than the clearance takes at full speed
        [s]."""
        longest = self.scene.longest_step
        return min(longest, self.scene.length / self.scene.speed) if self.moves else longest

    def first_step(self):
        """Ends before the body can be back at the wall [s]: functions that start at zero are then
        positive at its end. After an event at the start it is shorter each time."""
        force = abs(self.scene.force(self.time, self.segment)) + self.scene.friction
        flight = abs(self.state[1]) * self.scene.mass / (force + 1e-300)
        step = min(flight / 5 if flight > 0 else math.inf, self.longest_step() / 10)
        return step * 0.1 ** min(self.at_once, 8)

    def _hold(self, t):
        """At rest: how much force is missing to one that moves the body [N]."""
        force = self.scene.force(t, self.segment)
        if self.state[0] <= self.scene.lower:
            return self.scene.friction - force
        if self.state[0] >= self.scene.upper:
            return self.scene.friction + force
        return self.scene.friction - abs(force)

    def _arrive(self, which):
        if which == 2:
            self.state[1] = 0.0
            return
        wall = ("lower", "upper")[which]
        speed = self.state[1] if wall == "upper" else -self.state[1]
        self.state[0] = getattr(self.scene, wall)
        if speed > 0:
            self.result.impacts.append([self.time, wall, speed])
            self.state[1] *= -getattr(self.scene, "restitution_" + wall)
        # Where a tool sees a body cross a wall on its way back, it cannot resolve a speed as slow.
        is_slow = speed <= 0 or abs(self.state[1]) < self.rest_speed
        if is_slow and self._hold(self.time) >= 0:
            self.state[1] = 0.0

    def _settle(self, released):
        """Whether the body moves now, and in which direction. It does where a root of _hold() is
        found."""
        self.moves = released or self.state[1] != 0 or self._hold(self.time) < 0
        if self.moves:
            heading = self.state[1] or self.scene.force(self.time, self.segment)
            self.direction = 1 if heading > 0 else -1


def run(simulate):
    """Answers all scenes of the standard input by simulate(scene, call)."""
    if len(sys.argv) < 2 or sys.argv[-1] not in LEVELS:
        sys.exit(f"usage: {sys.argv[0]} [METHOD] loose|usual|tight")
    call = Call(sys.argv[1:])
    answers = os.fdopen(os.dup(1), "w")
    os.dup2(2, 1)  # what a library prints is no answer
    for line in sys.stdin:
        text = json.loads(line)
        answer = {"scene": text["scene"]}
        try:
            scene = Scene(text)
            start = time.process_time()
            result = simulate(scene, call)
            answer["seconds"] = time.process_time() - start
            answer["impacts"] = result.impacts
            answer["deepest"] = result.deepest
            answer["end"] = result.end
        except Cannot as reason:
            answer["cannot"] = str(reason)
        except Exception as error:  # whatever a tool throws is its answer
            answer["error"] = f"{type(error).__name__}: {error}"
        print(json.dumps(answer), file=answers, flush=True)
