"""Kendall's exact test of values against their order, and the slope of Theil and Sen, by SciPy.

Each row holds the number of values n, S, p of the two-sided test, the slope, and the n values. Values are distinct.
"""


import platform

import numpy as np
import scipy
from scipy import stats

from golden import SCIENCE

LONGEST = 40


def row(values):
    order = np.arange(len(values))
    test = stats.kendalltau(order, values, method="exact")
    pairs = len(values) * (len(values) - 1) // 2
    slope = stats.theilslopes(values, order).slope
    return [len(values), round(test.statistic * pairs), test.pvalue, slope, *values]


def main():
    generator = np.random.default_rng(5)
    rows = []
    for count in (3, 4, 5, 8, 15, 16, 33, LONGEST):
        for drift in (0.0, 0.05, 0.5, -2.0):
            values = generator.normal(size=count) + drift * np.arange(count)
            rows.append(row(values.round(6)))
    versions = f"SciPy {scipy.__version__}, NumPy {np.__version__}, Python {platform.python_version()}"
    head = f"# {versions}; 16 digits; trend.py: kendalltau (exact) and theilslopes\nn,s,p,slope," + ",".join(f"x{index}" for index in range(LONGEST))
    lines = [",".join(repr(float(v)) if isinstance(v, (float, np.floating)) else str(v) for v in r) for r in rows]
    lines = [line + "," * (LONGEST - r[0]) for line, r in zip(lines, rows)]
    (SCIENCE / "trend.csv").write_text(head + "\n" + "\n".join(lines) + "\n")


main()
