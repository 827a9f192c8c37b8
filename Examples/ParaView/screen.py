# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A virtual screen whose content can be read, and small PNG files of it."""

import os
import struct
import subprocess
import tempfile
import zlib

import numpy

COLORS = 255
HEADER = 25  # words at the beginning of an XWD file


class VirtualScreen:
    """Xvfb with its content in a file."""

    def __init__(self, width, height):
        self.folder = tempfile.TemporaryDirectory()
        read, write = os.pipe()
        command = ["Xvfb", "-displayfd", str(write), "-screen", "0", "%dx%dx24" % (width, height), "-noreset"]
        self.server = subprocess.Popen(
            command + ["-fbdir", self.folder.name], pass_fds=[write], stderr=subprocess.DEVNULL
        )
        os.close(write)
        with os.fdopen(read) as number:
            self.display = ":" + number.readline().strip()

    def pixels(self):
        """What is on the screen, as an array height x width x 3 of bytes, rows downwards."""
        with open(os.path.join(self.folder.name, "Xvfb_screen0"), "rb") as file:
            data = file.read()
        words = struct.unpack(">%dI" % HEADER, data[: 4 * HEADER])
        width, height, stride = words[4], words[5], words[12]
        if words[7] != 0 or words[11] != 32:
            raise RuntimeError("the screen has %d bits per pixel in byte order %d" % (words[11], words[7]))
        begin = words[0] + 12 * words[19]  # behind the header and the colour map
        rows = numpy.frombuffer(data[begin : begin + stride * height], dtype=numpy.uint8).reshape(height, stride)
        return rows[:, : 4 * width].reshape(height, width, 4)[:, :, 2::-1].copy()

    def close(self):
        """Ends the server."""
        self.server.terminate()
        self.server.wait()
        self.folder.cleanup()


def palette(pixels):
    """The colours of a picture, few enough for a byte, and the index of every pixel."""
    for lost in range(8):  # bits of every channel that nobody will miss
        coarse = pixels >> lost
        codes = (coarse.astype(numpy.uint32) * numpy.array([1 << 16, 1 << 8, 1], numpy.uint32)).sum(axis=2)
        found, indices = numpy.unique(codes, return_inverse=True)
        if len(found) <= COLORS:
            break
    indices = indices.reshape(pixels.shape[:2])
    count = numpy.bincount(indices.ravel())
    means = [numpy.bincount(indices.ravel(), pixels[:, :, c].ravel()) / count for c in range(3)]
    return numpy.stack(means, axis=1).round().astype(numpy.uint8), indices.astype(numpy.uint8)


def write_png(file_name, pixels):
    """Writes a picture with a palette."""
    colors, indices = palette(pixels)
    height, width = indices.shape
    rows = numpy.concatenate([numpy.zeros((height, 1), numpy.uint8), indices], axis=1)  # 0: no filter
    parts = [(b"IHDR", struct.pack(">2I5B", width, height, 8, 3, 0, 0, 0)), (b"PLTE", colors.tobytes())]
    parts += [(b"IDAT", zlib.compress(rows.tobytes(), 9)), (b"IEND", b"")]
    with open(file_name, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n")
        for name, data in parts:
            file.write(struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data)))
