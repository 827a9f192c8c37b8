# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""pvbatch paraview_frames.py PLUGIN [OPTION...]: what a frame of each representation costs in ParaView, as JSON.

Draws an isosurface with a vector array in one view for each representation, by turns with ParaView's own
Surface and Surface LIC, while the camera moves. Times are medians over frames, in milliseconds; processor time is
that of all threads of the first process. With mpirun -n RANKS before pvbatch the surface is distributed; ranks
that wait for others take processor time then, so compare wall times.
"""

import argparse
import json
import math
import statistics
import time

from paraview import servermanager, simple

OURS = ("Pattern", "Noise", "Stipple", "View-dependent Texture")
THEIRS = ("Surface", "Surface LIC")
ISOVALUE = 157.0  # in the middle of the wavelet's values, which hides parts of itself
SMALLEST_RADIUS = 4
STEP = 0.5  # degrees from frame to frame
WARM_UP = 2  # frames in which buffers, shaders and points are made
# What a frame may cost at most, against Surface and against Surface LIC.
BOUNDS = {"Surface": 1.2, "Surface LIC": 1.0 / 8.0}


def options():
    """The arguments."""
    parser = argparse.ArgumentParser(prog="paraview_frames.py", description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("plugin", help="Hachure.so")
    parser.add_argument("--triangles", type=int, default=500000, help="about so many; default 500000")
    parser.add_argument("--frames", type=int, default=15, help="frames that are timed; default 15")
    parser.add_argument("--size", default="1280x720", help="of the views in pixels; default 1280x720")
    parser.add_argument("--only", default="", help="representations, separated by commas; default all")
    parser.add_argument("--json", default="", help="file to write to as well")
    return parser.parse_args()


def surface(triangles):
    """An isosurface of about so many triangles, with the point array Velocity."""
    radius = 16
    for _ in range(5):
        wavelet = simple.Wavelet(WholeExtent=[-radius, radius] * 3)
        contour = simple.Contour(Input=wavelet, ContourBy=["POINTS", "RTData"], Isosurfaces=[ISOVALUE])
        contour.UpdatePipeline()
        part = triangles / max(1, contour.GetDataInformation().GetNumberOfCells())
        wanted = max(SMALLEST_RADIUS, round(radius * math.sqrt(part)))
        if abs(part - 1) < 0.03 or wanted == radius:
            break
        radius = wanted
    flow = simple.Calculator(Input=contour, ResultArrayName="Velocity")
    flow.Function = "-coordsY*iHat+coordsX*jHat+%g*kHat" % (radius / 3)
    flow.UpdatePipeline()
    return flow, radius


class Subject:
    """One representation in a view of its own."""

    def __init__(self, label, source, radius, size):
        self.radius = radius
        self.cpu, self.wall = [], []
        self.view = simple.CreateView("RenderView")
        self.view.ViewSize = size
        self.view.UseFXAA = 0
        self.view.OrientationAxesVisibility = 0
        display = simple.Show(source, self.view)
        display.Representation = label
        display.ColorArrayName = ["POINTS", ""]
        if label == "Surface LIC":
            display.SelectInputVectors = ["POINTS", "Velocity"]
        self.window = self.view.SMProxy.GetRenderWindow()
        self.window.SetMultiSamples(0)
        self.look(0)
        simple.Render(self.view)
        if label == "View-dependent Texture":
            display.SMProxy.InvokeCommand("ViewTextureAddCamera")

    def look(self, frame):
        """The camera of a frame."""
        angle = math.radians(STEP * frame)
        distance = 5.0 * self.radius
        self.view.CameraPosition = [distance * math.sin(angle), 0.4 * distance, distance * math.cos(angle)]
        self.view.CameraFocalPoint = [0, 0, 0]

    def draw(self, frame):
        """Draws a frame, and takes its time unless it is one of the first."""
        self.look(frame)
        wall, cpu = time.perf_counter(), time.process_time()
        simple.Render(self.view)
        self.window.WaitForCompletion()
        if frame >= WARM_UP:
            self.cpu.append(1000 * (time.process_time() - cpu))
            self.wall.append(1000 * (time.perf_counter() - wall))


def row(label, subjects, common):
    """The numbers of one representation; ratios to those of ParaView, where these were drawn."""
    subject = subjects[label]
    result = {"representation": label, **common}
    result["cpu_ms"] = round(statistics.median(subject.cpu), 2)
    result["wall_ms"] = round(statistics.median(subject.wall), 2)
    for other in THEIRS:
        if other in subjects:
            name = other.lower().replace(" ", "_")
            for kind in ("cpu", "wall"):
                ratios = [a / b for a, b in zip(getattr(subject, kind), getattr(subjects[other], kind)) if b > 0]
                result["%s_to_%s" % (kind, name)] = round(statistics.median(ratios), 4) if ratios else None
            ratio = result["cpu_to_" + name]
            if label in OURS:
                result["within_bound_of_" + name] = ratio is not None and ratio <= BOUNDS[other]
    return result


def main():
    """Draws all frames and prints the rows."""
    given = options()
    simple.LoadPlugin(given.plugin, remote=False, ns=globals())
    simple._DisableFirstRenderCameraReset()  # pylint: disable=protected-access
    size = [int(side) for side in given.size.split("x")]
    labels = given.only.split(",") if given.only else [*THEIRS, *OURS]
    source, radius = surface(given.triangles)
    subjects = {label: Subject(label, source, radius, size) for label in labels}
    for frame in range(WARM_UP + given.frames):
        for subject in subjects.values():
            subject.draw(frame)
    common = {
        "ranks": servermanager.vtkProcessModule.GetProcessModule().GetNumberOfLocalPartitions(),
        "triangles": source.GetDataInformation().GetNumberOfCells(),
        "width": size[0],
        "height": size[1],
        "frames": given.frames,
    }
    text = json.dumps([row(label, subjects, common) for label in labels], indent=1)
    if given.json:
        with open(given.json, "w", encoding="ascii") as file:
            file.write(text + "\n")
    print(text)


main()
