# A grid of VTK, or one of pyvista

from vtkmodules.vtkIOLegacy import vtkUnstructuredGridReader

import hex_mesh_optimization as hmo

reader = vtkUnstructuredGridReader()
reader.SetFileName("tangled.vtk")
reader.Update()
grid, status = hmo.optimize_grid(reader.GetOutput(), target_quality=0.3)
print(grid.GetNumberOfCells(), "cells,", status.return_code.name)
