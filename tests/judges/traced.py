#!/usr/bin/env python3
"""Our own path tracer, which light is fitted to, against Mitsuba's on the same volume by the sun alone.

Run by hand in the project's root; PyPI has Mitsuba 3 ready:

    cargo build --release --workspace --bins
    python3 -m venv venv && venv/bin/pip install mitsuba
    venv/bin/python tests/judges/traced.py target/release OUT_FOLDER [--spp 64] [--width 128] [SCENE:CAMERA:HOUR …]

For each view it exports the scene as Mitsuba volumes and has Mitsuba (scalar_rgb) render them with Henyey and Greenstein's
g = .85, no sky and no end to scattering. It prints both means over the cloud, how blocks of 8 x 8 pixels that are mostly
cloud go together as a correlation, and the root of the mean square of their difference as a share of the mean; for these, one in
a hundred pixels, the brightest, are cut to what the others keep. Mitsuba interpolates between voxels
where ours are even, so the two clouds are not quite the same. It fails if the means differ by more than 8 % or the correlation
is below .9.
"""

import argparse
import json
import subprocess
import sys
from pathlib import Path

import mitsuba as mi
import numpy

VIEWS = ["single_cumulus:main:10", "single_cumulus:main:18", "single_cumulus:east:20"]
BLOCK = 8
LONGEST = 128

parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
parser.add_argument("programs", type=Path)
parser.add_argument("out", type=Path)
parser.add_argument("views", nargs="*", default=VIEWS)
parser.add_argument("--spp", type=int, default=64)
parser.add_argument("--width", type=int, default=128)
arguments = parser.parse_args()
width, height = arguments.width, arguments.width * 9 // 16
arguments.out.mkdir(parents=True, exist_ok=True)
mi.set_variant("scalar_rgb")


def value_after(text, mark):
    """What stands after `mark` up to the next quote: from where to where."""
    begin = text.index(mark) + len(mark)
    return begin, text.index('"', begin)


def theirs(name, scene, camera, hour):
    """Of the sun alone, where a white, matt card that faces it has a radiance of 1."""
    volume = arguments.out / f"{name}.vol"
    words = ["export", scene, "-o", volume, "--camera", camera, "--time", f"{hour}:00", "--set", f"longest={LONGEST}"]
    subprocess.run([arguments.programs / "cloudwright", *map(str, words)], check=True, stderr=subprocess.DEVNULL)
    file = volume.with_suffix(".xml")
    text = file.read_text()
    for mark, value in [
        ('<rgb name="irradiance" value="', " ".join(3 * [str(numpy.pi)])),
        ('<rgb name="radiance" value="', "0 0 0"),
        ('name="max_depth" value="', "-1"),
    ]:
        begin, end = value_after(text, mark)
        text = text[:begin] + value + text[end:]
    file.write_text(text)
    scene = mi.load_file(str(file), width=width, height=height, spp=arguments.spp, g=0.85)
    return numpy.array(mi.render(scene))[..., 0]


def ours(scene, camera, hour):
    words = [scene, camera, hour, width, height, arguments.spp, LONGEST]
    ran = subprocess.run([arguments.programs / "traced", *map(str, words)], check=True, capture_output=True)
    answer = json.loads(ran.stdout)
    return [numpy.array(answer[plane]).reshape(height, width) for plane in ("sun", "alpha")]


def blocks(values):
    rows, columns = height // BLOCK, width // BLOCK
    return values[: rows * BLOCK, : columns * BLOCK].reshape(rows, BLOCK, columns, BLOCK).mean(axis=(1, 3))


failed = False
for view in arguments.views:
    scene_name, camera, hour = view.split(":", 2)
    scene = Path(f"assets/scenes/{scene_name}.cloudscene")
    wanted = theirs(f"{scene_name}_{camera}_{hour}", scene, camera, hour)
    sun, alpha = ours(scene, camera, hour)
    means = [light.sum() / alpha.sum() for light in (sun, wanted)]
    sun, wanted = [numpy.minimum(light, numpy.quantile(light, 0.99)) for light in (sun, wanted)]
    solid = blocks(alpha) >= 0.9
    a, b = blocks(sun)[solid], blocks(wanted)[solid]
    together = numpy.corrcoef(a, b)[0, 1]
    off = numpy.sqrt(((a - b) ** 2).mean()) / b.mean()
    print(f"{view:26} mean {means[0]:.4f}, Mitsuba's {means[1]:.4f}; {solid.sum()} blocks: {together:.3f}, off by {100 * off:.1f} %")
    failed |= bool(abs(means[0] / means[1] - 1) > 0.08 or together < 0.9)
sys.exit(failed)
