#!/usr/bin/env python3
"""Tests the examples of one page of the documentation.

    examples_test.py PAGE

The environment names the program (RICOCHET_PROGRAM), the source folder (RICOCHET_SOURCE) and the
build folder (RICOCHET_BUILD). Blocks of a page:

  ```console   Lines `$ COMMAND` run in order, all of a page in one temporary folder. A command must
               end with exit code 0. Lines below a command are its standard output; `...` stands
               for any text, on a line of its own for any lines.
  ```text      Not tested.
  ```LANGUAGE  Any other block is a part of the file that the comment above it names.

A comment directly above a block changes this:

  <!-- not run: REASON -->   Only commands and options are looked up, in the help.
  <!-- needs: MODULE -->     Skipped if Python does not have this module.
  <!-- part of: FILE -->     The block stands in this file, word for word.
"""
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from typing import NamedTuple

SECONDS = 120  # that one command may take
README_LINES = 150
SOURCE = pathlib.Path(os.environ["RICOCHET_SOURCE"])
FROM_SOURCE = ["examples", "include", "python"]  # what a command finds in its folder


class Block(NamedTuple):
    line: int  # of the page, from 1
    language: str
    note: str  # such as "part of", or ""
    value: str
    text: str


class Command(NamedTuple):
    line: int
    text: str
    output: list  # of lines; empty if the page shows none


def blocks_of(page):
    """All fenced blocks of a page, with the comment above each."""
    blocks, lines = [], page.splitlines()
    k = 0
    while k < len(lines):
        if not lines[k].startswith("```"):
            k += 1
            continue
        end = k + 1
        while end < len(lines) and lines[end] != "```":
            end += 1
        note = re.fullmatch(r"<!-- ([a-z ]+): (.*) -->", lines[k - 1] if k else "")
        name, value = note.groups() if note else ("", "")
        text = "".join(line + "\n" for line in lines[k + 1 : end])
        blocks.append(Block(k + 1, lines[k][3:], name, value, text))
        k = end + 1
    return blocks


def commands_of(block):
    """The commands of a console block, each with the output that is shown."""
    commands = []
    for k, line in enumerate(block.text.splitlines(), block.line + 1):
        if line.startswith("$ "):
            commands.append(Command(k, line[2:], []))
        elif commands:
            commands[-1].output.append(line)
    return commands


def matches(shown, printed):
    """Whether the output is as shown, where `...` stands for any text, or for any lines."""
    pattern = ""
    for line in shown:
        escaped = re.escape(line + "\n").replace(re.escape("..."), "[^\n]*")
        pattern += "(?:[^\n]*\n)*" if line == "..." else escaped
    return re.fullmatch(pattern, printed) is not None


def prepare(folder):
    """Makes a folder look like a checkout that is built."""
    script = folder / "ricochet"
    script.write_text('#!/bin/sh\nexec "$RICOCHET_PROGRAM" "$@"\n')
    script.chmod(0o755)
    for name in FROM_SOURCE:
        if name != "examples":
            (folder / name).symlink_to(SOURCE / name)
    shutil.copytree(SOURCE / "examples", folder / "examples")  # evaluations are kept beside a problem
    (folder / "build").mkdir()
    (folder / "build" / "release").symlink_to(os.environ["RICOCHET_BUILD"])
    (folder / "bin").mkdir()
    (folder / "bin" / "python3").symlink_to(sys.executable)


def run(command, folder):
    """Complaints about a command that is run."""
    environment = {**os.environ, "PATH": f"{folder / 'bin'}:{os.environ['PATH']}"}
    try:
        done = subprocess.run(
            ["bash", "-c", command.text], cwd=folder, env=environment, capture_output=True,
            text=True, timeout=SECONDS, stdin=subprocess.DEVNULL,
        )  # fmt: skip
    except subprocess.TimeoutExpired:
        return [f"takes more than {SECONDS} s"]
    if done.returncode != 0:
        return [f"exit code {done.returncode}: {done.stderr.strip() or done.stdout.strip()}"]
    if command.output and not matches(command.output, done.stdout):
        return [f"prints\n{done.stdout}"]
    return []


def printed(*arguments):
    """All that the call prints."""
    done = subprocess.run(arguments, capture_output=True, text=True, stdin=subprocess.DEVNULL)
    return done.stdout + done.stderr


def calls_in(text):
    """The arguments of each call of ricochet in a command line."""
    calls, call = [], None
    for word in shlex.split(text, comments=True):
        if word in ("ricochet", "./ricochet"):
            call = []
            calls.append(call)
        elif word in ("|", "&&", ";", ">", "<"):
            call = None
        elif call is not None:
            call.append(word)
    return calls


def look_up(arguments):
    """Complaints about a call that is not run: its command, and options that the help lacks."""
    program = os.environ["RICOCHET_PROGRAM"]
    if arguments[0] in ("test", "--no-install"):  # the script's own
        known = " ".join(arguments[:2] if arguments[0] == "test" else arguments[:1])
        usage = printed("bash", str(SOURCE / "ricochet"))
        return [] if known in usage else [f"the script does not know {known}"]
    if not re.search(rf"^  {re.escape(arguments[0])}\b", printed(program, "--help"), re.MULTILINE):
        return [f"there is no command {arguments[0]}"]
    options = [a.split("=")[0] for a in arguments if a.startswith("--")]
    options = [option for option in options if not option.startswith("--benchmark_")]
    if not options:
        return []
    words = [a for a in arguments[:2] if not a.startswith("-")]
    known = set(re.findall(r"--[a-z-]+", printed(program, *words, "--help")))
    return [f"{words[0]} has no option {option}" for option in options if option not in known]


def has_module(name):
    return subprocess.run([sys.executable, "-c", f"import {name}"], capture_output=True).returncode == 0


def complaints_of(block, folder):
    """Pairs of line and complaint."""
    if block.language == "text":
        return []
    if block.language != "console":
        if block.note != "part of":
            return [(block.line, "no comment says which file this is a part of")]
        file = SOURCE / block.value
        if not file.exists() or block.text not in file.read_text():
            return [(block.line, f"is no part of {block.value}")]
        return []
    found = []
    for command in commands_of(block):
        if block.note == "not run":
            complaints = [c for call in calls_in(command.text) for c in look_up(call)]
        else:
            complaints = run(command, folder)
        found += [(command.line, f"{command.text}: {complaint}") for complaint in complaints]
    return found


def test(page):
    """All complaints about a page."""
    text = page.read_text()
    lines = text.count("\n")
    found = []
    if page.name == "README.md" and lines > README_LINES:
        found.append((lines, f"has more than {README_LINES} lines"))
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        prepare(folder)
        for block in blocks_of(text):
            if block.note == "needs" and not has_module(block.value):
                print(f"{page.name}:{block.line}: skipped, Python has no {block.value}")
                continue
            found += complaints_of(block, folder)
    return found


def main():
    page = pathlib.Path(sys.argv[1])
    found = test(page)
    for line, complaint in found:
        print(f"{page.name}:{line}: {complaint}")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
