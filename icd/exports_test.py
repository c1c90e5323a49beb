#!/usr/bin/env python3
"""What the shared libraries show the loader: exactly the lists of calls, and the right SONAMEs.

usage: exports_test.py SOURCE_DIR BUILD_DIR
SPDX-License-Identifier: MIT
"""
import re
import subprocess
import sys

source, build = sys.argv[1:]


def listed(path, prefix, entry=r"^(?:COMMON_)?CALL\([^,]*, (\w+),"):
    with open(f"{source}/{path}", encoding="utf-8") as lines:
        return {prefix + name for name in re.findall(entry, lines.read(), re.M)}


def exported(library):
    output = subprocess.run(["nm", "-D", "--defined-only", f"{build}/{library}"],
                            check=True, capture_output=True, text=True).stdout
    return {line.split()[-1].split("@")[0] for line in output.splitlines()}


def dynamic(library, tag):
    output = subprocess.run(["readelf", "-d", "-W", f"{build}/{library}"],
                            check=True, capture_output=True, text=True).stdout
    return re.findall(rf"\({tag}\)[^\[]*\[(.*)\]", output)


gl = listed("api/gles1.def", "gl") | listed("api/gles1_aliases.def", "gl", r"^(?:COMMON_)?ALIAS\((\w+),")
# Common-Lite: the commands of the registry that are not of the Common profile alone, and those of extensions without
# floats.
common = (listed("api/registry_names.def", "", r"^COMMON\((\w+)\)")
          | listed("api/gles1.def", "gl", r"^COMMON_CALL\([^,]*, (\w+),")
          | listed("api/gles1_aliases.def", "gl", r"^COMMON_ALIAS\((\w+),"))
fixed = listed("api/registry_names.def", "", r"^CORE\((\w+)\)")
egl = listed("icd/egl15.def", "egl")
failures = 0


def expect(what, found, wanted):
    global failures
    if found != wanted:
        failures += 1
        print(f"{what}: missing {sorted(wanted - found)}, unexpected {sorted(found - wanted)}")


if len(gl) < 140 or len(egl) < 30 or len(common) < 38 or len(fixed) != 106 or not fixed <= gl - common:
    failures += 1
    print(f"the lists were not understood: {len(gl)} gl and {len(egl)} egl names")
for library, names in {
    "icd/libEGL_clearpipe.so.0": {"__egl_Main"},
    "dropin/libEGL.so.1": egl,
    "dropin/libGLESv1_CM.so.1": gl,
    "dropin/libGLESv1_CL.so.1": gl - common,
    "dropin/libclearpipe.so.0": gl | egl,
}.items():
    expect(f"{library} exports", exported(library), names)
    expect(f"{library} SONAME", set(dynamic(library, "SONAME")), {library.split("/")[-1]})
for library in ("dropin/libEGL.so.1", "dropin/libGLESv1_CM.so.1", "dropin/libGLESv1_CL.so.1"):
    expect(f"{library} filters", set(dynamic(library, "FILTER")), {"libclearpipe.so.0"})
    expect(f"{library} looks beside itself",
           set(dynamic(library, "RUNPATH") + dynamic(library, "RPATH")), {"$ORIGIN"})
sys.exit(1 if failures else 0)
