# SPDX-License-Identifier: MIT
"""Runs bench/scenes on an implementation and reads what it prints. For bench/compare and the scripts that draw pictures of it."""

import atexit
import dataclasses
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
MESA_MANIFEST = os.environ.get("MESA_MANIFEST", "/usr/share/glvnd/egl_vendor.d/50_mesa.json")
MESA_DRIVERS = ("llvmpipe", "softpipe")


class Refused(Exception):
    """An implementation that lacks what a scene needs."""


@dataclasses.dataclass
class Scene:
    name: str
    unit: str
    window: bool
    amount: int
    extension: str
    bytes: float
    traffic: str
    share: float
    what: str


@dataclasses.dataclass
class Implementation:
    """One of Mesa's drivers by its name; otherwise clearpipe, by its manifest."""

    name: str
    manifest: Path | None

    @property
    def is_mesa(self):
        return self.name in MESA_DRIVERS

    def environment(self, threads, window):
        environment = {k: v for k, v in os.environ.items() if k not in ("EGL_PLATFORM", "WAYLAND_DISPLAY")}
        if self.is_mesa:
            environment.update(LIBGL_ALWAYS_SOFTWARE="1", GALLIUM_DRIVER=self.name, __EGL_VENDOR_LIBRARY_FILENAMES=MESA_MANIFEST)
            # Mesa's driver is unloaded before LeakSanitizer can tell its memory from the program's.
            environment["ASAN_OPTIONS"] = "detect_leaks=0"
            if not window:
                environment["EGL_PLATFORM"] = "surfaceless"
            if threads:
                # llvmpipe's threads work beside the application's; with none, the application's does all.
                environment["LP_NUM_THREADS"] = str(threads if threads > 1 else 0)
        else:
            environment["__EGL_VENDOR_LIBRARY_FILENAMES"] = str(self.manifest)
            if threads:
                environment["CLEARPIPE_THREADS"] = str(threads)
        return environment


def install(manifest):
    """Copies a build's library, as installing it does: where the linker put the pages of the file it wrote decides up to 30% of some
    scenes, and no installation has these. Returns the manifest of the copy, which stays until the program ends."""
    folder = Path(tempfile.mkdtemp())
    atexit.register(shutil.rmtree, folder)
    fields = json.loads(manifest.read_text())
    library = Path(fields["ICD"]["library_path"])
    fields["ICD"]["library_path"] = str(shutil.copy(library, folder / library.name))
    copied = folder / manifest.name
    copied.write_text(json.dumps(fields))
    return copied


def implementation(text, build):
    """NAME or NAME=BUILD-FOLDER."""
    name, _, folder = text.partition("=")
    if name in MESA_DRIVERS:
        return Implementation(name, None)
    manifest = Path(folder or build).resolve() / "icd" / "clearpipe_icd.json"
    if not manifest.exists():
        sys.exit(f"there is no {manifest}: build first")
    return Implementation(name, install(manifest))


def list_scenes(build):
    done = subprocess.run([build / "bench" / "scenes", "--list"], capture_output=True, text=True, check=True)
    scenes = []
    for line in done.stdout.splitlines():
        name, unit, window, amount, extension, count, traffic, share, what = line.split("\t")
        scenes.append(Scene(name, unit, window != "-", int(amount), extension, float(count), traffic, float(share), what))
    return scenes


def run(build, which, scene, *words, threads=0, extra=None):
    """The fields of one run, as numbers where they are some; raises Refused when the implementation lacks an extension."""
    environment = which.environment(threads, scene.window) | (extra or {})
    environment["BENCH_NOTE_START"] = "1"
    done = subprocess.run([build / "bench" / "scenes", "--scene", scene.name, *map(str, words)], capture_output=True, text=True,
                          env=environment)
    renderer = re.search(r'renderer="(.*)"', done.stdout)
    missing = re.search(r"missing=(\S+)", done.stdout)
    if missing:
        raise Refused(f"{which.name} has no {missing[1]}")
    if done.returncode != 0 or not renderer:
        sys.exit(f"bench: {scene.name} on {which.name} failed ({done.returncode}):\n{done.stdout}{done.stderr}")
    drawn_by = [name for name in MESA_DRIVERS if name in renderer[1]]
    if drawn_by != ([which.name] if which.is_mesa else []):
        sys.exit(f"bench: {which.name} was asked for, but {renderer[1]} drew")
    fields = {}
    for key, value in re.findall(r"(\w+)=([^\s\"]+)", done.stdout.split("renderer=")[0]):
        try:
            fields[key] = float(value)
        except ValueError:
            fields[key] = value
    times = re.search(r"^times:(.*)$", done.stdout, re.M)
    if times:
        fields["times"] = [float(t) for t in times[1].split()]
    return fields


def compare_pictures(build, ours, theirs, share):
    return subprocess.run([build / "bench" / "agree", ours, theirs, str(share)], capture_output=True, text=True)


def agreement(build, ours, theirs, share):
    """Whether two pictures are of the same, and how they agree, in words."""
    done = compare_pictures(build, ours, theirs, share)
    fields = dict(re.findall(r"(\w+)=(\S+)", done.stdout))
    if not fields:
        return False, done.stdout.strip() or done.stderr.strip()
    return done.returncode == 0, f"{100 * float(fields['near']):.2f}% within 2/255"


def limits(build, threads):
    """What the machine can do: GB/s by kind of traffic, and `arithmetic` in thousand millions of operations a second."""
    done = subprocess.run([build / "bench" / "limits", str(threads)], capture_output=True, text=True, check=True)
    return {key: float(value) for key, value in re.findall(r"(\w+)_g(?:b)?=(\S+)", done.stdout)}
