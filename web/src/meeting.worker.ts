// The worker of the larger engine, for specs whose windings meet: the same questions, the same answers.
//
// Next door: what it does (`serve`), who asks (`lane`), the first engine's (`engine.worker`).

import { serve } from './serve';
import { Engine, initSync } from './workshop/coilsense_web';

serve((engine) => {
  initSync({ module: engine });
  return new Engine();
});
