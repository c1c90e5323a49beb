#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""clearpipe-validate on programs that are right and on programs that are wrong on purpose: what it compares, what it says, and its
exit status.

  validate_test.py --build FOLDER [--window]    with a display: programs with windows, else those without
"""
import argparse
import json
import os
import pathlib
import subprocess
import tempfile
import unittest


class Validate(unittest.TestCase):
    """Runs clearpipe-validate in a scratch folder."""

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)
        self.report = self.folder / "report.html"

    def validate(self, *options, program):
        command = [BUILD / "tools" / "clearpipe-validate", "--report", self.report, *options, "--", *program]
        return subprocess.run([str(word) for word in command], capture_output=True, text=True, timeout=100, check=False)

    def judge(self, *options, program):
        done = self.validate("--json", *options, program=program)
        self.assertTrue(done.stdout, done.stderr)
        result = json.loads(done.stdout)
        self.assertEqual(result["status"], done.returncode)
        self.assertIn("<html", self.report.read_text())
        return result

    def frames(self, result):
        return [frame["frame"] for frame in result["frames"]]

    def assert_says(self, result, *texts):
        for text in texts:
            self.assertTrue(any(text in message for message in result["messages"]), f"{text!r} is not in {result['messages']}")


def offscreen(mode):
    return [BUILD / "tools" / "validate" / "offscreen", mode]


class Offscreen(Validate):
    def test_gears(self):
        result = self.judge("--frames", "1,10", program=[BUILD / "examples" / "gears", "--frames", "100", "--size", "200x150"])
        self.assertEqual((result["status"], self.frames(result), result["messages"]), (0, [1, 10], []))
        self.assertIn("llvmpipe", result["mesa"]["renderer"])
        self.assertIn("clearpipe", result["clearpipe"]["renderer"])
        self.assertEqual((result["frames"][0]["width"], result["frames"][0]["height"]), (200, 150))
        self.assertEqual(result["clearpipe"]["frames"], 10, "the program is ended after the last frame")

    def test_functions_by_lookup_and_every(self):
        result = self.judge("--every", "2", program=offscreen("swap"))
        self.assertEqual((result["status"], self.frames(result)), (0, [2, 4, 6]))

    def test_ends_of_frames_without_swaps(self):
        for mode in ("finish", "read"):
            result = self.judge("--every", "1", program=offscreen(mode))
            self.assertEqual((result["status"], self.frames(result)), (0, [1, 2, 3, 4, 5, 6]))

    def test_difference(self):
        result = self.judge("--frames", "1,3", program=offscreen("differs"))
        self.assertEqual(result["status"], 1)
        self.assertFalse(result["frames"][0]["within_tolerance"])
        self.assertEqual(result["frames"][0]["largest"], 255)
        self.assertEqual(result["messages"], [])
        self.assertEqual(self.judge("--frames", "1", "--tolerance", "255", program=offscreen("differs"))["status"], 0)
        self.assertEqual(self.judge("--frames", "1", "--share", "10", program=offscreen("differs"))["status"], 0)

    def test_time_dependent(self):
        result = self.judge("--every", "1", "--share", "100", program=offscreen("clock"))
        self.assertEqual(result["status"], 1)
        self.assert_says(result, "two runs on Mesa differ too", "--fixed-clock")
        result = self.judge("--every", "1", "--share", "100", "--fixed-clock", "50", program=offscreen("clock"))
        self.assertEqual((result["status"], len(result["frames"]), result["messages"]), (0, 6, []))

    def test_undefined_texture(self):
        result = self.judge("--frames", "2", program=offscreen("undefined"))
        self.assert_says(result, "clearpipe: frame 1 uses texture 1", "Mesa: frame 1 uses texture 1", "3.7.1")

    def test_crash(self):
        result = self.judge("--frames", "1,2,10", program=offscreen("crash"))
        self.assertEqual((result["status"], self.frames(result)), (2, [1, 2]))
        self.assert_says(result, "Mesa: the program was killed by signal 6 (Aborted) after 3 frames",
                         "clearpipe: the program was killed by signal 6 (Aborted) after 3 frames")

    def test_never_swaps(self):
        result = self.judge(program=offscreen("never"))
        self.assertEqual((result["status"], result["frames"]), (2, []))
        self.assert_says(result, "no frame was drawn", "never called eglSwapBuffers", "end of the program")
        self.assertEqual(self.judge(program=offscreen("no-egl"))["status"], 2)

    def test_too_few_frames(self):
        result = self.judge("--frames", "100", program=offscreen("swap"))
        self.assertEqual(result["status"], 2)
        self.assert_says(result, "6 frames", "before the first that was asked for")

    def test_endless(self):
        result = self.judge("--every", "1000000", "--timeout", "1", program=offscreen("endless"))
        self.assertEqual(result["status"], 2)
        self.assert_says(result, "was ended after 1 seconds")

    def test_scripts_that_start_the_program(self):
        script = self.folder / "start"
        script.write_text(f"#!/bin/sh\n{' '.join(map(str, offscreen('swap')))}\n")
        script.chmod(0o755)
        result = self.judge("--frames", "1,6", program=[script])
        self.assertEqual((result["status"], self.frames(result)), (0, [1, 6]))

    def test_what_cannot_be_run(self):
        done = self.validate(program=["/nowhere/program"])
        self.assertEqual(done.returncode, 2)
        self.assertIn("/nowhere/program: No such file", done.stderr)
        done = self.validate("--frames", "x", program=["true"])
        self.assertEqual(done.returncode, 2)
        self.assertIn("--frames does not take x", done.stderr)

    def test_text(self):
        done = self.validate("--frames", "1", program=offscreen("swap"))
        self.assertRegex(done.stdout, r"^frame 1: equal 100.00%")
        self.assertEqual(done.returncode, 0)


class Window(Validate):
    def setUp(self):
        super().setUp()
        self.program = [BUILD / "tools" / "validate" / "sdl_window"]

    def test_sdl(self):
        result = self.judge("--frames", "1,5,20", "--fixed-clock", "60", program=self.program)
        self.assertEqual((result["status"], self.frames(result), result["messages"]), (0, [1, 5, 20], []))
        self.assertEqual((result["frames"][0]["width"], result["frames"][0]["height"]), (160, 120))

    def test_replay_of_a_trace(self):
        trace = self.folder / "window.trace"
        environment = {**os.environ, "__EGL_VENDOR_LIBRARY_FILENAMES": "/usr/share/glvnd/egl_vendor.d/50_mesa.json"}
        with subprocess.Popen(["apitrace", "trace", "--api", "egl", "--output", str(trace), *map(str, self.program)],
                              env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as tracing:
            self.assertEqual(tracing.wait(timeout=90), 0)
        # Its other ways to a window are not EGL. It resizes the window in the first frame, which Mesa notices in the second.
        result = self.judge("--frames", "2,5,20", program=["env", "WAFFLE_PLATFORM=x11_egl", "eglretrace", trace])
        self.assertEqual((result["status"], self.frames(result)), (0, [2, 5, 20]), result["messages"])


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--build", type=pathlib.Path, required=True)
    parser.add_argument("--window", action="store_true")
    given = parser.parse_args()
    BUILD = given.build.resolve()
    unittest.main(argv=["validate_test", "Window" if given.window else "Offscreen"], verbosity=2)
