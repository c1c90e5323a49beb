#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs those of piglit's egl* programs that need neither desktop OpenGL nor OpenGL ES 2, on whatever EGL the environment names, and
fails unless each reports what piglit_egl.txt says and each program of the package is named there. It needs an X server.

usage: piglit_egl.py [--any]    --any: print what they report, whatever it is
"""
import re
import subprocess
import sys
from pathlib import Path

LIST = Path(__file__).with_name("piglit_egl.txt")


def package():
    """The paths of the package's programs that are about EGL."""
    listing = subprocess.run(["dpkg", "-L", "piglit"], capture_output=True, text=True, check=True).stdout
    return {Path(line).name: line for line in listing.splitlines() if re.search(r"/piglit/bin/egl[-_][^/]+$", line)}


def report_of(path, arguments):
    try:
        done = subprocess.run([path, *arguments, "-auto"], stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=60,
                              errors="replace", check=False)
    except subprocess.TimeoutExpired:
        return "timeout", ""
    found = re.findall(r'PIGLIT: \{"result": "(\w+)" \}', done.stdout)
    result = found[-1] if found and done.returncode >= 0 else f"status {done.returncode}"
    return result, done.stdout + done.stderr


programs = package()
if not programs:
    sys.exit("piglit_egl: the package piglit has no program egl*")
named, wrong, passed, ran = set(), [], 0, 0
for line in LIST.read_text(encoding="utf-8").splitlines():
    words, _, reason = line.partition(" | ")
    words = words.split()
    if not words or words[0] == "#":
        continue
    if words[0] == "leave":
        named.add(words[1])
        continue
    expected, name, arguments = words[1], words[2], words[3:]
    named.add(name)
    result, output = report_of(programs.get(name, name), arguments)
    ran += 1
    passed += result == "pass"
    title = " ".join(words[2:])
    print(f"{result:8} {title}{'  (' + reason + ')' if reason else ''}")
    if result != expected:
        wrong.append(f"{title}: {result}, expected {expected}\n{output[-1500:]}")
wrong += [f"{name} is in the package, but not in {LIST.name}" for name in sorted(set(programs) - named)]
wrong += [f"{name} is in {LIST.name}, but not in the package" for name in sorted(named - set(programs))]
print(f"piglit_egl: {passed} of {ran} runs pass, {len(programs)} programs are known")
if sys.argv[1:] != ["--any"] and wrong:
    sys.exit("\n".join(wrong))
