"""Arrays that are views copy nothing, keep their owner alive, and cannot be written."""

import gc
import weakref

import naocal
import numpy as np
import pytest


def views(captures, result):
    """Each kind of view: a name, and a function that makes it anew from its owner."""
    return {
        "uv": lambda: captures[0].corners[0].uv,
        "ids": lambda: captures[0].corners[0].ids,
        "measured": lambda: captures[0].measured,
        "unknowns": lambda: result.unknowns,
        "covariance": lambda: result.covariance,
        "predicted": lambda: result.sightings[0].predicted,
        "residual": lambda: result.sightings[0].residual,
        "fitted": lambda: result.sightings[0].fitted,
        "fitted_residual": lambda: result.sightings[0].fitted_residual,
        "weight": lambda: result.sightings[0].weight,
    }


def test_views_share_the_memory_of_their_owner(captures, result):
    """Proves for every kind of view that two of them are one memory, which neither owns nor lets change."""
    for name, make in views(captures, result).items():
        one, other = make(), make()
        assert one.size > 0 and np.shares_memory(one, other), name
        assert not one.flags.owndata and not one.flags.writeable, name
        with pytest.raises(ValueError):
            one[...] = 0
        with pytest.raises(ValueError):
            one.flags.writeable = True


def test_shapes_are_those_of_the_documentation(captures, result):
    """Proves the order of axes: points are rows, and the covariance is square."""
    count = len(result.names)
    assert result.unknowns.shape == result.sigmas.shape == (count,) and result.covariance.shape == (count, count)
    sighting = result.sightings[0]
    assert sighting.predicted.shape == sighting.residual.shape == sighting.measured.shape == (len(sighting), 2)
    assert sighting.weight.shape == sighting.ids.shape == (len(sighting),)
    assert captures.joint_angles.shape == (len(captures), len(captures.joints))
    assert captures[0].corners[0].uv.shape == (len(captures[0].corners[0]), 2)


def test_a_view_keeps_its_owner_alive():
    """Proves that a result lives as long as a view of it, is freed with the last one, and that values stay."""
    result = naocal.solve(naocal.simulate(poses=4, samples=1).captures)
    alive = weakref.ref(result)
    covariance, residual = result.covariance, result.sightings[0].residual
    copies = covariance.copy(), residual.copy()
    del result
    gc.collect()
    assert alive() is not None  # held by the covariance
    naocal.simulate(poses=4, samples=1, seed=2)  # would reuse freed memory
    assert np.array_equal(covariance, copies[0]) and np.array_equal(residual, copies[1])
    del covariance
    gc.collect()
    assert alive() is None
    assert np.array_equal(residual, copies[1])  # holds the calibration without its Python object


def test_captures_live_as_long_as_their_parts():
    """Proves that corners and angles outlive the simulation and the captures that they come from."""
    captures = naocal.simulate(poses=4, samples=1).captures
    uv, angles = captures[0].corners[0].uv, captures[0].measured
    copies = uv.copy(), angles.copy()
    del captures
    gc.collect()
    naocal.simulate(poses=4, samples=1, seed=2)
    assert np.array_equal(uv, copies[0]) and np.array_equal(angles, copies[1])
