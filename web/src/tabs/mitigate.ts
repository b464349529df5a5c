// The tab *Mitigate*: every filter and estimator on the conditions of the page's spec, error against lag; one of them over time, and its settings.
//
// Next door: how they are judged (`coilsense-web`, `mitigate`).

import type { Answer } from '../answer';
import type { Compute } from '../compute';
import { toToml } from '../document';
import { digits, download, fixed, make, rich } from '../dom';
import { curves } from '../plots/curves';
import { readInk } from '../plots/looks';
import type { Store } from '../state';

interface Candidate {
  name: string;
  origin: string;
  against: string;
  'rms error [N]': number;
  'worst rms error [N]': number;
  'worst run': string;
  'lag at bandwidth [deg]': number;
}

/** What `coilsense mitigate --json` prints, as far as it is shown. */
interface Ranking {
  advice: string[];
  'F_nom [N]': number;
  'bandwidth [Hz]': number;
  'noise [N rms]': number;
  seeds: number;
  candidates: Candidate[];
  'left out': { name: string; reason: string }[];
}

interface Facts {
  json: string;
  mostLag: number;
  best: (number | null)[];
  run: string | null;
  exports: ({ name: string; header: string; json: string } | null)[];
}

const GROUPS = [
  ['k·Δl', 'Filters of F_i, held against k·Δl'],
  ['F_o', 'Estimators, held against F_o'],
] as const;
const LOOKS: Record<string, string> = { raw: 'F_L', 'first try': 'F_i', fitted: 'F_o' };

export function open(panel: HTMLElement, store: Store, compute: Compute): void {
  readInk();
  const lag = make('input', { type: 'text', inputmode: 'decimal', id: 'most-lag', value: '30' });
  const seeds = make(
    'select',
    { id: 'seeds' },
    ...[1, 5, 50].map((count) => make('option', { value: count }, String(count))),
  );
  const start = make('button', { type: 'button', class: 'play' }, 'Judge');
  const stop = make('button', { type: 'button', class: 'plain', hidden: true }, 'Cancel');
  const bar = make('progress', { 'aria-label': 'Candidates judged', hidden: true });
  const said = make('p', { class: 'hint', role: 'status' });
  const refusal = make('p', { class: 'refusal', role: 'alert', hidden: true });
  const place = make('div', { class: 'found' });
  let cancel = () => {};

  const rest = (words: string) => {
    [bar.hidden, stop.hidden, start.disabled] = [true, true, false];
    said.textContent = words;
  };
  const judge = async () => {
    const mostLag = Number(lag.value);
    const wrong = !(mostLag > 0 && mostLag <= 360);
    lag.toggleAttribute('aria-invalid', wrong);
    refusal.hidden = !wrong;
    refusal.textContent = wrong ? `Most lag must be a number of degrees above 0, up to 360, got “${lag.value}”` : '';
    if (wrong) return;
    [bar.hidden, stop.hidden, start.disabled] = [false, false, true];
    bar.removeAttribute('value');
    said.textContent = 'Designing …';
    const begun = performance.now();
    let stopped = false;
    cancel = () => (stopped = true);
    const asked = await compute.job(
      { kind: 'mitigate', text: toToml(store.state.spec).text, seeds: Number(seeds.value), mostLag },
      (done, of) => {
        [bar.value, bar.max] = [done, of];
        said.textContent = `${done} of ${of} candidates judged`;
      },
    );
    cancel = asked.cancel;
    if (stopped) return cancel();
    void asked.reply.then((reply) => {
      const seconds = fixed((performance.now() - begun) / 1e3, 1);
      rest('answer' in reply ? `Judged in ${seconds} s, in this browser.` : '');
      if ('answer' in reply) fill(place, reply.answer as Answer<Facts>);
      refusal.hidden = !('error' in reply);
      refusal.textContent = 'error' in reply ? reply.error : '';
    });
  };
  start.addEventListener('click', () => void judge());
  stop.addEventListener('click', () => {
    cancel();
    rest('Cancelled.');
  });
  const field = (label: string, input: HTMLElement, hint: string) =>
    make(
      'div',
      { class: 'field' },
      make('label', { for: input.id }, label),
      input,
      make('span', { class: 'hint' }, hint),
    );
  panel.classList.add('logs');
  panel.replaceChildren(
    make(
      'div',
      { class: 'asked' },
      make(
        'div',
        { class: 'fields' },
        make(
          'p',
          { class: 'hint' },
          'Every filter and observer on the conditions of the tab Spring: 2.5 kHz, noise of 0.2 % of F_nom, k and m off by up to 10 % either way.',
        ),
        field('Most lag [°]', lag, 'At the bandwidth that the force needs.'),
        field('Series of noise', seeds, 'The command takes 5; one is quicker and enough for a look.'),
        make('div', { class: 'downloads' }, start, stop),
        bar,
        said,
      ),
      refusal,
    ),
    place,
  );
}

