#!/usr/bin/env python3
"""Where the programs and libraries of a folder look for libraries.

    runpaths.py FOLDER...

Every entry of RUNPATH and RPATH must be an absolute path or begin with $ORIGIN: an empty or a relative one
is looked up in the current folder, where a stranger's library may lie. Exit code 1, with a line a file,
where one is not; 2 where the folders have nothing to look at.
"""
import os
import re
import subprocess
import sys

ENTRY = re.compile(r"\((?:RUNPATH|RPATH)\)\s+Library (?:runpath|rpath): \[(.*)\]")


def loadable(folder):
    """The programs and shared libraries in ELF below a folder."""
    for root, _, names in os.walk(folder):
        for name in names:
            path = os.path.join(root, name)
            if os.path.islink(path) or not (os.access(path, os.X_OK) or ".so" in name):
                continue
            with open(path, "rb") as file:
                if file.read(4) == b"\x7fELF":
                    yield path


def main(folders):
    looked_at = 0
    wrong = []
    for path in (path for folder in folders for path in loadable(folder)):
        looked_at += 1
        told = subprocess.run(["readelf", "--dynamic", "--wide", path], capture_output=True, text=True, check=True)
        for entries in ENTRY.findall(told.stdout):
            if any(not entry.startswith(("/", "$ORIGIN")) for entry in entries.split(":")):
                wrong.append(f"{path}: {entries}")
    print("\n".join([*wrong, f"{looked_at} programs and libraries, {len(wrong)} with an empty or relative entry"]))
    return 1 if wrong else 0 if looked_at else 2


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
