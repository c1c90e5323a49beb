#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Records `examples/gears` with `apitrace trace -a egl`, plays the recording back with `eglretrace` in a window, and compares the
picture played back with the one that gears wrote: they must be the same, pixel for pixel. It needs an X server for the window.

usage: apitrace.py GEARS FOLDER    the program, and a folder for what it leaves behind
"""
import os
import re
import subprocess
import sys
from pathlib import Path

FRAMES, SIZE = 3, "300x300"
RENDERER = os.environ.get("RENDERER", "clearpipe")  # that must play it back


def run(*command, **environment):
    done = subprocess.run([str(word) for word in command], env={**os.environ, **environment}, capture_output=True, text=True,
                          timeout=120, check=False)
    if done.returncode != 0:
        sys.exit(f"apitrace: {command[0]}: status {done.returncode}\n{done.stdout[-2000:]}{done.stderr[-2000:]}")
    return done.stdout + done.stderr


gears, folder = sys.argv[1], Path(sys.argv[2])
folder.mkdir(parents=True, exist_ok=True)
for old in folder.glob("*.*"):
    old.unlink()
trace, drawn = folder / "gears.trace", folder / "gears.png"
run("apitrace", "trace", "-a", "egl", "-o", trace, gears, "--frames", FRAMES, "--size", SIZE, "--output", drawn,
    DISPLAY="", EGL_PLATFORM="surfaceless")

calls = run("apitrace", "dump", "--color=never", trace)
reads = re.findall(r"^(\d+) glReadPixels\(", calls, re.M)
draws = len(re.findall(r"^\d+ glDrawElements\(", calls, re.M))
if len(reads) != 1 or draws < FRAMES:
    sys.exit(f"apitrace: the recording has {draws} draws and {len(reads)} reads of pixels")
# Debian's eglretrace opens its window through waffle, which would take GLX.
said = run("eglretrace", f"--snapshot={reads[0]}", f"--snapshot-prefix={folder}/retraced-", trace, WAFFLE_PLATFORM="x11_egl")
if "error" in said or "warning" in said:
    sys.exit(f"apitrace: eglretrace says\n{said}")
state = run("eglretrace", "-D", reads[0], trace, WAFFLE_PLATFORM="x11_egl")
renderer = re.search(r'"GL_RENDERER": "([^"]*)"', state)
pictures = sorted(folder.glob("retraced-*.png"))
if len(pictures) != 1:
    sys.exit(f"apitrace: eglretrace left {len(pictures)} pictures\n{said}")
# Of colours alone: what is shown has no alpha.
compared = subprocess.run(["oiiotool", str(pictures[0]), "--ch", "R,G,B", str(drawn), "--ch", "R,G,B", "--fail", "0", "--warn", "0",
                           "--diff"], capture_output=True, text=True, check=False)
print(f"apitrace: {draws} draws recorded and played back on {renderer.group(1) if renderer else 'nothing known'}: "
      f"{'the same picture' if compared.returncode == 0 else 'another picture'}")
if compared.returncode != 0:
    sys.exit(compared.stdout)
if renderer is None or RENDERER not in renderer.group(1):
    sys.exit(f"apitrace: that is not {RENDERER}")
