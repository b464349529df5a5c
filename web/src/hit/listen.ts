// The button that plays what end 2 feels, in real time, and says what is heard.
//
// Next door: what is played (`samples`).

import type { Answer, ExactFacts } from '../answer';
import { make } from '../dom';
import { heard, samples } from './samples';

/** Never loud at once [1]; in and out [s]. */
const GAIN = 0.3;
const FADE = 0.03;

export class Listen {
  readonly element = make(
    'button',
    { type: 'button', class: 'plain listen', 'aria-pressed': 'false', hidden: !('AudioContext' in window) },
    'Listen',
  );
  readonly words = make('p', { class: 'foot', role: 'status', hidden: true });
  private shown: Answer<ExactFacts> | null = null;
  /** Somebody wants to hear what is not exact yet. */
  private isWanted = false;
  private context: AudioContext | null = null;
  private playing: { source: AudioBufferSourceNode; gain: GainNode } | null = null;

  constructor() {
    this.element.addEventListener('click', () => this.press());
  }

  /** The exact case; null while there is none: what is played then is of another spring and ends. */
  show(shown: Answer<ExactFacts> | null): void {
    if (!shown) {
      this.stop();
      this.say('');
    }
    this.shown = shown;
    if (shown && this.isWanted) this.play(shown);
  }

  private press(): void {
    if (this.playing) return this.stop();
    // Only within a press may a page begin to sound.
    this.context ??= new AudioContext();
    void this.context.resume();
    if (this.shown) this.play(this.shown);
    else this.isWanted = true;
  }

  private play(shown: Answer<ExactFacts>): void {
    const { context } = this;
    this.isWanted = false;
    if (!context) return;
    const values = samples(shown, context.sampleRate);
    if (!values) return this.say('Nothing to hear: the force at end 2 is steady.');
    const buffer = context.createBuffer(1, values.length, context.sampleRate);
    buffer.copyToChannel(values, 0);
    const source = new AudioBufferSourceNode(context, { buffer });
    const gain = new GainNode(context, { gain: 0 });
    source.connect(gain).connect(context.destination);
    gain.gain.linearRampToValueAtTime(GAIN, context.currentTime + FADE);
    source.start();
    this.playing = { source, gain };
    source.addEventListener('ended', () => this.playing?.source === source && this.ended());
    this.mark('Stop');
    const lines = heard(shown).map((hertz) => hertz.toFixed(0));
    const at = lines.length > 0 ? `, loudest at ${lines.join(', ')} Hz` : '';
    this.say(`The force at end 2 less its mean, in real time${at}.`);
  }

  private stop(): void {
    this.isWanted = false;
    if (!this.playing || !this.context) return;
    const { source, gain } = this.playing;
    const now = this.context.currentTime;
    gain.gain.cancelScheduledValues(now);
    gain.gain.setTargetAtTime(0, now, FADE / 3);
    source.stop(now + 2 * FADE);
    this.ended();
  }

  private ended(): void {
    this.playing = null;
    this.mark('Listen');
  }

  private mark(word: string): void {
    this.element.textContent = word;
    this.element.setAttribute('aria-pressed', String(word === 'Stop'));
  }

  private say(words: string): void {
    this.words.hidden = words === '';
    this.words.textContent = words;
  }
}
