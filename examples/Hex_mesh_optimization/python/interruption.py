# A run that ends when it is good enough, or when the user presses Ctrl-C

from typing import Optional

import hex_mesh_optimization as hmo

mesh = hmo.read("tangled.vtk")


def watch(iteration: hmo.Iteration) -> Optional[bool]:
    print(iteration.stage.name, iteration.iteration, iteration.number_of_inverted, iteration.minimum)
    return False if iteration.minimum > 0.5 else None


try:
    points, status = hmo.optimize(mesh.points, mesh.hexahedra, progress=watch)
except hmo.Interrupted as stopped:
    points, status = stopped.points, stopped.status  # the best so far
print("valid:", status.valid_mesh, "because", status.why_it_stopped)
