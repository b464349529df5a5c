  // Colours, lines and the state that all parts share. One piece of the function that data.js opens; joined in the order of README.md.
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
