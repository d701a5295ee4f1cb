/** Files in memory: what the program sees of the world when it runs in a page. */

/** A file: its bytes, of which the first `length` count. */
export class HeldFile {
  readonly kind = "file";
  private bytes: Uint8Array;
  private held: number;

  constructor(bytes: Uint8Array = new Uint8Array(0)) {
    this.bytes = bytes;
    this.held = bytes.length;
  }

  get length(): number {
    return this.held;
  }

  /** The bytes; a view that later writes may leave behind. */
  content(): Uint8Array {
    return this.bytes.subarray(0, this.held);
  }

  /** Reads into `target` from `offset` on: how many bytes there were. */
  read(offset: number, target: Uint8Array): number {
    const part = this.bytes.subarray(Math.min(offset, this.held), Math.min(offset + target.length, this.held));
    target.set(part);
    return part.length;
  }

  /** Writes at `offset`; what lies between the end and there is filled with zeros. */
  write(offset: number, source: Uint8Array): void {
    const end = offset + source.length;
    // The bytes that were given belong to whoever gave them: they are copied at the first write.
    if (end > this.bytes.length || this.held === this.bytes.length) this.grow(Math.max(end, this.bytes.length));
    this.bytes.set(source, offset);
    this.held = Math.max(this.held, end);
  }

  resize(length: number): void {
    this.grow(length);
    if (length < this.held) this.bytes.fill(0, length, this.held);
    this.held = length;
  }

  private grow(least: number): void {
    const grown = new Uint8Array(Math.max(least, 64, 2 * this.held));
    grown.set(this.content());
    this.bytes = grown;
  }
}

/** A folder: its files and folders by name. */
export class HeldFolder {
  readonly kind = "folder";
  readonly entries = new Map<string, HeldFile | HeldFolder>();

  /** The file or folder at a path that is relative to this folder, and where it is or would be; null without such a folder. */
  find(path: string): { folder: HeldFolder; name: string; node: HeldFile | HeldFolder | null } | null {
    const steps: string[] = [];
    for (const step of path.split("/")) {
      if (step === "..") steps.pop();
      else if (step !== "" && step !== ".") steps.push(step);
    }
    const name = steps.pop();
    if (name === undefined) return { folder: this, name: ".", node: this };
    let folder: HeldFolder = this;
    for (const step of steps) {
      const next = folder.entries.get(step);
      if (next?.kind !== "folder") return null;
      folder = next;
    }
    return { folder, name, node: folder.entries.get(name) ?? null };
  }

  /** All files below, by their paths. */
  *files(before = ""): Generator<[string, HeldFile]> {
    for (const [name, node] of this.entries) {
      if (node.kind === "file") yield [before + name, node];
      else yield* node.files(`${before}${name}/`);
    }
  }
}

/** A folder with these files; a path with slashes makes folders. */
export function folderOf(files: Iterable<[string, Uint8Array]>): HeldFolder {
  const root = new HeldFolder();
  for (const [path, bytes] of files) {
    let folder = root;
    const steps = path.split("/").filter((step) => step !== "");
    const name = steps.pop();
    if (name === undefined) continue;
    for (const step of steps) {
      const next = folder.entries.get(step);
      const inner = next?.kind === "folder" ? next : new HeldFolder();
      folder.entries.set(step, inner);
      folder = inner;
    }
    folder.entries.set(name, new HeldFile(bytes));
  }
  return root;
}
