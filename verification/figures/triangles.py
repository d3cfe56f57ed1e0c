"""Triangles of a field file as gnuplot surfaces: triangles.py FIELDS.vtu XMIN YMIN XMAX YMAX > FILE

Every triangle that touches the window (m, deformed) becomes two lines of two points, x y plastic_strain localisation.
"""
import sys

import meshio

file, window = sys.argv[1], [float(x) for x in sys.argv[2:6]]
mesh = meshio.read(file)
points = mesh.points[:, :2] + mesh.point_data["displacement"][:, :2]
strain, localisation = (mesh.cell_data[name][0] for name in ("plastic_strain", "localisation"))
for corners, a, b in zip(points[mesh.cells[0].data], strain, localisation):
    low, high = corners.min(axis=0), corners.max(axis=0)
    if high[0] < window[0] or low[0] > window[2] or high[1] < window[1] or low[1] > window[3]:
        continue
    lines = ["%.7g %.7g %.6g %.6g" % (*x, a, b) for x in corners]
    print("\n".join([lines[0], lines[1], "", lines[2], lines[2], "", ""]))
