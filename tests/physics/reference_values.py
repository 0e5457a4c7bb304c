#!/usr/bin/env python3
"""Writes reference_values.hpp: a ball on a spring floor, followed with 50 digits.

A second, slow and plain way to the exact solution, independent of the course's code: each contact
is a sum of two complex exponentials, and its end is found by walking in small steps until the sign
changes, then by bisection. Needs mpmath (Debian: python3-mpmath); the tests need only the values.
usage: python3 reference_values.py > reference_values.hpp
"""
from mpmath import mp, mpf, mpc, exp, sqrt, pi

mp.dps = 50


def bisect(f, low, high):
    sign = f(low) > 0
    for _ in range(180):
        middle = (low + high) / 2
        if (f(middle) > 0) == sign:
            low = middle
        else:
            high = middle
    return (low + high) / 2


def first_change(f, step, longest):
    """The first sign change of f after 0, found on a grid; None within `longest`."""
    t = step / 1000  # f may be zero at the start
    sign = f(t) > 0
    while t < longest:
        if (f(t + step) > 0) != sign:
            return bisect(f, t, t + step)
        t += step
    return None


class Ball:
    def __init__(self, m, g, r, k, c, push_only, y, v):
        self.m, self.g, self.r, self.k, self.c = map(mpf, (m, g, r, k, c))
        self.push_only = push_only
        self.t, self.y, self.v = mpf(0), mpf(y), mpf(v)
        self.phase = "flight" if self.y >= self.r else "touch"

    def flight(self, t):
        return self.y + self.v * t - self.g * t * t / 2, self.v - self.g * t

    def touch(self, t):
        beta = self.c / (2 * self.m)
        root = sqrt(mpc(beta * beta - self.k / self.m))
        rest = self.r - self.m * self.g / self.k
        x0 = self.y - rest
        l1, l2 = -beta + root, -beta - root
        a = (self.v - l2 * x0) / (l1 - l2)
        b = x0 - a
        e1, e2 = a * exp(l1 * t), b * exp(l2 * t)
        return (rest + (e1 + e2).real, (l1 * e1 + l2 * e2).real)

    def force(self, state):
        return self.k * (self.r - state[0]) - self.c * state[1]

    def phase_end(self, longest):
        if self.phase == "flight":
            h = self.y - self.r
            return (self.v + sqrt(self.v ** 2 + 2 * self.g * h)) / self.g, "touch"
        step = pi * sqrt(self.m / self.k) / 400
        if self.phase == "touch":
            if self.push_only and self.c > 0:
                end = first_change(lambda t: self.force(self.touch(t)), step, longest)
                return end, "let_go"
            end = first_change(lambda t: self.touch(t)[0] - self.r, step, longest)
            return end, "flight"
        out = first_change(lambda t: self.flight(t)[0] - self.r, step, longest)
        again = first_change(lambda t: self.force(self.flight(t)), step, longest)
        if again is not None and (out is None or again < out):
            return again, "touch"
        return out, "flight"

    def at(self, t):
        """(position, velocity) at time t, events passed on the way."""
        move = lambda: self.touch if self.phase == "touch" else self.flight
        while True:
            if not hasattr(self, "end"):
                self.end = self.phase_end(mpf("0.3"))
            after, following = self.end
            if after is None or self.t + after > t:
                return move()(t - self.t)
            self.y, self.v = move()(after)
            self.t += after
            self.phase = following
            del self.end


CASES = [  # m, g, r, k, c, push-only, y, v, times
    ("1", "9.81", "0.1", "1e4", "0", False, "1", "0", ["1", "2.5", "5", "10"]),
    ("1", "9.81", "0.1", "1e4", "5", False, "1", "0", ["0.44", "1", "2.5", "5"]),
    ("1", "9.81", "0.1", "1e4", "5", True, "1", "0", ["0.45", "1", "2.5", "5"]),
    ("0.37", "9.80665", "0.113", "812.3", "2.9", False, "1.2", "0.4", ["0.6", "1.5", "3"]),
    ("0.37", "9.80665", "0.113", "812.3", "2.9", True, "1.2", "0.4", ["0.6", "1.5", "3"]),
    ("1", "9.81", "0.1", "1e4", "199.9999999", True, "1", "0", ["0.43", "0.46", "0.6"]),
    ("1", "9.81", "0.1", "1e4", "450", True, "1", "0", ["0.43", "0.5", "0.6"]),
    ("1", "9.81", "0.1", "1e4", "450", False, "1", "0", ["0.43", "0.5", "0.6"]),
    ("0.021", "9.81", "0.02", "3.1e6", "1", True, "0.3", "-1", ["0.15", "0.5", "0.9"]),
    ("1e-12", "9.81", "1e-4", "3e6", "1e-8", False, "1e-3", "0", ["0.0137", "0.02", "0.05"]),
]

print("#pragma once")
print("// Written by reference_values.py (mpmath, 50 digits). Do not edit.")
print('#include "physics/contact.hpp"')
print()
print("namespace bounce::test {")
print()
print("struct ReferenceValue {")
print("  double mass, gravity, radius, stiffness, damping;")
print("  ContactLaw law;")
print("  double position, velocity;  // at the start")
print("  double t, y, v;             // the answer")
print("};")
print()
print("inline constexpr ReferenceValue reference_values[] = {")
for m, g, r, k, c, push_only, y, v, times in CASES:
    # The parameters are the doubles that the program reads, not the decimals.
    exact = [mpf(float(x)) for x in (m, g, r, k, c)]
    ball = Ball(*exact, push_only, mpf(float(y)), mpf(float(v)))
    for t in times:
        answer = ball.at(mpf(float(t)))
        law = "ContactLaw::push_only" if push_only else "ContactLaw::may_pull"
        print(f"    {{{m}, {g}, {r}, {k}, {c}, {law}, {y}, {v},")
        print(f"     {t}, {mp.nstr(answer[0], 20)}, {mp.nstr(answer[1], 20)}}},")
print("};")
print()
print("}  // namespace bounce::test")
