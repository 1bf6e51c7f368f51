<?xml version='1.0' encoding='UTF-8' standalone='yes' ?>
<!-- What ours refers to in the documentation of CGAL itself -->
<tagfile>
  <compound kind="page">
    <name>packages</name>
    <title>Package Overview</title>
    <filename>Manual/packages.html</filename>
    <docanchor file="Manual/packages.html" title="Linear Cell Complex">PkgLinearCellComplex</docanchor>
    <docanchor file="Manual/packages.html" title="Polygon Mesh Processing">PkgPolygonMeshProcessing</docanchor>
  </compound>
  <compound kind="page">
    <name>license</name>
    <title>License</title>
    <filename>Manual/license.html</filename>
    <docanchor file="Manual/license.html" title="GPL">licensesGPL</docanchor>
  </compound>
  <compound kind="group">
    <name>bgl_namedparameters</name>
    <title>Named Parameters</title>
    <filename>BGL/group__bgl__namedparameters.html</filename>
  </compound>
  <compound kind="class">
    <name>FaceListGraph</name>
    <filename>BGL/classFaceListGraph.html</filename>
  </compound>
  <compound kind="class">
    <name>HalfedgeListGraph</name>
    <filename>BGL/classHalfedgeListGraph.html</filename>
  </compound>
  <compound kind="class">
    <name>MutableFaceGraph</name>
    <filename>BGL/classMutableFaceGraph.html</filename>
  </compound>
  <compound kind="namespace">
    <name>CGAL</name>
    <filename>Manual/namespaceCGAL.html</filename>
    <class kind="class">CGAL::Linear_cell_complex_for_combinatorial_map</class>
    <class kind="class">CGAL::Linear_cell_complex_for_generalized_map</class>
    <class kind="class">CGAL::Surface_mesh</class>
    <class kind="struct">CGAL::Sequential_tag</class>
    <class kind="struct">CGAL::Parallel_tag</class>
  </compound>
  <compound kind="class">
    <name>CGAL::Linear_cell_complex_for_combinatorial_map</name>
    <filename>Linear_cell_complex/classCGAL_1_1Linear__cell__complex__for__combinatorial__map.html</filename>
  </compound>
  <compound kind="class">
    <name>CGAL::Linear_cell_complex_for_generalized_map</name>
    <filename>Linear_cell_complex/classCGAL_1_1Linear__cell__complex__for__generalized__map.html</filename>
  </compound>
  <compound kind="class">
    <name>CGAL::Surface_mesh</name>
    <filename>Surface_mesh/classCGAL_1_1Surface__mesh.html</filename>
  </compound>
  <compound kind="struct">
    <name>CGAL::Sequential_tag</name>
    <filename>STL_Extension/structCGAL_1_1Sequential__tag.html</filename>
  </compound>
  <compound kind="struct">
    <name>CGAL::Parallel_tag</name>
    <filename>STL_Extension/structCGAL_1_1Parallel__tag.html</filename>
  </compound>
</tagfile>
