// The worker of the first engine. It gets it compiled: what could fetch and compile one is left out of what both of its lanes load.
//
// Next door: what it does (`serve`), who asks (`lane`), the larger engine's (`meeting.worker`).

import { Engine, initSync } from './engine/coilsense_web';
import { serve } from './serve';

serve((engine) => {
  initSync({ module: engine });
  return new Engine();
});
