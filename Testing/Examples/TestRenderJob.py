# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A tiny job writes exactly its files, and the pictures show what was asked for."""

import os

import numpy

from rendering_program import draw, fresh_folder, ink, picture, run, write_sphere, write_volume

fresh_folder()
write_sphere("sphere.vtp")
write_volume("volume.vti")

# Four frames, movie and contact sheet; no temporary file stays.
done = draw("sphere.vtp", "--orbit", 4, "--zoom", "0.5:1", "--size", "160x120", "--output",
            "a/b", "--movie")
frames = [f"frame_{i:04d}.png" for i in range(4)]
assert sorted(os.listdir("a/b")) == ["contact.png", *frames, "movie.ogv"], os.listdir("a/b")
assert "frame 4 of 4" in done.stderr and "4 frames in a/b" in done.stderr
assert open("a/b/movie.ogv", "rb").read(4) == b"OggS"
pictures = [picture("a/b/" + name) for name in frames]
assert all(one.shape == (120, 160, 3) for one in pictures)
assert picture("a/b/contact.png").shape[1] > 4 * 160

# White paper; the drawing is in the middle, and fills the picture at the end of the zoom.
drawn = [(one < 0.9).any(axis=2) for one in pictures]
assert not drawn[0][:20].any() and not drawn[0][:, :30].any()
rows = [numpy.flatnonzero(one.any(axis=1)) for one in drawn]
heights = [(row[-1] - row[0] + 1) / 120 for row in rows]
assert abs(heights[3] - 0.96) < 0.03, heights
assert abs(heights[0] - 0.48) < 0.03, heights

# The key light comes from the upper left.
def shade(pixels):
    """Ink of the lower right and of the upper left quarter."""
    return ink(pixels[:60, 80:]), ink(pixels[60:, :80])


draw("sphere.vtp", "--size", "160x120", "--output", "lit")
dark, bright = shade(picture("lit/frame_0000.png"))
assert dark > 1.5 * bright, (dark, bright)
draw("sphere.vtp", "--size", "160x120", "--output", "turned", "--light=140,-40")
dark, bright = shade(picture("turned/frame_0000.png"))
assert dark < bright, (dark, bright)

# Tone follows an array: low is paper, high is ink. Seen from the side, z grows upwards.
draw("sphere.vtp", "--array", "height", "--up", "z", "--front", "y", "--size", "160x120",
     "--output", "array")
tones = picture("array/frame_0000.png")
assert ink(tones[70:110, 60:100]) > 0.55 and ink(tones[10:50, 60:100]) < 0.45
assert ink(tones[90:110, 70:90]) > ink(tones[50:70, 70:90]) > ink(tones[10:30, 70:90])

# A volume, another style, no supersampling; a second run gives the same bytes.
job = ("volume.vti", "--isovalue", 150, "--style", "halftone", "--supersample", 1, "--size",
       "160x120", "--output")
draw(*job, "first")
draw(*job, "second")
assert ink(picture("first/frame_0000.png")) > 0.02
first, second = (open(name + "/frame_0000.png", "rb").read() for name in ("first", "second"))
assert first == second

# Without a display the picture is the same, or the refusal clear and nothing written.
bare = {name: value for name, value in os.environ.items() if name != "DISPLAY"}
done = run(*job, "bare", environment=bare)
if done.returncode == 0:
    assert open("bare/frame_0000.png", "rb").read() == first
else:
    assert done.returncode == 2 and "no display to draw with" in done.stderr, done.stderr
    assert not os.path.exists("bare")
