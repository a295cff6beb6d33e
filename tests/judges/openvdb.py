#!/usr/bin/env python3
"""What OpenVDB itself, and Blender, read of an exported .vdb: the values must be those of the .vol beside it. Where a stage
(.usda) of volumes lies beside it too, Blender must find the volume through it, at the same place.

Run by hand in the project's root; PyPI's bpy has OpenVDB's own module for Python in it (Python 3.11):

    python3.11 -m venv venv && venv/bin/pip install bpy==5.0.1 'numpy<2'
    cloudwright export SCENE -o OUT/clouds.vol && cloudwright export SCENE -o OUT/clouds.vdb --cloud NAME
    venv/bin/python tests/judges/openvdb.py OUT/clouds.vdb …

It prints what is said of each grid and ends with 1 where values or places differ. A .vol of clouds that touch holds all of
them, so compare one cloud (--cloud).
"""

import struct
import sys
from pathlib import Path

import bpy
import numpy
from mathutils import Vector

sys.path.insert(0, str(next(Path(bpy.utils.resource_path("LOCAL")).glob("python/lib/python*/site-packages"))))
import openvdb

failed = False
for path in map(Path, sys.argv[1:]):
    (grid,), _ = openvdb.readAll(str(path))
    file = path.with_suffix(".vol").read_bytes()
    width, height, depth = struct.unpack("<3i", file[8:20])
    corners = struct.unpack("<6f", file[24:48])
    volume = numpy.frombuffer(file[48:], dtype="<f4").reshape(depth, height, width).transpose(2, 1, 0)
    read = numpy.zeros(volume.shape, dtype=numpy.float32)
    grid.copyToArray(read)
    side = grid.transform.voxelSize()[0]
    corner = [at - side / 2 for at in grid.transform.indexToWorld((0, 0, 0))]
    same = numpy.array_equal(read, volume)
    near = all(abs(a - b) < 1e-3 * side for a, b in zip(corner, corners))

    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.object.volume_import(filepath=str(path.resolve()), files=[{"name": path.name}], directory=str(path.resolve().parent))
    shown = bpy.context.object.data.grids
    shown.load()
    names = [f"{one.name} {one.data_type}" for one in shown]
    print(f"{path}: {grid.gridClass}, {grid.activeVoxelCount()} of {volume.size} voxels, {side:.3f} m; Blender: {names}")
    print(f"  values {'are' if same else 'ARE NOT'} the same, the corner {'is' if near else 'IS NOT'}")
    failed |= not (same and near) or bool(shown.error_message) or names != ["density FLOAT"]

    if (stage := path.with_suffix(".usda")).exists():
        bpy.ops.wm.read_factory_settings(use_empty=True)
        bpy.ops.wm.usd_import(filepath=str(stage.resolve()))
        bpy.context.view_layer.update()
        volumes = [each for each in bpy.data.objects if each.type == "VOLUME"]
        loaded = [each.data.grids.load() for each in volumes]
        # Up is z there and y here.
        points = [each.matrix_world @ Vector(corner) for each in volumes for corner in each.bound_box]
        ends = [(min(p[axis] for p in points), max(p[axis] for p in points)) for axis in range(3)] if points else []
        low, high = corners[:3], corners[3:]
        wanted = [(low[0], high[0]), (-high[2], -low[2]), (low[1], high[1])]
        # Blender's bounds are those of voxels that hold something.
        there = bool(ends) and all(a - side <= c and d <= b + side for (a, b), (c, d) in zip(wanted, ends))
        print(f"  {stage.name}: {len(volumes)} volumes, {'there' if there else 'ELSEWHERE'}")
        failed |= loaded != [True] or not there
sys.exit(failed)
