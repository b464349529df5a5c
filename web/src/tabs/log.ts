// The tab *Log*: drop a measured log, say which column is what, and read what rings. The file stays in this browser.
//
// Next door: what is said of a log (`log/form`), what comes of it (`log/found`), what computes it (`coilsense-web`, `log`).

import type { Answer, Job } from '../answer';
import type { Compute } from '../compute';
import { toToml } from '../document';
import { make } from '../dom';
import { showCalibration, showFound, type LogFacts } from '../log/found';
import { Form, type Column } from '../log/form';
import { readInk } from '../plots/looks';
import type { Store } from '../state';

export function open(panel: HTMLElement, store: Store, compute: Compute): void {
  readInk();
  const refusal = make('p', { class: 'refusal', role: 'alert', hidden: true });
  const written = make('p', { class: 'hint', 'aria-live': 'polite' });
  const [found, calibration] = [make('div', { class: 'found' }), make('div', { class: 'found' })];
  const choose = make('input', { type: 'file', id: 'log-file', accept: '.csv,.tsv,.txt,.dat,.log,text/*' });
  const drop = make(
    'div',
    { class: 'drop' },
    make('label', { for: 'log-file' }, make('b', {}, 'Drop a log here'), ', or choose one'),
    choose,
    make(
      'p',
      { class: 'hint' },
      'A text with columns: time, positions u1 and u2, forces F_i and F_o, inductance L. It does not leave this browser.',
    ),
  );
  let log: { name: string; bytes: Uint8Array } | null = null;
  let running: { cancel: () => void }[] = [];

  const say = (error: string | null) => {
    refusal.hidden = error === null;
    refusal.textContent = error ?? '';
    if (error !== null) found.classList.add('stale');
  };
  const ask = (question: Job, done: (answer: Answer<unknown>) => void, wrong: (error: string) => void = say) => {
    const mine = running;
    panel.setAttribute('aria-busy', 'true');
    void compute
      .job(question, () => {})
      .then(async ({ reply: coming, cancel }) => {
        // A newer question has come meanwhile.
        if (mine !== running) return cancel();
        mine.push({ cancel });
        const reply = await coming;
        panel.setAttribute('aria-busy', 'false');
        if ('answer' in reply) done(reply.answer as Answer<unknown>);
        else if ('error' in reply) wrong(reply.error);
      });
  };
  const form = new Form(() => identify());

  function identify(): void {
    if (!log) return;
    for (const { cancel } of running) cancel();
    running = [];
    const { name, bytes } = log;
    const asked = form.asked(toToml(store.state.spec).text);
    ask({ kind: 'identify', name, bytes, asked }, (answer) => {
      say(null);
      found.classList.remove('stale');
      showFound(found, name, answer as Answer<LogFacts>);
    });
    calibration.replaceChildren();
    if (!form.canCalibrate) return;
    const refused = (error: string) => calibration.replaceChildren(make('p', { class: 'refusal' }, error));
    ask(
      { kind: 'calibrate', name, bytes, asked },
      (answer) => showCalibration(calibration, name, answer as Answer<{ json: string }>),
      refused,
    );
  }

  async function take(file: File | undefined): Promise<void> {
    if (!file) return;
    log = { name: file.name, bytes: new Uint8Array(await file.arrayBuffer()) };
    const { name, bytes } = log;
    for (const part of [found, calibration]) part.replaceChildren();
    form.element.hidden = true;
    written.textContent = '';
    ask({ kind: 'columns', name, bytes }, (answer) => {
      const { description, columns } = answer.facts as { description: string; columns: Column[] };
      say(null);
      written.textContent = `${name}: ${description}`;
      form.show(columns);
      identify();
    });
  }

  choose.addEventListener('change', () => void take(choose.files?.[0]));
  const over = (event: DragEvent, on: boolean) => {
    event.preventDefault();
    drop.classList.toggle('over', on);
  };
  panel.addEventListener('dragover', (event) => over(event, true));
  panel.addEventListener('dragleave', (event) => over(event, false));
  panel.addEventListener('drop', (event) => {
    over(event, false);
    void take(event.dataTransfer?.files[0]);
  });
  panel.classList.add('logs');
  panel.replaceChildren(
    make('div', { class: 'asked' }, drop, refusal, written, form.element),
    make('div', { class: 'told' }, found, calibration),
  );
}
