"""What unpickling calls where a constructor alone does not say it all."""

from typing import Any

from coilsense._coilsense import Cascade, Excitation, Motion, Mount, Spring, TwoPort


def spring(arguments: dict[str, Any]) -> Spring:
    """A spring as it was, be it one of a spec whose mass is that of no wire."""
    return Spring._kept(**arguments)


def motion(spring: Spring, excitation: Excitation, mount: Mount, modes: int | None) -> Motion:
    """A motion, truncated to its first ``modes`` where that is given."""
    full = Motion(spring, excitation, mount)
    return full if modes is None else full.truncated(modes)


def cascade(parts: list[tuple[str, dict[str, Any]]]) -> Cascade:
    """A cascade of parts by kind and arguments."""
    return Cascade([TwoPort(**made) if kind == "spring" else getattr(Cascade, kind)(**made) for kind, made in parts])
