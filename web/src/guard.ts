// What is said where the page's own script or style sheet does not come: a script by itself, without which the page works, too.
//
// Next door: everything that may be missing later (`faults`); what puts this into the page (`whole.ts`, beside the configuration).

(() => {
  const SILENT = 2500;
  let shown: HTMLElement | null = null;

  function say(text: string, retry?: () => Promise<void>): void {
    shown?.remove();
    shown = document.createElement('div');
    shown.setAttribute('role', 'alert');
    // Without any style sheet it must be read, too.
    shown.style.cssText =
      'padding:1rem;margin:1rem;border:3px solid;border-radius:6px;font:1rem/1.5 system-ui,sans-serif';
    shown.append(text, ' ');
    if (retry) {
      const button = document.createElement('button');
      button.textContent = 'Try again';
      button.onclick = () => {
        shown?.remove();
        void retry();
      };
      shown.append(button);
    }
    document.body.prepend(shown);
  }

  const runs = () => document.body?.dataset['runs'];
  const sheet = document.querySelector<HTMLLinkElement>('link[rel=stylesheet]');
  const isStyled = () => getComputedStyle(document.documentElement).getPropertyValue('--whole') !== '';
  /** Past any cache, which may hold what was wrong; the address holds the state. */
  async function anew(): Promise<void> {
    const files = document.querySelectorAll<HTMLScriptElement & HTMLLinkElement>('script[src],link');
    await Promise.allSettled([...files].map(({ src, href }) => fetch(src || href, { cache: 'reload' })));
    location.reload();
  }

  /** Everything has come, or has failed to. */
  function check(): void {
    if (location.protocol === 'file:')
      say(
        'Opened as a file, this page cannot load its scripts: browsers forbid it. Run “python3 -m http.server” in its folder and open http://localhost:8000, or “coilsense app”.',
      );
    else if (!runs())
      say(
        'The script of this page is missing, came cut short, or is too new for this browser. Nothing that you set is lost.',
        anew,
      );
    else if (!isStyled())
      say('The style sheet of this page is missing or came cut short: it works, but looks bare.', anew);
    else shown?.remove();
  }

  /** It takes long: a sheet that does not come must not keep the page blank. */
  function late(): void {
    if (document.readyState === 'complete') return;
    if (sheet && !sheet.sheet) {
      sheet.media = 'print';
      sheet.onload = () => (sheet.media = 'all');
    }
    // A page that runs, but bare, is not all there either.
    const isThere = () => runs() && isStyled();
    if (!isThere()) say('The page is still loading …');
    const wait = setInterval(() => {
      if (!isThere()) return;
      clearInterval(wait);
      shown?.remove();
    }, 200);
  }

  if (document.readyState === 'complete') check();
  else {
    addEventListener('load', check);
    setTimeout(late, SILENT);
  }
})();
