// Draws the report's interactive part: choice of case, spring in slow motion, signals and their errors.
// The data's form is README.md's matter, colours are viewer.css's, the charts' canvas is uPlot's.
(function () {
  'use strict';

  // --- Small tools -------------------------------------------------------------------------------------------

  const byId = (id) => document.getElementById(id);
  const clamp = (value, low, high) => Math.min(Math.max(value, low), high);

  function make(tag, attributes, ...children) {
    const element = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes || {})) {
      if (name.startsWith('on')) element.addEventListener(name.slice(2), value);
      else if (value !== null && value !== false) element.setAttribute(name, value === true ? '' : value);
    }
    element.append(...children.filter((child) => child !== null && child !== undefined));
    return element;
  }

  // "F_i" with its subscript, as nodes; a name of several letters ("load_cell") stays as it is.
  function rich(text) {
    const nodes = document.createDocumentFragment();
    String(text).split(/(\b[A-Za-z]_[A-Za-z0-9]+)/).forEach((piece, index) => {
      if (index % 2 === 0) return nodes.append(piece);
      const [base, low] = piece.split('_');
      nodes.append(base, make('sub', {}, low));
    });
    return nodes;
  }

  function fixed(value, digits, signed) {
    if (value === null || !Number.isFinite(value)) return '–';
    const text = Math.abs(value).toFixed(digits);
    const sign = Number(text) === 0 ? '' : value < 0 ? '\u2212' : signed ? '+' : '';
    return sign + text;
  }

  // Decimals that show about a thousandth of a span.
  const digitsOf = (span) => (span > 0 ? clamp(3 - Math.ceil(Math.log10(span)), 0, 6) : 3);
  // A given number as it was written, without the noise of binary digits.
  const plain = (value) => String(Number(value.toPrecision(4))).replace('-', '\u2212');

  // Decimals that write a step between ticks in full: 2 for 0.25.
  function digitsFor(step) {
    let digits = 0;
    for (let rest = step; digits < 9 && Math.abs(rest - Math.round(rest)) > 1e-6 * rest; rest *= 10) digits++;
    return digits;
  }

  function extent(values, first = 0, last = values.length - 1) {
    let low = Infinity, high = -Infinity;
    for (let index = first; index <= last; index++) {
      const value = values[index];
      if (value === null) continue;
      if (value < low) low = value;
      if (value > high) high = value;
    }
    return low <= high ? [low, high] : null;
  }

  // --- Data --------------------------------------------------------------------------------------------------

  const SHOWN = { m: { unit: 'mm', factor: 1e3 }, H: { unit: 'µH', factor: 1e6 } };
  const HEADS = { position: 'Change of position', inductance: 'Inductance' };

  function bytes(text) {
    const raw = atob(text);
    return new DataView(Uint8Array.from(raw, (letter) => letter.charCodeAt(0)).buffer);
  }

  function decodeSignal(signal, count) {
    const view = bytes(signal.data);
    if (view.byteLength !== 4 * count) throw new Error(`${signal.name}: ${view.byteLength / 4} samples, not ${count}`);
    const { unit, factor } = SHOWN[signal.unit] || { unit: signal.unit, factor: 1 };
    const values = Array.from({ length: count }, (_, index) => {
      const value = signal.offset + signal.scale * view.getFloat32(4 * index, true);
      return Number.isFinite(value) ? value * factor : null;
    });
    const [low, high] = extent(values) || [0, 0];
    return { name: signal.name, label: signal.label || signal.name, kind: signal.kind, unit, values, low, high };
  }

  function decodeWindings(given) {
    if (!given) return null;
    const view = bytes(given.data), row = given.count + 2;
    if (view.byteLength !== 2 * row * given.frames) throw new Error(`windings: ${view.byteLength} bytes, not ${2 * row * given.frames}`);
    const place = (frame, node) => given.zero_m + given.metres_per_unit * view.getInt16(2 * (frame * row + node), true);
    const windings = { ...given, row, last: given.start_s + given.step_s * (given.frames - 1) };
    // Positions at a time, between frames along the straight line.
    windings.at = (time) => {
      const exact = clamp((time - given.start_s) / given.step_s, 0, given.frames - 1);
      const frame = Math.min(Math.floor(exact), Math.max(given.frames - 2, 0));
      const next = Math.min(frame + 1, given.frames - 1), part = exact - frame;
      return Float64Array.from({ length: row }, (_, node) => (1 - part) * place(frame, node) + part * place(next, node));
    };
    windings.peak = 0;
    windings.left = Infinity;
    windings.right = -Infinity;
    for (let frame = 0; frame < given.frames; frame++) {
      const x = windings.at(given.start_s + frame * given.step_s);
      for (const strain of strains(x)) windings.peak = Math.max(windings.peak, Math.abs(strain));
      windings.left = Math.min(windings.left, x[0]);
      windings.right = Math.max(windings.right, x[row - 1]);
    }
    return windings;
  }

  // Pitch of each gap over the mean pitch, less one. The outermost gaps are half a pitch wide.
  function strains(x) {
    const count = x.length - 2, mean = (x[count + 1] - x[0]) / count;
    return Float64Array.from({ length: count + 1 }, (_, gap) =>
      (x[gap + 1] - x[gap]) * (gap === 0 || gap === count ? 2 : 1) / mean - 1);
  }

  const decoded = new Map();
  function decode(given) {
    if (decoded.has(given)) return decoded.get(given);
    const { start_s: start, step_s: step, count } = given.time;
    const signals = given.signals.map((signal) => decodeSignal(signal, count));
    const reference = signals.find((signal) => signal.name === data.reference && signal.kind === 'force');
    for (const signal of signals) {
      if (!reference || signal === reference || signal.kind !== 'force') continue;
      signal.error = signal.values.map((value, index) =>
        (value === null || reference.values[index] === null ? null : value - reference.values[index]));
      // What has no sample beside the reference is not judged: it must not seem to meet a goal.
      const found = extent(signal.error);
      if (found) signal.worst = Math.max(-found[0], found[1]);
      else signal.error = null;
    }
    const times = Float64Array.from({ length: count }, (_, index) => start + index * step);
    const item = { given, signals, reference, times, start, step, end: times[count - 1] };
    item.goal = given.goal && given.goal.error_n > 0 ? given.goal.error_n : null;
    for (const signal of signals) {
      const kin = signals.filter(({ kind }) => kind === signal.kind).map(({ low, high }) => high - low);
      signal.digits = digitsOf(Math.max(...kin));
    }
    const errors = signals.filter((signal) => signal.error);
    item.errorDigits = digitsOf(2 * Math.max(0, ...errors.map((signal) => signal.worst)));
    item.windings = decodeWindings(given.windings);
    decoded.set(given, item);
    return item;
  }

  const quantity = ({ values, digits, unit }, index) => (values[index] === null ? '–' : `${fixed(values[index], digits)} ${unit}`);
  const indexAt = (item, time) => clamp(Math.round((time - item.start) / item.step), 0, item.times.length - 1);

  // --- Colours and lines -------------------------------------------------------------------------------------

  // Colour and dash, each of which alone tells lines apart; the four forces look as in the paper's figures.
  const KNOWN = { F_o: ['red', []], F_i: ['blue', [9, 3, 2, 3]], F_L: ['ink', [7, 4]], F_x: ['green', [2, 2.5]],
    u1: ['blue', []], u2: ['red', [7, 4]], L: ['ink', []] };
  const OTHERS = [['violet', [12, 3]], ['amber', [4, 3]], ['teal', [12, 3, 4, 3]], ['rose', [9, 3, 2, 3, 2, 3]],
    ['violet', [2, 4]], ['amber', []], ['teal', [7, 2]], ['rose', [4, 6]]];
  const styles = new Map();
  function styleOf(name) {
    if (!styles.has(name)) {
      const met = [...styles.keys()].filter((other) => !KNOWN[other]).length;
      const [colour, dash] = KNOWN[name] || OTHERS[met % OTHERS.length];
      styles.set(name, { colour: 'cs-' + colour, dash, width: name === 'F_x' ? 2 : 1.5 });
    }
    return styles.get(name);
  }

  const ink = {};
  function readInk() {
    const style = getComputedStyle(document.documentElement);
    for (const name of ['ground', 'ink', 'soft', 'line', 'cs-red', 'cs-blue', 'cs-green', 'cs-ink', 'cs-violet', 'cs-amber', 'cs-teal',
      'cs-rose', 'cs-goal', 'cs-goal-edge', 'cs-low', 'cs-middle', 'cs-high', 'cs-touch']) {
      ink[name] = style.getPropertyValue('--' + name).trim() || '#888';
    }
  }

  function sample(name) {
    const { colour, dash, width } = styleOf(name);
    const line = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
    line.setAttribute('viewBox', '0 0 34 8');
    line.setAttribute('aria-hidden', 'true');
    line.innerHTML = `<line x1="0" y1="4" x2="34" y2="4" style="stroke:var(--${colour})" stroke-width="${width + 0.3}" stroke-dasharray="${dash.join(' ')}"/>`;
    return line;
  }

  // --- State -------------------------------------------------------------------------------------------------

  let data = null;
  const state = { item: null, view: null, mark: null, hover: null, hidden: new Set(), playing: false, speed: 1 / 50, gain: null };
  let charts = [];
  let table = null;
  let spring = null;

  const wholeView = () => state.view[0] <= state.item.start && state.view[1] >= state.item.end;

  function setView(low, high) {
    const { start, end, step } = state.item;
    const width = clamp(high - low, Math.min(10 * step, end - start), end - start);
    const first = clamp((low + high - width) / 2, start, end - width);
    state.view = [first, first + width];
    for (const { plot } of charts) plot.setScale('x', { min: first, max: first + width });
    const reset = byId('cs-reset');
    if (reset) reset.disabled = wholeView();
    if (table) table.peaks();
  }

  function zoom(factor) {
    const [low, high] = state.view, middle = (low + high) / 2;
    const centre = state.mark >= low && state.mark <= high ? state.mark : middle;
    setView(centre - (centre - low) / factor, centre + (high - centre) / factor);
  }

  function setMark(time, inMotion) {
    state.mark = clamp(time, state.item.start, state.item.end);
    for (const { plot } of charts) placeMark(plot);
    if (spring) spring.draw();
    if (table) table.values(inMotion);
  }

  // --- Charts ------------------------------------------------------------------------------------------------

  const FONT = '12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif';

  function placeMark(plot) {
    const line = plot.over.querySelector('.cs-mark');
    if (!line || plot.scales.x.min === null || state.mark === null) return;
    const left = plot.valToPos(state.mark, 'x');
    line.hidden = !(left >= 0 && left <= plot.over.clientWidth);
    line.style.transform = `translateX(${left}px)`;
  }

  function padded(low, high) {
    if (low === null) return [0, 1];
    const span = high - low || Math.abs(high) * 0.01 || 1;
    return [low - 0.06 * span, high + 0.06 * span];
  }

  // The goal's limits belong to the picture unless they would flatten what is in it.
  function errorRange(low, high, goal) {
    const most = Math.max(-low, high, 0);
    const shown = goal === null ? 0 : most > 0 ? Math.min(goal * 1.05, 4 * most) : goal * 1.05;
    return padded(Math.min(low, -shown), Math.max(high, shown));
  }

  function drawGoal(plot, goal) {
    const { ctx, bbox } = plot;
    const place = (value) => clamp(plot.valToPos(value, 'y', true), bbox.top, bbox.top + bbox.height);
    const top = place(goal), bottom = place(-goal);
    ctx.save();
    ctx.fillStyle = ink['cs-goal'];
    ctx.fillRect(bbox.left, top, bbox.width, bottom - top);
    ctx.fillStyle = ink['cs-goal-edge'];
    for (const value of [-goal, goal]) {
      if (value > plot.scales.y.min && value < plot.scales.y.max) ctx.fillRect(bbox.left, place(value) - 0.5, bbox.width, devicePixelRatio);
    }
    ctx.restore();
  }

  function axis(scale, side, size, label) {
    const values = (_, splits, __, ___, step) => splits.map((value) => fixed(value, digitsFor(step)));
    return { scale, side, size, label, values, font: FONT, labelFont: FONT, labelSize: 18, labelGap: 0, gap: 4,
      stroke: () => ink.soft, grid: { show: side !== 1, stroke: () => ink.line, width: 1 }, ticks: { stroke: () => ink.line, size: 5, width: 1 },
      space: side % 2 ? 34 : 62 };
  }

  function chartOptions(spec, width) {
    const wide = width >= 560, nominal = data.nominal_force_n;
    const percent = spec.goal !== undefined && nominal > 0 && wide;
    const scales = { x: { time: false }, y: { range: (_, low, high) => (spec.goal === undefined ? padded(low, high) : errorRange(low, high, spec.goal)) } };
    const axes = [axis('x', 2, 26, 'Time [s]'), axis('y', 3, spec.left)];
    if (percent) {
      scales.percent = { from: 'y', range: (_, low, high) => [100 * low / nominal, 100 * high / nominal] };
      axes.push(axis('percent', 1, 62));
    }
    const lines = spec.lines.map(({ signal }) => {
      const { colour, dash, width: thick } = styleOf(signal.name);
      return { label: signal.label, scale: 'y', stroke: () => ink[colour], dash, width: thick, show: !state.hidden.has(signal.name), points: { show: false } };
    });
    return {
      width, height: spec.height, scales, axes, series: [{}, ...lines], legend: { show: false },
      padding: [8, percent ? 0 : wide && nominal > 0 ? 62 : 12, 0, 0],
      cursor: { y: false, drag: { x: true, y: false, dist: 4 }, points: { size: 6 }, sync: { key: 'coilsense', scales: ['x', null] } },
      hooks: {
        drawAxes: [(plot) => { if (spec.goal) drawGoal(plot, spec.goal); }],
        draw: [placeMark],
        setCursor: [(plot) => { if (plot === charts[0]?.plot) follow(plot); }],
        setScale: [(plot, key) => { if (key === 'x') followZoom(plot.scales.x); }],
      },
    };
  }

  function follow(plot) {
    const index = plot.cursor.left >= 0 ? plot.cursor.idx : null;
    const time = index === null || index === undefined ? null : state.item.times[index];
    if (time === state.hover) return;
    state.hover = time;
    if (table) table.values();
  }

  // A zoom made by dragging or a double click in one chart goes to all of them.
  function followZoom({ min, max }) {
    const small = 1e-9 + 1e-6 * state.item.step;
    if (min === null || (Math.abs(min - state.view[0]) < small && Math.abs(max - state.view[1]) < small)) return;
    setView(min, max);
  }

  function keys(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const width = state.view[1] - state.view[0], stride = width / (event.shiftKey ? 20 : 200);
    const act = { ArrowLeft: () => setMark(state.mark - stride), ArrowRight: () => setMark(state.mark + stride), Home: () => setMark(state.view[0]),
      End: () => setMark(state.view[1]), '+': () => zoom(2), '=': () => zoom(2), '-': () => zoom(0.5), Escape: () => setView(state.item.start, state.item.end) }[event.key];
    if (!act) return;
    event.preventDefault();
    act();
  }

  // Room for the numbers at the left, the same in all charts so that their times stand below each other.
  function leftRoom(specs) {
    const letters = specs.flatMap(({ lines }) => lines.map(({ values }) => {
      const [low, high] = extent(values) || [0, 1];
      const digits = high > low ? clamp(1 - Math.floor(Math.log10(high - low)), 0, 9) : 2;
      return Math.max(fixed(low, digits).length, fixed(high, digits).length);
    }));
    return clamp(14 + 7 * Math.max(...letters), 44, 100);
  }

  function addChart(host, spec) {
    const room = make('div', { class: 'cs-plot', tabindex: 0, role: 'group', 'aria-roledescription': 'chart', 'aria-label': spec.sentence, onkeydown: keys });
    host.append(make('figure', { class: 'cs-chart' }, spec.head, room, make('figcaption', {}, rich(spec.sentence))));
    const columns = [state.item.times, ...spec.lines.map((line) => line.values)];
    const entry = { spec, room, wide: room.clientWidth >= 560 };
    entry.build = (width) => {
      if (entry.plot) entry.plot.destroy();
      entry.wide = width >= 560;
      entry.plot = new uPlot(chartOptions(spec, width), columns, room);
      entry.plot.over.append(make('div', { class: 'cs-mark', 'aria-hidden': 'true' }));
      entry.plot.over.addEventListener('click', (event) => setMark(entry.plot.posToVal(event.offsetX, 'x')));
    };
    entry.resize = (width) => {
      if (width < 50 || width === entry.plot.width) return;
      if ((width >= 560) === entry.wide) return entry.plot.setSize({ width, height: spec.height });
      entry.build(width);
      entry.plot.setScale('x', { min: state.view[0], max: state.view[1] });
    };
    entry.build(Math.max(room.clientWidth, 200));
    charts.push(entry);
    sizes.observe(room);
  }

  const sizes = new ResizeObserver((entries) => {
    for (const { target, contentRect } of entries) {
      const entry = charts.find(({ room }) => room === target);
      if (entry) entry.resize(Math.floor(contentRect.width));
      else if (spring && target === spring.canvas) spring.draw();
    }
  });

  const list = (parts) => (parts.length < 2 ? parts.join('') : parts.slice(0, -1).join(', ') + ' and ' + parts[parts.length - 1]);
  const caseName = ({ given }) => [given.condition, given.damping_label].filter(Boolean).join(', ');

  function errorSentence(item, judged) {
    const worst = list(judged.map((signal) => `${signal.label} ${fixed(signal.worst, item.errorDigits)} N`));
    const text = `Largest error against ${item.reference.label}: ${worst}`;
    if (item.goal === null) return text + '.';
    const good = judged.filter((signal) => signal.worst <= item.goal).map((signal) => signal.label);
    const met = good.length === 0 ? 'none of them' : good.length === judged.length ? 'all of them' : list(good);
    return `${text}; the goal of ±${plain(item.goal)} N is met by ${met}.`;
  }

  const head = (left, middle, right) => make('div', { class: 'cs-head' }, make('span', {}, left), middle, make('span', {}, right));

  function forceCharts(item) {
    const forces = item.signals.filter((signal) => signal.kind === 'force' && extent(signal.values));
    if (!forces.length) return [];
    const low = Math.min(...forces.map((signal) => signal.low)), high = Math.max(...forces.map((signal) => signal.high));
    const digits = digitsOf(high - low);
    const specs = [{ height: 270, lines: forces.map((signal) => ({ signal, values: signal.values })), head: head('Force [N]', null, ''),
      sentence: `Forces, ${caseName(item)}: between ${fixed(low, digits)} and ${fixed(high, digits)} N from ${plain(item.start)} to ${plain(item.end)} s.` }];
    const judged = forces.filter((signal) => signal.error);
    if (!judged.length) return specs;
    const goal = item.goal === null ? null : make('span', { class: 'cs-goal' }, `goal ±${plain(item.goal)} N`);
    const percent = data.nominal_force_n > 0 ? make('span', { class: 'cs-wide' }, rich('[% of F_nom]')) : '';
    return [...specs, { height: 230, goal: item.goal, lines: judged.map((signal) => ({ signal, values: signal.error })),
      head: head(rich(`Error against ${item.reference.label} [N]`), goal, percent), sentence: errorSentence(item, judged) }];
  }

  function otherCharts(item) {
    const kinds = new Set(item.signals.map((signal) => signal.kind));
    kinds.delete('force');
    return [...kinds].map((kind) => {
      const lines = item.signals.filter((signal) => signal.kind === kind), unit = lines[0].unit;
      const first = (signal) => (kind === 'position' ? signal.values.find((value) => value !== null) || 0 : 0);
      const names = list(lines.map((signal) => signal.label)), title = HEADS[kind] || kind;
      if (lines.every((signal) => signal.high - signal.low < 1e-9 * Math.max(1, Math.abs(signal.high)))) {
        return { still: `${title}: ${names} ${lines.length > 1 ? 'do' : 'does'} not change.` };
      }
      const spans = list(lines.map((signal) => `${signal.label} by ${plain(signal.high - signal.low)} ${unit}`));
      return { height: 170, head: head(`${title} [${unit}]`, null, ''), sentence: `${title}: from lowest to highest, ${spans}.`,
        lines: lines.map((signal) => ({ signal, values: signal.values.map((value) => (value === null ? null : value - first(signal))) })) };
    });
  }

  // --- Read-out ----------------------------------------------------------------------------------------------

  function toggle(name, button) {
    const hide = !state.hidden.has(name);
    state.hidden[hide ? 'add' : 'delete'](name);
    button.setAttribute('aria-pressed', String(!hide));
    for (const { plot, spec } of charts) {
      spec.lines.forEach(({ signal }, index) => { if (signal.name === name) plot.setSeries(index + 1, { show: !hide }); });
    }
  }

  function buildTable(host, item) {
    const nominal = data.nominal_force_n, judged = item.signals.some((signal) => signal.error);
    const titles = judged ? ['Error [N]', nominal > 0 ? '[% of F_nom]' : null, 'Worst in view [N]'].filter(Boolean) : [];
    const clock = make('th', { scope: 'col' });
    const rows = item.signals.map((signal) => {
      const button = make('button', { type: 'button', 'aria-pressed': String(!state.hidden.has(signal.name)), title: 'Show or hide', onclick: () => toggle(signal.name, button) },
        sample(signal.name), make('span', {}, rich(signal.label)));
      const cells = [make('td'), ...titles.map(() => make('td'))];
      return { signal, cells, row: make('tr', {}, make('th', { scope: 'row', class: 'row' }, button), ...cells) };
    });
    const heads = titles.map((title) => make('th', { scope: 'col' }, rich(title)));
    host.append(make('div', { class: 'scroll' }, make('table', { class: 'cs-table' },
      make('thead', {}, make('tr', {}, make('th', { class: 'row', scope: 'col' }, 'Signal'), clock, ...heads)), make('tbody', {}, ...rows.map(({ row }) => row)))));
    let last = 0;
    const values = (inMotion) => {
      // Ten times a second is as fast as digits can be read.
      if (inMotion && (state.hover !== null || performance.now() - last < 100)) return;
      last = performance.now();
      const index = indexAt(item, state.hover === null ? state.mark : state.hover);
      clock.textContent = `at ${fixed(item.times[index], 4)} s`;
      for (const { signal, cells } of rows) {
        cells[0].textContent = quantity(signal, index);
        if (!signal.error) continue;
        cells[1].textContent = fixed(signal.error[index], item.errorDigits, true);
        if (nominal > 0) cells[2].textContent = fixed(signal.error[index] === null ? null : 100 * signal.error[index] / nominal, 2, true);
      }
    };
    const peaks = () => {
      const first = indexAt(item, state.view[0]), end = indexAt(item, state.view[1]);
      for (const { signal, cells } of rows) {
        const found = signal.error && extent(signal.error, first, end);
        if (!found) continue;
        const worst = Math.max(-found[0], found[1]), cell = cells[cells.length - 1];
        const over = item.goal !== null && worst > item.goal;
        cell.className = over ? 'off' : '';
        cell.replaceChildren(...(over ? [make('span', { class: 'range' }, 'over goal ')] : []), fixed(worst, item.errorDigits));
      }
    };
    return { values, peaks };
  }

  function clear() {
    for (const { plot, room } of charts) { sizes.unobserve(room); plot.destroy(); }
    if (spring) { sizes.unobserve(spring.canvas); seen.unobserve(spring.canvas); }
    charts = [];
    table = spring = null;
  }

  function drawSignals(item) {
    const host = byId('coilsense-signals');
    if (!host) return;
    const button = (text, label, act, id) => make('button', { type: 'button', id, 'aria-label': label, onclick: act }, text);
    const reset = button('Reset zoom', null, () => setView(item.start, item.end), 'cs-reset');
    const bar = make('div', { class: 'cs-controls' }, button('+', 'Zoom in', () => zoom(2), null), button('\u2212', 'Zoom out', () => zoom(0.5), null), reset,
      make('span', { class: 'soft' }, 'Drag to zoom, double-click to reset, click to move the marker; with a chart in focus: ← → + \u2212 Esc.'));
    host.replaceChildren();
    table = buildTable(host, item);
    host.append(bar);
    if (typeof uPlot !== 'function') return;
    const specs = [...forceCharts(item), ...otherCharts(item)], left = leftRoom(specs.filter(({ lines }) => lines));
    for (const spec of specs) {
      if (spec.still) host.append(make('p', { class: 'cs-note' }, rich(spec.still)));
      else addChart(host, { ...spec, left });
    }
  }

  // --- Spring ------------------------------------------------------------------------------------------------

  function mix(low, high, part) {
    const parse = (text) => [1, 3, 5].map((at) => parseInt(text.slice(at, at + 2), 16));
    const [from, to] = [parse(low), parse(high)];
    return `rgb(${from.map((value, index) => Math.round(value + part * (to[index] - value))).join(',')})`;
  }
  const shade = (part) => (part < 0 ? mix(ink['cs-middle'], ink['cs-low'], Math.min(-part, 1)) : mix(ink['cs-middle'], ink['cs-high'], Math.min(part, 1)));

  // Where everything lies on the canvas: the ends true to scale, windings off the straight line by `gain`.
  function layOut(windings, x, width) {
    const margin = clamp(0.07 * width, 34, 70);
    const scale = (width - 2 * margin) / (windings.right - windings.left);
    const count = windings.count, mean = (x[count + 1] - x[0]) / count;
    const place = (position) => margin + (position - windings.left) * scale;
    const drawn = Float64Array.from(x, (position, node) => {
      if (node === 0 || node === count + 1) return place(position);
      const straight = x[0] + (node - 0.5) * mean;
      return place(straight + state.gain * (position - straight));
    });
    const radius = clamp(windings.coil_radius_m * scale, 16, 46);
    return { drawn, scale, margin, radius, middle: radius + 16, wire: clamp(windings.wire_diameter_m * scale * 0.8, 1.2, 8) };
  }

  function drawCoil(context, plan, strain, touching, peak) {
    const { drawn, radius, middle, wire } = plan, count = drawn.length - 2;
    const between = (node) => (node === 0 ? drawn[0] : node === count ? drawn[count + 1] : (drawn[node] + drawn[node + 1]) / 2);
    const half = (from, to, up, gap, front) => {
      const [start, end] = up ? [middle + radius, middle - radius] : [middle - radius, middle + radius];
      // Control points of the cubic nearest to half a cosine wave.
      const near = from + 0.3642 * (to - from), far = from + 0.6358 * (to - from);
      const stroke = (style, width) => {
        context.beginPath();
        context.moveTo(from, start);
        context.bezierCurveTo(near, start, far, end, to, end);
        context.strokeStyle = style;
        context.lineWidth = width;
        context.stroke();
      };
      if (front) stroke(ink.ground, wire + 1.6);
      stroke(touching[gap] ? ink['cs-touch'] : shade(peak > 0 ? strain[gap] / peak : 0), front ? wire : 0.7 * wire);
    };
    context.lineCap = 'round';
    context.globalAlpha = 0.5;
    for (let node = 1; node <= count; node++) half(between(node - 1), drawn[node], true, node - 1, false);
    context.globalAlpha = 1;
    for (let node = 1; node <= count; node++) half(drawn[node], between(node), false, node, true);
    context.fillStyle = ink['cs-touch'];
    for (let gap = 1; gap < count; gap++) {
      if (!touching[gap]) continue;
      const at = (drawn[gap] + drawn[gap + 1]) / 2, foot = middle + radius + wire;
      context.fill(new Path2D(`M${at} ${foot + 1}l3.5 7h-7z`));
    }
  }

  // An arrow out of the end for tension, into it for compression; its length is the force over the case's largest.
  function drawArrow(context, at, middle, length, outward) {
    const size = Math.abs(length);
    if (size < 4) return;
    const [tail, tip] = length > 0 ? [at, at + outward * size] : [at + outward * size, at];
    const back = Math.sign(tail - tip) * 8;
    context.fillStyle = context.strokeStyle = ink.ink;
    context.lineWidth = 2;
    context.stroke(new Path2D(`M${tail} ${middle}H${tip + back / 2}`));
    context.fill(new Path2D(`M${tip} ${middle}l${back} -5v10z`));
  }

  function drawEnds(context, plan, item) {
    const { drawn, radius, middle, margin } = plan, ends = [drawn[0], drawn[drawn.length - 1]];
    const force = (name) => item.signals.find((signal) => signal.name === name);
    const pair = [force('F_i'), force('F_o')];
    const most = Math.max(1e-12, ...pair.filter(Boolean).map((signal) => Math.max(-signal.low, signal.high)));
    ends.forEach((at, end) => {
      const outward = end ? 1 : -1;
      context.fillStyle = ink.soft;
      context.fillRect(at + (end ? 0 : -4), middle - radius - 8, 4, 2 * radius + 16);
      const value = pair[end] && pair[end].values[indexAt(item, state.mark)];
      if (value) drawArrow(context, at + outward * 5, middle, (margin - 8) * value / most, outward);
    });
  }

  function drawRuler(context, plan) {
    const room = 90 / plan.scale, power = 10 ** Math.floor(Math.log10(room));
    const length = power * [5, 2, 1].find((step) => step * power <= room);
    const y = 2 * plan.middle + 10, pixels = length * plan.scale;
    context.strokeStyle = context.fillStyle = ink.soft;
    context.lineWidth = 1;
    context.stroke(new Path2D(`M${plan.margin + 0.5} ${y - 4}v8m0 -4h${pixels}m0 -4v8`));
    context.font = FONT;
    context.fillText(`${plain(length * 1e3)} mm`, plan.margin + pixels + 8, y + 4);
  }

  function drawSpring(item) {
    const { canvas } = spring, windings = item.windings, width = canvas.clientWidth, ratio = devicePixelRatio || 1;
    if (!width) return;
    const x = windings.at(state.mark), plan = layOut(windings, x, width), height = Math.ceil(2 * plan.middle + 24);
    if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
      canvas.style.height = height + 'px';
      canvas.width = Math.round(width * ratio);
      canvas.height = Math.round(height * ratio);
    }
    const context = canvas.getContext('2d'), strain = strains(x);
    const pitch = x.slice(1).map((place, gap) => place - x[gap]);
    const touching = pitch.map((value, gap) => Number(gap > 0 && gap < windings.count && value <= windings.wire_diameter_m));
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, width, height);
    drawCoil(context, plan, strain, touching, windings.peak);
    drawEnds(context, plan, item);
    drawRuler(context, plan);
    spring.tell(item, pitch.slice(1, -1), touching);
  }

  function endLabel(item, name, at) {
    const signal = item.signals.find((other) => other.name === name), index = indexAt(item, state.mark);
    if (!signal) return [];
    const error = signal.error && signal.error[index] !== null ? ` (error ${fixed(signal.error[index], item.errorDigits, true)} N)` : '';
    return [make('span', { class: 'soft' }, `End ${at} `), make('b', {}, rich(name)), ` = ${quantity(signal, index)}`, make('span', { class: 'soft' }, error)];
  }

  // The exaggeration at which the largest strain opens or closes a pitch by about half.
  function fitting(peak) {
    return peak > 0 ? [50, 20, 10, 5, 2].find((gain) => gain * peak <= 0.6) || 1 : 1;
  }

  function player(item) {
    const { start_s: first, last, step_s: step } = item.windings;
    const play = make('button', { type: 'button', class: 'cs-play', onclick: () => setPlaying(!state.playing) });
    const scrub = make('input', { type: 'range', 'aria-label': 'Time', min: first, max: last, step: step / 10, oninput: () => { setPlaying(false); setMark(Number(scrub.value)); } });
    const clock = make('output', { class: 'cs-clock' });
    const speeds = [1, 5, 20, 50, 100, 500].map((slow) => make('option', { value: 1 / slow, selected: Math.abs(state.speed * slow - 1) < 1e-9 }, slow === 1 ? 'real time' : `1/${slow}`));
    const speed = make('select', { onchange: () => { state.speed = Number(speed.value); } }, ...speeds);
    const gain = make('output', {});
    const slider = make('input', { type: 'range', min: 1, max: 50, step: 1, value: state.gain, oninput: () => { state.gain = Number(slider.value); spring.draw(); } });
    const bar = make('div', { class: 'cs-controls cs-player' }, play, make('label', { class: 'cs-scrub' }, scrub, clock), make('label', {}, 'Speed ', speed),
      make('label', { class: 'cs-gain' }, 'Displacement ', slider, gain));
    return { bar, play, scrub, clock, gain };
  }

  function strainLegend(peak) {
    const percent = (value) => `${fixed(100 * value, digitsOf(100 * peak), true)} %`;
    return make('p', { class: 'cs-strain' }, 'Pitch against its mean: ', make('span', { class: 'cs-range' }, percent(-peak),
      make('span', { class: 'cs-scale', 'aria-hidden': 'true' }), percent(peak)), make('span', { class: 'cs-touch' }, 'windings touch'));
  }

  function buildSpring(item) {
    const host = byId('coilsense-spring');
    if (!host) return;
    if (!item.windings) {
      setPlaying(false);
      return host.replaceChildren(make('p', { class: 'cs-note' }, 'This case holds no positions of windings.'));
    }
    state.gain = fitting(item.windings.peak);
    const canvas = make('canvas', { class: 'cs-spring', role: 'img' }), controls = player(item);
    const left = make('span'), right = make('span'), note = make('p', { class: 'cs-note' });
    canvas.setAttribute('aria-label', `The spring with its ${item.windings.count} windings, end 1 at the left, coloured by local pitch; largest strain ${fixed(100 * item.windings.peak, 2)} % of the mean pitch.`);
    host.replaceChildren(make('div', { class: 'cs-ends' }, left, right), canvas, controls.bar, strainLegend(item.windings.peak), note);
    spring = { canvas, controls, draw: () => drawSpring(item) };
    spring.tell = (of, pitch, touching) => {
      left.replaceChildren(...endLabel(of, 'F_i', 1));
      right.replaceChildren(...endLabel(of, 'F_o', 2));
      controls.scrub.value = state.mark;
      controls.clock.textContent = `${fixed(state.mark, 4)} s`;
      controls.gain.textContent = state.gain === 1 ? '×1, true to scale' : `×${state.gain}`;
      const pairs = touching.reduce((sum, one) => sum + one, 0), mm = (value) => fixed(1e3 * value, 2);
      const enlarged = state.gain > 1 ? ` Displacements are drawn ×${state.gain}: what seems to touch here touches only where marked.` : '';
      note.textContent = `Closest pitch ${mm(Math.min(...pitch))} mm, wire ${mm(of.windings.wire_diameter_m)} mm: ` +
        (pairs ? `${pairs} ${pairs > 1 ? 'pairs' : 'pair'} of windings touch.` : 'no windings touch.') + enlarged;
    };
    sizes.observe(canvas);
    seen.observe(canvas);
    setPlaying(state.playing);
  }

  // --- Motion ------------------------------------------------------------------------------------------------

  let inSight = false, running = false, before = 0;
  const seen = new IntersectionObserver((entries) => {
    inSight = entries[entries.length - 1].isIntersecting;
    run();
  });

  function setPlaying(playing) {
    state.playing = playing;
    if (spring) {
      spring.controls.play.textContent = playing ? 'Pause' : 'Play';
      spring.controls.play.classList.toggle('cs-playing', playing);
    }
    run();
  }

  function run() {
    if (running || !state.playing || !inSight || !spring) return;
    running = true;
    before = performance.now();
    requestAnimationFrame(step);
  }

  // Goes round within what the charts show.
  function step(now) {
    running = state.playing && inSight && spring !== null;
    if (!running) return;
    const { start_s: start, last } = state.item.windings;
    let [low, high] = [Math.max(state.view[0], start), Math.min(state.view[1], last)];
    if (low >= high) [low, high] = [start, last];
    const time = state.mark + clamp((now - before) / 1e3, 0, 0.1) * state.speed;
    before = now;
    setMark(time > high || time < low ? low : time, true);
    requestAnimationFrame(step);
  }

  // --- Choice of case ----------------------------------------------------------------------------------------

  const MANY = 8;
  function choice(title, options, current, possible, act) {
    if (options.length < 2) return null;
    if (options.length > MANY) {
      const select = make('select', { onchange: () => act(select.value) },
        ...options.map((option) => make('option', { selected: option === current, disabled: !possible(option) }, option)));
      return make('label', { class: 'cs-choice' }, title + ' ', select);
    }
    const name = 'cs-' + title.toLowerCase();
    return make('fieldset', { class: 'cs-choice' }, make('legend', {}, title), ...options.map((option) => make('label', {},
      make('input', { type: 'radio', name, value: option, checked: option === current, disabled: !possible(option), onchange: () => act(option) }), make('span', {}, option))));
  }

  function drawChoice(item) {
    const host = byId('coilsense-case');
    if (!host) return;
    const { condition, damping_label: damping, surge_lines_hz: lines } = item.given;
    const unique = (key) => [...new Set(data.cases.map((one) => one[key]))];
    const find = (wanted, label) => data.cases.find((one) => one.condition === wanted && one.damping_label === label);
    const pick = (wanted, label) => {
      const focused = document.activeElement && document.activeElement.value, name = document.activeElement && document.activeElement.name;
      show(find(wanted, label) || data.cases.find((one) => one.condition === wanted));
      if (name) host.querySelectorAll(`input[name="${name}"]`).forEach((input) => { if (input.value === focused) input.focus(); });
    };
    const facts = [make('b', {}, caseName(item))];
    if (item.goal !== null) facts.push(`, goal ±${plain(item.goal)} N`);
    if (lines && lines.length) facts.push(`, surges at ${lines.slice(0, 3).map((hertz) => fixed(hertz, 1)).join(', ')}${lines.length > 3 ? ' …' : ''} Hz (${fixed(1e3 / lines[0], 1)} ms to and fro)`);
    host.replaceChildren(...[
      make('div', { class: 'cs-controls' }, choice('Condition', unique('condition'), condition, () => true, (wanted) => pick(wanted, damping)),
        choice('Damping', unique('damping_label'), damping, (label) => Boolean(find(condition, label)), (label) => pick(condition, label))),
      make('p', { class: 'cs-facts' }, ...facts, '.')]);
  }

  // A narrow page begins with as many surges as it can show apart, a wide one with everything.
  function firstView(item) {
    const lines = item.given.surge_lines_hz, width = (byId('coilsense-signals') || document.body).clientWidth;
    if (!lines || !lines.length || width >= 560) return [item.start, item.end];
    return [item.start, Math.min(item.end, item.start + Math.floor(width / 60) / lines[0])];
  }

  function show(given) {
    let item;
    clear();
    try {
      item = decode(given);
    } catch (error) {
      drawChoice({ given, goal: null });
      for (const part of ['spring', 'signals']) byId('coilsense-' + part)?.replaceChildren(make('p', { class: 'warning' }, `This case cannot be drawn: ${error.message}.`));
      return;
    }
    const same = state.item && state.item.start === item.start && state.item.end === item.end;
    state.item = item;
    state.hover = null;
    if (!same) state.view = firstView(item);
    state.mark = clamp(state.mark === null ? item.start : state.mark, item.start, item.end);
    drawChoice(item);
    drawSignals(item);
    buildSpring(item);
    setView(...state.view);
    setMark(state.mark);
  }

  // --- Beginning ---------------------------------------------------------------------------------------------

  function repaint() {
    readInk();
    for (const { plot } of charts) plot.redraw(false, true);
    if (spring) spring.draw();
  }

  // On paper the page is light and about 680 px wide, whatever it is on the screen.
  function print(on) {
    document.documentElement.classList.toggle('cs-print', on);
    readInk();
    if (table) table.values();
    for (const { plot, spec, room } of charts) plot.setSize({ width: on ? 660 : Math.floor(room.clientWidth), height: spec.height });
    repaint();
  }

  // A link to "#case-<id>" anywhere in the page chooses that case.
  const linked = () => data.cases.find(({ id }) => ['#case-' + id, '#case-' + encodeURIComponent(id)].includes(location.hash));

  function begin() {
    try {
      data = JSON.parse(byId('coilsense-data').textContent);
    } catch (_) {
      return;
    }
    if (!data || !Array.isArray(data.cases) || !data.cases.length) return;
    for (const { name } of data.cases.flatMap((one) => one.signals || [])) styleOf(name);
    readInk();
    state.playing = !matchMedia('(prefers-reduced-motion: reduce)').matches;
    show(linked() || data.cases[0]);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', repaint);
    window.addEventListener('beforeprint', () => print(true));
    window.addEventListener('afterprint', () => print(false));
    window.addEventListener('hashchange', () => { if (linked()) show(linked()); });
  }

  if (byId('coilsense-data')) begin();
})();
