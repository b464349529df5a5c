"""Table I of the paper: the two coil springs, as the doubles nearest to the printed decimals (SI units).

No formula of the model lives here; every script states its own.
"""

from typing import NamedTuple


class Spring(NamedTuple):
    name: str
    rest_length: float  # l0 [m]
    windings: int  # N
    radius: float  # r [m], of the coil
    wire_radius: float  # rho [m]
    mass: float  # m [kg]
    stiffness: float  # k [N/m]
    shortest: float  # l_min [m]
    longest: float  # l_max [m]

    @property
    def middle(self):
        """Middle of the operating range [m], in doubles."""
        return 0.5 * (self.shortest + self.longest)

    @property
    def span(self):
        """Operating range l_max - l_min [m], in doubles; also the end-stop speed in m/s, eq. (12)."""
        return self.longest - self.shortest


S_T = Spring("S_T", 0.104, 52, 0.008, 0.001, 0.065, 760.0, 0.196, 0.264)
S_A = Spring("S_A", 0.081, 25, 0.008, 0.0016, 0.08, 9100.0, 0.082, 0.122)
SPRINGS = (S_T, S_A)
