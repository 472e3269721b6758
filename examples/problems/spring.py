"""The weight of a coil spring and what it must hold; see spring.toml."""

import json
import sys

for line in sys.stdin:
    wire, coil, turns = json.loads(line)["x"]
    bend = 12566 * (coil * wire**3 - wire**4)
    if bend == 0:
        answer = {"error": "the coil is as narrow as its wire"}
    else:
        answer = {
            "objective": (turns + 2) * coil * wire**2,
            "constraints": [
                1 - coil**3 * turns / (71785 * wire**4),
                (4 * coil**2 - wire * coil) / bend + 1 / (5108 * wire**2) - 1,
                1 - 140.45 * wire / (coil**2 * turns),
                (coil + wire) / 1.5 - 1,
            ],
        }
    print(json.dumps(answer), flush=True)
