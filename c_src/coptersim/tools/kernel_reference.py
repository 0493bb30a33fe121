#!/usr/bin/env python3
"""Writes the reference values of test/kernels_test.cpp: test/data/copter_kernels.txt.gz.

    kernel_reference.py FILE.gz

Needs mpmath (Debian: python3-mpmath), which computes with 200 bits; nothing of the kernels is used. A line is
`function argument... high low`: doubles as C99 hexadecimal, the value is high + low.
"""
import gzip
import random
import sys

import mpmath
from mpmath import mp, mpf

mp.prec = 200
PER_FUNCTION = 500
DEGREE = mp.pi / 180

random.seed(20)


def angle():
    near = random.choice((0, 30, 45, 90, 135, 180, 270))
    return random.choice((
        random.uniform(-180, 180),
        random.choice((-1, 1)) * near + random.choice((-1, 1)) * 2.0 ** random.uniform(-40, 2),
        random.uniform(-1, 1) * 10.0 ** random.uniform(-10, 14)))


def length():
    return random.choice((-1, 1)) * 2.0 ** random.uniform(-12, 12)


def power():
    # what the simulator needs: decay^dt with dt from a microsecond to a quarter of an hour; and anything
    if random.random() < 0.5:
        return random.choice((0.9, 0.995, 0.8, random.uniform(0.01, 1))), 10.0 ** random.uniform(-6, 2)
    base = 2.0 ** random.uniform(-1000, 1000)
    return base, random.uniform(-1, 1) * 700 / max(1.0, abs(float(mpmath.log(base))))


FUNCTIONS = {
    "sin": (lambda: (angle(),), lambda x: mpmath.sin(x * DEGREE)),
    "cos": (lambda: (angle(),), lambda x: mpmath.cos(x * DEGREE)),
    "tan": (lambda: (angle(),), lambda x: mpmath.tan(x * DEGREE)),
    "atan2": (lambda: (length(), length()), lambda y, x: mpmath.atan2(y, x) / DEGREE),
    "pow": (power, lambda b, y: mpmath.power(b, y)),
    "exp": (lambda: (random.uniform(-1, 1) * 10.0 ** random.uniform(-10, 2.85),), mpmath.exp),
    "log": (lambda: (random.choice((random.uniform(0.5, 2), 2.0 ** random.uniform(-1022, 1023))),), mpmath.log),
}


def line(name):
    draw, function = FUNCTIONS[name]
    arguments = draw()
    value = function(*map(mpf, arguments))
    high = float(value)
    return " ".join([name, *(a.hex() for a in arguments), high.hex(), float(value - mpf(high)).hex()])


text = "".join(line(name) + "\n" for name in FUNCTIONS for _ in range(PER_FUNCTION))
with open(sys.argv[1], "wb") as file:
    file.write(gzip.compress(text.encode(), 9, mtime=0))
