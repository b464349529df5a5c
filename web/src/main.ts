// The page: one store, one engine, a row of tabs.
//
// Next door: the tabs (`tabs/all`), the state (`state`), what is computed (`compute`).

import { Compute } from './compute';
import { byId, make } from './dom';
import { part, say } from './faults';
import { readInk } from './plots/looks';
import { Store } from './store';
import { TABS } from './tabs/all';
import type { Tab } from './tabs/tab';

const store = new Store((words) =>
  say('link', `The link has settings that this page does not know: “${words.join('”, “')}”. They are ignored.`),
);
const compute = new Compute(store);
const main = byId('main');
const opened = new Set<string>();
const { title } = document;

const buttons = TABS.map(({ id, label }) =>
  make(
    'button',
    {
      type: 'button',
      role: 'tab',
      id: `tab-${id}`,
      'aria-controls': `panel-${id}`,
      onclick: () => store.setView({ tab: id }),
    },
    label,
  ),
);
const panels = TABS.map(({ id }) =>
  make('div', { role: 'tabpanel', id: `panel-${id}`, 'aria-labelledby': `tab-${id}`, hidden: true }),
);
byId('tabs').replaceChildren(...buttons);
main.replaceChildren(...panels);
byId('tabs').addEventListener('keydown', (event) => {
  const at = TABS.findIndex(({ id }) => id === store.state.view.tab);
  const next = { ArrowRight: at + 1, ArrowLeft: at - 1, Home: 0, End: TABS.length - 1 }[event.key];
  const tab = next === undefined ? undefined : TABS[(next + TABS.length) % TABS.length];
  // A key that is held down would fill the browser's history.
  if (!tab || event.repeat) return;
  event.preventDefault();
  store.setView({ tab: tab.id });
  byId(`tab-${tab.id}`).focus();
});

function showTab(): void {
  const tab = TABS.find(({ id }) => id === store.state.view.tab) ?? TABS[0];
  if (!tab) return;
  TABS.forEach(({ id }, index) => {
    buttons[index]?.setAttribute('aria-selected', String(id === tab.id));
    buttons[index]?.setAttribute('tabindex', id === tab.id ? '0' : '-1');
  });
  byId('sentence').hidden = tab.lead !== undefined;
  byId('lead').hidden = tab.lead === undefined;
  byId('lead').textContent = tab.lead ?? '';
  document.title = tab === TABS[0] ? title : `${tab.label} – coilsense`;
  panels.forEach((panel) => (panel.hidden = panel.id !== `panel-${tab.id}`));
  openTab(tab);
}

/** In another page's frame: the spring, its forces, and a way to all of it. */
function embed(): void {
  if (!new URLSearchParams(location.search).has('embed')) return;
  document.documentElement.classList.add('embed');
  const whole = make('a', { class: 'whole', target: '_blank', rel: 'noopener' }, 'Open in coilsense');
  whole.addEventListener('click', () => (whole.href = location.pathname + location.hash));
  whole.href = location.pathname + location.hash;
  document.querySelector('.title')?.append(whole);
}

function openTab(tab: Tab): void {
  if (opened.has(tab.id)) return;
  opened.add(tab.id);
  const panel = byId(`panel-${tab.id}`);
  if (tab !== TABS[0])
    panel.append(make('p', { class: 'hint', role: 'status' }, `The tab ${tab.label} is not loaded yet …`));
  void part(`The tab ${tab.label}`, tab.load).then(({ open }) => {
    open(panel, store, compute);
    if (tab === TABS[0]) compute.begin();
  });
}

const [undo, redo, reset] = [
  byId<HTMLButtonElement>('undo'),
  byId<HTMLButtonElement>('redo'),
  byId<HTMLButtonElement>('reset'),
];
undo.addEventListener('click', () => store.undo());
redo.addEventListener('click', () => store.redo());
reset.addEventListener('click', () => store.reset());
addEventListener('keydown', (event) => {
  if (!(event.ctrlKey || event.metaKey) || event.key.toLowerCase() !== 'z') return;
  event.preventDefault();
  if (event.shiftKey) store.redo();
  else store.undo();
});
const tools = () => {
  undo.disabled = !store.canUndo;
  redo.disabled = !store.canRedo;
  reset.disabled = !store.canReset;
};

// Words that are asked for are in the glossary, which few need.
addEventListener('click', ({ target }) => {
  const asked = (target as Element).closest<HTMLElement>('[data-word]')?.dataset['word'];
  if (asked !== undefined) void part('The glossary', () => import('./glossary/open')).then(({ open }) => open(asked));
});

// A file dropped beside any place for files is taken by the tab that it belongs to.
addEventListener('dragover', (event) => event.preventDefault());
addEventListener('drop', (event) => {
  event.preventDefault();
  const files = [...(event.dataTransfer?.files ?? [])];
  if (files[0])
    void part('What takes files', () => import('./dropped')).then(({ take }) => take(files, store, compute));
});

matchMedia('(prefers-color-scheme: dark)').addEventListener('change', readInk);
store.subscribe((state, before) => {
  if (state.view.tab !== before.view.tab) showTab();
  tools();
});
tools();
embed();
// The first tab also says the answer above all tabs.
if (TABS[0]) openTab(TABS[0]);
showTab();
document.body.dataset['runs'] = 'true';

/** So long after the first exact answer there is nothing more to load [ms]. */
const KEEPS = 4000;
let isKept = false;
compute.listen({
  shown: ({ exact }) => {
    if (!exact || isKept) return;
    isKept = true;
    const keep = () => import('./offline').then(({ keep }) => keep());
    const not = () => (byId('offline').hidden = false);
    setTimeout(() => void keep().catch(not), KEEPS);
  },
  refused: () => {},
  busy: () => {},
});
