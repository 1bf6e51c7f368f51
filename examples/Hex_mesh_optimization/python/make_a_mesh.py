# A mesh of what a surface bounds, here a tetrahedron

import hex_mesh_optimization as hmo

vertices = [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)]
triangles = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)]
points, hexahedra, status = hmo.make(vertices, triangles, cells=100)
print(status)
hmo.write("tetrahedron.vtk", (points, hexahedra))
