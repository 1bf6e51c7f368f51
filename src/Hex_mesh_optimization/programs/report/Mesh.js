// A mesh of the page: what the program wrote in base64, as arrays of numbers.

// The vertices of the sides of a hexahedron, counter-clockwise from outside, as the program numbers them.
const hexahedronSides = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]];
const hexahedronEdges = [0, 1, 3, 2, 4, 5, 7, 6, 0, 3, 1, 2, 4, 7, 5, 6, 0, 4, 1, 5, 2, 6, 3, 7];

function decoded(base64, Numbers) {
  const characters = atob(base64);
  const bytes = new Uint8Array(characters.length);
  for (let i = 0; i < bytes.length; ++i)
    bytes[i] = characters.charCodeAt(i);
  return new Numbers(bytes.buffer);
}

class Mesh {
  // first: the mesh whose hexahedra this one has, where the data name none.
  constructor(data, first) {
    this.role = data.role;
    this.name = data.name;
    this.points = decoded(data.points, Float32Array);
    this.hexahedra = data.hexahedra ? decoded(data.hexahedra, Uint32Array) : first.hexahedra;
    this.opposite = data.hexahedra ? decoded(data.opposite_sides, Int32Array) : first.opposite;
    this.jacobians = decoded(data.scaled_jacobians, Float32Array);
    this.size = this.jacobians.length;
    this.isInvalid = new Uint8Array(this.size);
    for (const h of decoded(data.invalid_hexahedra, Uint32Array))
      this.isInvalid[h] = 1;
    this.readDeviations(data.deviations);
    this.centers = this.averages();
  }

  // Where there are none, -1.
  readDeviations(data) {
    this.vertexDeviations = new Float32Array(this.points.length / 3).fill(-1);
    this.sideDeviations = new Float32Array(6 * this.size).fill(-1);
    this.largestDeviation = 0;
    if (!data)
      return;
    this.vertexDeviations = decoded(data.of_vertices, Float32Array);
    const ofSides = decoded(data.of_outer_sides, Float32Array);
    decoded(data.outer_sides, Uint32Array).forEach((side, i) => { this.sideDeviations[side] = ofSides[i]; });
    for (const deviations of [this.vertexDeviations, ofSides])
      for (const d of deviations)
        this.largestDeviation = Math.max(this.largestDeviation, d);
  }

  averages() {
    const centers = new Float32Array(3 * this.size);
    for (let h = 0; h < this.size; ++h)
      for (let k = 0; k < 8; ++k)
        for (let c = 0; c < 3; ++c)
          centers[3 * h + c] += this.points[3 * this.hexahedra[8 * h + k] + c] / 8;
    return centers;
  }

  point(v) {
    return new THREE.Vector3().fromArray(this.points, 3 * v);
  }

  center(h) {
    return new THREE.Vector3().fromArray(this.centers, 3 * h);
  }

  box() {
    const box = new THREE.Box3();
    for (const v of this.hexahedra)
      box.expandByPoint(this.point(v));
    return box;
  }

  verticesOf(h) {
    return Array.from(this.hexahedra.subarray(8 * h, 8 * h + 8));
  }

  cornersOfSide(side) {
    const h = Math.floor(side / 6);
    return hexahedronSides[side % 6].map(k => this.hexahedra[8 * h + k]);
  }

  // The hexahedra that have one of the vertices.
  around(vertices) {
    const wanted = new Set(vertices), result = [];
    for (let h = 0; h < this.size; ++h)
      for (let k = 0; k < 8; ++k)
        if (wanted.has(this.hexahedra[8 * h + k])) {
          result.push(h);
          break;
        }
    return result;
  }

  nearest(point) {
    let best = 0, distance = Infinity;
    for (let h = 0; h < this.size; ++h) {
      const d = this.center(h).distanceToSquared(point);
      if (d < distance) {
        distance = d;
        best = h;
      }
    }
    return best;
  }

  // Calls visit(side) for the sides between what is shown and what is not. isShown: of the hexahedra, 0 or 1.
  forVisibleSides(isShown, visit) {
    for (let h = 0; h < this.size; ++h)
      if (isShown[h])
        for (let side = 6 * h; side < 6 * h + 6; ++side) {
          const opposite = this.opposite[side];
          if (opposite < 0 || !isShown[Math.floor(opposite / 6)])
            visit(side);
        }
  }
}

// The surface from which the deviation is measured, with its own distances from the result.
class Reference {
  constructor(data) {
    this.role = "reference";
    this.name = data.name;
    this.points = decoded(data.points, Float32Array);
    const corners = decoded(data.triangles, Uint32Array);
    this.triangles = [];
    for (let i = 0; i < corners.length; i += 3)
      this.triangles.push([corners[i], corners[i + 1], corners[i + 2]]);
    this.vertexDeviations = decoded(data.deviations_of_vertices, Float32Array);
    this.triangleDeviations = decoded(data.deviations_of_triangles, Float32Array);
    this.largestDeviation = [...this.vertexDeviations, ...this.triangleDeviations].reduce((a, b) => Math.max(a, b), 0);
  }

  center(t) {
    return [0, 1, 2].map(c => this.triangles[t].reduce((sum, v) => sum + this.points[3 * v + c], 0) / 3);
  }

  // At the corners of a triangle and at its center.
  deviations(t) {
    return [...this.triangles[t].map(v => this.vertexDeviations[v]), this.triangleDeviations[t]];
  }
}
