"""What OpenUSD's own library reads of exported stages: each has to pass all of its validators, and to hold the clouds,
sprites and cameras that the scene has, where the sprite export has them. In OUT_FOLDER lie, of each scene, NAME.usda,
NAME.usdz and NAME-volumes.usda, NAME.info.json (`info --json`), NAME.sprites.json (`export`), and NAME.sprites-LATER.json,
the same at second LATER.
usage: python usd.py OUT_FOLDER LATER NAME...
"""

import json
import sys
from pathlib import Path

from pxr import Usd, UsdGeom, UsdLux, UsdShade, UsdValidation, UsdVol

# Corners are rounded to a centimetre, places to a millimetre; the sprite export to a tenth of one.
NEAR_M = 0.011
# Samples are followed within 5 cm; a parabola is farther off by a third where no one looked.
NEAR_LATER_M = 0.07

validators = UsdValidation.ValidationRegistry().GetOrLoadAllValidators()
# The .vdb files beside are another export's.
but_of_files = [each for each in validators if not each.GetMetadata().name.startswith("usdUtils")]


def of_type(stage, kind):
    return [kind(prim) for prim in stage.Traverse() if prim.IsA(kind)]


def faults_of(path, by=validators):
    stage = Usd.Stage.Open(str(path))
    errors = UsdValidation.ValidationContext(by).Validate(stage)
    return [f"{error.GetName()}: {error.GetMessage()}" for error in errors]


def centers(stage, time):
    """The middles of all quads in the world, by cloud."""
    found = {}
    for mesh in of_type(stage, UsdGeom.Mesh):
        cloud = mesh.GetPrim().GetParent()
        x, y, z = UsdGeom.Xformable(cloud).ComputeLocalToWorldTransform(time).ExtractTranslation()
        points = mesh.GetPointsAttr().Get(time)
        quads = [points[at : at + 4] for at in range(0, len(points), 4)]
        mean = lambda quad, axis: sum(point[axis] for point in quad) / 4
        found[str(cloud.GetPath())] = [(mean(q, 0) + x, mean(q, 1) + y, mean(q, 2) + z) for q in quads]
    return found


def apart(got, wanted):
    """How far two heaps of points are from each other along any axis, each sorted."""
    pairs = (zip(sorted(p[axis] for p in got), sorted(p[axis] for p in wanted)) for axis in range(3))
    return max((abs(a - b) for pair in pairs for a, b in pair), default=0.0)


def judge(out, name, later):
    info = json.loads((out / f"{name}.info.json").read_text())
    sprites = json.loads((out / f"{name}.sprites.json").read_text())
    faults = []
    for file in (f"{name}.usda", f"{name}.usdz"):
        path = out / file
        faults += faults_of(path)
        stage = Usd.Stage.Open(str(path))
        cameras = of_type(stage, UsdGeom.Camera)
        meshes = of_type(stage, UsdGeom.Mesh)
        quads = sum(len(mesh.GetFaceVertexCountsAttr().Get()) for mesh in meshes)
        clouds = stage.GetPrimAtPath("/Sky/Clouds").GetChildren()
        unbound = [m for m in meshes if not bound(m)]
        counts = {
            "clouds": (len(clouds), info["total"]["clouds"]),
            "sprites": (quads, info["total"]["sprites"]),
            "cameras": (len(cameras), len(info["cameras"]) + len(info["paths"])),
            "lights": (len(of_type(stage, UsdLux.DistantLight)), 1),
            "meshes without a material": (len(unbound), 0),
        }
        faults += [f"{got} {what} instead of {wanted}" for what, (got, wanted) in counts.items() if got != wanted]
    here = [point for cloud in centers(stage, 0).values() for point in cloud]
    there = [sprite["position"] for cloud in sprites["clouds"] for sprite in cloud["sprites"]]
    far = apart(here, there)
    if far > NEAR_M:
        faults.append(f"sprites are {far} m off")
    faults += drifted(out, name, later, stage, sprites)
    volumes = Usd.Stage.Open(str(out / f"{name}-volumes.usda"))
    faults += faults_of(out / f"{name}-volumes.usda", but_of_files)
    assets = of_type(volumes, UsdVol.OpenVDBAsset)
    fields = [volume.GetFieldPaths() for volume in of_type(volumes, UsdVol.Volume)]
    if len(assets) != info["total"]["clouds"] or any(list(field) != ["density"] for field in fields):
        faults.append(f"{len(assets)} volumes")
    moving = sum(1 for prim in stage.Traverse() for a in prim.GetAttributes() if a.GetNumTimeSamples() > 1)
    print(f"{name}: {len(clouds)} clouds, {quads} quads, {len(cameras)} cameras, {moving} moving attributes, "
          f"{len(assets)} volumes, sprites within {far:.4f} m, {len(faults)} faults")
    for fault in faults[:10]:
        print(f"{name}: {fault}", file=sys.stderr)
    return len(faults)


def bound(mesh):
    """Whether all of a mesh has a material with the sheet."""
    parts = UsdGeom.Subset.GetGeomSubsets(mesh, UsdGeom.Tokens.face, UsdShade.Tokens.materialBind)
    prims = [part.GetPrim() for part in parts] or [mesh.GetPrim()]
    for prim in prims:
        material, _ = UsdShade.MaterialBindingAPI(prim).ComputeBoundMaterial()
        tiles = material and material.GetPrim().GetChild("tiles")
        if not tiles or not tiles.GetAttribute("inputs:file").Get().resolvedPath:
            return False
    return True


def drifted(out, name, later, stage, sprites):
    """Clouds that only drift are, later, where the sprite export has them."""
    after = json.loads((out / f"{name}.sprites-{later}.json").read_text())
    now, then = centers(stage, 0), centers(stage, later * stage.GetTimeCodesPerSecond())
    faults = []
    for path, before, new in zip(now, sprites["clouds"], after["clouds"]):
        old_places, new_places = ([s["position"] for s in cloud["sprites"]] for cloud in (before, new))
        way = [b - a for a, b in zip(old_places[0], new_places[0])] if old_places else [0, 0, 0]
        moved = [[p[axis] + way[axis] for axis in range(3)] for p in old_places]
        if apart(moved, new_places) > 1e-3:
            continue
        far = apart(then[path], new_places)
        if far > NEAR_LATER_M:
            faults.append(f"{path} is {far} m off at {later} s")
    return faults


folder, second, *names = sys.argv[1:]
sys.exit(1 if sum(judge(Path(folder), each, float(second) if "." in second else int(second)) for each in names) else 0)
