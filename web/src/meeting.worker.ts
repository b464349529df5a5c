// The worker of the larger engine, for specs whose windings meet: the same questions, the same answers; and for the two ends over frequency.
//
// Next door: what it does (`serve`), who asks (`lane`), the first engine's (`engine.worker`).

import { serve } from './serve';
import { Engine, initSync } from './workshop/coilsense_web';

serve(
  (engine) => {
    initSync({ module: engine });
    return new Engine();
  },
  (engine, question) => {
    switch (question.kind) {
      case 'response':
        return engine.response(question.text, question.condition, question.damping, question.masses);
      case 'response-at': {
        const { text, condition, damping, masses, frequency, places } = question;
        return engine.response_at(text, condition, damping, masses, frequency, places);
      }
      default:
        return null;
    }
  },
);
