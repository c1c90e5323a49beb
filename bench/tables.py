# SPDX-License-Identifier: MIT
"""The tables of bench/compare, in Markdown."""

import fnmatch
import os
import statistics

import runs
from measuring import geometric_mean

# What the second thread is asked about.
BUSY = 2  # more than this many others that want to run, and threads say nothing
SCALED = ("fill_gouraud_depth", "texture_bilinear", "blend_16", "mesh_unlit", "mesh_eight_lights")

# Kinds of work, by the names of their scenes; the first that fits.
KINDS = {
    "flat and gouraud areas, with and without depth": ("fill_*", "layers_*"),
    "textures, blending, fragment tests": ("texture_*", "units_*", "blend*", "fog_*", "stencil", "logic_op", "tiles_*", "states_*"),
    "meshes": ("mesh_*", "model_*", "gears*"),
    "many draws, with changes of state": ("draws_*",),
    "points and lines": ("points_*", "lines_*"),
    "transfers, other surfaces, clear": ("*",),
}


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "| --- |" + " ---: |" * (len(head) - 1)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])


def number(value, digits=3):
    if value is None:
        return "-"
    return f"{value:.{max(0, digits - len(str(int(abs(value)))))}f}"


def times(value):
    return "-" if value is None else f"{value:.2f}"


def progress(measurement, scene):
    first, *others = measurement.implementations
    if scene.name in measurement.refused:
        return f"{scene.name}: refused: {measurement.refused[scene.name]}"
    words = [f"{number(measurement.median(scene.name, first, 'median_ms'))} ms"]
    words += [f"{other.name} {times(measurement.ratio(scene.name, other))}x" for other in others]
    return f"{scene.name}: " + ", ".join(words)


def scenes(measurement):
    """Milliseconds a frame and the ratio of each scene; CPU time is of all threads, first frames are from the start of the process."""
    first, *others = measurement.implementations
    head = ["scene", f"{first.name}, ms"]
    for other in others:
        head += [f"{other.name}, ms", "faster by", "CPU time, less by"]
    head += [f"first frame, ms: {first.name}"] + [other.name for other in others]
    head += [f"peak, MiB: {first.name}"] + [other.name for other in others] + ["pictures"]
    rows = []
    for name in measurement.results:
        row = [name, number(measurement.median(name, first, "median_ms"))]
        for other in others:
            ratio = measurement.ratio(name, other)
            ours, theirs = measurement.cpu(name, first), measurement.cpu(name, other)
            cpu = theirs / ours if ratio and ours and theirs else None
            row += [number(measurement.median(name, other, "median_ms")), times(ratio), times(cpu)]
        row += [number(measurement.median(name, which, "first_ms")) for which in measurement.implementations]
        for which in measurement.implementations:
            peak = measurement.median(name, which, "peak_kib")
            row.append(number(peak / 1024 if peak else None))
        row.append("**refused**: " + measurement.refused[name] if name in measurement.refused
                   else measurement.missing.get(name) or measurement.agreements.get(name, "-"))
        rows.append(row)
    return table(head, rows)


def summary(measurement):
    first, *others = measurement.implementations
    lines = []
    for other in others:
        ratios = measurement.ratios(other)
        if not ratios:
            continue
        slow = sorted((name for name in ratios if ratios[name] < 2), key=ratios.get)
        worst = min(ratios, key=ratios.get)
        lines += [f"{first.name} against {other.name}, {len(ratios)} scenes:", "",
                  f"- frames: geometric mean {geometric_mean(ratios.values()):.2f}; the worst is {worst} with {ratios[worst]:.2f}",
                  f"- CPU time of all threads: geometric mean {geometric_mean(measurement.cpu_ratios(other).values()):.2f}",
                  f"- under 2: {', '.join(f'{name} {ratios[name]:.2f}' for name in slow) or 'none'}",
                  "- from the start of the process to its first frame: geometric mean "
                  f"{geometric_mean(measurement.ratios(other, 'first_ms').values()):.2f}",
                  f"- peak memory: geometric mean {geometric_mean(measurement.ratios(other, 'peak_kib').values()):.2f}"]
        missing = [f"{name} ({what})" for name, what in measurement.missing.items()]
        if missing:
            lines.append(f"- not compared: {', '.join(missing)}")
        if measurement.refused:
            lines.append(f"- refused: {', '.join(measurement.refused)}")
        lines.append("")
    return "\n".join(lines).rstrip()


