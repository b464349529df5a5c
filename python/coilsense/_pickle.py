"""What unpickling calls where a constructor alone does not say it all."""

from coilsense._coilsense import Excitation, Motion, Mount, Spring


def motion(spring: Spring, excitation: Excitation, mount: Mount, modes: int | None) -> Motion:
    """A motion, truncated to its first ``modes`` where that is given."""
    full = Motion(spring, excitation, mount)
    return full if modes is None else full.truncated(modes)
