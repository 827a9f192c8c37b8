# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of views of textures share: small images, and errors that are expected."""

import hachure
import numpy
from vtkmodules.util.misc import calldata_type
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkCommonDataModel import vtkImageData

_errors = []


@calldata_type(VTK_STRING)
def _remember(_caller, _event, text):
    _errors.append(text)


def watched(thing):
    """The same object; its errors are kept for expect_error()."""
    thing.AddObserver("ErrorEvent", _remember)
    return thing


def new_views():
    return watched(hachure.vtkTextureViews())


def number_of_errors():
    return len(_errors)


def expect_error(call, *parts):
    """The call tells exactly one message, which holds all parts; returns what the call does."""
    result = call()
    assert len(_errors) == 1, (parts, _errors)
    for part in parts:
        assert part in _errors[0], "%r is not in %r" % (part, _errors[0])
    _errors.clear()
    return result


def _image(values):
    height, width, components = values.shape
    result = vtkImageData()
    result.SetDimensions(width, height, 1)
    scalars = numpy_to_vtk(values.reshape(-1, components), deep=True)
    result.GetPointData().SetScalars(scalars)
    return result


def image(width=8, height=6, components=4, seed=1):
    """A picture of 8 bits."""
    numbers = numpy.random.default_rng(seed).integers(0, 256, (height, width, components))
    return _image(numbers.astype(numpy.uint8))


def depth_image(width=8, height=6):
    return _image(numpy.arange(width * height, dtype=numpy.uint16).reshape(height, width, 1) * 999)


def pixels(picture):
    """Size and bytes of an image, None of none."""
    if picture is None:
        return None
    scalars = vtk_to_numpy(picture.GetPointData().GetScalars())
    return picture.GetDimensions(), scalars.dtype, scalars.tobytes()
