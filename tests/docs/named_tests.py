"""Whether every test and script that docs/security.md names is there."""

import pathlib
import re
import sys

source = pathlib.Path(sys.argv[1])
page = (source / "docs" / "security.md").read_text()
table = page[page.index("## Which test holds which sentence?"):]
named = set(re.findall(r"`([A-Z]\w+)\.([A-Z]\w+)`", table))
scripts = set(re.findall(r"`(tests/\S+)`", table))
there = set()
for file in source.glob("tests/**/*.cpp"):
    there |= set(re.findall(r"TEST(?:_F|_P)?\(\s*(\w+),\s*(\w+)\)", file.read_text()))
for file in source.glob("tests/**/CMakeLists.txt"):
    there |= set(re.findall(r"add_test\(NAME (\w+)\.(\w+)", file.read_text()))
missing = sorted(".".join(name) for name in named - there)
missing += sorted(script for script in scripts if not (source / script).is_file())
assert len(named) > 20 and len(scripts) >= 3, "the table is not read"
sys.exit(f"docs/security.md names what is not there: {', '.join(missing)}" if missing else 0)
