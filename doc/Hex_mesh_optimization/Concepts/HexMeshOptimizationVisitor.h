/*!
\ingroup PkgHexMeshOptimizationConcepts
\cgalConcept

The concept `HexMeshOptimizationVisitor` describes what watches an optimization and can end it, for the named parameter
`visitor()`. A visitor is copied, unless it is passed with `std::ref()`.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Hex_mesh_optimization::Default_visitor}
\cgalHasModelsEnd

\sa `CGAL::optimize_hex_mesh()`
*/
class HexMeshOptimizationVisitor
{
public:
  /// Called after each iteration, and never twice at a time. The optimization goes on if it returns a value that converts
  /// to `true`; on `false` the mesh takes the best positions so far. An exception passes through and leaves the mesh as it
  /// was before the call.
  bool on_iteration(const CGAL::Hex_mesh_optimization::Iteration& iteration);
};
