// Begins the interactive part of a report, or says why there is none. Bundled into the report by `cargo xtask viewer`.
//
// Next door: that part (`viewer`), the data (`data`).

import 'uplot/dist/uPlot.min.css';
import './report.css';
import { byId, make } from '../dom';
import { read } from './data';
import { Viewer } from './viewer';

try {
  new Viewer(read(byId('coilsense-data').textContent ?? ''));
} catch (error) {
  const reason = error instanceof Error ? error.message : String(error);
  const words = `The signals of this report cannot be shown: ${reason}.`;
  byId('coilsense-spring').replaceChildren(make('p', { class: 'warning', role: 'alert' }, words));
}
