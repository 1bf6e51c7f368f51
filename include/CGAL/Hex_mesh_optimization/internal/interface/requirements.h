// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_INTERFACE_REQUIREMENTS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_INTERFACE_REQUIREMENTS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// What is required of the types of a caller, checked before anything is compiled with them: where one does not fit, the
// compiler says so in one line. Each function below is for the condition of an if constexpr around the call.

#include <CGAL/Hex_mesh_optimization/Visitor.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/parameter_lists.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <functional>
#include <iterator>
#include <tuple>
#include <type_traits>
#include <utility>

namespace CGAL::Hex_mesh_optimization::internal {

// --- Ranges -------------------------------------------------------------------

template <class T>
using Iterator_of = decltype(std::begin(std::declval<T&>()));

template <class T, class = void>
struct Is_range : std::false_type
{};
template <class T>
struct Is_range<
  T, std::void_t<typename std::iterator_traits<Iterator_of<T>>::value_type, decltype(std::end(std::declval<T&>()))>>
  : std::true_type
{};

template <class T, class = void>
struct Has_size : std::false_type
{};
template <class T>
struct Has_size<T, std::void_t<decltype(std::declval<const T&>().size())>> : std::true_type
{};

template <class Range>
using Value_of = typename std::iterator_traits<Iterator_of<Range>>::value_type;

template <class Range>
constexpr bool is_random_access_v = std::is_convertible_v<
  typename std::iterator_traits<Iterator_of<Range>>::iterator_category, std::random_access_iterator_tag>;

template <class Range>
constexpr bool is_random_access_range()
{
  if constexpr (Is_range<Range>::value)
    return is_random_access_v<Range>;
  return false;
}

template <class T>
constexpr bool is_index_v = std::is_constructible_v<unsigned long long, T> && !std::is_floating_point_v<T>;

// A range of ranges of indices.
template <class Range>
constexpr bool is_range_of_cells()
{
  if constexpr (Is_range<const Range>::value)
    if constexpr (Is_range<const Value_of<const Range>>::value)
      return is_index_v<Value_of<const Value_of<const Range>>>;
  return false;
}

// --- Points -------------------------------------------------------------------

template <class T, class = void>
struct Is_coordinate : std::false_type
{};
template <class T>
struct Is_coordinate<T, std::void_t<decltype(CGAL::to_double(std::declval<const T&>()))>>
  : std::is_convertible<decltype(CGAL::to_double(std::declval<const T&>())), double>
{};

template <class T, class = void>
struct Is_readable_point : std::false_type
{};
template <class T>
struct Is_readable_point<T, std::void_t<decltype(std::declval<const T&>().x()), decltype(std::declval<const T&>().y()),
                                        decltype(std::declval<const T&>().z())>>
  : std::conjunction<Is_coordinate<std::decay_t<decltype(std::declval<const T&>().x())>>,
                     Is_coordinate<std::decay_t<decltype(std::declval<const T&>().y())>>,
                     Is_coordinate<std::decay_t<decltype(std::declval<const T&>().z())>>>
{};

template <class Range>
constexpr bool is_range_of_readable_points()
{
  if constexpr (Is_range<const Range>::value)
    return Is_readable_point<Value_of<const Range>>::value;
  return false;
}

template <class Range>
constexpr bool is_range_of_new_points()
{
  if constexpr (Is_range<Range>::value)
    return std::is_constructible_v<Value_of<Range>, double, double, double>;
  return false;
}

template <class Range>
constexpr bool is_range_of_assignable_points()
{
  if constexpr (is_range_of_new_points<Range>())
    return std::is_assignable_v<decltype(*std::begin(std::declval<Range&>())), Value_of<Range>&&>;
  return false;
}

// Of a mesh whose points are read.
template <class PointRange, class HexahedronRange>
constexpr bool accepts_cells_of_points()
{
  constexpr bool has_points = is_range_of_readable_points<PointRange>() && Has_size<PointRange>::value;
  static_assert(has_points, "the points must be a range with size() of points whose x(), y() and z() CGAL::to_double() "
                            "converts, see the concept HexMeshOptimizationPoint_3");
  constexpr bool has_hexahedra = is_range_of_cells<HexahedronRange>() && Has_size<HexahedronRange>::value;
  static_assert(has_hexahedra, "the hexahedra must be a range with size() of ranges of eight integers, the indices of "
                               "points");
  return has_points && has_hexahedra;
}

// Of a mesh whose points move.
template <class PointRange, class HexahedronRange>
constexpr bool accepts_mesh()
{
  if constexpr (accepts_cells_of_points<PointRange, HexahedronRange>()) {
    constexpr bool is_random_access = is_random_access_range<PointRange>();
    static_assert(is_random_access, "the points must be a random access range");
    constexpr bool can_move = is_range_of_assignable_points<PointRange>();
    static_assert(can_move, "the points must not be const, and a point must be assignable and constructible from three "
                            "double, see the concept HexMeshOptimizationPoint_3");
    return is_random_access && can_move;
  }
  return false;
}

// Of a mesh that is made.
template <class PointRange, class HexahedronRange>
constexpr bool accepts_new_mesh()
{
  constexpr bool has_points = is_range_of_assignable_points<PointRange>();
  static_assert(has_points,
                "the points must be a range that is not const, of points that can be constructed from three "
                "double, see the concept HexMeshOptimizationPoint_3");
  constexpr bool has_hexahedra = is_range_of_cells<HexahedronRange>() && !std::is_const_v<HexahedronRange>;
  static_assert(has_hexahedra, "the hexahedra must be a range of ranges of integers, and not const");
  return has_points && has_hexahedra;
}

template <class LCC>
constexpr bool accepts_linear_cell_complex()
{
  constexpr bool is_solid = LCC::dimension == 3 && LCC::ambient_dimension == 3;
  static_assert(is_solid, "the linear cell complex must have dimension 3 and ambient dimension 3");
  return is_solid;
}

// --- Property maps and visitors -------------------------------------------------

template <class Map, class Key, class Value, class = void>
struct Is_readable_map : std::false_type
{};
template <class Map, class Key, class Value>
struct Is_readable_map<
  Map, Key, Value,
  std::void_t<decltype(static_cast<Value>(get(std::declval<const Map&>(), std::declval<const Key&>())))>>
  : std::true_type
{};

template <class NamedParameters, class Tag>
using Given =
  std::decay_t<typename internal_np::Lookup_named_param_def<Tag, NamedParameters, internal_np::Param_not_found>::type>;

// True as well if the parameter is not given.
template <class NamedParameters, class Tag, class Key, class Value>
constexpr bool is_map_if_given = !is_given<NamedParameters, Tag> ||
                                 Is_readable_map<Given<NamedParameters, Tag>, Key, Value>::value;

// What std::ref() wraps is the caller's own object.
template <class T>
T& unwrapped(T& t)
{
  return t;
}
template <class T>
T& unwrapped(std::reference_wrapper<T>& t)
{
  return t.get();
}

template <class T, class = void>
struct Is_visitor : std::false_type
{};
template <class T>
struct Is_visitor<T,
                  std::void_t<decltype(unwrapped(std::declval<T&>()).on_iteration(std::declval<const Iteration&>()))>>
  : std::is_convertible<decltype(unwrapped(std::declval<T&>()).on_iteration(std::declval<const Iteration&>())), bool>
{};

// --- Lists of named parameters ---------------------------------------------------

template <class NamedParameters>
constexpr bool is_visitor_if_given()
{
  if constexpr (is_given<NamedParameters, internal_np::visitor_t>)
    return Is_visitor<Given<NamedParameters, internal_np::visitor_t>>::value;
  return true;
}

template <class NamedParameters>
constexpr bool are_internal_faces_if_given()
{
  if constexpr (is_given<NamedParameters, internal_np::hex_internal_faces_t>)
    return is_range_of_cells<Given<NamedParameters, internal_np::hex_internal_faces_t>>();
  return true;
}

// Those that need no key of a vertex or hexahedron.
template <class NamedParameters>
constexpr bool accepts_visitor()
{
  constexpr bool has_visitor = is_visitor_if_given<NamedParameters>();
  static_assert(has_visitor,
                "visitor() needs an object with the member function "
                "bool on_iteration(const CGAL::Hex_mesh_optimization::Iteration&), or std::ref() of one, see "
                "the concept HexMeshOptimizationVisitor");
  return has_visitor;
}

template <class NamedParameters, class Hexahedron>
constexpr bool accepts_labels()
{
  constexpr bool has_labels = is_map_if_given<NamedParameters, internal_np::hexahedron_label_map_t, Hexahedron, int>;
  static_assert(
    has_labels,
    "hexahedron_label_map() needs a readable property map, get(map, h), whose key is the index of a hexahedron "
    "(std::size_t) or, for a linear cell complex, a const dart descriptor, and whose value converts to int");
  return has_labels;
}

// boost::graph_traits does not compile for others.
template <class T, class = void>
struct Is_face_graph : std::false_type
{};
template <class T>
struct Is_face_graph<
  T, std::void_t<decltype(num_faces(std::declval<const T&>())), decltype(num_halfedges(std::declval<const T&>()))>>
  : std::true_type
{};

// Pairs of two labels and a surface: a face graph, or a std::pair of points and triples of indices.
template <class T>
struct Is_soup : std::false_type
{};
template <class PointRange, class TriangleRange>
struct Is_soup<std::pair<PointRange, TriangleRange>>
  : std::bool_constant<is_range_of_readable_points<PointRange>() && is_range_of_cells<TriangleRange>()>
{};

template <class T, class = void>
struct Is_interface_reference : std::false_type
{};
template <class T>
struct Is_interface_reference<
  T, std::void_t<decltype(static_cast<int>(std::get<0>(std::declval<const T&>().first))),
                 decltype(static_cast<int>(std::get<1>(std::declval<const T&>().first))), typename T::second_type>>
  : std::disjunction<Is_face_graph<typename T::second_type>, Is_soup<typename T::second_type>>
{};

// Two vertices and a translation.
template <class T, class = void>
struct Is_periodic_pair : std::false_type
{};
template <class T>
struct Is_periodic_pair<T, std::void_t<typename std::tuple_element<2, T>::type>>
  : std::bool_constant<std::tuple_size<T>::value == 3 && is_index_v<std::tuple_element_t<0, T>> &&
                       is_index_v<std::tuple_element_t<1, T>> && Is_readable_point<std::tuple_element_t<2, T>>::value>
{};

// Of the values of a range, if it is given.
template <class NamedParameters, class Tag, template <class...> class Is_value>
constexpr bool is_range_if_given()
{
  if constexpr (is_given<NamedParameters, Tag>) {
    if constexpr (Is_range<const Given<NamedParameters, Tag>>::value)
      return Is_value<Value_of<const Given<NamedParameters, Tag>>>::value;
    return false;
  }
  return true;
}

// Of optimize_hex_mesh(): the list of the mesh.
template <class NamedParameters, class Vertex, class Hexahedron>
constexpr bool accepts_parameters_of_mesh()
{
  constexpr bool is_of_mesh =
    !is_one_given<NamedParameters, internal_np::vertex_point_t, internal_np::edge_is_constrained_t>;
  static_assert(is_of_mesh,
                "vertex_point_map() and edge_is_constrained_map() describe the reference: they "
                "belong in a second list of named parameters, after that of the mesh and only with a reference");
  constexpr bool has_constraints = is_map_if_given<NamedParameters, internal_np::vertex_is_constrained_t, Vertex, bool>;
  static_assert(
    has_constraints,
    "vertex_is_constrained_map() needs a readable property map, get(map, v), whose key is the index of a vertex "
    "(std::size_t) or the descriptor of a vertex attribute, and whose value converts to bool; of a "
    "std::vector<bool> a lambda and boost::make_function_property_map() make one");
  constexpr bool has_lengths =
    is_map_if_given<NamedParameters, internal_np::hex_target_edge_length_map_t, std::pair<Vertex, Vertex>, double>;
  static_assert(has_lengths,
                "target_edge_length_map() needs a readable property map, get(map, e), whose key is a "
                "std::pair of two vertices, indices (std::size_t) or descriptors of vertex attributes, and "
                "whose value converts to double");
  constexpr bool has_faces = are_internal_faces_if_given<NamedParameters>();
  static_assert(has_faces, "internal_faces() needs a range of ranges of four integers, the indices of vertices");
  constexpr bool has_facets =
    is_map_if_given<NamedParameters, internal_np::facet_is_constrained_t, std::array<std::size_t, 4>, bool>;
  static_assert(has_facets, "facet_is_constrained_map() needs a readable property map, get(map, f), whose key is the "
                            "indices of the vertices of a face in increasing order, std::array<std::size_t, 4>, and "
                            "whose value converts to bool");
  constexpr bool has_references =
    is_range_if_given<NamedParameters, internal_np::hex_interface_references_t, Is_interface_reference>();
  static_assert(
    has_references,
    "interface_references() needs a range of pairs, such as a std::map, of two labels (std::pair<int, int> or "
    "std::array<int, 2>) and a surface: a model of FaceListGraph and HalfedgeListGraph, or a std::pair of two "
    "ranges, points and triples of indices");
  constexpr bool has_pairs =
    is_range_if_given<NamedParameters, internal_np::hex_periodic_vertices_t, Is_periodic_pair>();
  static_assert(has_pairs,
                "periodic_vertices() needs a range of std::tuple of two indices of vertices and a translation "
                "whose x(), y() and z() CGAL::to_double() converts");
  constexpr bool has_rest = accepts_labels<NamedParameters, Hexahedron>() && accepts_visitor<NamedParameters>();
  return is_of_mesh && has_constraints && has_lengths && has_faces && has_facets && has_references && has_pairs && has_rest;
}

template <class TriangleMesh, class NamedParameters>
constexpr bool accepts_surface_parameters()
{
  using Edge = typename boost::graph_traits<TriangleMesh>::edge_descriptor;
  constexpr bool has_constraints = is_map_if_given<NamedParameters, internal_np::edge_is_constrained_t, Edge, bool>;
  static_assert(has_constraints,
                "edge_is_constrained_map() needs a readable property map, get(map, e), whose key is an edge "
                "descriptor of the triangle mesh and whose value converts to bool");
  return has_constraints;
}

// A surface that is given as a face graph.
template <class TriangleMesh, class NamedParameters>
constexpr bool accepts_surface()
{
  constexpr bool is_graph = Is_face_graph<TriangleMesh>::value;
  static_assert(is_graph,
                "the surface must be a model of FaceListGraph and HalfedgeListGraph, or two ranges: points, and "
                "triples of indices");
  if constexpr (is_graph)
    return accepts_surface_parameters<TriangleMesh, NamedParameters>();
  return false;
}

// A surface that is given as a soup.
template <class PointRange, class TriangleRange>
constexpr bool accepts_soup()
{
  constexpr bool has_points = is_range_of_readable_points<PointRange>();
  static_assert(has_points, "the points of a triangle soup must be a range of points whose x(), y() and z() "
                            "CGAL::to_double() converts, see the concept HexMeshOptimizationPoint_3");
  constexpr bool has_triangles = is_range_of_cells<TriangleRange>();
  static_assert(has_triangles,
                "the triangles of a triangle soup must be a range of ranges of three integers, the indices of "
                "points");
  return has_points && has_triangles;
}

template <class NamedParameters>
constexpr bool accepts_edges_of_soup()
{
  constexpr bool has_constraints =
    is_map_if_given<NamedParameters, internal_np::edge_is_constrained_t, std::pair<std::size_t, std::size_t>, bool>;
  static_assert(has_constraints,
                "edge_is_constrained_map() of a triangle soup needs a readable property map, get(map, e), "
                "whose key is a std::pair of two indices of points (std::size_t) and whose value converts "
                "to bool");
  return has_constraints;
}

// Of optimize_hex_mesh(): the list of a soup.
template <class NamedParameters>
constexpr bool accepts_parameters_of_soup()
{
  constexpr bool is_of_soup = Has_only<NamedParameters, internal_np::edge_is_constrained_t>::value;
  static_assert(is_of_soup, "the second list of named parameters is that of the reference, for a triangle soup only "
                            "edge_is_constrained_map(): all others belong in the first list, that of the mesh");
  constexpr bool has_edges = accepts_edges_of_soup<NamedParameters>();
  return is_of_soup && has_edges;
}

// Of optimize_hex_mesh(): the list of the reference, which has nothing that would not be looked at.
template <class NamedParameters>
constexpr bool accepts_parameters_of_reference()
{
  constexpr bool is_of_reference =
    Has_only<NamedParameters, internal_np::vertex_point_t, internal_np::edge_is_constrained_t>::value;
  static_assert(is_of_reference, "the second list of named parameters is that of the reference, vertex_point_map() and "
                                 "edge_is_constrained_map(): all others belong in the first list, that of the mesh");
  return is_of_reference;
}

// Of make_hex_mesh(): what a face graph has for faces, without complaints where it is none.
template <class TriangleMesh, bool is_graph = Is_face_graph<TriangleMesh>::value>
struct Face_of_graph
{
  using type = std::size_t;
};
template <class TriangleMesh>
struct Face_of_graph<TriangleMesh, true>
{
  using type = typename boost::graph_traits<TriangleMesh>::face_descriptor;
};
template <class TriangleMesh>
using Face_of = typename Face_of_graph<TriangleMesh>::type;

template <class NamedParameters, class Face>
constexpr bool accepts_labels_of_faces()
{
  constexpr bool has_labels = is_map_if_given<NamedParameters, internal_np::hex_face_label_map_t, Face, int>;
  static_assert(has_labels,
                "face_label_map() needs a readable property map, get(map, f), whose key is a face descriptor of "
                "the triangle mesh or, for a triangle soup, the index of a triangle (std::size_t), and whose "
                "value converts to int");
  return has_labels;
}

// Of make_hex_mesh(): the mesh is not there yet.
template <class NamedParameters>
constexpr bool accepts_parameters_of_new_mesh()
{
  constexpr bool has_no_keys =
    !is_one_given<NamedParameters, internal_np::vertex_is_constrained_t, internal_np::hexahedron_label_map_t,
                  internal_np::facet_is_constrained_t, internal_np::hex_internal_faces_t,
                  internal_np::hex_interface_references_t,
                  internal_np::hex_periodic_vertices_t, internal_np::hex_target_edge_length_map_t>;
  static_assert(
    has_no_keys,
    "vertex_is_constrained_map(), facet_is_constrained_map(), hexahedron_label_map(), internal_faces(), "
    "interface_references() and target_edge_length_map() need a mesh that exists: call optimize_hex_mesh() with them");
  constexpr bool has_visitor = accepts_visitor<NamedParameters>();
  return has_no_keys && has_visitor;
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_INTERFACE_REQUIREMENTS_H
