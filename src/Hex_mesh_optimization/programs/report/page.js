// Fills the page with the data.

const byId = id => document.getElementById(id);
const data = JSON.parse(byId("data").textContent);
const report = data.report, status_ = report.status;
const meshes = [];
for (const of of data.meshes)
  meshes.push(new Mesh(of, meshes[0]));
const reference = data.reference ? new Reference(data.reference) : null;
const labels = data.labels ? decoded(data.labels, Int32Array) : null;

// --- numbers, with as many digits as mean something -----------------------------

const nothing = "–";
const minus = text => text.replace("-", "\u2212");
const formats = {
  count: n => n.toLocaleString("en-US"),
  quality: x => minus(x.toFixed(4)),
  length: x => minus(x === 0 ? "0" : Math.abs(x) >= 1e-3 && Math.abs(x) < 1e4 ? x.toPrecision(4) : x.toExponential(3)),
  percent: x => x === 0 ? "0 %" : minus(`${x >= 1e-5 ? (100 * x).toPrecision(3) : (100 * x).toExponential(2)} %`),
  seconds: x => x >= 100 ? `${x.toFixed(0)} s` : x >= 1 ? `${x.toPrecision(3)} s` : `${x.toFixed(2)} s`,
};
const short = x => minus(String(Number(x.toPrecision(3))));

// What the path of a member of the report leads to.
function at(path) {
  return path.split(".").reduce((value, key) => value === null || value === undefined ? value : value[key], report);
}

function number(tag, path, format) {
  const value = path === null ? null : at(path);
  return element(tag, { "data-path": path, "data-format": format }, value === null || value === undefined ? nothing : formats[format](value));
}

// Where the numbers of a mesh are, by its role.
const roles = {
  before: { statistics: "status.before", volume: "status.volume_before", deviation: null, color: "var(--before)" },
  after: { statistics: "status.after", volume: "status.volume_after", deviation: "status.deviation", color: "var(--after)" },
  compared: { statistics: "comparison.after", volume: null, deviation: "comparison.deviation", color: "var(--compared)" },
};
const results = meshes.filter(m => m.role !== "before");
const nameOf = file => file.split(/[\\/]/).pop();
const plural = (n, one, many) => `${formats.count(n)} ${n === 1 ? one : many}`;

function fillHeader() {
  const { input, surface, output } = report.options;
  byId("program").textContent = input === undefined ? "Hexahedral mesh of a surface" : report.comparison ? "Two results for one hexahedral mesh" : "Optimization of a hexahedral mesh";
  byId("title").append(nameOf(input === undefined ? surface : input), element("span", { class: "arrow" }, "→"), nameOf(output));
  if (report.comparison)
    byId("title").append(element("span", { class: "arrow" }, "compared with"), nameOf(report.comparison.file));
  const say = (isGood, text) => byId("verdict").append(element("span", { class: `verdict ${isGood ? "good" : "bad"}` }, text));
  for (const mesh of results) {
    const invalid = at(roles[mesh.role].statistics).number_of_invalid;
    const [good, bad] = report.comparison ? [`${mesh.name} is valid`, `${mesh.name} is not valid`] : ["Valid", "Not valid"];
    say(invalid === 0, invalid === 0 ? `${good}: every hexahedron is certified` : `${bad}: ${plural(invalid, "hexahedron is", "hexahedra are")} not certified`);
  }
  if (status_.deviation_bound !== null)
    say(status_.is_within_deviation_bound, status_.is_within_deviation_bound ? "Within the bound of the deviation"
      : `The bound of the deviation is not ${status_.deviation.maximum > status_.deviation_bound ? "" : "shown to be "}met`);
  if (status_.has_topology_of_surface === false)
    say(false, "Not the topology of the surface");
  if (data.why_it_stopped)
    byId("verdict").append(element("span", {}, `Stopped after ${plural(status_.iterations, "iteration", "iterations")}: ${data.why_it_stopped}.`));
}

