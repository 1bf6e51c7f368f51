// The view that turns: each mesh in a part of one canvas, all from the same side.

// Diverging and sequential scales that the color-blind can tell apart; what is invalid, or has no value, is off the scale.
const scales = {
  quality: ["#8e0b24", "#c62b2c", "#e8623b", "#f69d58", "#fbcf83", "#f7edb8", "#d3e8cf", "#a6d5d6", "#7bbad2"],
  deviation: ["#f3f1ea", "#fde3a0", "#fdbf6f", "#f98e52", "#e65a3a", "#bd1f36", "#7a0a3a"],
  plain: ["#c9d3dc", "#c9d3dc"],
};
const categories = ["#88ccee", "#ddcc77", "#cc6677", "#44aa99", "#aa4499", "#117733", "#999933", "#6699cc", "#ee8866", "#bbbbbb"];
const invalidColor = "#3b003f", neutralColor = "#d5d8dc";

class Color_scale {
  constructor(colors, isStepped = false) {
    const n = Color_scale.size, bytes = new Uint8Array(4 * n);
    const stops = colors.map(c => new THREE.Color(c));
    for (let i = 0; i < n; ++i) {
      const x = (i - 1) / (n - 3) * (stops.length - 1), low = Math.min(Math.floor(x), stops.length - 2);
      const color = i === 0 ? new THREE.Color(invalidColor) : i === n - 1 ? new THREE.Color(neutralColor)
        : isStepped ? stops[(i - 1) % stops.length] : stops[low].clone().lerp(stops[low + 1], x - low);
      bytes.set([color.r, color.g, color.b, 1].map(c => Math.round(255 * c)), 4 * i);
    }
    this.texture = new THREE.DataTexture(bytes, n, 1, THREE.RGBAFormat);
    this.texture.magFilter = this.texture.minFilter = THREE.NearestFilter;
    this.texture.needsUpdate = true;
  }

  // Coordinates of the texture: of a value from 0 to 1, of a number of a color, of what has no value, of what is invalid.
  static of(value) { return (1.5 + Math.min(Math.max(value, 0), 1) * (Color_scale.size - 3)) / Color_scale.size; }
  static ofNumber(i) { return (1.5 + i % categories.length) / Color_scale.size; }
}
Color_scale.size = 256;
Color_scale.invalid = .5 / Color_scale.size;
Color_scale.neutral = 1 - .5 / Color_scale.size;

