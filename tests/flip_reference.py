#!/usr/bin/env python3
"""What the published tool says of the pairs of pictures in tests/flip, for the test of our own ꟻLIP.

Run in the project's root after `cargo run -p cloudwright-tests --bin renew -- flip`, or to judge by a newer tool:

    python3 -m venv venv && venv/bin/pip install flip-evaluator==1.7 pillow
    venv/bin/python tests/flip_reference.py

It writes tests/flip/figures.json: for each pair the mean, the 99th percentile (nearest rank) and the largest error.
"""

import json
import math
from importlib.metadata import version
from pathlib import Path

import flip_evaluator
import numpy
from PIL import Image

FOLDER = Path("tests/flip")
PIXELS_PER_DEGREE = 0.7 * 3840 / 0.7 * math.pi / 180


def pixels(path):
    return numpy.asarray(Image.open(path).convert("RGB"), dtype=numpy.float32) / 255


def figures(name):
    reference, test = (pixels(FOLDER / f"{name}_{of}.png") for of in ("reference", "test"))
    parameters = {"ppd": PIXELS_PER_DEGREE}
    errors, mean, _ = flip_evaluator.evaluate(reference, test, "LDR", applyMagma=False, parameters=parameters)
    ordered = numpy.sort(errors.flatten())
    p99 = ordered[math.ceil(0.99 * ordered.size) - 1]
    return {"mean": round(float(mean), 6), "p99": round(float(p99), 6), "largest": round(float(ordered[-1]), 6)}


names = sorted(path.name.removesuffix("_test.png") for path in FOLDER.glob("*_test.png"))
report = {
    "made_with": f"flip-evaluator {version('flip-evaluator')}",
    "pixels_per_degree": round(PIXELS_PER_DEGREE, 6),
    "pairs": {name: figures(name) for name in names},
}
(FOLDER / "figures.json").write_text(json.dumps(report, indent=2) + "\n")
print(json.dumps(report, indent=2))
