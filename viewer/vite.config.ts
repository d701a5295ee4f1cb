import { defineConfig } from "vitest/config";
import { viteSingleFile } from "vite-plugin-singlefile";

// The page is one file: scripts and styles stand in it.
export default defineConfig({
  base: "./",
  plugins: [viteSingleFile({ removeViteModuleLoader: true })],
  build: {
    outDir: "../crates/coface-pictures/page",
    target: "es2022",
    emptyOutDir: true,
    rolldownOptions: { input: "viewer.html" },
  },
  test: { include: ["test/*.test.ts"] },
});
