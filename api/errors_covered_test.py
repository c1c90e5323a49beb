#!/usr/bin/env python3
"""Every rule that a validator names is broken by a case of the error tests, and every call that has a validator is refused at
least once; found in what the tests say on stderr with CLEARPIPE_DEBUG=1. Prints how many cases, rules and calls there are.

usage: errors_covered_test.py SOURCE_DIR API_TEST
SPDX-License-Identifier: MIT
"""
import os
import pathlib
import re
import subprocess
import sys

source, program = pathlib.Path(sys.argv[1]), sys.argv[2]
run = subprocess.run([program, "--gtest_filter=*Errors.*"], capture_output=True, text=True, check=False,
                     env={**os.environ, "CLEARPIPE_DEBUG": "1"})
said = set(re.findall(r"^clearpipe: (GL_\w+ in gl\w+\(.*)$", run.stderr, re.M))
cases = sum(int(n) for n in re.findall(r"^errors: (\d+) cases", run.stdout, re.M))

# Rules are the strings of these files that end with a section or an extension in parentheses.
files = sorted((source / "api").glob("validate*")) + [source / "api" / name for name in ("egl_image.cpp", "framebuffer.cpp", "queries.cpp")]
strings = [re.sub(r'"\s*"', "", text) for path in files
           for text in re.findall(r'"((?:[^"\\\n]|\\.)*(?:"\s*"(?:[^"\\\n]|\\.)*)*)"', path.read_text(encoding="utf-8"))]
rules = sorted({text for text in strings if re.search(r" \([^()]*\)$", text)})


def is_said(rule):
    pattern = re.compile(r"\): " + ".*".join(map(re.escape, re.split(r"\{\d\}", rule))) + "$")
    return any(pattern.search(line) for line in said)


calls = {}
for name, validator in re.findall(r"^(?:COMMON_)?CALL\([^,]*, (\w+), \(.*\), (\w+), \w+, \w+, \"[^\"]*\"\)$",
                                  (source / "api" / "gles1.def").read_text(encoding="utf-8"), re.M):
    if validator != "none":
        calls["gl" + name] = validator
refused = {line.split(" in ", 1)[1].split("(", 1)[0] for line in said}

failures = []
if run.returncode != 0:
    failures.append("the tests fail")
if len(rules) < 100 or len(calls) < 100:
    failures.append(f"the lists were not understood: {len(rules)} rules, {len(calls)} calls")
failures += [f"no case breaks the rule: {rule}" for rule in rules if not is_said(rule)]
failures += [f"never refused: {name}" for name in sorted(calls) if name not in refused]
print(f"negative: {cases} cases, {len(rules)} rules, {len(calls)} calls")
print("\n".join(failures))
sys.exit(1 if failures else 0)
