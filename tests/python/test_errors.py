"""Wrong input raises naocal.InputError with the sentence of the terminal's program."""

import json
import pickle

import naocal
import pytest


def said(done):
    """The sentence on the program's standard error."""
    return done.stderr.removeprefix("naocal: ").rstrip("\n")


def raised(call, *arguments, **options):
    with pytest.raises(naocal.InputError) as error:
        call(*arguments, **options)
    return str(error.value)


def test_sentences_are_the_commands(run, folder, captures, tmp_path):
    """Proves equality of sentences for a missing folder, broken JSON, an unknown effect, and results that are none."""
    assert raised(naocal.read_captures, tmp_path / "none") == said(run("solve", tmp_path / "none", code=2))
    (tmp_path / "broken").mkdir()
    (tmp_path / "broken/captures.json").write_text("{")
    assert raised(naocal.read_captures, tmp_path / "broken") == said(run("solve", tmp_path / "broken", code=2))
    assert raised(naocal.solve, captures, effects=["elastic@LKneePitch"]) == said(
        run("solve", folder, "--with", "elastic@LKneePitch", code=2))
    assert raised(naocal.diagnose, captures, without=["jointOffset@Tail"]) == said(
        run("diagnose", folder, "--without", "jointOffset@Tail", code=2))
    for text in ("[]", '{"format": "naocal-result", "version": 1}', '{"format": "naocal-result", "version": 7}'):
        file = tmp_path / "result.json"
        file.write_text(text)
        assert raised(naocal.compare, file, captures) == said(run("compare", file, folder, code=2))
    assert raised(naocal.simulate, robot="V9") == said(run("simulate", tmp_path / "v9", "--robot", "V9", code=2))


def test_an_effect_that_nothing_defines_is_refused_in_a_comparison(run, folder, captures, result, tmp_path):
    """Proves that a result with an unknown effect is refused instead of compared without it."""
    document = result.to_dict()
    document["effects"][0]["effect"] = "jointOfset"
    file = tmp_path / "result.json"
    file.write_text(json.dumps(document))
    assert raised(naocal.compare, file, captures) == said(run("compare", file, folder, code=2))


def test_an_input_error_is_a_value_error():
    """Proves the place of the exception among Python's, and that it crosses processes."""
    assert issubclass(naocal.InputError, ValueError) and naocal.InputError.__module__ == "naocal"
    assert str(pickle.loads(pickle.dumps(naocal.InputError("a sentence")))) == "a sentence"


def test_other_files_are_left_alone(result, tmp_path):
    """Proves that write() replaces a result, and nothing else."""
    result.write(tmp_path / "result.json")
    result.write(tmp_path / "result.json")
    (tmp_path / "notes.json").write_text("{}")
    assert "notes.json: expected a new file or one with naocal-result" in raised(result.write, tmp_path / "notes.json")
    assert (tmp_path / "notes.json").read_text() == "{}"
    assert "something there" in raised(naocal.simulate(poses=2, samples=1).write, tmp_path)
    assert sorted(file.name for file in tmp_path.iterdir()) == ["notes.json", "result.json"]


def test_wrong_arguments_are_named(captures):
    """Proves that numbers beyond their range and values of another type are refused by name."""
    assert raised(naocal.simulate, poses=0) == "poses: expected 1 to 1000, found 0"
    assert raised(naocal.simulate, offset_degrees=50) == "offset_degrees: expected 0 to 45, found 50"
    assert raised(naocal.simulate, offset_degrees=float("nan")) == "offset_degrees: expected 0 to 45, found nan"
    assert raised(naocal.simulate, support="toes") == "support: expected left, right, both, found 'toes'"
    assert raised(naocal.diagnose, captures, draws=1) == "draws: expected 19 to 100000, found 1"
    assert raised(naocal.read_captures, []).startswith("expected at least one folder")
    for wrong in ({"samples": "many"}, {"seed": -1}, {"poses": 2.5}):
        with pytest.raises(TypeError, match=next(iter(wrong))):
            naocal.simulate(**wrong)
    with pytest.raises(TypeError, match="progress"):
        naocal.solve(captures, progress=3)
    for wrong in (lambda: naocal.solve(captures, efects=[]), lambda: naocal.solve(None), lambda: naocal.diagnose(None),
                  lambda: naocal.compare(None, captures), lambda: naocal.compare("result.json", None)):
        with pytest.raises(TypeError):
            wrong()
    with pytest.raises(IndexError):
        captures[len(captures)]


def test_names_that_are_no_text_are_shown(tmp_path):
    """Proves that a file name with bytes beyond UTF-8 gives a sentence, not a decoding error."""
    name = str(tmp_path / "caf\udce9")
    assert "\\xe9" in raised(naocal.read_captures, name)
