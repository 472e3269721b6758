"""ricochet.Scene, against the program ricochet."""

import json
import os
import pickle
import subprocess
import sys
import threading
import unittest

try:
    import numpy
except ImportError:
    print("skipped: this Python has no NumPy (Debian: python3-numpy)", file=sys.stderr)
    sys.exit(77)

import ricochet

FILE = os.path.join(os.environ["RICOCHET_SOURCE"], "examples", "machine.toml")


def answer(*command):
    """What the program prints as JSON about the machine."""
    done = subprocess.run(
        [os.environ["RICOCHET_PROGRAM"], *command, "--scene", FILE, "--format", "json"],
        capture_output=True, text=True,
    )  # fmt: skip
    if done.returncode:
        raise AssertionError(done.stderr)
    return json.loads(done.stdout)


class Scene(unittest.TestCase):
    scene = ricochet.Scene.load(FILE)

    def test_ends_at_the_time_limit(self):
        text = self.scene.text
        endless = text.replace("[window]", "disturbance = 3.0\ndisturbance_frequency = 7.3\n[window]")
        try:
            last = ricochet.Scene.parse(endless).regimes(seconds=0.5)[-1]
            self.assertEqual(last.ends_by, "time-limit")
            self.assertFalse(last.certain)
            self.assertLess(last.highest, 18)
        except ricochet.Error as error:  # not even the slowest motion is known
            self.assertIn("time limit of 0.5 s", str(error))
        long = ricochet.Scene.parse(text.replace("revolutions = 10", "revolutions = 900000"))
        found = long.simulate(8.0, seconds=0.5)
        self.assertFalse(found.certain)
        self.assertGreater(found.reached, 0)
        self.assertIn("the time limit was reached", found.doubt)
        threshold = long.threshold("collisions", 1e12, seconds=0.5)
        self.assertIsNone(threshold.quiet)
        self.assertLess(threshold.reached, 18)
        with self.assertRaisesRegex(ricochet.Error, "time limit of 0.5 s"):
            long.counts([8.0], seconds=0.5)
        with self.assertRaisesRegex(ricochet.Error, "seconds 0: must be > 0"):
            long.counts([8.0], seconds=0)
        self.assertIsNone(self.scene.simulate(8.0).reached)
        self.assertIsNone(self.scene.threshold().reached)

    def test_has_no_quiet_speed_where_every_speed_is_loud(self):
        loud = self.scene.text.replace("friction = 0.2", "friction = 0")
        loud = loud.replace('"5 mm/s"', "1e-6")
        threshold = ricochet.Scene.parse(loud).threshold(fastest=5)
        self.assertEqual(tuple(threshold), (None, 0.01, 2.0))

    def test_simulates_as_the_program_does(self):
        for omega in (5.0, 6.5, 7.0, 15.0):
            told = answer("simulate", "--omega", str(omega))
            found = self.scene.simulate(omega, samples=200)
            self.assertEqual(found.count, told["count"])
            self.assertEqual(found.certain, told["certain"])
            self.assertEqual(found.impacts.times.tolist(), [i["time"] for i in told["impacts"]])
            self.assertEqual(found.impacts.speeds.tolist(), [i["speed"] for i in told["impacts"]])
            walls = ["lower", "upper"]
            self.assertEqual(
                [walls[k] for k in found.impacts.walls], [i["wall"] for i in told["impacts"]]
            )
            self.assertEqual(found.doubt, told["doubt"] or "")
            self.assertGreater(len(found.path.times), 200)
            self.assertEqual(found.path.times[-1], told["end"]["time"])
            self.assertEqual(found.path.positions[-1], told["end"]["position"])

    def test_counts_as_it_simulates(self):
        omegas = numpy.linspace(5, 16, 12).reshape(3, 4)
        counts = self.scene.counts(omegas)
        self.assertEqual(counts.shape, (3, 4))
        for omega, count in zip(omegas.flat, counts.flat):
            self.assertEqual(self.scene.simulate(omega).count, count)
        self.assertEqual(self.scene.counts(7.0), self.scene.counts([7.0])[0])
        self.assertEqual(self.scene.counts(7.0).shape, ())
        self.assertEqual(self.scene.counts([7, 8]).tolist(), self.scene.counts([7.0, 8.0]).tolist())
        self.assertEqual(self.scene.counts(omegas.T).T.tolist(), counts.tolist())

    def test_has_the_regimes_of_the_program(self):
        # Under a disturbance, so that turns differ in their collisions.
        settings = ["disturbance=2", "disturbance_frequency=11"]
        options = [word for setting in settings for word in ("--set", setting)]
        told = answer("regimes", "--from", "5.7", "--to", "6", *options)
        scene = ricochet.Scene.parse(
            self.scene.text.replace("[scene]", "[scene]\n" + "\n".join(settings))
        )
        found = scene.regimes(5.7, 6)
        self.assertGreater(len(found), 1)
        self.assertTrue(any(r.least_per_turn < r.mean_per_turn < r.most_per_turn for r in found))
        names = {"lowest": "from", "highest": "to", "mean_per_turn": "collisions_per_turn"}
        self.assertEqual(
            [r._asdict() for r in found],
            [{name: r[names.get(name, name)] for name in ricochet.Regime._fields} for r in told],
        )

    def test_has_the_threshold_of_the_program(self):
        self.assertEqual(self.scene.threshold().quiet, answer("threshold")["fastest_quiet"])
        told = answer("threshold", "--allow", "10")["fastest_quiet"]
        self.assertEqual(self.scene.threshold("collisions", 10).quiet, told)
        self.assertEqual(self.scene.threshold("collisions", 1e6).first_loud, None)

    def test_is_read_from_a_text(self):
        scene = ricochet.Scene.parse(self.scene.text)
        self.assertEqual(scene.counts([7.0]), self.scene.counts([7.0]))
        self.assertEqual(scene.omega, 1.0)

    def test_is_pickled(self):
        copy = pickle.loads(pickle.dumps(self.scene))
        self.assertEqual(copy.text, self.scene.text)
        self.assertEqual(copy.threshold(), self.scene.threshold())
        found = pickle.loads(pickle.dumps(self.scene.simulate(7.0)))
        self.assertEqual(found.count, self.scene.simulate(7.0).count)

    def test_is_used_by_threads_at_once(self):
        omegas = [5.0, 6.5, 7.0, 15.0]
        counts = [self.scene.simulate(omega).count for omega in omegas]
        impacts = [len(self.scene.simulate(omega).impacts.times) for omega in omegas]
        wrong = []

        def work(k):
            for _ in range(100):
                found = self.scene.simulate(omegas[k])
                if (found.count, len(found.impacts.times)) != (counts[k], impacts[k]):
                    wrong.append(omegas[k])

        interval = sys.getswitchinterval()
        self.addCleanup(sys.setswitchinterval, interval)
        sys.setswitchinterval(1e-6)
        threads = [threading.Thread(target=work, args=(k,)) for k in range(len(omegas))]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(wrong, [])

    def test_refuses_in_the_words_of_the_library(self):
        for ask, complaint in [
            (lambda: ricochet.Scene.load("none.toml"), "none.toml: there is no such file"),
            (lambda: ricochet.Scene.parse("[scene"), "text:1: not valid TOML"),
            (lambda: ricochet.Scene.parse(self.scene.text.replace("mass", "mas")), "mas"),
            (lambda: self.scene.counts([7.0, -1.0]), "speed = -1: must be a finite number > 0"),
            (lambda: self.scene.counts([numpy.nan]), "speed = nan"),
            (lambda: self.scene.simulate(-1.0), "omega = -1: must be"),
            (lambda: self.scene.simulate(7.0, samples=-1), "samples -1: must be >= 0"),
            (lambda: self.scene.simulate(7.0, samples=10**8), "samples = 100000000: must be at most"),
            (lambda: self.scene.regimes(5, 4), "speeds 5 to 4: must rise"),
            (lambda: self.scene.threshold("noise", 1), "measure noise: must be collisions"),
            (lambda: self.scene.threshold(fastest=-1), "fastest = -1: must be within"),
        ]:  # fmt: skip
            with self.assertRaisesRegex(ricochet.Error, complaint):
                ask()
        for ask in (
            lambda: self.scene.simulate(float("nan")),
            lambda: self.scene.threshold("collisions"),
            lambda: self.scene.threshold(fastest=float("inf")),
        ):
            with self.assertRaises(ValueError):
                ask()


if __name__ == "__main__":
    unittest.main()
