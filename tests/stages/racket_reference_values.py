#!/usr/bin/env python3
"""Writes racket_reference_values.hpp: a ball on a disc racket and its rim, followed with 34 digits.

A second, slow and plain way, independent of the course's code: seen from the ground, contacts by the
extrapolated midpoint rule (Gragg, Bulirsch and Stoer) in steps of 0.5 ms at order 24, and every
event found by bisection of a step. Needs mpmath (Debian: python3-mpmath); the tests need only the
values.
usage: python3 racket_reference_values.py > racket_reference_values.hpp
"""
from mpmath import mp, mpf, sqrt

mp.dps = 34


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def plus(a, b, s=1):
    return [x + s * y for x, y in zip(a, b)]


class Run:
    def __init__(self, case):
        (self.k, self.c, self.push_only, p, v, n, u) = case
        self.k, self.c = mpf(self.k), mpf(self.c)
        self.m, self.g, self.r, self.R = mpf(1), mpf("9.81"), mpf("0.1"), mpf("0.3")
        n = [mpf(x) for x in n]
        self.n = [x / sqrt(dot(n, n)) for x in n]
        self.u = [mpf(x) for x in u]
        self.t, self.y = mpf(0), [mpf(x) for x in p] + [mpf(x) for x in v]
        self.phase, self.place, self.side = "flight", None, 1

    # Seen from the disc: height on the ball's side, way along the disc, its length, velocity.
    def seen(self, t, y):
        way = plus(y[:3], self.u, -t)
        up = [self.side * x for x in self.n]
        height = dot(way, up)
        along = plus(way, up, -height)
        return height, along, sqrt(dot(along, along)), plus(y[3:], self.u, -1), up

    # Distance and its gradient.
    def gap(self, t, y, place):
        height, along, lateral, v, up = self.seen(t, y)
        if place == "face":
            return height, up, v
        out = [x / lateral for x in along]
        x = lateral - self.R
        l = sqrt(x * x + height * height)
        if place == "rim":
            d, dx, dy = l, x / l, height / l
        else:  # (x^2 - y^2) / l, differentiated as a quotient
            q = x * x - height * height
            d, dx, dy = q / l, 2 * x / l - q * x / l**3, -2 * height / l - q * height / l**3
        return d, plus([dx * e for e in out], up, dy), v

    def push(self, t, y):
        d, grad, v = self.gap(t, y, self.place)
        return self.k * (self.r - d) - self.c * dot(grad, v), d, grad

    def rate(self, t, y):
        a = [mpf(0), -self.g, mpf(0)]
        if self.phase == "touch":
            push, _, grad = self.push(t, y)
            a = plus(a, grad, push / self.m)
        return y[3:] + a

    def step(self, h):
        """Modified midpoint with 2, 4, ... substeps, extrapolated to none."""
        if self.phase != "touch":  # the parabola
            a = [mpf(0), -self.g, mpf(0)]
            return plus(plus(self.y[:3], self.y[3:], h), a, h * h / 2) + plus(self.y[3:], a, h)
        rows = []
        for j in range(1, 13):
            n = 2 * j
            s = h / n
            before, now = self.y, plus(self.y, self.rate(self.t, self.y), s)
            for i in range(1, n):
                before, now = now, plus(before, self.rate(self.t + i * s, now), 2 * s)
            end = plus(plus(before, now), self.rate(self.t + h, now), s)
            row = [[x / 2 for x in end]]
            for m in range(1, j):
                factor = (mpf(j) / (j - m)) ** 2 - 1
                row.append([a + (a - b) / factor for a, b in zip(row[m - 1], rows[-1][m - 1])])
            rows.append(row)
        return rows[-1][-1]

    def events(self, t, y):
        """What is positive until it happens."""
        if self.phase == "flight":
            height, _, lateral, _, _ = self.seen(t, y)
            x = lateral - self.R
            return {"touch": (abs(height) if x < 0 else sqrt(x * x + height * height)) - self.r}
        push, d, _ = self.push(t, y)
        height, _, lateral, _, _ = self.seen(t, y)
        pushes = self.push_only and self.c > 0
        all = {}
        if self.phase == "let go" or not pushes:
            all["out"] = self.r - d
        if pushes:
            all["push"] = push if self.phase == "touch" else -push
        all["inside"] = self.R - lateral if self.place == "face" else lateral - self.R
        if self.place == "beyond":
            all["height"] = -height
        return all

    def happen(self, what):
        height, _, lateral, _, _ = self.seen(self.t, self.y)
        if what == "touch":
            self.side *= 1 if height >= 0 else -1
            self.place = "face" if lateral < self.R else "rim"
            self.phase = "touch"
        elif what == "out":
            self.phase = "flight"
        elif what == "push":
            self.phase = "let go" if self.phase == "touch" else "touch"
        elif what == "height":
            self.place = "rim"
        elif self.place == "face":
            self.place = "rim" if height >= 0 else "beyond"
        else:
            if self.place == "rim" and height < 0:
                self.side *= -1
            self.place = "face"
        self.log.append(what + ":" + str(self.place))

    def advance(self, until):
        h = mpf("0.0005")
        while self.t < until:
            h_now = min(h, until - self.t)
            start = self.events(self.t, self.y)
            y = self.step(h_now)
            now = self.events(self.t + h_now, y)
            fallen = [e for e in now if now[e] < 0 and start[e] > -mpf(10) ** -25]
            # An event that has just happened starts at zero, and must rise first.
            fallen = [e for e in fallen if start[e] > mpf(10) ** -25 or now[e] < -mpf(10) ** -12]
            if not fallen:
                self.t, self.y = self.t + h_now, y
                continue
            best = None
            for e in fallen:
                low, high = mpf(0), h_now
                for _ in range(112):
                    middle = (low + high) / 2
                    if self.events(self.t + middle, self.step(middle))[e] > 0:
                        low = middle
                    else:
                        high = middle
                if best is None or high < best[0]:
                    best = (high, e)
            self.y = self.step(best[0])
            self.t += best[0]
            self.happen(best[1])

    log = []


