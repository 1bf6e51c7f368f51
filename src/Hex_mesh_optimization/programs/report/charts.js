// Two kinds of charts, as SVG: histograms with a logarithmic axis of counts, and lines over iterations.

function element(name, attributes = {}, ...children) {
  const isSvg = ["svg", "g", "line", "path", "rect", "text", "title", "circle"].includes(name);
  const result = isSvg ? document.createElementNS("http://www.w3.org/2000/svg", name) : document.createElement(name);
  for (const [key, value] of Object.entries(attributes))
    if (value !== null && value !== undefined)
      result.setAttribute(key, value);
  result.append(...children);
  return result;
}

// Round numbers that divide an interval into about so many parts.
function ticksOf(low, high, parts) {
  const raw = (high - low) / parts, power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map(k => k * power).find(s => s >= raw * .999);
  const result = [];
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; ++i)
    result.push(Number((i * step).toPrecision(12)));
  return result;
}

function powersUpTo(most) {
  const result = [];
  for (let p = 1; p <= Math.max(most, 1); p *= 10)
    result.push(p);
  return result;
}

class Chart {
  // x, y: [low, high] of the axes; y of the logarithms where it is logarithmic.
  constructor(label, x, y, { left = 52, bottom = 40, top = 10 } = {}) {
    Object.assign(this, { width: 560, height: 250, left, bottom, top, right: 20, xs: x, ys: y });
    this.svg = element("svg", { class: "chart", viewBox: `0 0 ${this.width} ${this.height}`, role: "img", "aria-label": label });
  }

  x(value) { return this.left + (value - this.xs[0]) / (this.xs[1] - this.xs[0]) * (this.width - this.left - this.right); }
  y(value) { return this.height - this.bottom - (value - this.ys[0]) / (this.ys[1] - this.ys[0]) * (this.height - this.bottom - this.top); }

  // ticks: [value, text]
  drawAxes(xTicks, yTicks, xTitle, yTitle) {
    const bottom = this.height - this.bottom, right = this.width - this.right;
    for (const [value, text] of yTicks)
      this.svg.append(
        element("line", { class: "grid", x1: this.left, x2: right, y1: this.y(value), y2: this.y(value) }),
        element("text", { x: this.left - 6, y: this.y(value) + 4, "text-anchor": "end" }, text));
    for (const [value, text] of xTicks)
      this.svg.append(element("text", { x: this.x(value), y: bottom + 17, "text-anchor": "middle" }, text),
        element("line", { class: "axis", x1: this.x(value), x2: this.x(value), y1: bottom, y2: bottom + 4 }));
    this.svg.append(element("line", { class: "axis", x1: this.left, x2: right, y1: bottom, y2: bottom }),
      element("text", { x: (this.left + right) / 2, y: this.height - 5, "text-anchor": "middle" }, xTitle),
      element("text", { transform: `translate(11 ${(bottom + this.top) / 2}) rotate(-90)`, "text-anchor": "middle" }, yTitle));
  }

  drawLine(points, color, dashes = null) {
    const d = points.map(([x, y], i) => `${i ? "L" : "M"}${this.x(x).toFixed(1)} ${this.y(y).toFixed(1)}`).join("");
    this.svg.append(element("path", { class: "line", d, stroke: color, "stroke-dasharray": dashes }));
  }
}

function keyOf(series) {
  return element("ul", { class: "key" }, ...series.map(s => {
    const mark = element("i");
    mark.style.background = s.color;
    return element("li", {}, mark, s.name);
  }));
}

// Where the counts of all numbers are; the last part includes its end.
function countsOf(values, low, high, parts) {
  const counts = new Array(parts).fill(0);
  for (const v of values)
    ++counts[Math.min(Math.max(Math.floor((v - low) / (high - low) * parts), 0), parts - 1)];
  return counts;
}

