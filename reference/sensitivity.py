"""Sobol indices of Ishigami's function and of Sobol's g-function, by SALib.

`sensitivity.csv` holds the values of both functions on SALib's scrambled Sobol sample of BASE rows, in SALib's order: for each base
row f(A), f(A_B^1) ... f(A_B^k), f(B). `sensitivity_indices.csv` holds, for each variable, SALib's first-order and total index of these
values (the estimators of Saltelli 2010, centred values), and the exact indices of the function.
"""

from importlib.metadata import version

import platform

import numpy as np
from SALib.analyze import sobol as analysis
from SALib.sample import sobol as sampling

from golden import LAB

BASE = 128
G = np.array([0.0, 1.0, 4.5, 9.0, 99.0, 99.0])
A, B = 7.0, 0.1


def ishigami(x):
    return np.sin(x[:, 0]) + A * np.sin(x[:, 1]) ** 2 + B * x[:, 2] ** 4 * np.sin(x[:, 0])


def ishigami_exact():
    """Ishigami and Homma 1990: the parts of the variance in closed form."""
    v1 = 0.5 * (1 + B * np.pi**4 / 5) ** 2
    v2 = A**2 / 8
    v13 = B**2 * np.pi**8 * (1 / 18 - 1 / 50)
    total = v1 + v2 + v13
    return [v1 / total, v2 / total, 0.0], [(v1 + v13) / total, v2 / total, v13 / total]


def g_function(x):
    return np.prod((np.abs(4 * x - 2) + G) / (1 + G), axis=1)


def g_exact():
    own = 1 / (3 * (1 + G) ** 2)
    total = np.prod(1 + own) - 1
    return list(own / total), [own[i] * np.prod(np.delete(1 + own, i)) / total for i in range(len(G))]


def main():
    cases = [
        ("ishigami", ishigami, [[-np.pi, np.pi]] * 3, ishigami_exact()),
        ("g", g_function, [[0.0, 1.0]] * len(G), g_exact()),
    ]
    head = f"# SALib {version('SALib')}, NumPy {np.__version__}, Python {platform.python_version()}; 17 digits; sensitivity.py: "
    values = [head + "the two functions on sobol.sample(scramble=True, seed=3)", "function,value"]
    indices = [head + "sobol.analyze without second order, and closed forms", "function,variable,s1,st,s1_exact,st_exact"]
    for name, function, bounds, (first, total) in cases:
        problem = {"num_vars": len(bounds), "names": [f"x{i + 1}" for i in range(len(bounds))], "bounds": bounds}
        x = sampling.sample(problem, BASE, calc_second_order=False, scramble=True, seed=3)
        y = function(x)
        found = analysis.analyze(problem, y, calc_second_order=False, seed=1)
        values += [f"{name},{float(value)!r}" for value in y]
        for i in range(len(bounds)):
            row = [found["S1"][i], found["ST"][i], first[i], total[i]]
            indices.append(f"{name},x{i + 1}," + ",".join(repr(float(value)) for value in row))
    (LAB / "sensitivity.csv").write_text("\n".join(values) + "\n")
    (LAB / "sensitivity_indices.csv").write_text("\n".join(indices) + "\n")


main()
