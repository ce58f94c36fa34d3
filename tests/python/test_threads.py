"""Long calls leave the interpreter to other threads, tell their progress, and end on Ctrl-C."""

import os
import signal
import threading
import time

import naocal
import pytest

from conftest import FLAW


def test_other_threads_run_during_a_calibration(captures):
    """Proves that a calibration does not hold the interpreter's lock: otherwise no turn of the loop would end."""
    done = threading.Event()
    threading.Thread(target=lambda: (naocal.solve(captures, restarts=5), done.set())).start()
    turns = 0
    while not done.is_set():
        turns += 1
        time.sleep(0.001)
    assert turns > 3


def test_threads_share_captures(captures, result):
    """Proves that calibrations of the same captures in four threads give the numbers of one after another."""
    effects = [[], [FLAW], ["hysteresis@LKneePitch"], ["focalLength@top"]]
    found = [None] * len(effects)

    def solve(index):
        found[index] = naocal.solve(captures, effects=effects[index]).to_dict()

    threads = [threading.Thread(target=solve, args=[index]) for index in range(len(effects))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    expected = [naocal.solve(captures, effects=each).to_dict() for each in effects]
    for document in found + expected:
        del document["seconds"]
    assert found == expected
    assert found[0]["sightings"] == result.to_dict()["sightings"]


def test_a_diagnosis_tells_its_progress(captures):
    """Proves that progress comes in the caller's thread, grows, and ends complete."""
    told = []
    naocal.diagnose(captures, next_count=0, progress=lambda done, total: told.append((done, total, threading.get_ident())))
    told, threads = [pair[:2] for pair in told], {entry[2] for entry in told}
    assert threads == {threading.get_ident()}
    reported = [pair for pair in told if pair[1] is not None]
    assert reported == sorted(reported) and reported[-1][0] == reported[-1][1]


def test_what_progress_raises_ends_the_calibration(captures):
    """Proves that the exception of the caller's function arrives unchanged, and that the next calibration is whole."""
    error = RuntimeError("enough")

    def refuse(done, total):
        assert total is None and done > 0
        raise error

    with pytest.raises(RuntimeError) as caught:
        naocal.solve(captures, progress=refuse)
    assert caught.value is error
    assert naocal.solve(captures).converged


def test_ctrl_c_ends_a_diagnosis(captures):
    """Proves that SIGINT during the computation raises KeyboardInterrupt before its end."""
    ended = []
    timer = threading.Timer(0.1, os.kill, [os.getpid(), signal.SIGINT])
    with pytest.raises(KeyboardInterrupt):
        timer.start()
        for _ in range(3):
            naocal.diagnose(captures)
            ended.append(True)
    timer.join()
    assert not ended
