"""Triangles of a field file as gnuplot surfaces: triangles.py FIELDS.vtu XMIN YMIN XMAX YMAX NAME... > FILE

Every triangle that touches the window (m, deformed) becomes two lines of two points: x y and the named fields, those of
cells as they are, those of points by their length.
"""
import sys

import meshio
import numpy

file, window, names = sys.argv[1], [float(x) for x in sys.argv[2:6]], sys.argv[6:]
mesh = meshio.read(file)
points = mesh.points[:, :2] + mesh.point_data["displacement"][:, :2]
triangles = mesh.cells[0].data


def at_corners(name):
    if name in mesh.cell_data:
        return numpy.repeat(mesh.cell_data[name][0][:, None], 3, axis=1)
    return numpy.linalg.norm(mesh.point_data[name], axis=1)[triangles]


fields = numpy.stack([at_corners(name) for name in names], axis=2)
for corners, values in zip(points[triangles], fields):
    low, high = corners.min(axis=0), corners.max(axis=0)
    if high[0] < window[0] or low[0] > window[2] or high[1] < window[1] or low[1] > window[3]:
        continue
    lines = ["%.7g %.7g " % tuple(x) + " ".join("%.6g" % v for v in value) for x, value in zip(corners, values)]
    print("\n".join([lines[0], lines[1], "", lines[2], lines[2], "", ""]))