function fillSummary() {
  const figure = (title, member, format) => {
    const of = role => number("span", `${roles[role].statistics}.${member}`, format);
    const from = of("before");
    from.setAttribute("class", "from");
    const result = element("div", { class: "figure" }, element("h3", {}, title), element("p", {}, from, element("span", { class: "from" }, " → "), of("after")));
    if (report.comparison)
      result.lastChild.append(element("small", {}, `${meshes.find(m => m.role === "compared").name}: `, of("compared")));
    return result;
  };
  const deviation = element("p", {}, number("span", "status.deviation.maximum_relative", "percent"),
    element("small", {}, "of the diagonal, or ", number("span", "status.deviation.maximum", "length")));
  if (report.comparison && report.comparison.deviation)
    deviation.append(element("small", {}, `${nameOf(report.comparison.file)}: `, number("span", "comparison.deviation.maximum_relative", "percent")));
  byId("summary").append(
    element("div", { class: "figure" }, element("h3", {}, "Hexahedra"), element("p", {}, number("span", "status.after.number_of_hexahedra", "count"))),
    figure("Invalid hexahedra", "number_of_invalid", "count"),
    figure("Minimum scaled Jacobian", "minimum", "quality"),
    figure("Mean scaled Jacobian", "average", "quality"),
    element("div", { class: "figure" }, element("h3", {}, "Largest deviation"), deviation));
}

// --- the table ------------------------------------------------------------------

const statistics = [
  ["Hexahedra", "number_of_hexahedra", "count"],
  ["Inverted", "number_of_inverted", "count"],
  ["Invalid", "number_of_invalid", "count"],
  ["Minimum scaled Jacobian", "minimum", "quality"],
  ["Mean scaled Jacobian", "average", "quality"],
  ["Standard deviation", "standard_deviation", "quality"],
  ["Median edge ratio", "median_edge_ratio", "length"],
  ["99th percentile of edge ratio", "edge_ratio_99", "length"],
  ["Maximum edge ratio", "maximum_edge_ratio", "length"],
];
const deviations = [
  ["Average", "average", "length"],
  ["Maximum", "maximum", "length"],
  ["Average, of the diagonal", "average_relative", "percent"],
  ["Maximum, of the diagonal", "maximum_relative", "percent"],
  ["Certified maximum", "certified", "length"],
];
const times = [["Rectification", "rectification_seconds"], ["Untangling", "untangling_seconds"],
  ["Maximization", "maximization_seconds"], ["All", "total_seconds"]];

function fillNumbers() {
  const body = element("tbody");
  const row = (title, paths, format) =>
    body.append(element("tr", {}, element("th", { scope: "row" }, title), ...paths.map(p => number("td", p, format))));
  const group = title => body.append(element("tr", { class: "group" }, element("th", { colspan: meshes.length + 1, scope: "rowgroup" }, title)));
  const onlyAfter = path => meshes.map(m => m.role === "after" ? path : null);
  for (const [title, member, format] of statistics)
    row(title, meshes.map(m => `${roles[m.role].statistics}.${member}`), format);
  row("Volume", meshes.map(m => roles[m.role].volume), "length");
  (status_.regions.length > 1 ? status_.regions : []).forEach((region, i) =>
    row(`Volume of label ${region.label}`, meshes.map(m => ({ before: `status.regions.${i}.volume_before`, after: `status.regions.${i}.volume_after` })[m.role] || null), "length"));
  group("Deviation from the reference, in both directions");
  for (const [title, member, format] of deviations)
    if (results.some(m => at(`${roles[m.role].deviation}.${member}`) != null))
      row(title, meshes.map(m => roles[m.role].deviation && `${roles[m.role].deviation}.${member}`), format);
  if (status_.deviation_bound !== null)
    row("Bound asked for", onlyAfter("status.deviation_bound"), "length");
  status_.interfaces.forEach((of, i) =>
    row(`Maximum between labels ${of.labels.join(" and ")}`, onlyAfter(`status.interfaces.${i}.maximum_deviation`), "length"));
  group("Time");
  for (const [title, member] of times)
    row(title, onlyAfter(`status.${member}`), "seconds");
  (status_.attempts || []).forEach((attempt, i) =>
    row(`Attempt: ${attempt.name}${attempt.is_taken ? "" : ", not taken"}`, onlyAfter(`status.attempts.${i}.seconds`), "seconds"));
  byId("numbers").append(element("table", {}, element("thead", {}, element("tr", {}, element("td"), ...meshes.map(m => element("th", { scope: "col" }, m.name)))), body));

  const notes = (report.lost || []).map(line => `Not in the output: ${line}.`);
  const note = (n, one, many) => { if (n > 0) notes.push(plural(n, one, many)); };
  note(status_.number_of_reoriented_hexahedra, "hexahedron was numbered inside out: its bottom and top are exchanged.", "hexahedra were numbered inside out: their bottoms and tops are exchanged.");
  note(report.number_of_merged_vertices || 0, "vertex coincides with another one and was merged with it.", "vertices coincide with others and were merged with them.");
  note(status_.number_of_coincident_vertices, "vertex coincides with another one: faces are in the same place, but their hexahedra are no neighbors.", "vertices coincide with others: faces are in the same place, but their hexahedra are no neighbors.");
  note(status_.locked_hexahedra.length, "invalid hexahedron has an inverted corner whose vertices are all fixed.", "invalid hexahedra have an inverted corner whose vertices are all fixed.");
  notes.push(...(status_.volume_changes_in_words || []));
  if (report.comparison && !report.comparison.deviation)
    notes.push("The deviation of the other result is not measured: the mesh has interfaces.");
  byId("notes").append(...notes.map(text => element("li", {}, text)));
}

