  // The charts of signals and of their errors. One piece of the function that data.js opens; joined in the order of README.md.
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
    return `${text}; every moment lies within ±${plain(item.goal)} N for ${met} (the goal itself counts only what falls into the wanted band).`;
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
