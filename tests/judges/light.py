#!/usr/bin/env python3
"""How near the light on our sprites comes to a path tracer's on the same clouds: block by block, at several suns.

Run by hand in the project's root; PyPI has Mitsuba 3 ready:

    python3 -m venv venv && venv/bin/pip install mitsuba pillow
    venv/bin/python tests/judges/light.py PROGRAM OUT_FOLDER [--spp 24] [--width 192] [SCENE:CAMERA:HH:MM …]

For each view it exports the scene's first cloud as Mitsuba volumes, has Mitsuba (scalar_rgb) render them with light that is scattered
forward (Henyey and Greenstein's g = .85, no absorption), from a sun that gives 20 times what the sky does, and lets PROGRAM
draw the same with self-shadow 0, with the scene's own, and with 1. It prints how the mean luminance of blocks of 8 x 8 pixels
that are all cloud goes with Mitsuba's, as a correlation: that of the sun's layer of light by itself, and of all light; and
the light of the brightest tenth of blocks over that of the darkest. Single pixels of Mitsuba's that a rare path made glow are
cut to what 99 of 100 keep. What Mitsuba has drawn is kept in OUT_FOLDER and used again.
"""

import argparse
import json
import subprocess
import time
from pathlib import Path

import mitsuba as mi
import numpy

VIEWS = [
    "single_cumulus:main:10:00", "single_cumulus:main:18:00", "single_cumulus:east:20:00",
    "fair_weather:main:10:00", "fair_weather:main:18:00", "fair_weather:main:20:00",
    "cumulonimbus_dusk:main:15:00", "cumulonimbus_dusk:main:19:30", "cumulonimbus_dusk:sunward:20:00",
]
BLOCK = 8
LUMINANCE = numpy.array([0.2126, 0.7152, 0.0722])

parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
parser.add_argument("program")
parser.add_argument("out", type=Path)
parser.add_argument("views", nargs="*", default=VIEWS)
parser.add_argument("--spp", type=int, default=24)
parser.add_argument("--width", type=int, default=192)
arguments = parser.parse_args()
width, height = arguments.width, arguments.width * 9 // 16
arguments.out.mkdir(parents=True, exist_ok=True)
mi.set_variant("scalar_rgb")


def run(*words):
    subprocess.run([arguments.program, *map(str, words)], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def first_cloud(scene):
    """The scene with one cloud: its first, which its cameras are made for."""
    scene["scene"]["clouds"] = scene["scene"]["clouds"][:1]
    scene["scene"]["tracks"] = []
    return scene


def traced(name, scene_file, camera, hour):
    """Linear luminance of Mitsuba's picture."""
    kept = arguments.out / f"{name}.npy"
    if kept.exists():
        return numpy.load(kept)
    volume = arguments.out / f"{name}.vol"
    run("export", scene_file, "-o", volume, "--camera", camera, "--time", hour)
    text = volume.with_suffix(".xml").read_text()
    begin = text.index('<rgb name="irradiance" value="') + len('<rgb name="irradiance" value="')
    sun = numpy.array([float(part) for part in text[begin:text.index('"', begin)].split()])
    sky = float(sun @ LUMINANCE) / 20 / numpy.pi
    begin = text.index('<rgb name="radiance" value="') + len('<rgb name="radiance" value="')
    text = text[:begin] + f"{sky} {sky} {sky}" + text[text.index('"', begin):]
    volume.with_suffix(".xml").write_text(text)
    start = time.monotonic()
    scene = mi.load_file(str(volume.with_suffix(".xml")), width=width, height=height, spp=arguments.spp, g=0.85)
    linear = numpy.array(mi.render(scene))[..., :3]
    print(f"{name}: Mitsuba took {time.monotonic() - start:.0f} s", flush=True)
    luminance = linear @ LUMINANCE
    luminance = numpy.minimum(luminance, numpy.quantile(luminance, 0.99))
    numpy.save(kept, luminance)
    return luminance


def ours(name, scene_file, camera, hour):
    """Linear luminance of the sun's light on our clouds, before haze, and of all light; their opacity."""
    picture = arguments.out / f"{name}.exr"
    run("render", scene_file, "-o", picture, "--layers", "--camera", camera, "--time", hour, "--size", f"{width}x{height}", "--renderer", "cpu")
    bitmap = mi.Bitmap(str(picture))
    names = [field.name for field in bitmap.struct_()]
    data = numpy.array(bitmap).astype(float)
    layer = lambda wanted: data[..., names.index(wanted)]
    alpha = layer("alpha.A")
    of = lambda light: sum(layer(f"{light}.{channel}") * share for channel, share in zip("RGB", LUMINANCE))
    return of("directional"), of("directional") + of("ambient"), alpha


def blocks(values):
    rows, columns = height // BLOCK, width // BLOCK
    return values[: rows * BLOCK, : columns * BLOCK].reshape(rows, BLOCK, columns, BLOCK).mean(axis=(1, 3))


def contrast(values):
    low, high = numpy.quantile(values, [0.1, 0.9])
    return values[values >= high].mean() / values[values <= low].mean()


print(f"{'view':34} {'blocks':>6}  of the sun's light, with self-shadow 0, the scene's, 1; of all   brightest : darkest, traced; ours")
for view in arguments.views:
    scene_name, camera, hour = view.split(":", 2)
    name = f"{scene_name}_{camera}_{hour.replace(':', '')}"
    scene = first_cloud(json.loads(Path(f"assets/scenes/{scene_name}.cloudscene").read_text()))
    files = []
    for share in (0, None, 1):
        for model in scene["scene"]["models"]:
            model["self_shadow"] = model.get("self_shadow", 0) if share is None else share
        if share is None:
            scene = first_cloud(json.loads(Path(f"assets/scenes/{scene_name}.cloudscene").read_text()))
        file = arguments.out / f"{name}_{len(files)}.cloudscene"
        file.write_text(json.dumps(scene))
        files.append(file)
    theirs = blocks(traced(name, files[0], camera, hour))
    pictures = [ours(f"{name}_{index}", file, camera, hour) for index, file in enumerate(files)]
    solid = blocks((pictures[0][2] > 0.98).astype(float)) >= 1.0
    goes_with = lambda light: numpy.corrcoef(blocks(light)[solid], theirs[solid])[0, 1]
    told = ["  ".join(f"{goes_with(picture[layer]):.3f}" for picture in pictures) for layer in (0, 1)]
    contrasts = "  ".join(f"{contrast(blocks(picture[0])[solid]):.2f}" for picture in pictures)
    print(f"{view:34} {solid.sum():6}  {told[0]};  {told[1]};  {contrast(theirs[solid]):.2f};  {contrasts}", flush=True)
