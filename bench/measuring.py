# SPDX-License-Identifier: MIT
"""Rounds of scenes on several implementations in turns, for bench/compare."""

import math
import statistics
from pathlib import Path

import runs


class Measurement:
    """What was measured: results[scene name][implementation name] is the list of its rounds' fields."""

    def __init__(self, given, implementations, folder):
        self.given = given
        self.implementations = implementations
        self.folder = Path(folder)
        self.scenes = {}
        self.results = {}
        self.agreements = {}
        self.refused = {}  # scene name -> how the pictures differ
        self.missing = {}  # scene name -> what an implementation lacks

    def take(self, scene):
        """All rounds of a scene; pictures are taken in the first, after its frames are measured."""
        self.scenes[scene.name] = scene
        rounds = self.results[scene.name] = {which.name: [] for which in self.implementations}
        for turn in range(self.given.rounds):
            for which in self.implementations:
                if which.name not in rounds:
                    continue
                words = ["--image", self.picture(scene, which)] if turn == 0 else []
                try:
                    rounds[which.name].append(self.run(which, scene, *words))
                except runs.Refused as missing:
                    self.missing[scene.name] = str(missing)
                    del rounds[which.name]
            if turn == 0 and not self.agree(scene, rounds):
                return

    def run(self, which, scene, *words, threads=None):
        return runs.run(self.given.build, which, scene, "--size", self.given.size, "--seconds", self.given.seconds, *words,
                        threads=self.given.threads if threads is None else threads)

    def picture(self, scene, which):
        return self.folder / f"{scene.name}-{which.name}.png"

    def agree(self, scene, rounds):
        first, *others = [which for which in self.implementations if which.name in rounds]
        for other in others:
            good, words = runs.agreement(self.given.build, self.picture(scene, first), self.picture(scene, other), scene.share)
            self.agreements[scene.name] = words
            if not good:
                self.refused[scene.name] = f"{words} of {other.name}; {100 * scene.share:g}% are asked for"
                return False
        return True

    def median(self, scene_name, which, field):
        """None where there is nothing to take it of."""
        rounds = self.results[scene_name].get(which.name)
        return statistics.median(r[field] for r in rounds) if rounds else None

    def cpu(self, scene_name, which):
        rounds = self.results[scene_name].get(which.name)
        return statistics.median(r["user_ms"] + r["sys_ms"] for r in rounds) if rounds else None

    def ratio(self, scene_name, other, field="median_ms"):
        """How many times less the first implementation takes than the other; None for what was refused or is missing."""
        if scene_name in self.refused:
            return None
        ours, theirs = (self.median(scene_name, which, field) for which in (self.implementations[0], other))
        return theirs / ours if ours and theirs else None

    def cpu_ratios(self, other):
        """The same of CPU time, which what the machine does besides disturbs less."""
        found = {}
        for name in self.ratios(other):
            ours, theirs = self.cpu(name, self.implementations[0]), self.cpu(name, other)
            if ours and theirs:
                found[name] = theirs / ours
        return found

    def ratios(self, other, field="median_ms"):
        found = {name: self.ratio(name, other, field) for name in self.results}
        return {name: ratio for name, ratio in found.items() if ratio is not None}


def geometric_mean(values):
    return math.exp(statistics.fmean(math.log(value) for value in values))