function fill(host: HTMLElement, answer: Answer<Facts>): void {
  const { facts } = answer;
  const ranking = JSON.parse(facts.json) as Ranking;
  const picked = make('section', { class: 'card', 'aria-label': 'What comes out', 'aria-live': 'polite' });
  const pick = (number: number) => {
    host
      .querySelectorAll('button.line')
      .forEach((button) =>
        button.setAttribute('aria-pressed', String(button.getAttribute('data-number') === String(number))),
      );
    show(picked, ranking, answer, number);
  };
  const scatters = make('div', { class: 'figures' });
  const few =
    ranking.seeds < 5
      ? make(
          'p',
          { class: 'warning' },
          `With ${ranking.seeds} series of noise; coilsense mitigate takes 5 unless told otherwise.`,
        )
      : null;
  const save = () => download('mitigation.json', facts.json, 'application/json');
  host.replaceChildren(
    make(
      'section',
      { class: 'card verdict', 'aria-label': 'Advice' },
      ...ranking.advice.map((line) => make('p', {}, rich(line))),
      few ?? '',
    ),
    scatters,
    picked,
    ...GROUPS.map(([truth, title]) => table(ranking, facts, truth, title, pick)),
    ...(ranking['left out'].length === 0
      ? []
      : [
          make(
            'section',
            { class: 'card', 'aria-label': 'Left out' },
            make('h2', {}, 'Left out'),
            make(
              'ul',
              { class: 'plainlist' },
              ...ranking['left out'].map(({ name, reason }) => make('li', {}, `${name}: ${reason}`)),
            ),
          ),
        ]),
    make(
      'div',
      { class: 'downloads' },
      make('button', { type: 'button', class: 'plain', onclick: save }, 'Everything (JSON)'),
    ),
  );
  for (const [truth, title] of GROUPS) scatter(scatters, ranking, facts, truth, title);
  pick(facts.best[0] ?? 0);
}

