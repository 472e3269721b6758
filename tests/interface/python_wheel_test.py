"""The wheel is installed by pip into an empty environment, and works there by itself."""

import importlib.metadata
import os
import pathlib
import platform
import subprocess
import sys
import tempfile

for package in ("build", "numpy", "pip", "setuptools", "wheel"):
    try:
        importlib.metadata.distribution(package)
    except importlib.metadata.PackageNotFoundError:
        print(f"skipped: this Python has no {package} (Debian: python3-{package})", file=sys.stderr)
        sys.exit(77)

if not os.path.exists("/proc/self/maps"):
    print("skipped: there is no /proc", file=sys.stderr)
    sys.exit(77)

SOURCE = pathlib.Path(os.environ["RICOCHET_SOURCE"])
BUILD = pathlib.Path(os.environ["RICOCHET_BUILD"])
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
bowl = ricochet.Problem(lambda x: (x[0] - 2) ** 2, [0], [5])
print(round(ricochet.minimise(bowl, "nlopt-cobyla").x[0], 6))
maps = pathlib.Path("/proc/self/maps").read_text()
assert f"{here / 'libricochet_minimise.so.3'}\\n" in maps
"""


def run(*command, **options):
    clean = {"PATH": os.environ["PATH"], "HOME": os.environ.get("HOME", "/")}
    done = subprocess.run(command, env=clean, capture_output=True, text=True, **options)
    if done.returncode:
        sys.exit(f"{command}: {done.stdout}{done.stderr}")
    return done.stdout


with tempfile.TemporaryDirectory() as folder:
    version = os.environ["RICOCHET_VERSION"]
    path = BUILD / f"ricochet-{version}-py3-none-linux_{platform.machine()}.whl"
    made = []
    for _ in range(2):
        path.unlink(missing_ok=True)
        run("cmake", "--build", BUILD, "--target", "wheel")
        made.append(path.read_bytes())
    assert made[0] == made[1], "two wheels of one library differ"

    home = pathlib.Path(folder, "environment")
    run(sys.executable, "-m", "venv", "--without-pip", "--system-site-packages", home)
    python = home / "bin" / "python3"
    run(
        sys.executable, "-m", "pip", "--python", python, "install", "--no-index", "--no-deps",
        "--disable-pip-version-check", path,
    )  # fmt: skip
    (pathlib.Path(folder) / "machine.toml").write_bytes(
        (SOURCE / "examples" / "machine.toml").read_bytes()
    )
    printed = run(python, "-c", USE, cwd=folder)
    expected = f"[0, 21, 42] 6.311\n[16.0]\n{version} True\n2.0\n"
    assert printed == expected, printed
    files = run(sys.executable, "-m", "pip", "--python", python, "show", "-f", "ricochet")
    assert "ricochet/libricochet.so.3" in files, files
    print(f"{path.name}: {path.stat().st_size / 1e6:.1f} MB")