def kinds(measurement):
    """The mean and the extremes of each kind of work."""
    first, *others = measurement.implementations
    rows = []
    for other in others:
        left = measurement.ratios(other)
        for kind, patterns in KINDS.items():
            ratios = {name: left[name] for name in left if any(fnmatch.fnmatch(name, pattern) for pattern in patterns)}
            left = {name: left[name] for name in left if name not in ratios}
            if ratios:
                ends = [f"{times(ratios[name])} ({name})" for name in (min(ratios, key=ratios.get), max(ratios, key=ratios.get))]
                rows.append([kind, other.name, str(len(ratios)), times(geometric_mean(ratios.values())), *ends])
    head = ["kind of work", f"{first.name} against", "scenes", "geometric mean", "least", "most"]
    return "By kinds of work:\n\n" + table(head, rows) if rows else ""


def new_states(measurement):
    """The scene each of whose frames has a state of its own, beside the one whose frames share three."""
    if "states_new" not in measurement.results or "states_seen" not in measurement.results:
        return ""
    rows = []
    for which in measurement.implementations:
        rounds = measurement.results["states_new"].get(which.name)
        seen = measurement.median("states_seen", which, "median_ms")
        if rounds and seen:
            worst = statistics.median(r["worst_ms"] for r in rounds)
            median = statistics.median(r["median_ms"] for r in rounds)
            rows.append([which.name, number(median), number(worst), times(worst / median), number(seen), times(median / seen)])
    return "What a new state costs: `states_new` beside `states_seen`.\n\n" + table(
        ["implementation", "new: median frame, ms", "worst frame, ms (median of rounds)", "worst / median", "seen: median frame, ms",
         "new / seen"], rows)


def second_thread(measurement, chosen):
    """One thread and two of the first implementation, in turns."""
    first = measurement.implementations[0]
    wanted = [scene for scene in chosen if scene.name in SCALED]
    if not wanted or (os.cpu_count() or 1) < 2:
        return ""
    load = os.getloadavg()[0]
    if load > os.cpu_count() + BUSY:
        return f"The second thread was not measured: with a load average of {load:.1f} it has no processor of its own."
    rows = []
    for scene in wanted:
        found = {1: [], 2: []}
        for _ in range(measurement.given.rounds):
            for threads, results in found.items():
                results.append(measurement.run(first, scene, threads=threads)["median_ms"])
        one, two = (statistics.median(found[threads]) for threads in (1, 2))
        rows.append([scene.name, number(one), number(two), times(one / two)])
    # The machine's second processor may be half of the first one, or somebody else's in part.
    most = [runs.limits(measurement.given.build, 2)["arithmetic"] / runs.limits(measurement.given.build, 1)["arithmetic"]
            for _ in range(measurement.given.rounds)]
    return (f"The second thread of {first.name}. To arithmetic that needs no memory it gave {times(statistics.median(most))} in this run, "
            f"from {times(min(most))} to {times(max(most))}.\n\n") + table(["scene", "1 thread, ms", "2 threads, ms", "faster by"], rows)


def limits(measurement, chosen):
    """Bytes that must move, over what the memory of this machine can do in this run."""
    wanted = [scene for scene in chosen if scene.bytes > 0 and scene.name not in measurement.refused]
    if not wanted:
        return ""
    threads = measurement.given.threads or os.cpu_count() or 1
    speeds = {count: runs.limits(measurement.given.build, count) for count in sorted({1, threads})}
    rows = []
    for scene in wanted:
        row = [scene.name, f"{scene.bytes:g}, {scene.traffic}"]
        for which in measurement.implementations:
            milliseconds = measurement.median(scene.name, which, "median_ms")
            if milliseconds is None:
                row += ["-", "-"]
                continue
            units = measurement.median(scene.name, which, "units")
            speed = 1e-6 * units * scene.bytes / milliseconds
            row += [number(speed), f"{100 * speed / speeds[threads][scene.traffic]:.0f}%"]
        rows.append(row)
    words = "; ".join(f"{count} thread{'s' * (count > 1)}: write {s['write']:.1f}, copy {s['copy']:.1f}, update {s['update']:.1f}"
                      for count, s in speeds.items())
    head = ["scene", "bytes a unit"]
    for which in measurement.implementations:
        head += [f"{which.name}, GB/s", f"of what {threads} threads can"]
    return ("The distance to the limit: bytes that must move, over what memory does in this run, in blocks that no cache holds "
            f"(GB/s, {words}). Surfaces of this size may fit into a cache, and a clear may be noted rather than written: "
            "then more than 100% is possible.\n\n" + table(head, rows))