function fillCharts() {
  const color = role => roles[role].color;
  const low = Math.min(0, ...meshes.map(m => m.jacobians.reduce((a, b) => Math.min(a, b), 0)));
  const start = Math.floor(low * 10) / 10;
  histogram(byId("histogram"), meshes.map(m => ({ name: m.name, role: m.role, color: color(m.role), values: m.jacobians })), {
    low: start, high: 1, parts: Math.round((1 - start) * 40), title: "Number of hexahedra by their scaled Jacobian",
    xTitle: "scaled Jacobian", format: x => minus(x.toFixed(Math.abs(x * 10 - Math.round(x * 10)) < 1e-9 ? 1 : 3)),
  });
  const withDeviations = results.filter(m => m.largestDeviation > 0);
  if (withDeviations.length > 0)
    histogram(byId("deviation-histogram"), withDeviations.map(m => ({
      name: m.name, role: m.role, color: color(m.role), values: [...m.vertexDeviations, ...m.sideDeviations].filter(d => d >= 0),
    })), {
      low: 0, high: Math.max(...withDeviations.map(m => m.largestDeviation)), parts: 40,
      title: "Number of places of the surface by their distance from the reference", xTitle: "distance from the reference, of vertices and middles of outer faces",
      format: short,
    });
  else
    byId("deviation-histogram").append(element("p", { class: "note" }, "All vertices and middles of outer faces are on the reference."));
  convergence(byId("convergence"), status_.before, report.iterations, color("after"));
}

// --- the view -------------------------------------------------------------------

const colorings = { quality: "scaled Jacobian", deviation: "distance from the reference", label: "label", plain: "none" };

function fillLegend(viewer) {
  const legend = byId("legend");
  legend.replaceChildren();
  const swatch = (color, text) => {
    const mark = element("span", { class: "swatch" });
    mark.style.background = color;
    legend.append(element("span", {}, mark, text));
  };
  const scale = (title, colors, ticks) => {
    const bar = element("div", { class: "bar" });
    bar.style.background = `linear-gradient(to right, ${colors.join(", ")})`;
    legend.append(element("div", { class: "scale" }, element("div", {}, title), bar, element("div", { class: "ticks" }, ...ticks.map(t => element("span", {}, t)))));
  };
  if (viewer.coloring === "quality") {
    swatch(invalidColor, "invalid");
    scale("Scaled Jacobian: 1 is a cube", scales.quality, ["0", "0.25", "0.5", "0.75", "1"]);
  }
  else if (viewer.coloring === "deviation") {
    const d = viewer.largestDeviation;
    scale("Distance between result and reference, as a length", scales.deviation, d > 0 ? [0, .25, .5, .75, 1].map(t => short(t * d)) : ["0"]);
    swatch(neutralColor, "inside");
  }
  else if (viewer.coloring === "label")
    status_.regions.forEach((region, i) => swatch(categories[i % categories.length], `label ${region.label}`));
}

function fillNames(viewer) {
  byId("view-names").replaceChildren(...viewer.shown.map((mesh, i) => {
    const part = viewer.part(i), name = element("span", {}, mesh.name);
    name.style.left = `${part.left}px`;
    name.style.top = `${part.top}px`;
    return name;
  }));
}

function drawAxes(viewer) {
  byId("axes").replaceChildren(...viewer.axes().flatMap((axis, i) => [
    element("line", { x1: 0, y1: 0, x2: 20 * axis.x, y2: -20 * axis.y }),
    element("text", { x: 27 * axis.x, y: -27 * axis.y }, "xyz"[i]),
  ]));
}

