import { defineConfig } from "vitest/config";

// The module and the page that `cargo xtask studio` made: the environment names them, the program and the browser.
export default defineConfig({
  test: { include: ["studio/test/*.test.ts"], testTimeout: 120000, hookTimeout: 60000, fileParallelism: false },
});
