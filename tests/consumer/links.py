#!/usr/bin/env python3
"""links.py FOLDER: every link of a page in the folder leads to a file in the folder."""
import pathlib
import re
import sys

folder = pathlib.Path(sys.argv[1]).resolve()
pages = sorted(folder.rglob("*.md"))
assert len(pages) > 20, f"{folder}: only {len(pages)} pages"
broken = []
for page in pages:
    text = re.sub(r"```.*?```|`[^`\n]*`", "", page.read_text(), flags=re.DOTALL)
    for link in re.findall(r"\]\(([^)#\s]+)", text):
        target = (page.parent / link).resolve()
        if "://" not in link and not (target.exists() and target.is_relative_to(folder)):
            broken.append(f"{page.relative_to(folder)}: {link}")
if broken:
    sys.exit("broken links:\n" + "\n".join(broken))
