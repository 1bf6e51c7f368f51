# A block of 5 x 5 x 5 cubes whose inner points are in disorder, as arrays of numpy

import numpy as np

import hex_mesh_optimization as hmo

ticks = np.arange(6.0)
points = np.stack(np.meshgrid(ticks, ticks, ticks, indexing="ij"), axis=-1).reshape(-1, 3)
number = np.arange(6**3).reshape(6, 6, 6)
corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
hexahedra = np.stack([number[i : i + 5, j : j + 5, k : k + 5].ravel() for i, j, k in corners], axis=-1)

inside = np.all((points > 0) & (points < 5), axis=1)
points[inside] += np.random.default_rng(1).uniform(-0.7, 0.7, (inside.sum(), 3))
print(len(hmo.invalid(points, hexahedra)), "hexahedra are not valid")

repaired, status = hmo.optimize(points, hexahedra, threads=2, progress=True)
print(status)
print("the worst hexahedron is number", hmo.quality(repaired, hexahedra).argmin())
