  // The spring in slow motion. One piece of the function that data.js opens; joined in the order of README.md.
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
    return { drawn, scale, margin, radius, middle: radius + 16, wire: clamp(windings.contact_pitch_m * scale * 0.8, 1.2, 8) };
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
    const touching = pitch.map((value, gap) => Number(gap > 0 && gap < windings.count && value <= windings.contact_pitch_m));
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
      const { contact_pitch_m: contact, gaps_per_pitch: share, wire_diameter_m: wire } = of.windings, gap = (Math.min(...pitch) - contact) * share;
      note.textContent = `Closest windings: gap ${mm(gap)} mm, pitch ${mm(wire + gap)} mm, wire ${mm(wire)} mm: ` +
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
