"""All kinds of log by name: springs first, then what is none."""

import zlib

import numpy as np

import channel_kinds
import last_kinds
import mount_kinds
import resonance_kinds
import source_kinds

SPRINGS = mount_kinds.KINDS + channel_kinds.KINDS + last_kinds.SPRINGS
STRANGERS = resonance_kinds.KINDS + source_kinds.KINDS + last_kinds.STRANGERS
KINDS = {kind.__name__.replace("_", "-"): kind for kind in SPRINGS + STRANGERS}


def make(kind, seed, number):
    """Log `number` of a kind: the same whatever else is made."""
    log = KINDS[kind](np.random.default_rng([seed, zlib.crc32(kind.encode()), number]))
    assert log.truth.kind == kind, f"{kind} calls itself {log.truth.kind}"
    return log
