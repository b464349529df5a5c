// Frequencies of the modes against length: curves by kind, bands between two ways of the ends, what drives the spring as level lines.
//
// Next door: what is chosen on it (`choice`), the same as a table (`table`), what it says in words (`words`).

import type uPlot from 'uplot';
import type { ExactFacts, Kind } from '../answer';
import { make } from '../dom';
import { axis, chart, curve, font, LARGER, plain } from '../plots/chart';
import { ink, sample, type Colour } from '../plots/looks';
import { Points } from '../plots/points';
import type { Choice } from './choice';
import { LOOKS, MEANING } from './kinds';
import type { Lines } from './lines';

/** Lines of the input that are named on the chart. */
const MOST_NAMED = 6;
/** A band that is nowhere wider than this is its line [1]. */
const WIDE = 1.02;

export interface LinesChart {
  /** Marks the chosen mode at the chosen length. */
  point(choice: Choice): void;
}

export function drawLines(host: HTMLElement, lines: Lines, shown: ExactFacts, choice: Choice): LinesChart {
  const curves = lines.ways[choice.way]?.curves ?? [];
  const places = curves.flatMap(({ number, kind, values }) =>
    values.flatMap((y, at) => {
      const x = lines.lengths[at] ?? 0;
      const label = `mode ${number}: ${y?.toFixed(1)} Hz at ${(1e3 * x).toFixed(1)} mm, ${kind}`;
      return y === null ? [] : [{ x, y, label, number }];
    }),
  );
  const points = new Points(places, (index) => {
    const place = places[index];
    if (place) choice.pick(place.number, place.x);
  });
  const plot = make('div', {
    class: 'plot lengths',
    tabindex: 0,
    role: 'group',
    'aria-label': 'Frequencies of the modes over length; left and right change the length, up and down the mode',
  });
  plot.addEventListener('keydown', (event) => key(event, choice));
  const kinds = (Object.keys(LOOKS) as Kind[]).filter((kind) => curves.some((curve) => curve.kind === kind));
  host.replaceChildren(make('figcaption', {}, make('b', {}, 'Lines against length'), legend(kinds)), plot);
  const drawn = chart(
    plot,
    {
      plugins: [points.plugin],
      scales: { x: { time: false }, y: { range: [0, lines.facts.top] } },
      cursor: { drag: { x: false, y: false }, points: { show: false }, y: false },
      axes: [
        axis('Length [mm]', 36, { values: (_, ticks) => ticks.map((tick) => plain(1e3 * tick)) }),
        axis('Frequency [Hz]', 58, { values: (_, ticks) => ticks.map(plain) }),
      ],
      series: [{}, ...curves.map(({ kind, number }) => curve(LOOKS[kind], `mode ${number}, ${kind}`))],
      hooks: {
        drawAxes: [(plot) => bands(plot, lines), (plot) => levels(plot, lines)],
        draw: [(plot) => names(plot, lines, shown), (plot) => marks(plot, shown, choice, places)],
      },
    },
    [lines.lengths, ...curves.map(({ values }) => values)] as unknown as uPlot.AlignedData,
  );
  return { point: () => drawn.redraw(false, false) };
}

function legend(kinds: Kind[]): HTMLElement {
  const one = (kind: Kind) => make('span', { title: MEANING[kind] }, sample(LOOKS[kind]), kind);
  return make('span', { class: 'keys' }, ...kinds.map(one));
}

function key(event: KeyboardEvent, choice: Choice): void {
  const far = event.shiftKey ? 8 : 1;
  const moves: Record<string, () => void> = {
    ArrowLeft: () => choice.step(-far),
    ArrowRight: () => choice.step(far),
    ArrowUp: () => choice.pick(choice.number + 1),
    ArrowDown: () => choice.pick(choice.number - 1),
    Home: () => choice.step(-Infinity),
    End: () => choice.step(Infinity),
  };
  const move = moves[event.key];
  if (!move || event.ctrlKey || event.metaKey || event.altKey) return;
  event.preventDefault();
  move();
}

/** Between the two ways of the ends, where that is more than a line. */
function bands(plot: uPlot, { bands, lengths }: Lines): void {
  const { ctx, bbox } = plot;
  ctx.save();
  ctx.beginPath();
  ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
  ctx.clip();
  for (const { kind, lower, upper } of bands) {
    const places = lengths.flatMap((x, at) => {
      const [low, high] = [lower[at] ?? null, upper[at] ?? null];
      return low === null || high === null ? [] : [{ x: plot.valToPos(x, 'x', true), low, high }];
    });
    if (!places.some(({ low, high }) => high > WIDE * low)) continue;
    const edge = (pick: 'low' | 'high') => places.map((place) => [place.x, plot.valToPos(place[pick], 'y', true)]);
    ctx.beginPath();
    for (const [x = 0, y = 0] of [...edge('high'), ...edge('low').reverse()]) ctx.lineTo(x, y);
    ctx.fillStyle = ctx.strokeStyle = ink[LOOKS[kind].colour as Colour];
    ctx.globalAlpha = 0.16;
    ctx.fill();
    ctx.globalAlpha = 0.6;
    ctx.lineWidth = devicePixelRatio;
    ctx.setLineDash([2, 3].map((part) => part * devicePixelRatio));
    ctx.beginPath();
    for (const [x = 0, y = 0] of edge('low')) ctx.lineTo(x, y);
    ctx.stroke();
  }
  ctx.restore();
}

