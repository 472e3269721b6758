"""A tool for `ricochet simulators`: semi-implicit Euler, 20,000 steps a scene."""
import json, math, sys, time

for line in sys.stdin:
    s, impacts, start = json.loads(line), [], time.process_time()
    x, v, dt = s["position"], s["velocity"], s["duration"] / 20_000
    for k in range(20_000):
        piece = max((p for p in s["force"] if p["from"] <= k * dt), key=lambda p: p["from"])
        force, u = 0.0, k * dt - piece["from"]
        for term in piece["terms"]:
            (a, b, c), (p, q, r) = term["amplitude"], term["phase"]
            force += (a + b * u + c * u * u) * math.cos(p + q * u + r * u * u)
        push = force + s["mass"] * v / dt  # what would stop the body
        v = dt * (push - math.copysign(min(s["friction"], abs(push)), push)) / s["mass"]
        x += dt * v
        for wall, e, out in (("lower", s["restitution_lower"], -1), ("upper", s["restitution_upper"], 1)):
            if s[wall] is not None and out * (x - s[wall]) > 0 and out * v > 0:
                impacts.append([(k + 1) * dt, wall, abs(v)])
                x, v = s[wall], -e * v
    print(json.dumps({"scene": s["scene"], "impacts": impacts, "seconds": time.process_time() - start}), flush=True)
