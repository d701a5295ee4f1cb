import { defineConfig } from "vitest/config";

// Tests in a real browser: the environment names the program and the browser.
export default defineConfig({
  test: { include: ["browser/*.test.ts"], testTimeout: 60000, hookTimeout: 60000, fileParallelism: false },
});