function describe(mesh, h) {
  const limit = mesh.role === "after" && status_.connectivity_limits.find(l => l.hexahedron === h);
  const valid = mesh.isInvalid[h] ? ", invalid" : "";
  return `${mesh.name}, hexahedron ${h}: scaled Jacobian ${formats.quality(mesh.jacobians[h])}${valid}${limit ? `; at most ${formats.quality(limit.largest_scaled_jacobian)}, as ${limit.reason}` : ""}.`;
}

function addView() {
  const all = reference ? [...meshes, reference] : meshes;
  const viewer = new Viewer(byId("canvas"), all, labels);
  const shown = byId("shown"), coloring = byId("coloring");
  shown.append(element("option", { value: "all" }, "all side by side"), ...all.map((m, i) => element("option", { value: i }, m.name)));
  for (const [key, name] of Object.entries(colorings))
    if (key !== "label" || labels)
      coloring.append(element("option", { value: key }, name));
  const sayThreshold = () => {
    const value = Number(byId("threshold").value).toFixed(2);
    byId("threshold-value").textContent = viewer.threshold === null ? `scaled Jacobian ≤ ${value}`
      : `≤ ${value}: ${viewer.shown.filter(m => m !== reference).map(m => formats.count(viewer.numberShown(m))).join(" / ")}`;
  };
  const update = () => {
    viewer.coloring = coloring.value;
    // with their distances from each other, the results and the reference
    const together = viewer.coloring === "deviation" && reference ? [...results, reference] : meshes;
    viewer.shown = shown.value === "all" ? together : [all[Number(shown.value)]];
    viewer.cut = { axis: Number(byId("cut-axis").value), position: Number(byId("cut-position").value), isFlipped: byId("cut-flipped").checked };
    byId("view").style.setProperty("--meshes", viewer.shown.length);
    viewer.threshold = byId("worst").checked ? Number(byId("threshold").value) : null;
    viewer.hasEdges = byId("edges").checked;
    viewer.focus = null;
    viewer.rebuild();
    viewer.resize();
    fillLegend(viewer);
    fillNames(viewer);
    sayThreshold();
  };
  byId("controls").addEventListener("input", update);
  byId("controls").addEventListener("submit", event => event.preventDefault());
  byId("threshold").addEventListener("input", () => { byId("worst").checked = true; });
  byId("whole").addEventListener("click", () => { byId("picked").textContent = ""; viewer.showAll(); });
  for (const button of document.querySelectorAll("[data-look]"))
    button.addEventListener("click", () => viewer.look(new THREE.Vector3(...button.dataset.look.split(",").map(Number))));
  viewer.onRender = () => drawAxes(viewer);
  let pressed = null;
  byId("canvas").addEventListener("mousedown", event => { pressed = [event.clientX, event.clientY]; });
  byId("canvas").addEventListener("click", event => {
    if (pressed && Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) > 4)
      return; // that was a turn
    const box = byId("canvas").getBoundingClientRect();
    const hit = viewer.pick(event.clientX - box.left, event.clientY - box.top);
    byId("picked").textContent = hit ? describe(hit.mesh, hit.hexahedron) : "";
  });
  new ResizeObserver(() => { viewer.resize(); fillNames(viewer); }).observe(byId("view"));
  window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => viewer.rebuild());
  update();
  return viewer;
}

// --- places ---------------------------------------------------------------------

// A list: rows(i) is what stands in row i of all so many, the first being {text, focus}, where to fly to.
function addPlaces(viewer, title, count, columns, row) {
  if (count === 0)
    return;
  const body = element("tbody"), more = element("button", { type: "button" });
  const page = 100;
  let filled = 0;
  const fill = () => {
    for (const end = Math.min(filled + page, count); filled < end; ++filled) {
      const [place, ...others] = row(filled);
      const button = element("button", { type: "button", title: "Show it in the view" }, place.text);
      if (viewer)
        button.addEventListener("click", () => {
          byId("view").scrollIntoView({ block: "nearest" });
          byId("picked").textContent = place.words;
          viewer.flyTo(place.focus);
        });
      body.append(element("tr", {}, element("td", {}, button), ...others.map((text, i) => element("td", { class: columns[i + 1].isText ? "text" : null }, text))));
    }
    more.textContent = `Show ${Math.min(page, count - filled)} more of ${formats.count(count - filled)}`;
    more.hidden = filled === count;
  };
  more.addEventListener("click", fill);
  const details = element("details", { "data-count": count }, element("summary", {}, `${title}: ${formats.count(count)}`),
    element("div", { class: "scroll" }, element("table", {}, element("thead", {}, element("tr", {}, ...columns.map(c => element("th", { scope: "col", class: c.isText ? "text" : null }, c.name)))), body), more));
  details.addEventListener("toggle", () => { if (filled === 0) fill(); });
  byId("places").append(details);
}

