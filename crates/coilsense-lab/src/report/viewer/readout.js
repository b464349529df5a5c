  // The table that is legend, switch and read-out at once. One piece of the function that data.js opens; joined in the order of README.md.
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
        cell.replaceChildren(...(over ? [make('span', { class: 'range' }, 'beyond ±goal ')] : []), fixed(worst, item.errorDigits));
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
