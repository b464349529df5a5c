  // The choice of case, and how all begins. One piece of the function that data.js opens; joined in the order of README.md.
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
