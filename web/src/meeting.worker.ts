// The worker of the larger engine, for specs whose windings meet: the same questions, the same answers.
//
// Next door: what it does (`serve`), who asks (`lane`), the first engine's (`engine.worker`).

import { serve } from './serve';
import init, { Engine } from './workshop/coilsense_web';

serve((engine) => init({ module_or_path: engine }).then(() => new Engine()));
