// Files of the page, whole or not at all; engines among them.
//
// Next door: what becomes of a fault (`faults`).

/** A file of the page; `isAgain`: past any cache, which may hold what was wrong. */
export async function fetched(address: string, isAgain: boolean): Promise<Response> {
  const reply = await fetch(address, isAgain ? { cache: 'reload' } : {});
  if (!reply.ok) throw new Error(`${address.replace(/.*\//, '')} is not on the server (${reply.status})`);
  return reply;
}

/** A compiled engine. */
export async function compiled(address: string, isAgain: boolean): Promise<WebAssembly.Module> {
  const reply = await fetched(address, isAgain);
  // Of another type no browser compiles it while it comes.
  if (reply.headers.get('content-type') === 'application/wasm') return WebAssembly.compileStreaming(reply);
  return WebAssembly.compile(await reply.arrayBuffer());
}

/** A text of so many bytes: half of a recorded motion is one, too. */
export async function text(address: string, bytes: number, isAgain: boolean): Promise<string> {
  const content = await (await fetched(address, isAgain)).arrayBuffer();
  if (content.byteLength !== bytes) throw new Error(`its file came with ${content.byteLength} of ${bytes} bytes`);
  return new TextDecoder().decode(content);
}
