# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A client of a server with one or more processes sees what a process alone draws, wherever the pictures are made.

Options as for the other tests, and -R: numbers of processes, by default 1,2.
"""

import contextlib
import os
import socket
import subprocess
import time

import parallel_scene as parallel
import pattern_scene as scene
from paraview import simple

PATIENCE = 60  # seconds for a server to start
FEW = {"StippleNumberOfPoints": 4000, "StippleRefinement": "Off"}


def free_port():
    """A port that nothing listens on."""
    with socket.socket() as candidate:
        candidate.bind(("127.0.0.1", 0))
        return candidate.getsockname()[1]


def wait_for(server, log):
    """Until the server takes clients."""
    end = time.time() + PATIENCE
    while time.time() < end and server.poll() is None:
        with open(log, encoding="utf-8", errors="replace") as file:
            if "Accepting connection" in file.read():
                return
        time.sleep(0.1)
    with open(log, encoding="utf-8", errors="replace") as file:
        raise AssertionError("the server did not start:\n" + file.read())


@contextlib.contextmanager
def server_of(processes):
    """A server that ends with the block, whatever happens in it; gives its port."""
    port = free_port()
    log = os.path.join(parallel.folder, "server-%d.log" % processes)
    command = ["mpirun", "--bind-to", "none", "-n", str(processes), "pvserver", "--server-port=%d" % port]
    with open(log, "w", encoding="utf-8") as output:
        server = subprocess.Popen(command, stdout=output, stderr=subprocess.STDOUT, start_new_session=True)
    try:
        wait_for(server, log)
        yield port
    finally:
        with scene.Messages():  # a server that was quicker to go is none
            simple.Disconnect()
        try:
            server.wait(20)
        except subprocess.TimeoutExpired:
            server.terminate()
            server.wait(20)


def draw(threshold=0):
    """Pictures of an isosurface by their names, of more than so many megabytes on the server."""
    blobs = parallel.blobs()
    pictures = {}
    for representation, properties in ("Pattern", {}), ("Noise", {}), ("Stipple", FEW):
        window = scene.view(parallel.SIZE)
        window.RemoteRenderThreshold = threshold
        scene.show(blobs, window, Representation=representation, **properties)
        for place in (30, 18, 40), parallel.BLOBS_SEEN_FROM:
            scene.look(window, place)
            pictures[representation] = scene.picture(window)
        remote = window.SMProxy.GetClientSideObject().GetUseDistributedRenderingForRender()
        assert remote == (threshold == 0 and bool(simple.GetActiveSource().GetSession().GetURI() != "builtin:"))
        simple.Delete(window)
    return pictures


alone = draw()
for processes in [int(number) for number in scene.options.get("-R", "1,2").split(",")]:
    with server_of(processes) as port:
        simple.Connect("127.0.0.1", port)
        simple.LoadPlugin(scene.plugin, remote=True, ns=globals())
        simple.LoadPlugin(scene.plugin, remote=False, ns=globals())
        simple._DisableFirstRenderCameraReset()
        for threshold, where in (0, "there"), (20000, "here"):
            for name, shown in draw(threshold).items():
                parallel.compare(name, shown, alone[name], "a server of %d, drawn %s" % (processes, where))

parallel.finish()
