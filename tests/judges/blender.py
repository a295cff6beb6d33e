"""What Blender reads of exported scenes: clouds, sprites, cameras and what moves, against what the scene has. In OUT_FOLDER
tests/judges.sh has put the exports. With --picture, Cycles draws what the scene's first camera sees of the .usda, as
OUT_FOLDER/NAME-blender.png.
usage: python blender.py OUT_FOLDER [--picture] NAME...

    python3.11 -m venv VENV && VENV/bin/pip install "bpy==5.0.1" "numpy<2"      (374 MB)
"""

import json
import sys
from pathlib import Path

import bpy


def fresh():
    bpy.ops.wm.read_factory_settings(use_empty=True)


def cameras():
    return [thing for thing in bpy.data.objects if thing.type == "CAMERA"]


def moving(thing):
    """Whether it has keys, or is read from a file at each frame."""
    data = thing.animation_data
    return bool(data and data.action) or any(each.type == "TRANSFORM_CACHE" for each in thing.constraints)


def meshes():
    return [thing for thing in bpy.data.objects if thing.type == "MESH"]


def quads_as_drawn():
    """Faces of all that is drawn, instances included."""
    graph = bpy.context.evaluated_depsgraph_get()
    return sum(len(each.object.data.polygons) for each in graph.object_instances if each.object.type == "MESH")


def judge(out, name, picture):
    info = json.loads((out / f"{name}.info.json").read_text())
    wanted = {
        "sprites": info["total"]["sprites"],
        "clouds": sum(1 for cloud in info["clouds"] if cloud["sprites"]),
        "cameras": len(info["cameras"]) + len(info["paths"]),
    }
    faults = 0
    for ending in ("-plain-no.glb", "-plain-yes.glb", ".usda"):
        fresh()
        path = str(out / f"{name}{ending}")
        if ending.endswith("glb"):
            bpy.ops.import_scene.gltf(filepath=path)
            # Quads come as two triangles, each an instance's or a mesh's.
            got = {"sprites": quads_as_drawn() // 2}
            tops = [each for each in bpy.data.objects if each.parent is None and each.users_scene]
            got["clouds"] = sum(1 for each in tops if each.type in ("EMPTY", "MESH"))
        else:
            bpy.ops.wm.usd_import(filepath=path)
            got = {"sprites": sum(len(each.data.polygons) for each in meshes()), "clouds": len(meshes())}
        got["cameras"] = len(cameras())
        lights = sum(1 for each in bpy.data.objects if each.type == "LIGHT")
        moves = sum(1 for each in bpy.data.objects if moving(each))
        frames = (bpy.context.scene.frame_start, bpy.context.scene.frame_end, bpy.context.scene.render.fps)
        bad = {what: wanted[what] for what in wanted if got[what] != wanted[what]}
        faults += len(bad)
        print(f"{name}{ending}: {got}, {lights} lights, {moves} that move, frames {frames}"
              + (f" instead of {bad}" if bad else ""))
    if picture:
        draw(str(out / f"{name}-blender.png"), info["cameras"][0])
    return faults


def draw(path, camera):
    scene = bpy.context.scene
    scene.camera = next(each for each in cameras() if each.name.replace("_", " ") == camera.replace("_", " "))
    scene.render.engine = "CYCLES"
    scene.cycles.samples = 16
    scene.cycles.transparent_max_bounces = 256
    scene.view_settings.view_transform = "Standard"
    scene.render.resolution_x, scene.render.resolution_y = 640, 360
    scene.render.filepath = path
    bpy.ops.render.render(write_still=True)


folder, *names = sys.argv[1:]
wants_picture = "--picture" in names
names = [each for each in names if each != "--picture"]
sys.exit(1 if sum(judge(Path(folder), each, wants_picture) for each in names) else 0)