up = (0, 1, 0)
rest = (0, 0, 0)
cases = [  # stiffness, damping, push only, position, velocity, normal, racket velocity
    ("on the rim", "1e4", 0, False, ("0.33", 1, "0.02"), rest, up, rest),
    ("on the rim, damped", "1e4", "14.17", False, ("0.35", 1, 0), rest, up, rest),
    ("on the rim, pushed only", "1e4", 100, True, ("0.31", 1, 0), (0, 0, "0.4"), up, rest),
    ("from below", "1e4", 5, False, ("0.32", "-0.5", 0), (0, 6, 0), up, rest),
    ("off the face over the rim of a moving, leaning racket", "1e4", 10, False,
     ("0.08", "0.6", "0.1"), (1, 0, "0.1"), ("0.1", 1, "-0.05"), ("0.3", "1.2", "-0.2")),
    ("through the disc and out over the rim", "1e4", 5, False, ("0.2", "0.3", 0), (4, -14, 1), up,
     rest),
    ("through the disc and out, pushed only", "1e4", 60, True, ("0.2", "0.3", 0), (5, -22, 0), up,
     rest),
    ("onto the face from the rim", "2000", 20, False, ("0.645", "0.5", 0), ("-1.2", 0, "0.3"), up,
     rest),
]
if __name__ == "__main__":
    print("""#pragma once
// Made by racket_reference_values.py: 34 digits, rounded to double.
#include <array>
#include <string>
#include <vector>

namespace bounce::test {

struct RacketReferenceCase {
  std::string name, settings;
  std::vector<std::array<double, 7>> rows;  // t, position, velocity
};

inline const std::vector<RacketReferenceCase> racket_reference_cases{""")
    for (name, *case) in cases:
        run = Run(case)
        run.log = []
        k, c, push_only, p, v, n, u = case
        text = lambda a: ",".join(str(x) for x in a)
        words = "stiffness=%s damping=%s contact=%s position=%s velocity=%s racket_normal=%s" % (
            k, c, "push-only" if push_only else "may-pull", text(p), text(v), text(n))
        print('    {"%s",\n     "%s "\n     "racket_velocity=%s",\n     {' % (name, words, text(u)))
        for row in range(1, 9):
            t = mpf(row) / 10
            run.advance(t)
            numbers = ", ".join(mp.nstr(x, 17) for x in [run.t] + run.y)
            print("         {%s}," % numbers)
        print("     }},")
        import sys
        print(name, run.log, file=sys.stderr)
    print("""};

}  // namespace bounce::test""")
