// The lanes of one engine: previews, exact cases, and a third for a part that asks often.
//
// Next door: one of them (`lane`), which engine a spec needs (`compute`).

import { Lane } from './lane';

export class Lanes {
  readonly previews: Lane;
  readonly exacts: Lane;
  private third: Lane | null = null;

  constructor(
    private readonly engine: Promise<WebAssembly.Module>,
    private readonly files: Map<string, string>,
    private readonly hire: () => Worker,
  ) {
    this.previews = this.lane(false);
    this.exacts = this.lane(true);
  }

  /** One more worker, `mayStop` as in `Lane`. */
  lane(mayStop: boolean): Lane {
    return new Lane(this.engine, this.files, mayStop, this.hire);
  }

  get asides(): Lane {
    return (this.third ??= this.lane(false));
  }

  addFile(name: string, text: string): void {
    for (const lane of [this.previews, this.exacts, this.third]) lane?.addFile(name, text);
  }

  /** Nobody waits for what was asked of the case. */
  drop(): void {
    this.previews.drop();
    this.exacts.drop();
  }
}
