#!/usr/bin/env python3
"""Makes a wheel of the package ricochet, with the C library inside.

    make_wheel.py VERSION LIBRARY BESIDE... --out FOLDER

LIBRARY is libricochet.so.3; BESIDE are libraries that it needs and that a system may lack. Each is
stored under its name in the ELF file, stripped if there is a program `strip`. Prints the wheel's path.
"""
import argparse
import base64
import hashlib
import os
import pathlib
import shutil
import subprocess
import tempfile
import zipfile

HERE = pathlib.Path(__file__).resolve().parent
TAG = "py3-none-linux_x86_64"
# Of Debian, whose code is in the libraries.
CONTAINED = ["libtbb12", "libfmt-dev", "libtomlplusplus-dev", "libeigen3-dev", "libceres-dev"]
METADATA = """\
Metadata-Version: 2.1
Name: ricochet
Version: {version}
Summary: The fastest quiet speed of a braiding machine, and a benchmark of solvers on it
License: MIT
Requires-Python: >=3.9
Requires-Dist: numpy
Provides-Extra: pandas
Requires-Dist: pandas; extra == "pandas"
Description-Content-Type: text/markdown

{description}"""
WHEEL = """\
Wheel-Version: 1.0
Generator: ricochet make_wheel.py
Root-Is-Purelib: false
Tag: {tag}
"""


def stripped(library):
    """The bytes of a library, without its symbols for linkers and debuggers."""
    program = shutil.which("strip")
    if program is None:
        return library.read_bytes()
    with tempfile.TemporaryDirectory() as folder:
        copy = pathlib.Path(folder, library.name)
        subprocess.run([program, "--strip-unneeded", "-o", copy, library], check=True)
        return copy.read_bytes()


def contents(version, libraries):
    """All files of the wheel but its list: pairs of path and bytes."""
    package = HERE / "ricochet"
    for file in sorted([*package.glob("*.py"), package / "py.typed"]):
        yield f"ricochet/{file.name}", file.read_bytes()
    for library in libraries:
        name = ".".join(library.name.split(".")[:3])  # libtbb.so.12 of libtbb.so.12.8
        yield f"ricochet/{name}", stripped(library)
    folder = f"ricochet-{version}.dist-info"
    description = (HERE.parent / "docs" / "other-languages.md").read_text()
    yield f"{folder}/METADATA", METADATA.format(version=version, description=description).encode()
    yield f"{folder}/WHEEL", WHEEL.format(tag=TAG).encode()
    yield f"{folder}/LICENSE", (HERE.parent / "LICENSE").read_bytes()
    for name in CONTAINED:
        licence = pathlib.Path("/usr/share/doc", name, "copyright")
        if licence.exists():
            yield f"{folder}/licenses/{name}", licence.read_bytes()


def make(folder, version, libraries):
    """Writes the wheel into the folder; returns its path."""
    wheel = folder / f"ricochet-{version}-{TAG}.whl"
    draft = wheel.with_suffix(".draft")
    listed = []
    with zipfile.ZipFile(draft, "w", zipfile.ZIP_DEFLATED) as archive:

        def add(path, content):
            info = zipfile.ZipInfo(path, (1980, 1, 1, 0, 0, 0))  # the same bytes every time
            info.external_attr = 0o100644 << 16
            info.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(info, content)

        for path, content in contents(version, libraries):
            digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=")
            listed.append(f"{path},sha256={digest.decode()},{len(content)}\n")
            add(path, content)
        record = f"ricochet-{version}.dist-info/RECORD"
        add(record, "".join(listed) + f"{record},,\n")
    os.replace(draft, wheel)
    return wheel


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("version")
    parser.add_argument("libraries", nargs="+", type=pathlib.Path)
    parser.add_argument("--out", type=pathlib.Path, required=True)
    options = parser.parse_args()
    print(make(options.out, options.version, options.libraries))
