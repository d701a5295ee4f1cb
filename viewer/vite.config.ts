import { defineConfig, type Plugin } from "vite";

/** Puts scripts and styles into the page, so that it is one file. */
function oneFile(): Plugin {
  return {
    name: "one-file",
    enforce: "post",
    generateBundle(_, bundle) {
      const page = Object.values(bundle).find((part) => part.fileName.endsWith(".html"));
      if (!page || page.type !== "asset") return;
      let html = String(page.source);
      for (const part of Object.values(bundle)) {
        const name = part.fileName.replace(/[.*+?^${}()|[\]\\]/g, "\\$&");
        if (part.type === "chunk") {
          const code = part.code.replaceAll("</script", "<\\/script");
          html = html.replace(new RegExp(`<script[^>]*src="[^"]*${name}"[^>]*></script>`), "");
          html = html.replace("</body>", () => `<script type="module">${code}</script>\n  </body>`);
          delete bundle[part.fileName];
        } else if (part.fileName.endsWith(".css")) {
          const style = String(part.source);
          html = html.replace(new RegExp(`<link[^>]*href="[^"]*${name}"[^>]*>`), () => `<style>${style}</style>`);
          delete bundle[part.fileName];
        }
      }
      page.source = html;
      page.fileName = "viewer.html";
    },
  };
}

export default defineConfig({
  base: "./",
  plugins: [oneFile()],
  build: { outDir: "../crates/coface-cli/page", target: "es2022", modulePreload: false, cssCodeSplit: false, assetsInlineLimit: 1 << 30, emptyOutDir: true },
});
