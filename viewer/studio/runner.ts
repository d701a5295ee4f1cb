/** Runs of the program in a worker, one after the other; a run that takes too long can be ended. */

import type { Outcome } from "./system";
import RunWorker from "./worker?worker&inline";

export type Asked =
  | { kind: "module"; module: WebAssembly.Module }
  | { kind: "run"; words: string[]; files: [string, Uint8Array][] };

export type Told = { kind: "message"; text: string } | { kind: "done"; outcome: Outcome } | { kind: "failed"; why: string };

/** The exit status of a run that the user ended, that of an interrupted program. */
export const ENDED = 130;

export class Runner {
  private worker: Worker | null = null;
  private last: Promise<unknown> = Promise.resolve();
  private end: (() => void) | null = null;

  constructor(private readonly module: WebAssembly.Module) {}

  /** Runs the program with these words on these files, after the runs that were asked for before. */
  run(words: string[], files: Iterable<[string, Uint8Array]>, onMessage: (text: string) => void = () => {}): Promise<Outcome> {
    const held = [...files];
    const run = this.last.then(() => this.start(words, held, onMessage));
    this.last = run.catch(() => {});
    return run;
  }

  /** Ends the run that is under way. */
  cancel(): void {
    this.end?.();
  }

  private start(words: string[], files: [string, Uint8Array][], onMessage: (text: string) => void): Promise<Outcome> {
    this.worker ??= this.newWorker();
    const worker = this.worker;
    return new Promise((resolve) => {
      const finish = (outcome: Outcome) => {
        this.end = null;
        resolve(outcome);
      };
      const without = (status: number, stderr: string): Outcome => ({ status, stdout: new Uint8Array(0), stderr, files: new Map(files) });
      this.end = () => {
        worker.terminate();
        this.worker = null;
        finish(without(ENDED, "ended before it was done\n"));
      };
      worker.onmessage = ({ data }: MessageEvent<Told>) => {
        if (data.kind === "message") onMessage(data.text);
        if (data.kind === "done") finish(data.outcome);
        if (data.kind === "failed") finish(without(1, `error: ${data.why}\n`));
      };
      worker.postMessage({ kind: "run", words, files } satisfies Asked);
    });
  }

  private newWorker(): Worker {
    const worker = new RunWorker();
    worker.postMessage({ kind: "module", module: this.module } satisfies Asked);
    return worker;
  }
}