function fillPlaces(viewer) {
  const after = meshes.find(m => m.role === "after"), before = meshes.find(m => m.role === "before");
  const inSpace = p => p.map(short).join(", ");
  const absolute = p => inSpace(p.toArray().map((x, c) => x + data.origin[c]));
  const hexahedron = h => ({ text: h, focus: { hexahedron: h }, words: describe(after, h) });
  const hexahedronColumns = [{ name: "hexahedron" }, { name: "before" }, { name: "after" }];
  const qualities = h => [formats.quality(before.jacobians[h]), formats.quality(after.jacobians[h])];

  const { invalid_hexahedra: invalid, vertices_off_reference: released, connectivity_limits: limits } = status_;
  addPlaces(viewer, "Invalid hexahedra", invalid.length, [...hexahedronColumns, { name: "center", isText: true }],
    i => [hexahedron(invalid[i].id), ...qualities(invalid[i].id), inSpace(invalid[i].center)]);
  const order = Array.from(after.jacobians.keys()).sort((a, b) => after.jacobians[a] - after.jacobians[b]).slice(0, 200);
  addPlaces(viewer, `The worst of ${formats.count(after.size)} hexahedra`, order.length,
    [...hexahedronColumns, { name: "center", isText: true }], i => [hexahedron(order[i]), ...qualities(order[i]), absolute(after.center(order[i]))]);
  addPlaces(viewer, "Vertices off the reference, not on the corner, curve or face that they belong to", released.length,
    [{ name: "vertex" }, { name: "distance from the reference" }, { name: "place", isText: true }], i => {
      const v = released[i];
      return [{ text: v, focus: { vertex: v }, words: `Vertex ${v}, which is not where it belongs.` },
        after.vertexDeviations[v] < 0 ? nothing : formats.length(after.vertexDeviations[v]), absolute(after.point(v))];
    });
  addPlaces(viewer, "Hexahedra that the connectivity limits", limits.length,
    [...hexahedronColumns, { name: "at most" }, { name: "because", isText: true }],
    i => [hexahedron(limits[i].hexahedron), ...qualities(limits[i].hexahedron), formats.quality(limits[i].largest_scaled_jacobian), limits[i].reason]);
  const thin = status_.thin_faces || [];
  const thinPlaces = data.thin_places ? decoded(data.thin_places, Float32Array) : null;
  addPlaces(viewer, "Faces of the surface that are thin for the spacing", thin.length, [{ name: "face" }, { name: "center", isText: true }], i => {
    const center = new THREE.Vector3().fromArray(thinPlaces, 3 * i);
    return [{ text: thin[i], focus: { point: center }, words: `Face ${thin[i]} of the surface, with too few cells behind it.` }, absolute(center)];
  });
  if (invalid.length + released.length + limits.length + thin.length === 0)
    byId("places").prepend(element("p", { class: "note" }, "No hexahedron is invalid or limited by the connectivity, and no vertex is released."));
  const first = byId("places").querySelector("details");
  if (first)
    first.open = true;
}

function fillRepeat() {
  byId("command").textContent = data.command;
  const show = value => value === null ? "not set" : Array.isArray(value) ? value.join(", ") : String(value);
  byId("options").append(element("table", {}, element("tbody", {}, ...Object.entries(report.options).map(([name, value]) =>
    element("tr", {}, element("th", { scope: "row" }, name.replace(/_/g, " ")), element("td", { class: "text" }, show(value)))))));
}

fillHeader();
fillSummary();
fillNumbers();
fillCharts();
fillRepeat();
let viewer = null;
try {
  viewer = addView();
}
catch (error) {
  byId("view").replaceChildren(element("p", { class: "note" }, `The view needs WebGL, which this browser does not offer: ${error.message}`));
  console.error(error);
}
fillPlaces(viewer);
requestAnimationFrame(() => { document.documentElement.dataset.isReady = "true"; }); // the view is drawn
