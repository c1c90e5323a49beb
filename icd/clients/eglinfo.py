#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs `eglinfo` of the Debian package mesa-utils-bin and checks what it says: every platform that there is here opens, is EGL 1.5
of clearpipe, renders OpenGL ES 1 and nothing else, has configs of the right kinds of surfaces, and lists its extensions once each.

usage: eglinfo.py PLATFORM...    the platforms that must open: wayland, x11, surfaceless, device
"""
import re
import subprocess
import sys

TITLES = {"wayland": "Wayland platform:", "x11": "X11 platform:", "surfaceless": "Surfaceless platform:", "device": "Device platform:"}
# Those that every display has, and what platforms with windows have beside them.
EVERYWHERE = {"EGL_KHR_config_attribs", "EGL_KHR_create_context", "EGL_KHR_fence_sync", "EGL_KHR_image_base", "EGL_KHR_wait_sync",
              "EGL_KHR_get_all_proc_addresses", "EGL_KHR_no_config_context", "EGL_KHR_surfaceless_context"}
WINDOWS = {"EGL_EXT_buffer_age", "EGL_EXT_swap_buffers_with_damage", "EGL_KHR_partial_update"}
SURFACES = {"wayland": ("win,pb",), "x11": ("win,pb,pix", "win,pb"), "surfaceless": ("pb",), "device": ("pb",)}

failures = []


def expect(platform, good, text):
    if not good:
        failures.append(f"{platform}: {text}")


def indented_words(section, title):
    """The words of the indented lines below a title."""
    found = re.search(rf"^{re.escape(title)}\n((?: +.*\n)+)", section, re.M)
    return found.group(1).split() if found else []


def check(platform, section):
    opens = "eglInitialize failed" not in section
    expect(platform, opens, "eglInitialize failed")
    if not opens:
        return
    for line in ("EGL API version: 1.5", "EGL vendor string: clearpipe", "EGL client APIs: OpenGL_ES", "EGL driver name: clearpipe"):
        expect(platform, re.search(rf"^{re.escape(line)}\s*$", section, re.M), f"no line {line!r}")
    extensions = indented_words(section, "EGL extensions string:")
    expect(platform, len(extensions) == len(set(extensions)), "an extension is listed twice")
    wanted = EVERYWHERE | (WINDOWS if platform in ("wayland", "x11") else set())
    expect(platform, wanted <= set(extensions), f"without {sorted(wanted - set(extensions))}")
    configs = re.findall(r"^0x[0-9a-f]+ .*$", section, re.M)
    expect(platform, len(configs) >= 16, f"{len(configs)} configs")
    heads = re.search(r"^.* gl es es2 vg surfaces.*$", section, re.M).group(0)
    for config in configs:
        # The APIs stand in columns of their own, blank where a config does not render one.
        apis = {name: config[heads.index(f" {name} ") + 1:][:len(name)].strip() for name in ("gl", "es", "es2", "vg")}
        expect(platform, apis == {"gl": "", "es": "y", "es2": "", "vg": ""}, f"other APIs than OpenGL ES 1: {config!r}")
        # Colours of 16 bits are for pbuffers where the window system has none, or no such.
        surfaces = SURFACES[platform] + (("pb",) if config.split()[1] == "16" else ())
        expect(platform, config.split()[-1] in surfaces, f"surfaces of {config!r}")
    print(f"eglinfo: {platform}: {len(configs)} configs, {len(extensions)} extensions")


wanted_platforms = sys.argv[1:]
done = subprocess.run(["eglinfo"], capture_output=True, text=True, timeout=120, check=False)
starts = sorted((done.stdout.find(title), name) for name, title in TITLES.items())
for i, (start, name) in enumerate(starts):
    if start < 0:
        expect(name, name not in wanted_platforms, "eglinfo does not name it")
        continue
    end = starts[i + 1][0] if i + 1 < len(starts) else len(done.stdout)
    if name in wanted_platforms:
        check(name, done.stdout[start:end])
expect("eglinfo", "EGL_MESA_platform_surfaceless" in indented_words(done.stdout, "EGL client extensions string:"), "no client extensions")
if failures or not wanted_platforms:
    sys.exit("\n".join(failures + ["", done.stdout, done.stderr]))