class Viewer {
  // meshes: with the reference, if there is one. labels: of the hexahedra of the first mesh, or null.
  constructor(canvas, meshes, labels) {
    this.isRequested = false;
    this.canvas = canvas;
    this.meshes = meshes;
    this.labels = labels;
    this.shown = meshes.filter(m => m.role !== "reference");
    this.coloring = "quality";
    this.cut = { axis: -1, position: .5, isFlipped: false }; // none: all of the boundary is seen
    this.threshold = null; // only what is not better than that
    this.hasEdges = true;
    this.focus = null; // {hexahedron} or {vertex} or {point}: only that, and what is around it
    this.largestDeviation = Math.max(...meshes.filter(m => m.role !== "before").map(m => m.largestDeviation));
    this.scales = {
      quality: new Color_scale(scales.quality), deviation: new Color_scale(scales.deviation),
      plain: new Color_scale(scales.plain), label: new Color_scale(categories, true),
    };
    this.box = new THREE.Box3();
    for (const mesh of meshes)
      if (mesh.role === "after" || mesh.role === "compared")
        this.box.union(mesh.box());
    this.radius = Math.max(this.box.getSize(new THREE.Vector3()).length() / 2, 1e-30);

    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: true });
    this.renderer.debug.checkShaderErrors = false; // to ask for them is to wait for them
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(28, 1, 1, 10);
    this.camera.up.set(0, 0, 1);
    const light = new THREE.DirectionalLight(0xffffff, .5);
    light.position.set(.4, .5, 1); // seen from the camera
    this.camera.add(light, light.target);
    light.target.position.set(0, 0, -1);
    this.scene.add(this.camera, new THREE.AmbientLight(0xffffff, .58));
    this.groups = meshes.map(() => {
      const group = new THREE.Group();
      this.scene.add(group);
      return group;
    });
    this.controls = new THREE.OrbitControls(this.camera, canvas);
    this.controls.enableKeys = false;
    this.controls.enableZoom = false; // the wheel is the page's until the view has the focus
    canvas.addEventListener("focus", () => { this.controls.enableZoom = true; });
    canvas.addEventListener("blur", () => { this.controls.enableZoom = false; });
    canvas.addEventListener("keydown", event => this.onKey(event));
    this.controls.addEventListener("change", () => this.render());
    this.controls.addEventListener("start", () => { this.seesWhole = false; });
    this.onRender = () => {};
    this.look(new THREE.Vector3(.75, -1.25, .8));
  }

  // Sees the whole from a side.
  look(direction) {
    this.seesWhole = true;
    this.place(this.box.getCenter(new THREE.Vector3()), direction.clone().normalize(), this.distanceTo(this.box, direction));
  }

  // To be called when the canvas or the number of meshes shown has changed.
  resize() {
    if (this.seesWhole)
      this.look(this.camera.position.clone().sub(this.controls.target));
    else
      this.render();
  }

  // From where all of a box is seen.
  distanceTo(box, direction) {
    const { width, height } = this.part(0), middle = box.getCenter(new THREE.Vector3());
    const back = direction.clone().normalize(), right = new THREE.Vector3().crossVectors(this.camera.up, back).normalize();
    const up = new THREE.Vector3().crossVectors(back, right);
    const tangent = Math.tan(this.camera.fov / 2 * Math.PI / 180), aspect = width / height;
    let distance = 0;
    for (let k = 0; k < 8; ++k) {
      const corner = new THREE.Vector3(...["x", "y", "z"].map((c, i) => (k >> i & 1 ? box.max : box.min)[c])).sub(middle);
      distance = Math.max(distance, corner.dot(back) + 1.06 * Math.max(Math.abs(corner.dot(right)) / (tangent * aspect), Math.abs(corner.dot(up)) / tangent));
    }
    return distance;
  }

  place(target, direction, distance) {
    this.controls.target.copy(target);
    this.camera.position.copy(target).addScaledVector(direction, distance);
    this.controls.update();
    this.render();
  }

  // The way there is shown, where that is wanted.
  fly(box) {
    this.seesWhole = box === this.box;
    const target = box.getCenter(new THREE.Vector3());
    const from = this.controls.target.clone(), offset = this.camera.position.clone().sub(from);
    const distance = this.distanceTo(box, offset);
    const start = performance.now(), startDistance = offset.length();
    const duration = window.matchMedia("(prefers-reduced-motion: reduce)").matches ? 0 : 500;
    const step = now => {
      const t = duration === 0 ? 1 : Math.min((now - start) / duration, 1), s = t * t * (3 - 2 * t);
      this.place(from.clone().lerp(target, s), offset.clone().normalize(),
        Math.exp((1 - s) * Math.log(startDistance) + s * Math.log(distance)));
      if (t < 1)
        requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
  }

  flyTo(focus) {
    this.focus = focus;
    this.rebuild();
    const mesh = [...this.shown, ...this.meshes].find(m => m.role === "after");
    const box = new THREE.Box3();
    for (const h of this.focused(mesh).around)
      for (const v of mesh.verticesOf(h))
        box.expandByPoint(mesh.point(v));
    if (box.isEmpty())
      return;
    this.fly(box);
  }

  showAll() {
    this.focus = null;
    this.rebuild();
    this.fly(this.box);
  }

  onKey(event) {
    const turn = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
    const zoom = { "+": 1 / 1.2, "-": 1.2 }[event.key];
    if (!turn && !zoom)
      return;
    event.preventDefault();
    const target = this.controls.target.clone();
    const s = new THREE.Spherical().setFromVector3(
      this.camera.position.clone().sub(target).applyQuaternion(this.toYUp()));
    if (turn) {
      s.theta += turn[0] * Math.PI / 18;
      s.phi = Math.min(Math.max(s.phi + turn[1] * Math.PI / 18, .01), Math.PI - .01);
    }
    const direction = new THREE.Vector3().setFromSpherical(s).applyQuaternion(this.toYUp().conjugate());
    this.place(target, direction.normalize(), s.radius * (zoom || 1));
  }

  toYUp() { return new THREE.Quaternion().setFromUnitVectors(this.camera.up, new THREE.Vector3(0, 1, 0)); }

  // --- what is shown ----------------------------------------------------------

  // Of the hexahedra of a mesh: those that are solid, those that are transparent.
  masks(mesh) {
    const solid = new Uint8Array(mesh.size), ghost = new Uint8Array(mesh.size);
    if (this.focus) {
      const { solid: few, around } = this.focused(mesh);
      for (const h of around)
        ghost[h] = 1;
      for (const h of few)
        solid[h] = 1;
      return { solid, ghost };
    }
    for (let h = 0; h < mesh.size; ++h) {
      const isKept = this.isKept(mesh.centers, 3 * h);
      const isBad = this.threshold === null || mesh.isInvalid[h] || mesh.jacobians[h] <= this.threshold;
      solid[h] = isKept && isBad ? 1 : 0;
      ghost[h] = this.threshold !== null ? 1 : 0;
    }
    return { solid, ghost };
  }

  // The point at a place of an array.
  isKept(points, at = 0) {
    const { axis, isFlipped } = this.cut;
    return axis < 0 || (points[at + axis] >= this.cutCoordinate()) !== isFlipped;
  }

  cutCoordinate() {
    const { axis, position } = this.cut, low = this.box.min.getComponent(axis), high = this.box.max.getComponent(axis);
    return low + position * (high - low);
  }

  focused(mesh) {
    const { hexahedron, vertex, point } = this.focus;
    if (vertex !== undefined && vertex < mesh.points.length / 3) {
      const around = mesh.around([vertex]);
      return { solid: [], around };
    }
    const h = hexahedron !== undefined && hexahedron < mesh.size ? hexahedron : mesh.nearest(point);
    return { solid: [h], around: mesh.around(mesh.verticesOf(h)) };
  }

  // Of hexahedra.
  numberShown(mesh) { return this.masks(mesh).solid.reduce((a, b) => a + b, 0); }

  // --- its geometry -------------------------------------------------------------

  rebuild() {
    const style = getComputedStyle(document.documentElement);
    this.colors = {
      background: new THREE.Color(style.getPropertyValue("--view").trim()),
      edge: new THREE.Color(style.getPropertyValue("--view-edge").trim()),
      mark: new THREE.Color(style.getPropertyValue("--view-mark").trim()),
    };
    this.meshes.forEach((mesh, i) => {
      this.clear(this.groups[i]);
      if (!this.shown.includes(mesh))
        return;
      if (mesh.role === "reference")
        this.buildReference(mesh, this.groups[i]);
      else
        this.build(mesh, this.groups[i]);
    });
    this.render();
  }

  clear(group) {
    for (const child of group.children.slice()) {
      child.geometry.dispose();
      child.material.dispose();
      group.remove(child);
    }
  }

  build(mesh, group) {
    const { solid, ghost } = this.masks(mesh);
    const faces = this.faces(mesh, solid), polygons = faces.sides.map(side => mesh.cornersOfSide(side));
    const surface = this.surface(faces.geometry);
    surface.userData.sides = faces.sides;
    group.add(surface);
    if (this.hasEdges)
      group.add(this.edges(mesh, polygons, .55));
    if (this.threshold !== null || this.focus) {
      const behind = this.faces(mesh, ghost);
      group.add(new THREE.Mesh(behind.geometry, new THREE.MeshLambertMaterial({
        color: this.focus ? 0xffffff : 0x8895a3, map: this.focus ? this.scales[this.coloring].texture : null,
        transparent: true, opacity: this.focus ? .35 : .13,
        depthWrite: false, side: THREE.DoubleSide,
      })));
      if (this.focus)
        group.add(this.edges(mesh, behind.sides.map(side => mesh.cornersOfSide(side)), .5));
    }
    if (this.focus)
      this.mark(mesh, group);
  }

  // Of the reference, what the cut leaves of it.
  buildReference(reference, group) {
    const kept = Array.from(reference.triangles.keys()).filter(t => this.isKept(reference.center(t)));
    const triangles = kept.map(t => reference.triangles[t]);
    const values = i => this.coloring === "deviation" ? reference.deviations(kept[i]).map(d => this.deviationValue(d))
      : new Array(4).fill(Color_scale.neutral);
    group.add(this.surface(this.fans(reference.points, triangles, values)));
    if (this.hasEdges)
      group.add(this.edges(reference, triangles, .4));
  }

  surface(geometry) {
    return new THREE.Mesh(geometry, new THREE.MeshLambertMaterial({
      map: this.scales[this.coloring].texture, side: THREE.DoubleSide,
      polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1,
    }));
  }

  value(mesh, h) {
    switch (this.coloring) {
    case "quality":
      return mesh.isInvalid[h] || mesh.jacobians[h] <= 0 ? Color_scale.invalid : Color_scale.of(mesh.jacobians[h]);
    case "label":
      return this.labels && h < this.labels.length ? Color_scale.ofNumber(this.labels[h]) : Color_scale.neutral;
    default:
      return Color_scale.of(0);
    }
  }

  deviationValue(deviation) {
    return deviation < 0 ? Color_scale.neutral : Color_scale.of(deviation / (this.largestDeviation || 1));
  }

  // The sides between what is shown of a mesh and what is not.
  faces(mesh, isShown) {
    const sides = [];
    mesh.forVisibleSides(isShown, side => sides.push(side));
    const values = (i, corners) => {
      if (this.coloring !== "deviation")
        return new Array(5).fill(this.value(mesh, Math.floor(sides[i] / 6)));
      if (mesh.sideDeviations[sides[i]] < 0)
        return new Array(5).fill(Color_scale.neutral);
      return [...corners.map(v => mesh.vertexDeviations[v]), mesh.sideDeviations[sides[i]]].map(d => this.deviationValue(d));
    };
    return { geometry: this.fans(mesh.points, sides.map(side => mesh.cornersOfSide(side)), values), sides };
  }

  // Triangles around the center of each polygon: no diagonal is preferred. values: of polygon i at its corners and its center.
  fans(p, polygons, values) {
    const n = polygons.length > 0 ? polygons[0].length : 0;
    const positions = new Float32Array(9 * n * polygons.length), normals = new Float32Array(9 * n * polygons.length);
    const coordinates = new Float32Array(6 * n * polygons.length).fill(.5);
    polygons.forEach((corners, i) => {
      const center = [0, 1, 2].map(c => corners.reduce((sum, v) => sum + p[3 * v + c], 0) / n);
      const ofPolygon = values(i, corners);
      for (let k = 0; k < n; ++k) {
        const next = (k + 1) % n, at = 9 * (n * i + k);
        for (let c = 0; c < 3; ++c) {
          positions[at + c] = p[3 * corners[k] + c];
          positions[at + 3 + c] = p[3 * corners[next] + c];
          positions[at + 6 + c] = center[c];
        }
        this.setNormal(positions, normals, at);
        [ofPolygon[k], ofPolygon[next], ofPolygon[n]].forEach((value, j) => { coordinates[6 * (n * i + k) + 2 * j] = value; });
      }
    });
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(positions, 3));
    geometry.setAttribute("normal", new THREE.BufferAttribute(normals, 3));
    geometry.setAttribute("uv", new THREE.BufferAttribute(coordinates, 2));
    return geometry;
  }

  setNormal(positions, normals, at) {
    const [ux, uy, uz, vx, vy, vz] = [3, 4, 5, 6, 7, 8].map(k => positions[at + k] - positions[at + k % 3]);
    const n = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx], length = Math.hypot(...n) || 1;
    for (let k = 0; k < 9; ++k)
      normals[at + k] = n[k % 3] / length;
  }

  lines(mesh, vertices, color, opacity, isInFront = false) {
    const positions = new Float32Array(3 * vertices.length);
    vertices.forEach((v, i) => positions.set(mesh.points.subarray(3 * v, 3 * v + 3), 3 * i));
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(positions, 3));
    return new THREE.LineSegments(geometry, new THREE.LineBasicMaterial({
      color, opacity, transparent: true, depthTest: !isInFront, depthWrite: false,
    }));
  }

  // Of polygons; many of them are drawn so thin that they do not become a color.
  edges(mesh, polygons, opacity) {
    const vertices = polygons.flatMap(corners => corners.flatMap((v, k) => [v, corners[(k + 1) % corners.length]]));
    return this.lines(mesh, vertices, this.colors.edge, opacity * Math.min(1, 32 / Math.sqrt(polygons.length)));
  }

  mark(mesh, group) {
    const { solid } = this.focused(mesh);
    for (const h of solid)
      group.add(this.lines(mesh, hexahedronEdges.map(k => mesh.hexahedra[8 * h + k]), this.colors.mark, 1, true));
    if (this.focus.vertex === undefined || this.focus.vertex >= mesh.points.length / 3)
      return;
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position",
      new THREE.BufferAttribute(mesh.points.slice(3 * this.focus.vertex, 3 * this.focus.vertex + 3), 3));
    group.add(new THREE.Points(geometry, new THREE.PointsMaterial({
      color: this.colors.mark, size: 9, sizeAttenuation: false, depthTest: false, transparent: true,
    })));
  }

  // --- drawing --------------------------------------------------------------------

  // The part of the canvas, from its upper left corner, that the mesh shown at i has.
  part(i) {
    const width = this.canvas.clientWidth || 1, height = this.canvas.clientHeight || 1, n = this.shown.length;
    return width / height > 1.1
      ? { left: Math.round(width * i / n), top: 0, width: width / n, height }
      : { left: 0, top: Math.round(height * i / n), width, height: height / n };
  }

  // In the next frame, once for all that has changed until then.
  render() {
    if (!this.isRequested)
      requestAnimationFrame(() => this.draw());
    this.isRequested = true;
  }

  draw() {
    this.isRequested = false;
    const width = this.canvas.clientWidth, height = this.canvas.clientHeight;
    this.renderer.setSize(width, height, false);
    this.renderer.setClearColor(this.colors.background);
    this.renderer.setScissorTest(false);
    this.renderer.clear();
    this.renderer.setScissorTest(true);
    const away = this.camera.position.distanceTo(this.box.getCenter(new THREE.Vector3()));
    this.camera.near = Math.max(away - 1.5 * this.radius, .002 * Math.min(away, this.radius),
      .02 * this.camera.position.distanceTo(this.controls.target) * (this.focus ? 1 : 0));
    this.camera.far = away + 3 * this.radius;
    this.shown.forEach((mesh, i) => {
      const part = this.part(i);
      this.camera.aspect = part.width / part.height;
      this.camera.updateProjectionMatrix();
      this.groups.forEach((group, k) => { group.visible = this.meshes[k] === mesh; });
      const bottom = height - part.top - part.height;
      this.renderer.setViewport(part.left, bottom, part.width, part.height);
      this.renderer.setScissor(part.left, bottom, part.width, part.height);
      this.renderer.render(this.scene, this.camera);
    });
    this.onRender();
  }

  // The hexahedron at a place of the canvas, {mesh, hexahedron}, or null.
  pick(x, y) {
    for (let i = 0; i < this.shown.length; ++i) {
      const part = this.part(i), u = (x - part.left) / part.width, v = (y - part.top) / part.height;
      if (u < 0 || u > 1 || v < 0 || v > 1)
        continue;
      this.camera.aspect = part.width / part.height;
      this.camera.updateProjectionMatrix();
      const caster = new THREE.Raycaster();
      caster.setFromCamera(new THREE.Vector2(2 * u - 1, 1 - 2 * v), this.camera);
      const surface = this.groups[this.meshes.indexOf(this.shown[i])].children[0];
      const hit = caster.intersectObject(surface)[0];
      return hit && surface.userData.sides
        ? { mesh: this.shown[i], hexahedron: Math.floor(surface.userData.sides[Math.floor(hit.faceIndex / 4)] / 6) }
        : null;
    }
    return null;
  }

  // The directions of the axes as they appear, for the cross in the corner.
  axes() {
    const inverse = this.camera.quaternion.clone().conjugate();
    return [new THREE.Vector3(1, 0, 0), new THREE.Vector3(0, 1, 0), new THREE.Vector3(0, 0, 1)]
      .map(axis => axis.applyQuaternion(inverse));
  }
}
