"""Two-ports in series: `@` beside NumPy's own products and solves, and what it does not take."""

import operator
from collections.abc import Callable

import numpy
import pytest
from samples import SPRING

import coilsense
from coilsense import Cascade, Damping, Load, TwoPort

HERTZ = numpy.array([0.7, 10.0, 33.0, 300.0])
OMEGA = 2 * numpy.pi * HERTZ


def part(windings: int) -> coilsense.Spring:
    """So many of the 52 windings."""
    share = windings / 52
    changed = {"windings": windings, "mass": SPRING.mass * share, "stiffness": SPRING.stiffness / share, "nominal_force": None, "inductance_windings": None}
    return coilsense.Spring(**SPRING.to_dict() | changed)


@pytest.mark.parametrize("damping", [Damping.none(), Damping.hysteretic(0.04)], ids=lambda it: it.kind)
def test_a_spring_that_was_cut_in_two_is_the_whole(damping: Damping) -> None:
    whole = TwoPort(SPRING, damping)
    for cut in (26, 20):
        two = TwoPort(part(cut), damping) @ TwoPort(part(52 - cut), damping)
        numpy.testing.assert_allclose(two.matrix(HERTZ), whole.matrix(HERTZ), rtol=1e-11)
        numpy.testing.assert_allclose(two.drive_point(HERTZ), whole.drive_point(HERTZ), rtol=1e-11)
        numpy.testing.assert_allclose(two.transfer(HERTZ), whole.transfer(HERTZ), rtol=1e-11)
        for load in (Load.held(), Load.mass(0.3), Load.stiffness(300.0, 40.0)):
            numpy.testing.assert_allclose(two.transmittance(HERTZ, load), whole.transmittance(HERTZ, load), rtol=1e-11)
            numpy.testing.assert_allclose(two.motion_ratio(HERTZ, load), whole.motion_ratio(HERTZ, load), rtol=1e-11)
            numpy.testing.assert_allclose(two.loaded(HERTZ, load), whole.loaded(HERTZ, load), rtol=1e-10)


def test_parts_multiply_as_chain_matrices_and_the_inverse_is_the_receptance() -> None:
    left, right = TwoPort(SPRING, Damping.modal(0.01)), TwoPort(part(20), Damping.modal(0.01), "wave")
    joined = left @ Cascade.mass("350 g") @ right @ Cascade.link("9 kN/m", 4.0)
    mass = numpy.broadcast_to(numpy.eye(2, dtype=complex), (4, 2, 2)).copy()
    mass[:, 1, 0] = -0.35 * OMEGA**2
    link = numpy.broadcast_to(numpy.eye(2, dtype=complex), (4, 2, 2)).copy()
    link[:, 0, 1] = 1 / (9e3 + 4j * OMEGA)
    product = link @ right.transmission(HERTZ) @ mass @ left.transmission(HERTZ)
    scale = abs(product).max(axis=(1, 2), keepdims=True)
    assert (abs(joined.transmission(HERTZ) - product) / scale).max() < 1e-13
    unit = joined.matrix(HERTZ) @ joined.receptance(HERTZ)
    numpy.testing.assert_allclose(unit, numpy.broadcast_to(numpy.eye(2), unit.shape), atol=1e-9)  # condition number about 1e3
    numpy.testing.assert_allclose(joined.drive_point(HERTZ, end=2), joined.matrix(HERTZ)[:, 1, 1], rtol=1e-15)