// series: {name, color, values, role}. The first one is an outline over the others.
function histogram(container, series, { low, high, parts, title, xTitle, format }) {
  for (const s of series)
    s.counts = countsOf(s.values, low, high, parts);
  const most = Math.max(1, ...series.flatMap(s => s.counts)), floor = -.3; // of the logarithms: one is seen
  const chart = new Chart(title, [low, high], [floor, Math.log10(most) + .1]);
  chart.drawAxes(ticksOf(low, high, 8).map(t => [t, format(t)]), powersUpTo(most).map(p => [Math.log10(p), inWords(p)]),
    xTitle, "number, logarithmic");
  const height = count => count > 0 ? Math.log10(count) : floor, width = (high - low) / parts;
  series.forEach((s, k) => {
    const d = [`M${chart.x(low)} ${chart.y(floor)}`];
    s.counts.forEach((count, i) => {
      const y = chart.y(height(count)).toFixed(1);
      d.push(`L${chart.x(low + i * width).toFixed(1)} ${y}L${chart.x(low + (i + 1) * width).toFixed(1)} ${y}`);
    });
    d.push(`L${chart.x(high)} ${chart.y(floor)}`);
    chart.svg.append(element("path", {
      d: d.join(""), stroke: s.color, "stroke-width": 1.6, fill: s.color, "fill-opacity": k === 0 && series.length > 1 ? .12 : .35,
      "data-role": s.role, "data-counts": s.counts.join(" "),
    }));
  });
  for (let i = 0; i < parts; ++i) {
    const words = series.map(s => `${s.name}: ${inWords(s.counts[i])}`).join("; ");
    chart.svg.append(element("rect", {
      x: chart.x(low + i * width), y: chart.top, width: chart.x(low + width) - chart.x(low), height: chart.height - chart.top - chart.bottom,
      fill: "transparent",
    }, element("title", {}, `${format(low + i * width)} to ${format(low + (i + 1) * width)}. ${words}`)));
  }
  container.append(keyOf(series), chart.svg);
}

function inWords(count) { return count.toLocaleString("en-US"); }

const stageNames = { RECTIFICATION: "rectification", UNTANGLING: "untangling", MAXIMIZATION: "maximization" };

// x of the first iteration is 1: at 0 is what came in.
function drawStages(chart, iterations) {
  for (let begin = 0, end; begin < iterations.length; begin = end) {
    for (end = begin; end < iterations.length && iterations[end].stage === iterations[begin].stage;)
      ++end;
    const left = chart.x(begin + .5), right = chart.x(end + .5), bottom = chart.height - chart.bottom;
    chart.svg.append(element("line", { class: "grid", x1: left, x2: left, y1: chart.top - 16, y2: bottom, "stroke-dasharray": "3 3" }));
    const name = stageNames[iterations[begin].stage];
    if (right - left > 7 * name.length)
      chart.svg.append(element("text", { x: (left + right) / 2, y: chart.top - 8, "text-anchor": "middle" }, name));
  }
}

// What came in, and what each iteration came to: quality, and how many are inverted.
function convergence(container, before, iterations, color) {
  if (iterations.length === 0) {
    container.append("There was no iteration.");
    return;
  }
  const states = [before, ...iterations], n = iterations.length, xs = [0, n + .5];
  const xTicks = ticksOf(0, n, 8).filter(t => Number.isInteger(t)).map(t => [t, inWords(t)]);
  const lowest = Math.min(0, ...states.map(s => s.minimum));
  const quality = new Chart("Minimum and mean of the scaled Jacobians after each iteration", xs, [lowest, 1], { top: 28 });
  quality.drawAxes(xTicks, ticksOf(lowest, 1, 5).map(t => [t, t.toFixed(1).replace("-", "\u2212")]), "iteration", "scaled Jacobian");
  drawStages(quality, iterations);
  quality.drawLine(states.map((s, i) => [i, s.average]), color, "6 4");
  quality.drawLine(states.map((s, i) => [i, s.minimum]), color);
  const most = Math.max(1, ...states.map(s => s.number_of_inverted)), floor = -.4; // of the logarithms: there are none
  const inverted = new Chart("Number of inverted hexahedra after each iteration", xs, [floor, Math.log10(most) + .1], { top: 28 });
  inverted.drawAxes(xTicks, [[floor, "0"], ...powersUpTo(most).map(p => [Math.log10(p), inWords(p)])], "iteration", "number, logarithmic");
  drawStages(inverted, iterations);
  inverted.drawLine(states.map((s, i) => [i, s.number_of_inverted > 0 ? Math.log10(s.number_of_inverted) : floor]), color);
  container.append(element("div", { class: "charts" },
    element("div", {}, element("p", { class: "note" }, "Scaled Jacobians: minimum (line) and mean (dashed)"), quality.svg),
    element("div", {}, element("p", { class: "note" }, "Inverted hexahedra"), inverted.svg)));
}
