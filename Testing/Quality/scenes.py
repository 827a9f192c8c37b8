# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the quality report draws: scenes, motions, fields, inks and lightings, each in one list.

A scene is a list of surfaces (polydata), see objects.py; a motion gives the camera at every frame, and
for some scenes the surfaces. Speeds keep motion below half the wavelength of the inks per frame.
"""

import math

import hachure
import numpy
import objects
from objects import ball, placed, square, steps
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkRenderingCore import vtkCamera

VIEW_ANGLE = 30.0
DISTANCE = 3.2  # of the camera from the origin, scene units
TONE = 0.5
WAVELENGTH = 12.0  # of all inks, in pixels


def sphere():
    return [ball()]


def ellipsoid():
    return [placed(ball(), scale=(1.0, 0.7, 0.5), turn=(25, 0, 1, 0))]


def plane():
    return [placed(square(), turn=(-40, 1, 0, 0))]


def sphere_before_plane():
    return [placed(ball(0.4), move=(0.1, 0.0, 0.5)), placed(square(), move=(0, 0, -0.6))]


def room():
    """A floor and a wall with several spheres that hide them and each other."""
    floor = placed(square(), move=(0, -0.6, 0), turn=(-90, 1, 0, 0))
    places = (-0.5, -0.35, 0.4), (0.4, -0.3, 0.0), (-0.1, -0.25, -0.5)
    return [floor, placed(square(), move=(0, 0, -1.2))] + [
        placed(ball(0.25), move=place) for place in places]


SCENES = {
    "sphere": sphere,
    "ellipsoid": ellipsoid,
    "plane": plane,
    "sphere before a plane": sphere_before_plane,
    "room": room,
    "skull": lambda: [objects.skull()],
    "disk_out_ref": lambda: [objects.disk()],
    "protein": lambda: [objects.protein()],
    "blade": lambda: [objects.blade()],
}


def camera_at(position, focal_point, up=(0.0, 1.0, 0.0)):
    camera = vtkCamera()
    camera.SetViewAngle(VIEW_ANGLE)
    camera.SetPosition(*position)
    camera.SetFocalPoint(*focal_point)
    camera.SetViewUp(*up)
    camera.SetClippingRange(0.3, 12.0)
    return camera


def pixel_width(size):
    """Of a picture of this size, at the origin, seen from DISTANCE, in scene units."""
    return 2 * DISTANCE * math.tan(math.radians(VIEW_ANGLE / 2)) / size


def translate(frames):
    return [camera_at((0.011 * s, 0.005 * s, DISTANCE), (0.011 * s, 0.005 * s, 0.0))
            for s in steps(frames)]


def rotate(frames):
    angles = [math.radians(1.2 * s) for s in steps(frames)]
    return [camera_at((DISTANCE * math.sin(a), 0.0, DISTANCE * math.cos(a)), (0, 0, 0))
            for a in angles]


def zoom(frames):
    return [camera_at((0, 0, DISTANCE * 1.026**-s), (0, 0, 0)) for s in steps(frames)]


def octave(frames):
    """A zoom through a whole octave, so that every pattern changes its octave on the way."""
    return [camera_at((0, 0, DISTANCE * 1.035**-s), (0, 0, 0)) for s in steps(max(frames, 22))]


def slow_octave(frames):
    """A calm zoom: 60 frames, two and a half seconds, until marks on the sphere are twice as large."""
    return [camera_at((0, 0, DISTANCE * 1.0092**-s), (0, 0, 0)) for s in steps(max(frames, 61))]


def roll(frames):
    angles = [math.radians(1.8 * s) for s in steps(frames)]
    return [camera_at((0, 0, DISTANCE), (0, 0, 0), (math.sin(a), math.cos(a), 0)) for a in angles]


def walk(frames):
    """Forward and to the side, with the up and down of steps, looking a little around."""
    cameras = []
    for s in steps(frames):
        bob = 0.012 * math.sin(0.9 * s)
        cameras.append(camera_at((0.010 * s, bob, DISTANCE - 0.03 * s), (0.006 * s, 0.5 * bob, 0)))
    return cameras


def approach(frames):
    """Three octaves of distance: a pattern that changes its octave on the way does so everywhere alike."""
    frames = max(frames, 13)
    return [camera_at((0, 0, 1.4 * 2 ** (3 - 3 * frame / (frames - 1))), (0, 0, 0))
            for frame in range(frames)]


def still(frames):
    return [camera_at((0, 0, DISTANCE), (0, 0, 0))] * frames


# Of the camera. Where the objects move it is still.
MOTIONS = {"translate": translate, "rotate": rotate, "zoom": zoom, "octave": octave,
           "slow octave": slow_octave, "roll": roll, "walk": walk, "approach": approach, "deform": still,
           "scale": still, "light": still}
# Only for some scenes: those that are large enough, and those that tell all there is to tell.
CHOSEN = {"approach": ("plane",), "octave": ("sphere", "ellipsoid"), "slow octave": ("sphere",),
          "light": ("sphere", "skull")}
# Too fast to tell slides. All others cover too few octaves to tell how size goes with distance.
FAST = {"approach"}

# Of the objects: scenes that have them, and their surfaces at every frame.
DEFORMATIONS = {
    "deform": {"disk_out_ref": objects.bend, "protein": objects.fold,
               "blade": objects.vibrate},
    "scale": {"disk_out_ref": objects.grow},
}


def around(frames):
    """A light that goes round the object, from the left to the right, a little above it."""
    angles = [math.radians(4.0 * s) for s in steps(frames)]
    return [(math.sin(a), 0.5, math.cos(a)) for a in angles]


# Of the light: the direction to it at every frame. Otherwise it shines from the camera.
LIGHTS = {"light": around}


def lights(motion, frames):
    return LIGHTS[motion](frames) if motion in LIGHTS else None


def path(scene, motion, surfaces, frames):
    """Surfaces and camera of every frame, None where the scene does not have this motion."""
    cameras = MOTIONS[motion](frames)
    if motion not in DEFORMATIONS:
        here = scene in CHOSEN.get(motion, (scene,))
        return ([surfaces] * len(cameras), cameras) if here else None
    deform = DEFORMATIONS[motion].get(scene)
    return (deform(surfaces, frames), cameras) if deform else None


def spread(layer):
    layer.SetMotion(layer.SIMILARITY)
    layer.SetLodStart(1.0)
    layer.SetLodEnd(2.0)


# How the pattern moves: a function that sets up a vtkImagePatternLayer. With "patches" by a similarity
# for each of the patches that patched() makes; "spread" changes its octave little by little all the time.
FIELDS = {
    "screen": lambda layer: layer.SetMotion(layer.FIXED_IN_IMAGE),
    "texture": lambda layer: layer.SetMotion(layer.TEXTURE),
    "solid": lambda layer: layer.SetMotion(layer.DYNAMIC_SOLID),
    "similarity": lambda layer: layer.SetMotion(layer.SIMILARITY),
    "spread": spread,
    "patches": lambda layer: layer.SetMotion(layer.SIMILARITY),
}
PATCHES = 24  # of a surface, from the automatic division
BLEND_WIDTH = 0.05  # to each side of a border, scene units


def patched(states):
    """The same surfaces, with the patches and blending weights of the first state in all of them."""
    divided, done = [], {}
    for surface in states[0]:
        patches = hachure.vtkSurfacePatches()
        patches.SetInputData(surface)
        patches.SetNumberOfPatches(PATCHES)
        weights = hachure.vtkPatchBlendWeights()
        weights.SetInputConnection(patches.GetOutputPort())
        weights.SetWidthModeToDistance()
        weights.SetDistance(BLEND_WIDTH)
        weights.Update()
        divided.append(weights.GetOutput())

    def of(surface, source):
        if surface not in done:
            done[surface] = surface.NewInstance()
            done[surface].ShallowCopy(surface)
            done[surface].GetCellData().AddArray(source.GetCellData().GetArray("PatchId"))
            for name in ("BlendPatches", "BlendWeights"):
                done[surface].GetPointData().AddArray(source.GetPointData().GetArray(name))
        return done[surface]

    return [[of(*pair) for pair in zip(surfaces, divided)] for surfaces in states]


# What a field needs beside the surfaces.
PREPARATIONS = {"patches": patched}


def prepared(field, states):
    return PREPARATIONS.get(field, lambda same: same)(states)


def noise(layer, size=256, seed=1):
    """Isotropic noise in a ring of frequencies, without a seam: slides show in every direction."""
    frequency = numpy.hypot(*numpy.meshgrid(*(numpy.fft.fftfreq(size),) * 2))
    ring = numpy.exp(-0.5 * ((frequency * WAVELENGTH - 1) / 0.2) ** 2)
    white = numpy.random.default_rng(seed).normal(size=(size, size))
    field = numpy.fft.ifft2(numpy.fft.fft2(white) * ring).real
    grey = 255 * (field - field.min()) / numpy.ptp(field)
    image = vtkImageData()
    image.SetDimensions(size, size, 1)
    image.GetPointData().SetScalars(numpy_to_vtk(grey.astype(numpy.float32).ravel(), deep=1))
    layer.SetPattern(layer.IMAGE)
    layer.SetImage(image)
    layer.SetSize(size)
    layer.SetAngle(0.0)


def hatch(layer):
    layer.SetPattern(layer.HATCH)
    layer.SetSize(WAVELENGTH)


def dots(layer):
    layer.SetPattern(layer.STIPPLE)


INKS = {"noise": noise, "hatch": hatch, "stipple": dots}


def kernels(kind, fade=2.0, smoothness=0.5, regularity=1.0):
    """For every ink a function that makes a layer of this noise."""
    def maker(spread):
        def layer():
            result = hachure.vtkNoiseLayer()
            result.SetKind(kind)
            result.SetSize(WAVELENGTH)
            result.SetSpread(spread)
            result.SetFade(fade)
            result.SetSmoothness(smoothness)
            result.SetRegularity(regularity)
            return result
        return layer
    return {"noise": maker(90.0), "hatch": maker(0.0)}


# Fields that are noises by themselves. "calm" has wide and soft marks that come and go slowly.
NOISES = {
    "gabor": kernels(hachure.vtkNoiseLayer.GABOR),
    "calm": kernels(hachure.vtkNoiseLayer.GABOR, fade=4.0, smoothness=1.0, regularity=0.6),
    "phasor": kernels(hachure.vtkNoiseLayer.PHASOR, smoothness=0.0),
    "spot": kernels(hachure.vtkNoiseLayer.SPOT),
}



def stipples(**parameters):
    """A function that makes a layer of stipples, for the only ink there is of them."""
    def layer():
        result = hachure.vtkStippleLayer()
        for name, value in parameters.items():
            getattr(result, "Set" + name)(value)
        return result
    return {"stipple": layer}


# Dots that are points of the surface: small ones, the more the darker; and large ones that grow.
STIPPLES = {
    "stipple": stipples(),
    "stipple size": stipples(Carrier=hachure.vtkStippleLayer.SIZE, Size=WAVELENGTH),
}

# Fields that are painted from all around, see views.py: whether pictures differ from one side to the next.
# Only of single objects, as each is painted alone.
PAINTED = {"view": False, "view fade": True}
PAINTED_SCENES = ("sphere", "ellipsoid", "skull", "disk_out_ref", "protein", "blade")

# Fields that make their ink themselves: for every ink a function that makes a layer.
MAKERS = {**NOISES, **STIPPLES}
# Dots tell as much as noise does of how these move: the two extremes, to compare.
DOTTED = ("screen", "similarity")

# Along their strokes slides cannot be seen: only those across count.
STROKES = {"hatch"}

LIGHTINGS = {
    "unlit": lambda tone: (tone.SetSource(tone.CONSTANT), tone.SetConstant(TONE)),
    "lit": lambda tone: tone.SetSource(tone.LIT),
}


def inks_of(field):
    """What a field can be drawn in."""
    if field in MAKERS:
        return list(MAKERS[field])
    if field in PAINTED:
        return ["noise"]
    return [ink for ink in INKS if ink != "stipple" or field in DOTTED]


def texture_style(seed=1):
    """What is painted: noise of even tone on the surface."""
    layer = hachure.vtkImagePatternLayer()
    noise(layer, seed=seed)
    FIELDS["texture"](layer)
    LIGHTINGS["unlit"](layer.GetTone())
    style = hachure.vtkPatternStyle()
    style.AddLayer(layer)
    return style


def new_style(field, ink, lighting):
    style = hachure.vtkPatternStyle()
    if field in MAKERS:
        layer = MAKERS[field][ink]()
    else:
        layer = hachure.vtkImagePatternLayer()
        INKS[ink](layer)
        FIELDS[field](layer)
    LIGHTINGS[lighting](layer.GetTone())
    style.AddLayer(layer)
    return style
