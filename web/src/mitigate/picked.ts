// One candidate on the run that rings hardest: raw, true, and what it makes of it; to take along with its settings.
//
// Next door: all candidates (`table`, `scatter`), the picture as a file (`plots/picture`).

import { make, rich } from '../dom';
import { download } from '../download';
import { curves, type Curves } from '../plots/curves';
import { picture } from '../plots/picture';
import type { Choices } from './choices';
import { degrees, lag, percent, type Candidate, type Judged } from './ranking';

const none = new Float64Array();

export class Picked {
  readonly element = make('section', { class: 'card', 'aria-label': 'What comes out' });
  private number = 0;
  private readonly heading = make('h2');
  /** What is told of it; the picture and the buttons below it are not to be read out. */
  private readonly numbers = make('p', { class: 'hint', role: 'status' });
  private readonly rest = make('div');

  constructor(
    private readonly judged: Judged,
    private readonly choices: Choices,
  ) {
    this.element.append(make('div', { class: 'head' }, this.heading), this.numbers, this.rest);
  }

  show(number: number): void {
    this.number = number;
    const { ranking, answer } = this.judged;
    const one = ranking.candidates[number];
    if (!one) return;
    const numbers = `${percent(this.judged, one.worst_rms_error_n)} of F_nom at worst (${one.worst_run}), ${percent(this.judged, one.rms_error_n)} on the nominal spring, ${degrees(lag(one))} late.`;
    this.numbers.replaceChildren(rich(`${one.name}: ${numbers}`));
    this.heading.textContent = one.name;
    this.rest.replaceChildren();
    if (answer.facts.run) {
      const run = `The run that rings hardest: ${answer.facts.run}.`;
      this.rest.append(make('p', { class: 'hint' }, rich(run)));
      curves(this.rest, this.drawing(one));
    }
    this.rest.append(this.downloads(one));
  }

  private drawing(one: Candidate): Curves {
    const { series } = this.judged.answer;
    return {
      title: 'Cleaned over raw',
      x: { label: 'Time [s]', values: series['time'] ?? none },
      y: { label: 'Force [N]' },
      curves: [
        { look: 'F_i', label: 'F_i as measured', values: series['measured'] ?? none },
        { look: 'F_x', label: `true ${one.against}`, values: series[`true ${this.number}`] ?? none },
        { look: 'F_o', label: 'what comes out', values: series[`out ${this.number}`] ?? none },
      ],
    };
  }

  private downloads(one: Candidate): HTMLElement {
    const name = one.name.replaceAll(/[^\w.-]+/g, '-');
    const plain = (label: string, title: string, act: () => void) =>
      make('button', { type: 'button', class: 'plain', title, onclick: act }, label);
    const csv = () => download(`${name}.csv`, this.csv(), 'text/csv');
    const svg = () => download(`${name}.svg`, picture(this.drawing(one), { width: 800, height: 360 }), 'image/svg+xml');
    return make(
      'div',
      { class: 'downloads' },
      make('span', {}, 'Take along: '),
      plain('Signal (CSV)', 'Time, what is measured, what comes out, what is true', csv),
      plain('Figure (SVG)', 'The picture above', svg),
      ...this.settings(plain),
    );
  }

  /** A controller's settings, as the command exports them. */
  private settings(plain: (label: string, title: string, act: () => void) => HTMLElement): HTMLElement[] {
    const exports = this.judged.answer.facts.exports[this.number];
    if (!exports) return [make('span', { class: 'hint' }, 'Measured as it is: there is nothing to set.')];
    const precision = make(
      'select',
      { 'aria-label': 'Precision of the settings' },
      make('option', { value: '' }, 'single precision'),
      make('option', { value: 'double' }, 'double precision'),
    );
    precision.value = this.choices.get('precision');
    precision.addEventListener('change', () => this.choices.set('precision', precision.value));
    const save = (ending: 'h' | 'rs' | 'json', type: string) => () => {
      const chosen = exports[precision.value === 'double' ? 'double' : 'single'];
      download(`${chosen.name}.${ending}`, chosen[ending], type);
    };
    return [
      plain('Settings (C header)', 'C99, needs no library', save('h', 'text/x-c')),
      plain('Settings (Rust)', 'A constant for coilsense-rt', save('rs', 'text/rust')),
      plain('Settings (JSON)', 'Every number, in full precision', save('json', 'application/json')),
      precision,
    ];
  }

  private csv(): string {
    const { series } = this.judged.answer;
    const columns = ['time', 'measured', `out ${this.number}`, `true ${this.number}`].map(
      (name) => series[name] ?? none,
    );
    const rows = Array.from(columns[0] ?? none, (_, row) => columns.map((values) => values[row] ?? '').join(','));
    return ['time [s],F_i [N],out [N],truth [N]', ...rows].join('\n') + '\n';
  }
}