def test_a_mass_at_the_joint_is_in_the_equations_of_all_masses() -> None:
    """Dynamic stiffness of 52 + 1 + 20 masses, assembled and condensed by NumPy."""
    rows = []
    for spring, between in ((SPRING, 0.35), (part(20), 0.0)):
        count = spring.chain_masses
        segments = numpy.full(count + 1, spring.stiffness * count)
        segments[[0, -1]] *= 2
        rows.append((segments, numpy.append(numpy.full(count, spring.mass / count), between)))
    segments = numpy.concatenate([row[0] for row in rows])
    masses = numpy.concatenate([[0.0], *(row[1] for row in rows)])
    stiffness = numpy.diag(numpy.append(segments, 0) + numpy.append(0, segments)) - numpy.diag(segments, 1) - numpy.diag(segments, -1)
    ours = (TwoPort(SPRING) @ Cascade.mass(0.35) @ TwoPort(part(20))).matrix(HERTZ)
    for omega, found in zip(OMEGA, ours):
        dynamic = stiffness - omega**2 * numpy.diag(masses)
        inner = numpy.linalg.solve(dynamic[1:-1, 1:-1], dynamic[1:-1, [0, -1]])
        condensed = dynamic[[0, -1]][:, [0, -1]] - dynamic[[0, -1], 1:-1] @ inner
        numpy.testing.assert_allclose(found, condensed * [[-1], [1]], rtol=1e-10)  # a solve of 73 unknowns


def test_joining_is_associative_and_has_a_direction() -> None:
    spring, mass, link = TwoPort(SPRING, Damping.modal(0.01)), Cascade.mass(0.2), Cascade.link(500.0, 3.0)
    one, other = (spring @ mass) @ link, spring @ (mass @ link)
    assert one == other == Cascade([spring, mass, link]) and one.parts == [spring, mass, link]
    assert (one.matrix(HERTZ) == other.matrix(HERTZ)).all()
    back = link @ mass @ spring
    assert back != one
    numpy.testing.assert_allclose(back.drive_point(HERTZ, end=2), one.drive_point(HERTZ), rtol=1e-12)
    assert (abs(back.drive_point(HERTZ) / one.drive_point(HERTZ) - 1) > 1e-3).all()
    assert repr(mass @ link) == "Cascade.mass(mass=0.2) @ Cascade.link(stiffness=500.0, damping=3.0)"
    assert [part["kind"] for part in one.to_dict()["parts"]] == ["spring", "mass", "link"]


def test_a_joint_that_rings_undamped_is_infinite() -> None:
    link, mass = Cascade.link(300.0), Cascade.mass(6.0)
    rings = 10 / (2 * numpy.pi)
    # 2 pi times that is 10 rad/s but for its last digit, and so may be the resonance.
    hit = next(f for f in (rings, numpy.nextafter(rings, 0), numpy.nextafter(rings, 1)) if 2 * numpy.pi * f == 10)
    at = link @ mass @ link
    assert numpy.isinf(at.matrix([hit]).real).all() and not numpy.isnan(at.matrix([hit])).any()
    assert at.transmittance([hit]) == pytest.approx(-1, rel=1e-12)
    assert numpy.isinf(Cascade.mass(1.0).drive_point([1.0]).real).all()


def test_what_does_not_fit_is_told() -> None:
    spring = TwoPort(SPRING)
    for left, right in [(spring, 3.0), (spring, Load.mass(1.0)), (Cascade.mass(1.0), SPRING), ("a", spring), (None, Cascade.mass(1.0))]:
        with pytest.raises(TypeError, match="unsupported operand type"):
            operator.matmul(left, right)
    assert spring.__matmul__(3.0) is NotImplemented  # type: ignore[operator]
    refused: list[tuple[Callable[[], object], str]] = [
        (lambda: Cascade([]), "parts must hold at least 1 two-port, got 0"),
        (lambda: Cascade.mass(-1.0), "mass must be finite and not below zero, got -1 kg"),
        (lambda: Cascade.mass(numpy.nan), "mass must be finite and not below zero, got NaN kg"),
        (lambda: Cascade.link(0.0), "stiffness must be above zero where the link has no damping, got 0 N/m"),
        (lambda: Cascade.link(1.0, numpy.inf), "damping of the link must be finite and not below zero, got inf N s/m"),
        (lambda: Cascade.mass("1 N"), "mass"),
        (lambda: (spring @ spring).matrix([1.0, numpy.nan]), "angular frequency must be finite"),
        (lambda: (spring @ spring).drive_point([1.0], end=0), "end must be 1 or 2, got 0"),
    ]
    for call, told in refused:
        with pytest.raises(coilsense.Error, match=told):
            call()
    with pytest.raises(TypeError):
        Cascade([spring, SPRING])  # type: ignore[list-item]
    assert (spring @ spring).matrix([]).shape == (0, 2, 2)
