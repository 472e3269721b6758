#!/usr/bin/env python3
"""The test of the examples complains about every mistake of broken_page.md, and about nothing else."""
import pathlib
import sys

import examples_test

EXPECTED = [
    (6, "prints"),
    (8, "exit code 2"),
    (14, "reproduce has no option --slow"),
    (15, "there is no command repro"),
    (16, "the script does not know test --valgrind"),
    (25, "is no part of examples/solvers/mine.c"),
    (29, "no comment says which file"),
]

found = examples_test.test(pathlib.Path(__file__).with_name("broken_page.md"))
assert [line for line, _ in found] == [line for line, _ in EXPECTED], found
for (_, complaint), (_, part) in zip(found, EXPECTED):
    assert part in complaint, (complaint, part)
