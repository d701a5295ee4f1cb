/** The worker in which the program runs, so that the page stays awake. */

import { run } from "./system";
import type { Asked, Told } from "./runner";

const worker = self as unknown as { onmessage: (event: MessageEvent<Asked>) => void; postMessage: (told: Told) => void };
let module: WebAssembly.Module | null = null;

worker.onmessage = ({ data }) => {
  if (data.kind === "module") {
    module = data.module;
    return;
  }
  const onMessage = (text: string) => worker.postMessage({ kind: "message", text });
  void run(module!, { words: data.words, files: data.files, onMessage }).then(
    (outcome) => worker.postMessage({ kind: "done", outcome }),
    (fault) => worker.postMessage({ kind: "failed", why: String(fault) }),
  );
};
