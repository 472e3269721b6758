"""The wheel is installed by pip into an empty environment, and works there by itself."""

import os
import pathlib
import subprocess
import sys
import tempfile

try:
    import numpy  # noqa: F401
except ImportError:
    print("skipped: this Python has no NumPy (Debian: python3-numpy)", file=sys.stderr)
    sys.exit(77)

SOURCE = pathlib.Path(os.environ["RICOCHET_SOURCE"])
USE = """
import pathlib, ricochet
here = pathlib.Path(ricochet.__file__).parent
assert "site-packages" in here.parts, here
scene = ricochet.Scene.load("machine.toml")
print(scene.counts([5.0, 6.0, 7.0]).tolist(), scene.threshold().quiet)
print(ricochet.problem("hs-71").batch([[1, 5, 5, 1]]).objectives.tolist())
print(ricochet.__version__, (here / "py.typed").exists())
maps = pathlib.Path("/proc/self/maps").read_text()
for library in ("libricochet.so.3", "libtbb.so.12"):
    assert f"{here / library}\\n" in maps, library + " is not that of the wheel"
for library in ("libfmt", "libtomlplusplus", "libnlopt", "libceres", "libipopt"):
    assert library not in maps, library
"""


def run(*command, **options):
    clean = {"PATH": os.environ["PATH"], "HOME": os.environ.get("HOME", "/")}
    done = subprocess.run(command, env=clean, capture_output=True, text=True, **options)
    if done.returncode:
        sys.exit(f"{command}: {done.stdout}{done.stderr}")
    return done.stdout


def skip_without(*module):
    if subprocess.run([sys.executable, "-m", *module], capture_output=True).returncode:
        print(f"skipped: this Python has no {module[0]} (Debian: python3-{module[0]})")
        sys.exit(77)


skip_without("pip", "--version")
skip_without("venv", "--help")
with tempfile.TemporaryDirectory() as folder:
    wheels = []
    for name in ("first", "second"):
        out = pathlib.Path(folder, name)
        out.mkdir()
        made = run(
            sys.executable, SOURCE / "python" / "make_wheel.py", os.environ["RICOCHET_VERSION"],
            os.environ["RICOCHET_LIBRARY"], os.environ["RICOCHET_TBB"], "--out", out,
        )  # fmt: skip
        wheels.append(pathlib.Path(made.strip()))
    assert wheels[0].read_bytes() == wheels[1].read_bytes(), "two wheels of one library differ"

    home = pathlib.Path(folder, "environment")
    run(sys.executable, "-m", "venv", "--without-pip", "--system-site-packages", home)
    python = home / "bin" / "python3"
    run(
        sys.executable, "-m", "pip", "--python", python, "install", "--no-index", "--no-deps",
        "--disable-pip-version-check", wheels[0],
    )  # fmt: skip
    (pathlib.Path(folder) / "machine.toml").write_bytes(
        (SOURCE / "examples" / "machine.toml").read_bytes()
    )
    printed = run(python, "-c", USE, cwd=folder)
    expected = f"[0, 21, 42] 6.311\n[16.0]\n{os.environ['RICOCHET_VERSION']} True\n"
    assert printed == expected, printed
    files = run(sys.executable, "-m", "pip", "--python", python, "show", "-f", "ricochet")
    assert "ricochet/libricochet.so.3" in files, files
    print(f"{wheels[0].name}: {wheels[0].stat().st_size / 1e6:.1f} MB")
