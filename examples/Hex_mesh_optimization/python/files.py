# A file, with everything that it holds beside points and hexahedra

import hex_mesh_optimization as hmo

mesh = hmo.read("tangled.vtk")
points, status = hmo.optimize(mesh.points, mesh.hexahedra, **mesh.parameters)
hmo.write("repaired.vtk", mesh, points, status=status)
