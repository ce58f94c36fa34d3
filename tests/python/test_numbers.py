"""The package computes what the terminal's commands compute: all numbers are equal to the last digit."""

import json

import naocal
import numpy as np

from conftest import FLAW


def without_seconds(document):
    document = dict(document)
    document.pop("seconds", None)
    if "inputs" in document:
        document["inputs"] = {key: value for key, value in document["inputs"].items() if key != "names"}
    return document


def test_a_simulation_writes_the_files_of_the_command(folder, tmp_path):
    """Proves that captures and truth are equal byte by byte, for options that differ from the defaults."""
    simulation = naocal.simulate(seed=3, poses=8, samples=2, flaw=FLAW)
    simulation.write(tmp_path / "captures")
    assert (tmp_path / "captures/captures.json").read_bytes() == (folder / "captures.json").read_bytes()
    truth = folder.parent / "captures.truth.json"
    assert (tmp_path / "captures.truth.json").read_bytes() == truth.read_bytes()
    assert simulation.truth["seed"] == 3


def test_all_options_of_a_simulation_are_the_commands(run, tmp_path):
    """Proves that every option reaches the simulator in the command's units."""
    run("simulate", tmp_path / "told", "--poses", 3, "--samples", 2, "--seed", 5, "--robot-seed", 4, "--same-place",
        "--robot", "V5", "--support", "both", "--repeat-kind", "restand", "--surveyed", "--offset-degrees", 2.5,
        "--mount-degrees", 1.25, "--mount-millimetres", 3, "--flaw", "linkLength@thigh", "--flaw-scale", 2,
        "--pixel-noise", 0.5, "--heavy-tails", "--gross-share", 0.01, "--gross-pixels", 12, "--displaced-board",
        "--stiction-degrees", 0.1, "--approach-stiction-degrees", 0.2)
    naocal.simulate(poses=3, samples=2, seed=5, robot_seed=4, same_place=True, robot="V5", support="both",
                    repeat_kind="restand", surveyed=True, offset_degrees=2.5, mount_degrees=1.25, mount_millimetres=3,
                    flaw="linkLength@thigh", flaw_scale=2, pixel_noise=0.5, heavy_tails=True, gross_share=0.01,
                    gross_pixels=12, displaced_board=True, stiction_degrees=0.1,
                    approach_stiction_degrees=0.2).write(tmp_path / "made")
    for file in ("captures.json", "../{}.truth.json"):
        told, made = (tmp_path / name / file.format(name) for name in ("told", "made"))
        assert made.read_bytes() == told.read_bytes(), file


def test_a_result_is_the_commands(run, read, folder, captures, result, tmp_path):
    """Proves that to_dict() and write() give the file of 'naocal solve', with and without options."""
    run("solve", folder, "-o", tmp_path / "told.json")
    result.write(tmp_path / "made.json")
    assert read(tmp_path / "made.json") == read(tmp_path / "told.json") == without_seconds(result.to_dict())

    run("solve", folder, "-o", tmp_path / "told.json", "--with", FLAW, "--without", "jointOffset@HeadYaw", "--restarts", 1,
        "--seed", 7, "--plain", "--pixel-noise", 0.4, "--fixed-noise", "--pose-noise", 0.001)
    other = naocal.solve(captures, effects=FLAW, without=["jointOffset@HeadYaw"], restarts=1, seed=7, robust=False,
                         pixel_noise=0.4, estimate_noise=False, pose_noise=0.001)
    assert without_seconds(other.to_dict()) == read(tmp_path / "told.json")


def test_the_attributes_of_a_result_are_its_documents(result):
    """Proves that attributes and arrays hold the numbers of the document."""
    document = result.to_dict()
    assert (result.verdict, result.usable, result.sentence) == tuple(document[k] for k in ("verdict", "usable", "sentence"))
    assert (result.rms_px, result.median_px, result.noise_floor_px) == tuple(
        document[k] for k in ("rmsPx", "medianPx", "noiseFloorPx"))
    assert (result.chi2, result.dof, result.p_value) == tuple(document[k] for k in ("chi2", "dof", "pValue"))
    for effect in document["effects"]:
        for name, unknown in effect["unknowns"].items():
            label = f"{effect['effect']}@{effect['at']}.{name}"
            estimate, index = result.estimates[label], result.names.index(label)
            assert result.unknowns[index] == estimate.value == unknown["value"]
            assert result.sigmas[index] == estimate.sigma == unknown["sigma"]
            assert result.units[index] == estimate.unit == unknown["unit"]
            assert estimate.learned == unknown["learned"]
            assert estimate.best == unknown["averaged"]["value"] and estimate.interval == unknown["averaged"]["interval"]
    assert len(result.sightings) == len(document["sightings"])
    for sighting, entry in zip(result.sightings, document["sightings"]):
        assert (sighting.capture, sighting.board, sighting.camera) == tuple(
            entry[k] for k in ("capture", "board", "camera"))
        for name in ("ids", "measured", "predicted", "fitted", "weight"):
            assert np.array_equal(getattr(sighting, name), entry[name]), name
        assert np.allclose(sighting.residual, sighting.measured - sighting.predicted, atol=1e-9)
    distances = np.linalg.norm(np.concatenate([s.residual for s in result.sightings]), axis=1)
    assert np.isclose(np.sqrt(np.mean(distances**2)), result.rms_px)
    assert np.allclose(result.covariance, result.covariance.T, rtol=1e-6, atol=1e-18)


