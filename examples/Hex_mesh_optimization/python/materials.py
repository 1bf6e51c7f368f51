# Two materials, whose interface is kept, in a part whose boundary is brought to a surface

import numpy as np

import hex_mesh_optimization as hmo

mesh = hmo.read("tangled.vtk")
centers = mesh.points[mesh.hexahedra].mean(axis=1)
material = np.where(centers[:, 0] < centers[:, 0].mean(), 1, 2)

points, status = hmo.optimize(
    mesh.points,
    mesh.hexahedra,
    reference=hmo.read_surface("surface.off"),
    labels=material,
    maximum_deviation=0.1,
    boundary_placement=hmo.Boundary_placement.WITHIN_TOLERANCE,
)
for region in status.regions:
    print("material", region.label, "has the volume", region.after, "and had", region.before)
