#!/usr/bin/env python3
"""Steps from the best point so far, shorter and shorter. Needs nothing but Python."""
import json
import random
import sys


def say(message):
    print(json.dumps(message), flush=True)


def ask(x):
    say({"ask": x})
    return json.loads(sys.stdin.readline())


say({"name": "hill-climber", "version": "1.0", "stochastic": True})
for line in sys.stdin:
    problem = json.loads(line)
    draw = random.Random(problem["seed"])
    box = list(zip(problem["lower"], problem["upper"]))
    best, best_value, step = problem["start"], None, 1.0
    x, answer = best, ask(best)
    while "stop" not in answer and step > 1e-6:
        value = answer["objective"]  # None where it is not finite
        if value is not None and (best_value is None or value <= best_value):
            best, best_value = x, value
        x = [b + step * (high - low) * draw.uniform(-1, 1) for b, (low, high) in zip(best, box)]
        answer = ask(x)
        step *= 0.98
    say({"done": "steps too short", "point": best})
