// The tab *Log*: drop a measured log, say which column is what, and read what rings. The file stays in this browser.
//
// Next door: what is said of a log (`log/form`), what comes of it (`log/found`), what computes it (`coilsense-web`, `log`).

import type { Log } from '../answer';
import type { Compute } from '../compute';
import { toToml } from '../document';
import { make } from '../dom';
import { download } from '../download';
import { part } from '../faults';
import { Asking } from '../log/asking';
import type { Column } from '../log/columns';
import { dropPlace } from '../log/drop';
import { empty } from '../log/empty';
import { button } from '../log/found';
import { Form } from '../log/form';
import { Results } from '../log/results';
import { openSpec, trialJob } from '../log/spec';
import { specOf, takeLogs } from '../log/takers';
import { readInk } from '../plots/looks';
import type { Store } from '../store';
import { dress } from '../style/dress';

export function open(panel: HTMLElement, store: Store, compute: Compute): void {
  readInk();
  dress();
  const refusal = make('p', { class: 'refusal', role: 'alert', hidden: true });
  const written = make('p', { class: 'hint', 'aria-live': 'polite' });
  const results = new Results({ openSpec: (text) => openSpec(store, text) }, () => empty(tryIt));
  const asking = new Asking(compute, (busy) => panel.setAttribute('aria-busy', String(busy)));
  /** Of the second device, whose columns no question about the first may end. */
  const beside = new Asking(compute, () => {});
  let log: Log | null = null;
  let second: Log | null = null;
  /** What was asked last, and which format it was asked for. */
  let [last, format] = ['', ''];
  /** Whether the log's columns are known; until then nothing else is asked about it. */
  let known = false;

  /** What is wrong with the log or a choice, and with what a calibration takes of them: told at its field, else in a line. */
  const wrong = { log: '', calibration: '' };
  const say = (part: keyof typeof wrong, error: string, isOfNow = false) => {
    wrong[part] = error;
    const rest = form.refuse(Object.values(wrong).filter(Boolean));
    refusal.hidden = !rest.includes(wrong.log);
    refusal.textContent = refusal.hidden ? '' : wrong.log;
    if (part === 'calibration' && rest.includes(error)) results.refuseCalibration(error);
    if (part === 'log' && error && !isOfNow) results.fade();
  };
  const sayOfLog = (error: string) => say('log', error);
  const read = async (file: File): Promise<Log> => ({
    name: file.name,
    bytes: new Uint8Array(await file.arrayBuffer()),
  });
  const put = (words: Record<string, string>) => store.setView({ log: words }, true);

  async function take(files: File[], device: 'first' | 'second'): Promise<void> {
    const spec = await specOf(files);
    if (spec) return (await part('What takes files', () => import('../dropped'))).take(files, store, compute);
    const mapping = files.find(({ name }) => name.endsWith('.toml'));
    const logs = files.filter((file) => file !== mapping);
    if (mapping) put({ ...store.state.view.log, layout: 'mapping', mapping: (await mapping.text()).trim() });
    const [one, other] = device === 'first' ? logs : [undefined, logs[0]];
    if (one) takeFirst(await read(one));
    if (other) takeSecond(await read(other));
  }

  function takeFirst(file: Log): void {
    log = file;
    results.clear(`Reading ${file.name} …`);
    form.clear(store.state.view.log);
    for (const part of [written, trial]) part.replaceChildren();
    columns();
  }

  function takeSecond(file: Log): void {
    beside.cancel();
    beside.ask({ kind: 'columns', log: file, asked: '{}' }, sayOfLog, ({ facts }) => {
      second = file;
      form.showSecond((facts as { columns: Column[] }).columns, store.state.view.log);
      secondName.replaceChildren(`${file.name}: ${(facts as { description: string }).description} `, without);
      secondName.hidden = false;
      identify();
    });
  }

  const without = make('button', { type: 'button', class: 'plain' }, 'Without it');
  without.addEventListener('click', () => {
    second = null;
    secondName.hidden = true;
    form.showSecond(null, store.state.view.log);
    identify();
  });

  /** Which parts of the choices say how the text is written. */
  const layout = () => {
    const { layout, mapping, delimiter, decimal } = store.state.view.log;
    return JSON.stringify([layout, mapping, delimiter, decimal]);
  };
  const asked = () => form.asked(toToml(store.state.spec).text);

  function columns(): void {
    if (!log) return;
    [format, last, known] = [layout(), asked(), false];
    const { name } = log;
    asking.cancel();
    asking.ask({ kind: 'columns', log, asked: asked() }, sayOfLog, ({ facts }) => {
      const { description, columns } = facts as { description: string; columns: Column[] };
      known = true;
      say('log', '');
      written.textContent = `${name}: ${description}`;
      form.show(columns, store.state.view.log);
      identify();
    });
  }

  function identify(): void {
    if (!log || !known) return;
    last = asked();
    asking.cancel();
    const { name } = log;
    const holds = form.holds;
    if (holds.force || !holds.calibration)
      asking.ask({ kind: 'identify', log, second, asked: last }, sayOfLog, (answer) => {
        say('log', results.showLog(name, answer), true);
      });
    else {
      say('log', '');
      results.onlyCalibration();
    }
    wrong.calibration = '';
    if (!holds.calibration) return results.showCalibration(name, null);
    asking.ask(
      { kind: 'calibrate', log, asked: last },
      (error) => say('calibration', error),
      (answer) => {
        say('calibration', '');
        results.showCalibration(name, answer);
      },
    );
  }

  const tryIt = () =>
    asking.ask(trialJob(store), sayOfLog, ({ facts }) => {
      const { name, text } = facts as { name: string; text: string };
      takeFirst({ name, bytes: new TextEncoder().encode(text) });
      const save = () => download(name, text, 'text/csv');
      trial.replaceChildren(button('Save the simulated log (CSV)', save));
    });
  const trial = make('div', { class: 'downloads' });
  const secondName = make('p', { class: 'hint', hidden: true });
  const secondPlace = make(
    'div',
    {},
    dropPlace(
      'log-second',
      ['Drop its log here', ', or choose one'],
      'Its channels are added on the first log’s times.',
      (files) => void take(files, 'second'),
    ),
    secondName,
  );
  const form = new Form(secondPlace, put);
  const place = dropPlace(
    'log-file',
    ['Drop a log here', ', or choose one'],
    'A text with columns: time, positions u1 and u2, forces F_i and F_o, inductance L. It does not leave this browser.',
    (files) => void take(files, 'first'),
    panel,
  );
  results.fade();
  store.subscribe(({ view }, before) => {
    if (view.log !== before.view.log) form.fill(view.log);
    if (!log || view.tab !== 'log') return;
    if (layout() !== format || (!known && asked() !== last)) columns();
    else if (asked() !== last) identify();
  });
  form.fill(store.state.view.log);
  panel.classList.add('logs');
  panel.replaceChildren(make('div', { class: 'asked' }, place, refusal, written, trial, form.element), results.element);
  takeLogs('log', (files) => void take(files, 'first'));
}