function table(
  ranking: Ranking,
  facts: Facts,
  truth: string,
  title: string,
  pick: (number: number) => void,
): HTMLElement {
  const percent = (force: number) => `${fixed((100 * force) / ranking['F_nom [N]'], 3)} %`;
  const row = ([number, one]: readonly [number, Candidate]) => {
    const late = one['lag at bandwidth [deg]'] > facts.mostLag;
    const name = make(
      'button',
      { type: 'button', class: 'line', 'aria-pressed': 'false', 'data-number': number, onclick: () => pick(number) },
      one.name,
    );
    return make(
      'tr',
      { 'data-candidate': one.name },
      make(
        'th',
        { scope: 'row' },
        name,
        facts.best.includes(number) ? make('b', { class: 'within' }, ' ✓ advised') : null,
      ),
      make('td', {}, percent(one['worst rms error [N]'])),
      make('td', {}, percent(one['rms error [N]'])),
      make(
        'td',
        { class: late ? 'above' : '' },
        `${fixed(Math.round(10 * one['lag at bandwidth [deg]']) / 10 + 0, 1)}°${late ? ' ✗ late' : ''}`,
      ),
      make('td', {}, one.origin),
    );
  };
  const those = ranking.candidates
    .map((one, number) => [number, one] as const)
    .filter(([, one]) => one.against === truth);
  const heads = ['Pick one', 'Worst error', 'Error', 'Lag', 'Origin'].map((word) => make('th', { scope: 'col' }, word));
  return make(
    'section',
    { class: 'card', 'aria-label': title },
    make('div', { class: 'head' }, make('h2', {}, rich(title))),
    make(
      'div',
      { class: 'scroll', tabindex: 0, role: 'region', 'aria-label': `Ranking: ${title}` },
      make(
        'table',
        { class: 'ranking' },
        make(
          'caption',
          {},
          'rms, in % of F',
          make('sub', {}, 'nom'),
          ', over all conditions; worst: of any spring in the box. Best first.',
        ),
        make('thead', {}, make('tr', {}, ...heads)),
        make('tbody', {}, ...those.map(row)),
      ),
    ),
  );
}

function scatter(host: HTMLElement, ranking: Ranking, facts: Facts, truth: string, title: string): void {
  const those = ranking.candidates.map((one, number) => ({ one, number })).filter(({ one }) => one.against === truth);
  those.sort((a, b) => a.one['lag at bandwidth [deg]'] - b.one['lag at bandwidth [deg]']);
  const best = those.find(({ number }) => facts.best.includes(number));
  const lags = those.map(({ one }) => one['lag at bandwidth [deg]']);
  const marks = [
    { x: facts.mostLag, label: 'most lag' },
    ...(best ? [{ x: best.one['lag at bandwidth [deg]'], label: best.one.name }] : []),
  ];
  curves(host, {
    title: `${title}: error against lag`,
    x: { label: `Lag at ${digits(ranking['bandwidth [Hz]'])} Hz [°]`, values: Float64Array.from(lags) },
    y: { label: 'Worst error [% of F_nom]', logarithmic: true },
    curves: Object.entries(LOOKS).map(([origin, look]) => ({
      look,
      label: origin,
      dots: true,
      values: those.map(({ one }) =>
        one.origin === origin ? (100 * one['worst rms error [N]']) / ranking['F_nom [N]'] : null,
      ),
    })),
    marks,
  });
}

/** The run that rings hardest: raw, true, and what this one makes of it. */
function show(host: HTMLElement, ranking: Ranking, { facts, series }: Answer<Facts>, number: number): void {
  const one = ranking.candidates[number];
  const settings = facts.exports[number];
  const none = new Float64Array();
  if (!one) return;
  const button = (label: string, name: string, text: string, type: string) =>
    make('button', { type: 'button', class: 'plain', onclick: () => download(name, text, type) }, label);
  const saves = settings
    ? [
        button('Settings (C header)', `${settings.name}.h`, settings.header, 'text/x-c'),
        button('Settings (JSON)', `${settings.name}.json`, settings.json, 'application/json'),
      ]
    : [make('span', { class: 'hint' }, 'Measured as it is: there is nothing to set.')];
  host.replaceChildren(
    make('div', { class: 'head' }, make('h2', {}, one.name)),
    make('p', { class: 'hint' }, facts.run ?? ''),
  );
  curves(host, {
    title: 'Cleaned over raw',
    x: { label: 'Time [s]', values: series['time'] ?? none },
    y: { label: 'Force [N]' },
    curves: [
      { look: 'F_i', label: 'F_i as measured', values: series['measured'] ?? none },
      { look: 'F_x', label: `true ${one.against}`, values: series[`true ${number}`] ?? none },
      { look: 'F_o', label: 'what comes out', values: series[`out ${number}`] ?? none },
    ],
  });
  host.append(make('div', { class: 'downloads' }, ...saves));
}
