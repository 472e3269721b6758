"""The examples of one language in examples/languages: what they print, and the error of a bad file.

    languages_test.py C|Lua|R|Octave
"""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

SOURCE = pathlib.Path(os.environ["RICOCHET_SOURCE"])
LIBRARY = pathlib.Path(os.environ["RICOCHET_LIBRARY"]).resolve()
EXPECTED = """\
collisions 0 21 42, quiet up to 6.311 rad/s
hs-71: 16, constraints 12 0, best known 17.014017
"""  # Interface.IsUsedFromPython compares these with the program
LINK = [f"-I{SOURCE / 'include'}", f"-L{LIBRARY.parent}", "-lricochet"]
# Program, what compiles the glue, and what runs the example.
LANGUAGES = {
    "C": ("gcc", ["gcc", "-std=c99", "-Wall", "-Wextra", "-pedantic", "-Werror", "ask.c", *LINK, "-o", "ask"], ["./ask"]),
    "Lua": ("luajit", None, ["luajit", "ask.lua"]),
    "R": ("Rscript", ["R", "CMD", "SHLIB", "for_r.c", *LINK[1:]], ["Rscript", "--vanilla", "ask.R"]),
    "Octave": (
        "mkoctfile", ["mkoctfile", "--mex", "ricochet_mex.c", *LINK],
        ["octave-cli", "--quiet", "--no-init-file", "ask.m"],
    ),
}  # fmt: skip


def minimisation():
    """What `minimise` prints, as the Python package finds it."""
    import numpy
    import ricochet

    speeds = numpy.linspace(5, 7, 201)
    counts = ricochet.Scene.load(SOURCE / "examples" / "machine.toml").counts(speeds)
    with ricochet.problem("classic-rosenbrock-2") as problem:
        least = problem.best_known
        assert problem([1, 1]) == least
    return (
        f"first collisions at {speeds[(counts > 0).argmax()]:.2f} rad/s\n"
        f"minimum {least:.2f} at 1.00 1.00\n"
    )


def main(language):
    program, compiling, running = LANGUAGES[language]
    if shutil.which(program) is None:
        print(f"skipped: there is no {program}")
        return 77
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for file in (SOURCE / "examples" / "languages").iterdir():
            shutil.copy(file, folder)
        environment = {
            **os.environ,
            "LD_LIBRARY_PATH": str(LIBRARY.parent),
            "PKG_CPPFLAGS": LINK[0],
            "HOME": name,
        }

        def run(command):
            return subprocess.run(
                command, cwd=folder, env=environment, capture_output=True, text=True
            )

        if compiling:
            done = run(compiling)
            if done.returncode:
                print(done.stdout + done.stderr)
                return 1
        shutil.copy(SOURCE / "examples" / "machine.toml", folder)
        done = run(running)
        if (done.returncode, done.stdout) != (0, EXPECTED):
            print(f"exit code {done.returncode}, prints\n{done.stdout}{done.stderr}")
            return 1
        *calling, example = running
        minimise = example.replace("ask", "minimise")
        if (folder / minimise).exists():
            done = run([*calling, minimise])
            if (done.returncode, done.stdout) != (0, minimisation()):
                print(f"{minimise}: exit code {done.returncode}, prints\n{done.stdout}{done.stderr}")
                return 1
        (folder / "machine.toml").write_text("[scene]\nmas = 1\n")
        done = run(running)
        if done.returncode == 0 or "machine.toml: " not in done.stdout + done.stderr:
            print(f"no error of a bad file: {done.stdout}{done.stderr}")
            return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
