"""The Python code of docs/python.md and of the notebook runs as printed."""

import json
import os
import pathlib
import re

import matplotlib.pyplot as plt
import naocal

ROOT = pathlib.Path(__file__).resolve().parents[2]


def test_the_page_runs(tmp_path, monkeypatch, run):
    """Proves that the blocks of docs/python.md run one after another, on captures of two simulated sets."""
    run("simulate", tmp_path / "captures", "--seed", 1, "--poses", 8, "--samples", 2, "--flaw", "elasticity@LKneePitch")
    run("simulate", tmp_path / "other-captures", "--seed", 2, "--robot-seed", 1, "--poses", 4, "--samples", 2, "--flaw",
        "elasticity@LKneePitch")
    monkeypatch.chdir(tmp_path)
    text = (ROOT / "docs/python.md").read_text()
    blocks = re.findall(r"^```python\n(.*?)^```", text, re.DOTALL | re.MULTILINE)
    assert len(blocks) >= 4
    names = {}
    for block in blocks:
        exec(compile(block, "docs/python.md", "exec"), names)
    assert isinstance(names["result"], naocal.Result)
    plt.close("all")


def test_the_notebook_shows_the_error_fall(monkeypatch):
    """Proves that the notebook draws one arrow per corner before and after, and that the error falls to the noise."""
    notebook = json.loads((ROOT / "examples/python/before-and-after.ipynb").read_text())
    names = {}
    for cell in notebook["cells"]:
        if cell["cell_type"] == "code":
            exec(compile("".join(cell["source"]), "before-and-after.ipynb", "exec"), names)
    before, after = names["results"]
    assert before.rms_px > 4 * after.rms_px
    assert after.rms_px < 1.5 * after.noise_floor_px
    for axes, result in zip(names["axes"], names["results"]):
        arrows = sum(drawn.N for drawn in axes.collections)
        assert arrows == sum(len(s) for s in result.sightings if s.camera == "bottom") > 100
    if folder := os.environ.get("NAOCAL_PICTURES"):
        names["figure"].savefig(pathlib.Path(folder) / "python.png", dpi=100)
    plt.close("all")
