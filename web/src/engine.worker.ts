// The worker of the first engine.
//
// Next door: what it does (`serve`), who asks (`lane`), the larger engine's (`meeting.worker`).

import init, { Engine } from './engine/coilsense_web';
import { serve } from './serve';

serve((engine) => init({ module_or_path: engine }).then(() => new Engine()));
