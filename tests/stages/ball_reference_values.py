#!/usr/bin/env python3
"""Writes ball_reference_values.hpp: balls that collide, followed with 40 digits.

A second, slow and plain way to the true movement, independent of the course's code: while nobody
new touches and nobody lets go, the law is smooth, and extrapolation (Gragg, Bulirsch and Stoer)
follows it to 30 digits; each step ends where a contact changes, found by regula falsi. Needs
mpmath (Debian: python3-mpmath) and some seconds; the tests need only the values.
usage: python3 ball_reference_values.py > ball_reference_values.hpp
"""
import sys
from mpmath import mp, mpf, sqrt

mp.dps = 40
GOAL = mpf(10) ** -30


class Balls:
    def __init__(self, gravity, k, c, push_only, floor, balls):
        """balls: (mass, radius, (x, y, z), (vx, vy, vz)), doubles. One law for pairs and floor."""
        self.g, self.k, self.c, self.push_only = mpf(gravity), mpf(k), mpf(c), push_only
        self.m = [mpf(b[0]) for b in balls]
        self.r = [mpf(b[1]) for b in balls]
        self.x = [mpf(a) for b in balls for a in b[2]]
        self.v = [mpf(a) for b in balls for a in b[3]]
        n = len(balls)
        self.contacts = [(i, j) for i in range(n) for j in range(i + 1, n)]
        if floor:
            self.contacts += [(i, None) for i in range(n)]
        self.mode = {two: self.mode_at_start(two) for two in self.contacts}
        self.t = mpf(0)
        fastest = sqrt(2 * self.k / min(self.m)) + 2 * self.c / min(self.m)
        self.longest = 1 / (4 * fastest)

    # ---- The law

    def gap(self, two, x, v):
        """Distance of the surfaces, the speed at which it grows, unit vector to the first."""
        i, j = two
        if j is None:
            return x[3 * i + 1] - self.r[i], v[3 * i + 1], (0, 1, 0)
        between = [x[3 * i + a] - x[3 * j + a] for a in range(3)]
        d = sqrt(sum(b * b for b in between))
        e = [b / d for b in between]
        speed = sum((v[3 * i + a] - v[3 * j + a]) * e[a] for a in range(3))
        return d - self.r[i] - self.r[j], speed, e

    def push(self, two, x, v):
        gap, speed, _ = self.gap(two, x, v)
        return -self.k * gap - self.c * speed

    def acceleration(self, x, v):
        a = [mpf(0)] * len(x)
        for i in range(len(self.m)):
            a[3 * i + 1] = -self.g
        for two in self.contacts:
            if self.mode[two] != "touch":
                continue
            gap, speed, e = self.gap(two, x, v)
            force = -self.k * gap - self.c * speed
            i, j = two
            for axis in range(3):
                a[3 * i + axis] += force * e[axis] / self.m[i]
                if j is not None:
                    a[3 * j + axis] -= force * e[axis] / self.m[j]
        return a

    # ---- What changes

    def mode_at_start(self, two):
        if self.gap(two, self.x, self.v)[0] >= 0:
            return "apart"
        pulls = self.push_only and self.c > 0 and self.push(two, self.x, self.v) <= 0
        return "let go" if pulls else "touch"

    def ends(self, two):
        """[(function, positive until that happens), what is then]"""
        gap = lambda x, v: self.gap(two, x, v)[0]
        if self.mode[two] == "apart":
            return [(gap, "touch")]
        if self.mode[two] == "let go":
            return [(lambda x, v: -gap(x, v), "apart"),
                    (lambda x, v: -self.push(two, x, v), "touch")]
        if self.push_only and self.c > 0:
            return [(lambda x, v: self.push(two, x, v), "let go")]
        return [(lambda x, v: -gap(x, v), "apart")]

    # ---- A step

    def midpoint(self, h, n):
        """Gragg's modified midpoint rule, n substeps."""
        h = h / n
        y0, y1 = self.x + self.v, None
        half = len(self.x)
        slope = lambda y: y[half:] + self.acceleration(y[:half], y[half:])
        y1 = [p + h * s for p, s in zip(y0, slope(y0))]
        for _ in range(n - 1):
            y0, y1 = y1, [p + 2 * h * s for p, s in zip(y0, slope(y1))]
        return [(p + q + h * s) / 2 for p, q, s in zip(y0, y1, slope(y1))]

    def step(self, h):
        """(x, v) after h, or None if it takes a shorter step."""
        table = []
        for k in range(16):
            row = [self.midpoint(h, 2 * (k + 1))]
            for j in range(k):
                ratio = (mpf(k + 1) / (k - j)) ** 2
                row.append([q + (q - p) / (ratio - 1) for q, p in zip(row[j], table[k - 1][j])])
            table.append(row)
            if k > 2 and max(abs(p - q) for p, q in zip(row[-1], row[-2])) < GOAL:
                return row[-1][:len(self.x)], row[-1][len(self.x):]
        return None

    def go_to(self, t):
        while self.t < t:
            h = min(self.longest if "touch" in self.mode.values() else mpf("0.01"), t - self.t)
            after = self.step(h)
            while after is None:
                h /= 2
                after = self.step(h)
            event = None
            while True:  # the earliest of those that happen in this step
                happening = [(f, two, what) for two in self.contacts for f, what in self.ends(two)
                             if f(*after) < 0 and (two, what) != event]
                if not happening:
                    break
                f, two, what = happening[0]
                h, after = self.cut(f, h, after)
                event = (two, what)
            self.x, self.v = after
            self.t += h
            if event:
                self.mode[event[0]] = event[1]

    def cut(self, f, h, after):
        """The step that ends where f is zero. Regula falsi in the Illinois form: the root stays
        between low and high, and an end that stays counts half."""
        low, f_low, high, f_high = mpf(0), f(self.x, self.v), h, f(*after)
        side = 0
        for _ in range(300):
            if f_low <= 0 or high - low < GOAL or f_high == 0:
                break
            middle = high - f_high * (high - low) / (f_high - f_low)
            after_middle = self.step(middle)
            f_middle = f(*after_middle)
            if f_middle > 0:
                low, f_low = middle, f_middle
                f_high = f_high / 2 if side > 0 else f_high
                side = 1
            else:
                high, f_high, after = middle, f_middle, after_middle
                f_low = f_low / 2 if side < 0 else f_low
                side = -1
        if f(self.x, self.v) <= 0:  # together with the event before
            return mpf(0), (self.x, self.v)
        return high, after


