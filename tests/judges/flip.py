"""What the published ꟻLIP says of pairs of pictures: the mean over the pixels of each has to be within MOST.

usage: python flip.py MOST REFERENCE:TEST...
"""

import math
import sys

import flip_evaluator
import numpy
from PIL import Image

# A display 0.7 m wide with 3,840 pixels, seen from 0.7 m, as core/src/measure/flip/.
PIXELS_PER_DEGREE = 3840 * math.pi / 180


def pixels(path):
    return numpy.asarray(Image.open(path).convert("RGB"), dtype=numpy.float32) / 255


most = float(sys.argv[1])
bad = 0
for pair in sys.argv[2:]:
    reference, test = pair.split(":")
    parameters = {"ppd": PIXELS_PER_DEGREE}
    _, mean, _ = flip_evaluator.evaluate(pixels(reference), pixels(test), "LDR", applyMagma=False, parameters=parameters)
    print(f"{test}: FLIP {mean:.4f}{'' if mean <= most else f', more than {most}'}")
    bad += mean > most
sys.exit(bad > 0)