/** What drives the spring within the chart, lowest first, and where that is [pixels of the canvas]. */
const driven = (plot: uPlot, { facts }: Lines): { condition: number; value: number; y: number }[] =>
  facts.driven
    .filter(([, value]) => value <= facts.top)
    .map(([condition, value]) => ({ condition, value, y: plot.valToPos(value, 'y', true) }))
    .sort((a, b) => a.value - b.value);

/** Broad and pale, behind the lines of the modes, which may lie on them. */
function levels(plot: uPlot, lines: Lines): void {
  const { ctx, bbox } = plot;
  ctx.save();
  ctx.fillStyle = ink.soft;
  ctx.globalAlpha = 0.45;
  const thick = 4 * (devicePixelRatio || 1);
  for (const { y } of driven(plot, lines)) ctx.fillRect(bbox.left, y - thick / 2, bbox.width, thick);
  ctx.restore();
}

/** Their names, where there is room. */
function names(plot: uPlot, lines: Lines, { conditions }: ExactFacts): void {
  const { ctx, bbox } = plot;
  const ratio = devicePixelRatio || 1;
  ctx.save();
  ctx.font = font(11, ratio);
  ctx.textBaseline = 'bottom';
  ctx.textAlign = 'right';
  let above = Infinity;
  driven(plot, lines).forEach(({ condition, value, y }, index) => {
    const fits = index < MOST_NAMED && y - 14 * ratio > bbox.top && above - y > 13 * LARGER * ratio;
    if (!fits) return;
    above = y;
    const words = `${conditions[condition]?.name ?? ''}, ${value.toFixed(1)} Hz`;
    written(ctx, words, bbox.left + bbox.width - 6 * ratio, y - 3 * ratio);
  });
  ctx.restore();
}

/** Words with the card's colour about them, for curves run behind. */
function written(ctx: CanvasRenderingContext2D, words: string, x: number, y: number): void {
  ctx.save();
  ctx.setLineDash([]);
  ctx.lineWidth = 4 * (devicePixelRatio || 1);
  ctx.lineJoin = 'round';
  ctx.strokeStyle = ink.card;
  ctx.strokeText(words, x, y);
  ctx.fillStyle = ink.ink;
  ctx.fillText(words, x, y);
  ctx.restore();
}

/** The length of the condition, the chosen length, and the chosen mode. */
function marks(
  plot: uPlot,
  shown: ExactFacts,
  choice: Choice,
  places: { x: number; y: number; number: number }[],
): void {
  const { ctx, bbox } = plot;
  const ratio = devicePixelRatio || 1;
  const upright = (length: number, colour: string, dash: number[], width: number): number | null => {
    const x = plot.valToPos(length, 'x', true);
    if (!(x >= bbox.left - 1 && x <= bbox.left + bbox.width + 1)) return null;
    ctx.strokeStyle = colour;
    ctx.lineWidth = width * ratio;
    ctx.setLineDash(dash.map((part) => part * ratio));
    ctx.beginPath();
    ctx.moveTo(x, bbox.top);
    ctx.lineTo(x, bbox.top + bbox.height);
    ctx.stroke();
    return x;
  };
  ctx.save();
  const own = upright(shown.meanLength, ink.soft, [3, 3], 1);
  ctx.font = font(11, ratio);
  ctx.textBaseline = 'top';
  const words = shown.conditions[shown.condition]?.name ?? '';
  if (own !== null) {
    const isRight = own + ctx.measureText(words).width + 8 * ratio <= bbox.left + bbox.width;
    ctx.textAlign = isRight ? 'left' : 'right';
    written(ctx, words, own + (isRight ? 5 : -5) * ratio, bbox.top + 3 * ratio);
  }
  upright(choice.length, ink.accent, [], 2);
  const y = between(
    places.filter(({ number }) => number === choice.number),
    choice.length,
  );
  if (y !== null) {
    ctx.setLineDash([]);
    ctx.lineWidth = 2.5 * LARGER * ratio;
    ctx.beginPath();
    ctx.arc(plot.valToPos(choice.length, 'x', true), plot.valToPos(y, 'y', true), 7 * LARGER * ratio, 0, 2 * Math.PI);
    ctx.stroke();
  }
  ctx.restore();
}

/** The frequency at a length, along the straight line between the nearest places; null where there is none. */
function between(places: { x: number; y: number }[], x: number): number | null {
  const sorted = [...places].sort((a, b) => a.x - b.x);
  const low = sorted.findLast((place) => place.x <= x + 1e-12);
  const high = sorted.find((place) => place.x >= x - 1e-12);
  if (!low || !high) return null;
  return low.x === high.x ? low.y : low.y + ((x - low.x) / (high.x - low.x)) * (high.y - low.y);
}
