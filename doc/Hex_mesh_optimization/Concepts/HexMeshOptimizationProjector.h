/*!
\ingroup PkgHexMeshOptimizationConcepts
\cgalConcept

The concept `HexMeshOptimizationProjector` describes a surface that is known by its closest points and normals, such as one that
is given by a signed distance function or by parameters, as the reference of `CGAL::optimize_hex_mesh()`.

The surface is sampled before the optimization: each edge of the boundary of the mesh is divided into four, each face of it
into sixteen, and the samples are brought to their closest points. The triangles between these are the reference of everything that
follows, certificates included. Their edges are features where the normals beside them differ by more than
`features_angle_bound()`; vertices there are brought to where the tangent planes beside them meet.

A signed distance function \f$ f \f$ with \f$ |\nabla f| = 1 \f$ has the closest point \f$ p - f(p) \nabla f(p) \f$ and the normal
\f$ \nabla f(p) \f$.

\sa `CGAL::optimize_hex_mesh()`
*/
class HexMeshOptimizationProjector
{
public:
  /// The point of the surface that is closest to `p`. `Point` is the type of the points of the mesh; the result has
  /// coordinates `x()`, `y()` and `z()` that `CGAL::to_double()` converts.
  Point closest_point(const Point& p) const;

  /// The outward normal of the surface at a point of it, of any length but 0. Where the surface turns sharply, that of either side.
  Vector normal(const Point& p) const;
};
