"""Calibrates a robot's joints and cameras from pictures of printed ChArUco boards, with uncertainties.

    import naocal
    captures = naocal.read_captures("captures/")
    result = naocal.solve(captures)
    print(result.sentence, result.estimates["jointOffset@LKneePitch.o"])
    print(naocal.diagnose(captures).sentence)

The functions compute what the commands of `naocal` compute, with the same defaults and the same numbers for the same
seeds. Angles are radians, lengths metres, corners pixels; names that end in _degrees or _millimetres say otherwise.

Arrays marked "a view" show memory of the object that they come from: nothing is copied, they keep that object alive, and
they cannot be written. Take `.copy()` of one to change it. Captures, results and diagnoses never change; several threads
may use them at once. Long calls leave the interpreter to other threads, and Ctrl-C ends them.
"""

from ._naocal import (
    BoardCorners,
    Candidate,
    Capture,
    Captures,
    Comparison,
    Curve,
    Diagnosis,
    Estimate,
    InputError,
    ResidualSummary,
    Result,
    Sighting,
    Simulation,
    Step,
    Suspicion,
    __version__,
)
from . import _naocal

__all__ = [
    "BoardCorners", "Candidate", "Capture", "Captures", "Comparison", "Curve", "Diagnosis", "Estimate", "InputError",
    "ResidualSummary", "Result", "Sighting", "Simulation", "Step", "Suspicion", "compare", "diagnose", "read_captures",
    "simulate", "solve",
]

for _class in (BoardCorners, Candidate, Capture, Captures, Comparison, Curve, Diagnosis, Estimate, ResidualSummary, Result,
               Sighting, Simulation, Step, Suspicion):
    _class.__module__ = "naocal"  # where people import it from
del _class


def _listed(one_or_more):
    """A list of the labels or paths; a single one stands for itself."""
    if isinstance(one_or_more, str) or hasattr(one_or_more, "__fspath__"):
        return [one_or_more]
    return list(one_or_more)


def read_captures(folders, *, configuration=None, same_place=False, skip_bad=False):
    """Reads capture sets of one robot: folders with captures.json.

    folders        a path, or several
    configuration  folder with the robots' descriptions; default: $NAOCAL_CONFIGURATION, or the installed ones
    same_place     boards and stances of equal id have the same placement in all sets
    skip_bad       leave out captures that cannot be used (`Captures.skipped`) instead of refusing their set

    Returns Captures. Raises InputError.
    """
    return _naocal.read_captures(_listed(folders), configuration, same_place, skip_bad)


def simulate(*, poses=24, samples=3, seed=1, robot="V6", support="left", repeat_kind="rest", surveyed=False,
             offset_degrees=6.5, mount_degrees=2.0, mount_millimetres=0.0, flaw="", flaw_scale=1.0, hidden_flaw=False,
             robot_seed=None, same_place=False, pixel_noise=0.3, heavy_tails=False, gross_share=0.0, gross_pixels=8.0,
             displaced_board=False, stiction_degrees=0.0, approach_stiction_degrees=0.0, name="simulated",
             configuration=None):
    """Simulates a robot with random errors that looks at four boards: 'naocal simulate' without pictures.

    poses                      how many, or the path of a pose file
    samples                    captures of each camera per pose
    seed                       the same seed gives the same captures
    support                    the foot it stands on: 'left', 'right' or 'both'
    repeat_kind                what happens between the samples of a pose: 'rest', 'reapproach' or 'restand'
    surveyed                   the captures state where boards and feet are
    offset_degrees, mount_degrees, mount_millimetres   errors of joints and cameras lie within these, both ways
    flaw, flaw_scale           hidden effect such as 'elasticity@LKneePitch', and its size (1: a worn NAO's)
    hidden_flaw                an effect that only the truth tells
    robot_seed, same_place     takes the robot of another seed, and its boards' places
    pixel_noise                standard deviation of a corner, per axis [px]
    heavy_tails, gross_share, gross_pixels, displaced_board   corners with larger errors
    stiction_degrees, approach_stiction_degrees   random deflection of joints per pose, per approach (1 sigma)
    name                       of the set
    configuration              folder with the robots' descriptions, as in read_captures()

    Returns Simulation. Raises InputError.
    """
    return _naocal.simulate(**locals())


def solve(captures, *, effects=(), without=(), model=None, restarts=0, seed=1, robust=True, estimate_noise=True,
          pixel_noise=None, encoder_noise=None, pose_noise=None, stance_noise=None, tolerance=None, progress=None):
    """Estimates joint offsets and camera rotations, with error bars and a verdict: 'naocal solve'.

    effects, without           effects to add and to leave out, such as ['elasticity@LKneePitch']; * matches any place
    model                      path of a model file, with effects of your own
    restarts, seed             extra searches from random starting points
    robust                     weigh down and list doubtful corners
    estimate_noise             False: take the noise levels as given
    pixel_noise [px], encoder_noise, pose_noise, stance_noise [rad]   standard deviations
    tolerance [m]              largest error at the task with which the result is usable
    progress                   called as progress(steps, None) while it computes; what it raises ends the calibration

    Returns Result. Raises InputError; KeyboardInterrupt on Ctrl-C.
    """
    return _naocal.solve(captures, effects=_listed(effects), without=_listed(without), model=model, restarts=restarts,
                         seed=seed, robust=robust, estimate_noise=estimate_noise, pixel_noise=pixel_noise,
                         encoder_noise=encoder_noise, pose_noise=pose_noise, stance_noise=stance_noise,
                         tolerance=tolerance, progress=progress)


def compare(result, captures, *, same_place=False, against=None):
    """Measures the prediction error of a result on captures that it has not seen: 'naocal compare'.

    result      a Result, or the path of a result file
    same_place  use the placements of boards and feet from the result instead of fitting them
    against     another result: which of the two predicts better?

    Returns Comparison. Raises InputError.
    """
    return _naocal.compare(result, captures, same_place, against)


def diagnose(captures, *, effects=(), without=(), model=None, seed=1, draws=199, next_count=4, progress=None):
    """Tells where and why the model fails, and which effect is missing: 'naocal diagnose'.

    effects, without, model    the model to diagnose, as in solve()
    seed, draws                of the noise simulations behind the false-alarm rate
    next_count                 number of poses to propose ('next' of to_dict())
    progress                   called as progress(models tested, at most); what it raises ends the diagnosis

    Returns Diagnosis. Raises InputError; KeyboardInterrupt on Ctrl-C.
    """
    return _naocal.diagnose(captures, effects=_listed(effects), without=_listed(without), model=model, seed=seed,
                            draws=draws, next_count=next_count, progress=progress)
