/*!
\ingroup PkgHexMeshOptimizationConcepts
\cgalConcept

The concept `HexMeshOptimizationPoint_3` describes the points of a mesh or a surface that is given by ranges of points and
indices. The functions that read points need the coordinates alone; those that move or make points need all of it.
A type that does not fit is refused by name when the call is compiled.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Point_3<Kernel>, of every kernel with a number type that converts to `double`}
\cgalHasModelsEnd

\sa `CGAL::optimize_hex_mesh()`
\sa `CGAL::make_hex_mesh()`
*/
class HexMeshOptimizationPoint_3
{
public:
  /// A number that `CGAL::to_double()` converts.
  typedef unspecified_type FT;

  /// \name Reading
  /// @{
  FT x() const;
  FT y() const;
  FT z() const;
  /// @}

  /// \name Moving
  /// @{

  /// The point with these coordinates. Where they are those of another point, as `CGAL::to_double()` gave them, it need not be
  /// equal to that one: points that do not move are not assigned.
  HexMeshOptimizationPoint_3(double x, double y, double z);

  HexMeshOptimizationPoint_3& operator=(HexMeshOptimizationPoint_3&&);
  /// @}
};
