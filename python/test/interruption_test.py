# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Ctrl-C ends the loading of a robot: fits are kept as they are made, so they show how far it came."""
import os
import signal
import threading
import time

import pytest

import collision_monitor_core as cm

from conftest import URDF

DEADLINE = 60.0  # [s] of a test that has failed


def load(cache):
    """Takes seconds: shapes are sought until there are so many."""
    return cm.load(URDF / "arm6.urdf", URDF / "arm6.srdf", fit_cache=cache, max_shapes=40,
                   target_overshoot=0.0)


def press_after_first_fit(cache, pressed):
    end = time.monotonic() + DEADLINE
    while time.monotonic() < end and not any(cache.glob("*")):
        time.sleep(0.001)
    pressed.append(len(list(cache.glob("*"))))
    os.kill(os.getpid(), signal.SIGINT)


def test_interrupt_endsLoading(tmp_path):
    pressed = []
    thread = threading.Thread(target=press_after_first_fit, args=(tmp_path, pressed))
    thread.start()
    with pytest.raises(KeyboardInterrupt):
        load(tmp_path)
    thread.join()
    kept = len(list(tmp_path.glob("*")))
    assert pressed[0] > 0
    load(tmp_path)
    assert kept < len(list(tmp_path.glob("*")))


def test_loading_onAnotherThread_endsWithWhatHappens(tmp_path):
    found = []

    def try_to_load():
        try:
            cm.load(tmp_path / "no.urdf", fit_cache="none")
        except cm.SetupError as failure:
            found.append(failure)
        found.append(cm.load(URDF / "arm6.urdf", fit_cache="none"))

    thread = threading.Thread(target=try_to_load)
    thread.start()
    thread.join()
    assert isinstance(found[0], cm.SetupError) and isinstance(found[1], cm.Robot)
