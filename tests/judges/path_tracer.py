#!/usr/bin/env python3
"""A path tracer's picture of an exported cloud beside ours: both as PNG, side by side.

Run by hand in the project's root; PyPI has Mitsuba 3 ready:

    python3 -m venv venv && venv/bin/pip install mitsuba pillow
    venv/bin/python tests/judges/path_tracer.py PROGRAM SCENE OUT_FOLDER [--spp 64] [--width 320] [--set voxel_m=12] …

It exports SCENE as Mitsuba volumes, has Mitsuba (scalar_rgb) render the scene that is written with them, as it is, and
lets PROGRAM render the same camera. OUT_FOLDER/volume.png has ours on the left and Mitsuba's on the right. It prints how
long each took, and the mean colours of both.
"""

import argparse
import subprocess
import time
from pathlib import Path

import mitsuba as mi
import numpy
from PIL import Image

parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
parser.add_argument("program")
parser.add_argument("scene", type=Path)
parser.add_argument("out", type=Path)
parser.add_argument("--spp", type=int, default=64)
parser.add_argument("--width", type=int, default=320)
parser.add_argument("--set", action="append", default=[])
arguments = parser.parse_args()
width, height = arguments.width, arguments.width * 9 // 16
arguments.out.mkdir(parents=True, exist_ok=True)


def run(*words):
    start = time.monotonic()
    subprocess.run([arguments.program, *map(str, words)], check=True)
    print(f"{words[0]}: {time.monotonic() - start:.1f} s")


volume = arguments.out / "clouds.vol"
options = [word for option in arguments.set for word in ("--set", option)]
run("export", arguments.scene, "-o", volume, *options)
ours = arguments.out / "ours.png"
run("render", arguments.scene, "-o", ours, "--size", f"{width}x{height}")

mi.set_variant("scalar_rgb")
start = time.monotonic()
scene = mi.load_file(str(volume.with_suffix(".xml")), width=width, height=height, spp=arguments.spp)
linear = numpy.array(mi.render(scene))[..., :3]
print(f"mitsuba: {time.monotonic() - start:.1f} s for {arguments.spp} samples a pixel")
tone = mi.Bitmap(linear).convert(mi.Bitmap.PixelFormat.RGB, mi.Struct.Type.UInt8, srgb_gamma=True)
theirs = numpy.array(tone)

left = numpy.asarray(Image.open(ours).convert("RGB"))
Image.fromarray(numpy.concatenate([left, theirs], axis=1)).save(arguments.out / "volume.png", optimize=True)
print(f"mean colours: ours {left.mean(axis=(0, 1)).round()}, Mitsuba's {theirs.mean(axis=(0, 1)).round()}")
