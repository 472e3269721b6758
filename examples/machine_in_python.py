#!/usr/bin/env python3
"""A machine from Python: its collisions over the speed, its motion, and its fastest quiet speed."""
import sys

import numpy
import ricochet

scene = ricochet.Scene.load(sys.argv[1] if len(sys.argv) > 1 else "machine.toml")
speeds = numpy.linspace(1, 18, 1000)  # rad/s
counts = scene.counts(speeds)
print(f"most collisions: {counts.max()} at {speeds[counts.argmax()]:.2f} rad/s")
found = scene.simulate(7.0, samples=500)
print(f"{found.count} collisions at 7 rad/s, fastest impact {found.impacts.speeds.max():.4f} m/s")
print(f"{len(scene.regimes())} regimes, quiet up to {scene.threshold().quiet:.3f} rad/s")
