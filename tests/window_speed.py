"""How quick the editor's window is, as seen from outside: what stands on the screen is looked at again and again while a
pointer turns the view. Prints medians over five turns, and each:

- from the program's start to its first picture,
- pictures a second while the view turns,
- from a hand's first move to the first picture that shows it,
- from its last move until the picture stands still, sharp.

Needs a screen (Xvfb will do) with nothing else on it, and python-xlib from PyPI.
usage: tests/window_speed.py PROGRAM SCENE [WIDTHxHEIGHT]
"""

import subprocess
import sys
import time
from statistics import median

from Xlib import X, display, error
from Xlib.ext import xtest

# Of the screen, what is looked at: large enough to see each turn, small enough to be fetched in a millisecond.
LOOKED_AT = (240, 160)
# More than a panel or an empty window shows.
COLOURS_OF_A_PICTURE = 500
TURNS, TURN_S, MOVES_A_SECOND = 5, 3.0, 90
# Beyond what counts as a click, pixels.
FIRST_MOVE = 14


class Window:
    """The editor's window, and a hand over it."""

    def __init__(self, program, scene):
        self.screen = display.Display()
        self.begun = time.perf_counter()
        self.editor = subprocess.Popen([program, scene], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.window = None
        while self.window is None:
            self.window = self.find(self.screen.screen().root)

    def find(self, window):
        try:
            if "Cloudwright" in str(window.get_wm_name() or ""):
                return window
            return next(filter(None, map(self.find, window.query_tree().children)), None)
        except error.XError:
            return None  # It went away meanwhile.

    def seen(self, at):
        left, top = (at[i] - LOOKED_AT[i] // 2 for i in (0, 1))
        return self.window.get_image(left, top, *LOOKED_AT, X.ZPixmap, 0xFFFFFFFF).data

    def middle(self):
        size = self.window.get_geometry()
        return size.width * 2 // 5, size.height * 2 // 5

    def first_picture_s(self):
        while True:
            try:
                data = self.seen(self.middle())
                if len({data[i : i + 4] for i in range(0, len(data), 4)}) > COLOURS_OF_A_PICTURE:
                    return time.perf_counter() - self.begun
            except error.XError:
                time.sleep(0.005)  # Not on the screen yet.

    def resize(self, width, height):
        self.window.configure(x=0, y=0, width=width, height=height)
        self.window.set_input_focus(X.RevertToParent, X.CurrentTime)
        self.screen.sync()
        time.sleep(3)

    def move(self, x, y):
        xtest.fake_input(self.screen, X.MotionNotify, x=int(x), y=int(y))
        self.screen.sync()

    def button(self, event):
        xtest.fake_input(self.screen, event, 2)
        self.screen.sync()

    def turn(self):
        """Pictures a second, seconds to the first change, seconds to stillness."""
        at = self.middle()
        self.move(*at)
        time.sleep(0.8)
        self.button(X.ButtonPress)
        time.sleep(0.4)
        before, begun = self.seen(at), time.perf_counter()
        self.move(at[0] + FIRST_MOVE, at[1])
        while self.seen(at) == before and time.perf_counter() - begun < 2:
            pass
        first = time.perf_counter() - begun

        changes, last, steps, begun = 0, self.seen(at), 0, time.perf_counter()
        while (now := time.perf_counter() - begun) < TURN_S:
            if now * MOVES_A_SECOND >= steps:
                steps += 1
                self.move(at[0] + FIRST_MOVE + steps, at[1] + steps // 3)
            new = self.seen(at)
            changes, last = changes + (new != last), new

        begun = still = time.perf_counter()
        self.button(X.ButtonRelease)
        while time.perf_counter() - begun < 1.5:
            new = self.seen(at)
            if new != last:
                still, last = time.perf_counter(), new
        return changes / TURN_S, first, still - begun


def main(program, scene, size="1600x1000"):
    window = Window(program, scene)
    try:
        print(f"start to first picture: {window.first_picture_s() * 1e3:.0f} ms")
        window.resize(*map(int, size.split("x")))
        rows = "pictures a second while turning", "first change after a move, ms", "sharp after the last move, ms"
        for name, scale, values in zip(rows, (1, 1e3, 1e3), zip(*(window.turn() for _ in range(TURNS)))):
            each = ", ".join(f"{value * scale:.1f}" for value in values)
            print(f"{name}: median {median(values) * scale:.1f} of {each}")
    finally:
        window.editor.terminate()
        window.editor.wait()


main(*sys.argv[1:])
