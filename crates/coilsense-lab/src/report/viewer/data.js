// Draws the report's interactive part: choice of case, spring in slow motion, signals and their errors.
// This piece opens the one function that all pieces share (joined in the order of README.md) and reads the data.
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
