/** The program inside the page: a WebAssembly module, packed by gzip, as base64 in an element. */

export async function moduleOfPage(): Promise<WebAssembly.Module> {
  const text = document.querySelector("#program")?.textContent?.trim() ?? "";
  if (text === "") throw new Error("this page has no program in it: make it by cargo xtask studio");
  const packed = Uint8Array.from(atob(text), (character) => character.charCodeAt(0));
  const unpacked = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return WebAssembly.compile(await new Response(unpacked).arrayBuffer());
}