def ball(x, y, z, vx=0.0, vy=0.0, vz=0.0, mass=1.0, radius=0.1):
    return (mass, radius, (x, y, z), (vx, vy, vz))


def cradle(count):  # as in scenes.hpp, in doubles
    row = [ball((0.2 + 1e-12) * (i - (count - 1) / 2.0), 0.1, 0.0) for i in range(count)]
    x = row[0][2][0] - 0.3
    return [ball(x, 0.1, 0.0, vx=0.3)] + row[1:]


CASES = [  # name, gravity, k, c, push-only, floor, balls, times
    ("oblique", 0.0, 1e4, 0.0, False, False,
     [ball(-0.6, 0.1, 0.1, vx=1.0), ball(0.0, 0.1, 0.0)], [0.44, 1.0, 1.5]),
    ("oblique, damped", 0.0, 1e4, 30.0, False, False,
     [ball(-0.6, 0.12, 0.1, vx=1.0), ball(0.0, 0.1, 0.0)], [0.44, 1.0]),
    ("oblique, damped, only pushing", 0.0, 1e4, 60.0, True, False,
     [ball(-0.6, 0.12, 0.05, vx=1.0), ball(0.0, 0.1, 0.0)], [0.44, 1.0]),
    ("a million times heavier", 0.0, 1e4, 2.0, False, False,
     [ball(0.0, 0.1, 0.0, vx=2.0, mass=1e6, radius=0.2), ball(0.7, 0.25, 0.05)], [0.3, 1.0]),
    ("one ball hits two that touch", 0.0, 1e4, 10.0, False, False,
     [ball(-0.5, 0.1, 0.03, vx=2.0), ball(0.0, 0.1, -0.1), ball(0.0, 0.1, 0.1)], [0.18, 0.6]),
    ("cradle", 0.0, 1e4, 0.0, False, False, cradle(5), [1.02, 1.06, 2.0]),
    ("cradle, damped", 0.0, 1e4, 15.0, True, False, cradle(5), [1.02, 1.06, 2.0]),
    ("one on the other, on the floor", 9.81, 1e4, 20.0, False, True,
     [ball(0.0, 0.1, 0.0), ball(0.01, 0.3, 0.0)], [0.05, 0.2]),
    ("tower", 9.81, 1e4, 40.0, True, True,
     [ball(0.0, 0.5, 0.0, mass=10.0, radius=0.2), ball(0.02, 0.8, 0.01)], [0.27, 0.3, 0.7]),
]


def main():
    only = sys.argv[1:]
    print("#pragma once")
    print("// Written by ball_reference_values.py (mpmath, 40 digits). Do not edit.")
    print("#include <string>")
    print("#include <vector>")
    print()
    print("namespace bounce::test {")
    print()
    print("struct BallReference {")
    print("  std::string name;")
    print("  double gravity, stiffness, damping;  // of pairs and floor alike")
    print("  bool push_only, floor;")
    print("  std::vector<std::vector<double>> start;  // mass, radius, x, y, z, vx, vy, vz")
    print("  struct Answer {")
    print("    double t;")
    print("    std::vector<std::vector<double>> balls;  // x, y, z, vx, vy, vz")
    print("  };")
    print("  std::vector<Answer> answers;")
    print("};")
    print()
    print("inline const std::vector<BallReference>& ball_reference_values() {")
    print("  static const std::vector<BallReference> all{")
    for name, g, k, c, push_only, floor, balls, times in CASES:
        if only and name not in only:
            continue
        run = Balls(g, k, c, push_only, floor, balls)
        true = lambda flag: "true" if flag else "false"
        print(f'      {{"{name}",')
        print(f"       {g!r}, {k!r}, {c!r}, {true(push_only)}, {true(floor)},")
        rows = [", ".join(repr(a) for a in (m, r, *x, *v)) for m, r, x, v in balls]
        print("       {" + ", ".join("{" + row + "}" for row in rows) + "},")
        print("       {")
        for t in times:
            run.go_to(mpf(t))
            n = len(balls)
            rows = [", ".join(mp.nstr(a, 20) for a in run.x[3 * i:3 * i + 3] + run.v[3 * i:3 * i + 3])
                    for i in range(n)]
            print(f"           {{{t!r},")
            print("            {" + ",\n             ".join("{" + row + "}" for row in rows) + "}},",
                  flush=True)
        print("       }},")
    print("  };")
    print("  return all;")
    print("}")
    print()
    print("}  // namespace bounce::test")


main()
