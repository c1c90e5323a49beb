#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Tests over all scenes of bench/scenes, small: two frames of each, and a twentieth of its triangles, draws, ...

  scenes_test.py BUILD mesa                     each picture is Mesa's, as far as the scene asks, and is not blank
  scenes_test.py BUILD same VARIABLE=VALUE[,VARIABLE=VALUE...]...
                                                each picture is the same, byte for byte, with each of these settings of clearpipe
  scenes_test.py BUILD allocations              a frame that is like the one before asks for no memory
  scenes_test.py BUILD count                    CLEARPIPE_COUNT counts the pixels that were drawn
"""

import concurrent.futures
import pathlib
import re
import sys
import tempfile

import runs

SIZE = "320x240"  # smaller pictures are nothing but edges
BLANK = ("clear", "fill_flat", "fill_flat_depth")  # of one colour by design


def small(scene):
    """The words for a short run; what shows the cost of states needs its own number of draws."""
    amount = ["--amount", max(scene.amount // 20, 9)] if scene.amount > 1000 else []
    return ["--size", SIZE, "--frames", 1, *amount]


def draw(build, which, scene, picture, extra=None):
    return runs.run(build, which, scene, *small(scene), "--image", picture, extra=extra)


def is_blank(build, picture):
    return "colours=1\n" in runs.compare_pictures(build, picture, picture, 1).stdout


def agrees(build, folder, scene):
    """A line on how clearpipe's picture agrees with Mesa's, and whether it does."""
    pictures = [folder / f"{scene.name}-{name}.png" for name in ("clearpipe", "llvmpipe")]
    ours, mesa = (runs.implementation(name, build) for name in ("clearpipe", "llvmpipe"))
    draw(build, ours, scene, pictures[0])
    if scene.name not in BLANK and is_blank(build, pictures[0]):
        return f"{scene.name} is of one colour", False
    try:
        draw(build, mesa, scene, pictures[1])
    except runs.Refused as missing:
        return f"{scene.name}: {missing}", True
    good, words = runs.agreement(build, *pictures, scene.share)
    return f"{scene.name}: {words}, {100 * scene.share:g}% are asked for", good


def test_mesa(build, folder):
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        results = list(pool.map(lambda scene: agrees(build, folder, scene), runs.list_scenes(build)))
    print("\n".join(line for line, _ in results))
    return [line for line, good in results if not good]


def same(build, folder, scene, settings):
    """The settings with which the scene's picture is another."""
    ours = runs.implementation("clearpipe", build)
    picture = folder / f"{scene.name}.png"
    draw(build, ours, scene, picture)
    expected = picture.read_bytes()
    failed = []
    for setting in settings:
        picture.unlink()
        draw(build, ours, scene, picture, dict(pair.split("=") for pair in setting.split(",")))
        if picture.read_bytes() != expected:
            failed.append(f"{scene.name} with {setting}")
    return failed


def test_same(build, folder, settings):
    scenes = [scene for scene in runs.list_scenes(build) if not scene.window]
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        return sum(pool.map(lambda scene: same(build, folder, scene, settings), scenes), [])


def test_count(build, folder):
    """Two warm-up frames, the first, one that is measured: four frames of one rectangle over all."""
    table = folder / "table"
    scene = next(scene for scene in runs.list_scenes(build) if scene.name == "fill_gouraud")
    runs.run(build, runs.implementation("clearpipe", build), scene, "--size", SIZE, "--frames", 1, extra={"CLEARPIPE_COUNT": str(table)})
    counted = [int(pixels) for pixels in re.findall(r"^usage: (\d+) pixels +\S+% \w+: .*interpolate_colour", table.read_text(), re.M)]
    return [] if counted == [4 * 320 * 240] else [f"{counted} pixels were counted:\n{table.read_text()}"]


def test_allocations(build, folder):
    ours = runs.implementation("clearpipe", build)
    preload = {"LD_PRELOAD": str(build / "bench" / "libbench_allocations.so")}
    failed = []
    for scene in runs.list_scenes(build):
        if scene.window:
            continue
        count = runs.run(build, ours, scene, *small(scene), extra=preload)["allocations"]
        print(f"{scene.name}: {count:.0f}")
        if count != 0:
            failed.append(f"{scene.name}: {count:.0f} allocations in a steady frame")
    return failed


def main():
    build, what, *settings = sys.argv[1:]
    build = pathlib.Path(build)
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        tests = {"mesa": test_mesa, "count": test_count, "allocations": test_allocations, "same": lambda *where: test_same(*where, settings)}
        failed = tests[what](build, folder)
    if failed:
        sys.exit("scenes_test: " + "\n".join(failed))
    print("all scenes passed")


if __name__ == "__main__":
    main()
