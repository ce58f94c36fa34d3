"""What several files need: the terminal's program, captures of a simulated robot, and its calibration."""

import json
import os
import subprocess

import pytest

import naocal

FLAW = "elasticity@LKneePitch"


@pytest.fixture(scope="session")
def run():
    """Runs a command of the terminal's program; 3, for a result that should not be used, counts as 0."""

    def run(*arguments, code=0):
        done = subprocess.run([os.environ["NAOCAL_PROGRAM"], *map(str, arguments)], capture_output=True, text=True)
        assert done.returncode == code or (done.returncode, code) == (3, 0), done.stderr
        return done

    return run


@pytest.fixture(scope="session")
def read():
    """Reads a JSON file without the time that its computation took, with the places of its captures made whole."""

    def read(file):
        document = json.loads(file.read_text())
        document.pop("seconds", None)
        if "inputs" in document:
            inputs = document["inputs"]
            inputs["sets"] = [str((file.parent / place).resolve()) for place in inputs["sets"]]
            inputs.pop("names", None)  # only beside a file's places
        return document

    return read


@pytest.fixture(scope="session")
def folder(run, tmp_path_factory):
    """Captures of a robot with a knee that gives way, written by the terminal's program."""
    folder = tmp_path_factory.mktemp("naocal") / "captures"
    run("simulate", folder, "--seed", 3, "--poses", 8, "--samples", 2, "--flaw", FLAW)
    return folder


@pytest.fixture(scope="session")
def captures(folder):
    return naocal.read_captures(folder)


@pytest.fixture(scope="session")
def result(captures):
    return naocal.solve(captures)
