/** Elements of the page, made in one line. */

type Child = Node | string | null;

export function element<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Record<string, string> = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const found = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) found.setAttribute(name, value);
  found.append(...children.filter((child): child is Node | string => child !== null));
  return found;
}

export function button(text: string, title: string, onClick: () => void): HTMLButtonElement {
  const found = element("button", { type: "button", title }, text);
  found.addEventListener("click", onClick);
  return found;
}

/** A button that stays pressed. */
export function toggle(text: string, title: string, isOn: boolean, onChange: (isOn: boolean) => void): HTMLButtonElement {
  const found = button(text, title, () => {
    const next = found.getAttribute("aria-pressed") !== "true";
    found.setAttribute("aria-pressed", String(next));
    onChange(next);
  });
  found.setAttribute("aria-pressed", String(isOn));
  return found;
}

export function download(name: string, blob: Blob): void {
  const link = element("a", { href: URL.createObjectURL(blob), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}
