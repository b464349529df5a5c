"""NumPy: the modal sum as a matrix product, as one who knows both would write it.

On two levels, t = t_p +- t_q with t_p = p B/rate and q from 0 to B/2: a mode's cosine c and sine s give
    (c cos w t_p + s sin w t_p) cos w t_q  +-  (s cos w t_p - c sin w t_p) sin w t_q,
so that two small tables and two matrix products make all samples. Odd modes push both ends oppositely and even ones alike,
so that one sum over each serves both ends; what is not excited is left out; a sine at end 1 is one more "mode".
"""

import numpy as np
from scipy.fft import irfft, next_fast_len, rfft


class Chain:
    """Modes of the spring, and the end force of a straight line of displacements, mode by mode."""

    def __init__(self, spring):
        n = spring["windings"]
        mode = np.arange(1, n + 1)
        self.omega = 2 * n * np.sqrt(spring["stiffness"] / spring["mass"]) * np.sin(mode * (np.pi / (2 * n)))
        self.odd = mode % 2 == 1
        # Force 2Nk s_j of a mode times projection 1/(2 s_j) (2/N) of a line: s_j = sin(j pi / 2N) cancels.
        self.gain = np.full(n, 2 * spring["stiffness"])
        self.gain[-1] = spring["stiffness"]

    def line(self, first, last):
        return self.gain * np.where(self.odd, first + last, first - last)


def two_levels(omega, cosine, sine, samples, rate):
    """sum_j cosine_j cos(omega_j t) + sine_j sin(omega_j t) at t = 0, 1/rate, ..."""
    used = (cosine != 0) | (sine != 0)
    if not used.any():
        return 0.0
    if not used.all():
        omega, cosine, sine = omega[used], cosine[used], sine[used]
    half = int(np.ceil(np.sqrt(0.5 * samples)))
    blocks = samples // (2 * half) + 2
    coarse = np.outer(np.arange(blocks) * (2 * half / rate), omega)
    fine = np.outer(omega, np.arange(half + 1) / rate)
    c, s = np.cos(coarse), np.sin(coarse)
    even = (cosine * c + sine * s) @ np.cos(fine)
    odd = (sine * c - cosine * s) @ np.sin(fine)
    result = np.empty((blocks, 2 * half))
    result[:, half:] = (even + odd)[:, :half]
    result[:, half::-1] = even - odd
    return result.ravel()[half : half + samples]


def end_forces(job):
    """F_i and F_o [N] at all samples."""
    chain, u1 = Chain(job["spring"]), job["u1"]
    (x1, x2), (v1, v2) = job["start"]["position"], job["start"]["velocity"]
    length, stiffness = job["mean_length"], job["spring"]["stiffness"]
    preload = stiffness * (length - job["spring"]["rest_length"])
    first = u1["samples"][0] if u1["kind"] == "sampled" else 0.0
    place, speed = chain.line(x1 - first, x2 - length), chain.line(v1, v2)
    sums = {"held": free, "harmonic": harmonic, "sampled": recorded}[u1["kind"]]
    odd, even = sums(job, chain, place, speed)
    even = even + preload
    return even + odd, even - odd


def free(job, chain, place, speed):
    """Odd and even sum with both ends held."""
    for part in (chain.odd, ~chain.odd):
        yield two_levels(chain.omega[part], place[part], speed[part] / chain.omega[part], job["samples"], job["rate"])


def harmonic(job, chain, place, speed):
    """Odd and even sum with u1 = a sin(W t + p); the even one carries -k u1, which both ends feel alike."""
    u1, omega = job["u1"], chain.omega
    a, big_omega, phase = u1["amplitude"], 2 * np.pi * u1["frequency"], u1["phase"]
    per_line = chain.line(1.0, 0.0)
    forced = per_line * a * big_omega**2 / (omega**2 - big_omega**2)
    sine, cosine = np.sin(phase), np.cos(phase)
    place = place - (per_line * a + forced) * sine
    speed = speed - (per_line * a + forced) * (big_omega * cosine)
    for part, common in ((chain.odd, 0.0), (~chain.odd, -job["spring"]["stiffness"] * a)):
        steady = forced[part].sum() + common
        yield two_levels(
            np.append(omega[part], big_omega),
            np.append(place[part], steady * sine),
            np.append(speed[part] / omega[part], steady * cosine),
            job["samples"],
            job["rate"],
        )


def recorded(job, chain, place, speed):
    """Odd and even sum with a sampled u1: each change of slope is a blow, convolved with the answer to one blow."""
    samples, rate = job["samples"], job["rate"]
    blows = np.diff(np.diff(job["u1"]["samples"]) * rate, prepend=0.0)
    size = next_fast_len(2 * samples - 1, real=True)
    spectrum, per_blow = rfft(blows, size), -chain.line(1.0, 0.0) / chain.omega
    for part, common in ((chain.odd, 0.0), (~chain.odd, -job["spring"]["stiffness"] * job["u1"]["samples"])):
        omega = chain.omega[part]
        answer = two_levels(omega, np.zeros_like(omega), per_blow[part], samples, rate)
        own = two_levels(omega, place[part], speed[part] / omega, samples, rate)
        yield irfft(rfft(answer, size) * spectrum, size)[:samples] + (own + common)
