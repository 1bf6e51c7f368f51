# A mesh of meshio

import meshio

import hex_mesh_optimization as hmo

mesh, status = hmo.optimize_meshio(meshio.read("tangled.vtk"))
mesh.write("repaired.vtu")
print(status)
