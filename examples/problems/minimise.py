#!/usr/bin/env python3
"""The lightest spring that holds, of functions in Python; spring.toml is the same as a program."""
import ricochet


def weight(x):
    wire, coil, turns = x
    return (turns + 2) * coil * wire**2


constraints = [  # each <= 0
    lambda x: 1 - x[1] ** 3 * x[2] / (71785 * x[0] ** 4),
    lambda x: (4 * x[1] ** 2 - x[0] * x[1]) / (12566 * (x[1] * x[0] ** 3 - x[0] ** 4))
    + 1 / (5108 * x[0] ** 2)
    - 1,
    (lambda x: 140.45 * x[0] / (x[1] ** 2 * x[2]) - 1, ">= 0"),
    lambda x: (x[0] + x[1]) / 1.5 - 1,
]
spring = ricochet.Problem(weight, [0.05, 0.25, 2], [2, 1.3, 15], constraints=constraints)
found = ricochet.minimise(spring, budget=5000)
print(f"{found.solver}: weight {found.value:.5f} at {found.x.round(3)}, violation {found.violation:g}")
print(found.trace[["value", "violation", "best"]].tail(1).round(5).to_string())
print(ricochet.compare(spring, ["auto", "mads-tuned", "random-search"], budget=2000, starts=3)
      .groupby("solver")[["value", "targets"]].median().round(4))