def test_a_comparison_is_the_commands(run, read, folder, result, tmp_path):
    """Proves that a comparison is the command's, of a Result and of its file, also against another result."""
    run("simulate", tmp_path / "other", "--seed", 8, "--robot-seed", 3, "--poses", 4, "--flaw", FLAW)
    run("solve", folder, "-o", tmp_path / "with.json", "--with", FLAW)
    result.write(tmp_path / "result.json")
    run("compare", tmp_path / "result.json", tmp_path / "other", "--against", tmp_path / "with.json", "--json",
        tmp_path / "told.json")
    captures = naocal.read_captures(tmp_path / "other")
    for of in (result, tmp_path / "result.json"):
        comparison = naocal.compare(of, captures, against=str(tmp_path / "with.json"))
        assert comparison.to_dict() == read(tmp_path / "told.json")
    assert comparison.rms_px == comparison.to_dict()["rmsPx"] > comparison.against_px
    assert comparison.nominal.rms_px > comparison.rms_px
    assert sum(board.corners for board in comparison.by_board.values()) == comparison.corners
    assert naocal.compare(result, captures).weighted_px is None


def test_a_diagnosis_is_the_commands(run, read, folder, captures, tmp_path):
    """Proves that to_dict() is the file of 'naocal diagnose', the proposed poses included, and attributes its numbers."""
    run("diagnose", folder, "--json", tmp_path / "told.json")
    diagnosis = naocal.diagnose(captures)
    assert without_seconds(diagnosis.to_dict()) == read(tmp_path / "told.json")
    document = diagnosis.to_dict()
    assert diagnosis.verdict == "effect-missing" and diagnosis.suggested == [FLAW] == document["suggested"]
    assert diagnosis.tentative is document["tentative"] is False
    assert (diagnosis.sentence, diagnosis.alarm) == (document["sentence"], document["alarm"])
    assert [c.label for c in diagnosis.ranking] == [f"{c['effect']}@{c['at']}" for c in document["ranking"]]
    assert [c.state for c in diagnosis.ranking] == [c["state"] for c in document["ranking"]]
    assert diagnosis.ranking[0].unknowns["c"][0] == document["ranking"][0]["unknowns"]["c"]["value"]
    assert [s.held_out_px for s in diagnosis.steps] == [s["heldOutPx"] for s in document["steps"]]
    assert all(np.array_equal(c.points, d["curve"]) for c, d in zip(diagnosis.curves, document["drivers"]))
    assert diagnosis.curves


def test_next_poses_of_an_arm_are_the_commands(run, read, tmp_path):
    """Proves that poses are proposed for a robot with a URDF, too, those of 'naocal diagnose'."""
    joints = [("turn", "base", "upper", "0 0 0.3", "0 0 1"), ("lift", "upper", "fore", "0.1 0 0", "0 1 0"),
              ("bend", "fore", "hand", "0.4 0 0", "0 1 0")]
    (tmp_path / "arm.urdf").write_text('<robot name="arm">' + "".join(
        f'<link name="{link}"/>' for link in ("base", "upper", "fore", "hand")) + "".join(
        f'<joint name="{name}" type="revolute"><parent link="{parent}"/><child link="{child}"/><origin xyz="{xyz}"/>'
        f'<axis xyz="{axis}"/><limit lower="-2" upper="2" velocity="1" effort="1"/></joint>'
        for name, parent, child, xyz, axis in joints) + "</robot>")
    (tmp_path / "scene.json").write_text(json.dumps({
        "format": "naocal-scene", "version": 1, "robot": {"urdf": "arm.urdf"},
        "trackers": {"laser": {"sigma": 0.0005, "about": {"x": 2, "y": 0.3, "z": 1, "yaw": 3}}},
        "markers": [{"id": "ball", "link": "hand", "about": [0.1, 0.05, 0.02]}]}))
    run("simulate", tmp_path / "arm", "--robot", tmp_path / "arm.urdf", "--scene", tmp_path / "scene.json", "--poses", 8,
        "--samples", 1, "--seed", 3)
    run("diagnose", tmp_path / "arm", "--json", tmp_path / "told.json")
    diagnosis = naocal.diagnose(naocal.read_captures(tmp_path / "arm"))
    assert without_seconds(diagnosis.to_dict()) == read(tmp_path / "told.json")
    poses = diagnosis.to_dict()["next"]["poses"]
    assert len(poses) == 4 and all(pose["observes"] == ["ball"] for pose in poses)


def test_captures_hold_what_was_recorded(folder, captures, read):
    """Proves that captures, corners and joint angles are those of captures.json."""
    document = read(folder / "captures.json")
    assert len(captures) == len(document["captures"]) and captures.robot == document["robot"]["model"]
    for capture, entry in zip(captures, document["captures"]):
        assert (capture.id, capture.pose, capture.camera) == (entry["id"], entry["pose"], entry["camera"])
        assert np.array_equal(capture.measured, entry["joints"]["measured"])
        assert [(c.board, c.ids.tolist(), c.uv.tolist()) for c in capture.corners] == [
            (c["board"], c["ids"], c["uv"]) for c in entry["corners"]]
    angles = captures.joint_angles
    columns = [captures.joints.index(name) for name in captures[0].joint_names]
    assert np.array_equal(angles[:, columns], [capture.measured for capture in captures])
    assert captures[-1].id == captures[len(captures) - 1].id
