"""A ray caster in a few lines of Python: a ball in the light of a lamp far away, seen from (0, 0, 4).

It prints what it computes for one pixel, a JSON object a line, as `lightwalk follow` reads it.
Usage: follow.py X Y; with a third word it takes the light to come from the other side.
"""
import json
import math
import sys

WIDTH, HEIGHT = 64, 48
x, y = int(sys.argv[1]), int(sys.argv[2])


def record(kind, **values):
    print(json.dumps({"kind": kind, **values}))


def dot(a, b):
    return sum(p * q for p, q in zip(a, b))


def unit(a):
    length = math.sqrt(dot(a, a))
    return [p / length for p in a]


focal = 0.5 * WIDTH / math.tan(math.radians(20))
eye, u = [0, 0, 4], unit([x + 0.5 - 0.5 * WIDTH, 0.5 * HEIGHT - y - 0.5, -focal])
record("Ray", O=eye, u=u)
b = dot(eye, u)
t = -b - math.sqrt(b * b - (dot(eye, eye) - 1))
record("ObjectTested", object=0, t=t, nearer=True)
n = [p + t * q for p, q in zip(eye, u)]
record("SurfaceMet", P=n, N_geometric=n)
to_light = unit([1, 2, 3]) if len(sys.argv) < 4 else unit([-1, -2, -3])
record("ToLight", L=to_light)
cosine = max(0, dot(n, to_light))
diffuse = [k * 0.9 * cosine for k in (0.6, 0.5, 0.4)]
record("Diffuse", I_d=diffuse)
record("Returned", I=[0.1 + d for d in diffuse])
