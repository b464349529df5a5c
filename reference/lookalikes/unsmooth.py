"""Assemblies with one law that is not linear: a mass that rubs, or windings that touch. Stepped in modes, exactly but for the law's
force, which stays the same over a step.

Next door: the linear answer that this adds to (assembly.py).
"""

import numpy as np


class Stepper:
    """The modes' states under forces that stay over a step."""

    def __init__(self, modes, rate):
        omega, zeta, step = modes.angular, modes.ratios, 1 / rate
        turn = omega * np.sqrt(1 - zeta**2)
        fall, sine, cosine = np.exp(-zeta * omega * step), np.sin(turn * step), np.cos(turn * step)
        lag = zeta * omega / turn
        self.place_by_place, self.place_by_speed = fall * (cosine + lag * sine), fall * sine / turn
        self.speed_by_place, self.speed_by_speed = -fall * sine * omega**2 / turn, fall * (cosine - lag * sine)
        self.place_by_force = (1 - self.place_by_place) / omega**2
        self.speed_by_force = self.place_by_speed
        self.place, self.speed = np.zeros(len(omega)), np.zeros(len(omega))

    def free(self):
        """One step without a force."""
        place = self.place_by_place * self.place + self.place_by_speed * self.speed
        self.speed = self.speed_by_place * self.place + self.speed_by_speed * self.speed
        self.place = place

    def push(self, force):
        """What a force on the modes over the last step adds."""
        self.place += self.place_by_force * force
        self.speed += self.speed_by_force * force


def rubbing(modes, rate, node, friction, speed, rows):
    """What Coulomb friction [N] on a mass adds to rows of motion; `speed` [m/s] is what the mass has without it.

    Each step takes the friction that stops the mass by its end, or all of it: it sticks and slips without a softened law.
    """
    stepper, shape = Stepper(modes, rate), modes.shapes[node]
    mobility = shape @ (stepper.speed_by_force * shape)
    sights = rows @ modes.shapes
    out = np.zeros((len(rows), len(speed)))
    for sample in range(1, len(speed)):
        stepper.free()
        moving = speed[sample] + shape @ stepper.speed
        force = min(max(-moving / mobility, -friction), friction)
        stepper.push(force * shape)
        out[:, sample] = sights @ stepper.place
    return out


def touching(modes, rate, gaps, stiffness, damping, place, rows):
    """What contact of neighbouring masses adds to rows of motion; `place`, shape masses x samples, is theirs without it.

    Masses i and i+1 touch where they come nearer than gaps[i] [m]; then stiffness [N/m] and damping [N s/m] push, and never pull.
    """
    stepper, between = Stepper(modes, rate), np.diff(modes.shapes, axis=0)
    nearer, sights = np.diff(place, axis=0).T.copy(), rows @ modes.shapes
    faster = np.gradient(nearer, 1 / rate, axis=0)
    out = np.zeros((len(rows), place.shape[1]))
    for sample in range(1, place.shape[1]):
        stepper.free()
        depth = -(nearer[sample] + between @ stepper.place) - gaps
        if depth.max() > 0:
            closing = -(faster[sample] + between @ stepper.speed)
            push = np.where(depth > 0, np.maximum(stiffness * depth + damping * closing, 0), 0)
            stepper.push(push @ between)
        out[:, sample] = sights @ stepper.place
    return out
