import { defineConfig } from "vite";
import { viteSingleFile } from "vite-plugin-singlefile";

// The studio is one file too; `cargo xtask studio` puts the program into it.
export default defineConfig({
  base: "./",
  plugins: [viteSingleFile({ removeViteModuleLoader: true })],
  build: { outDir: "../dist", target: "es2022", emptyOutDir: false, rolldownOptions: { input: "studio.html" } },
});
