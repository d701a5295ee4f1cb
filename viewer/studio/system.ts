/**
 * The system calls that the program needs, of WASI preview 1, over files in memory.
 *
 * The program runs once from start to end: it gets words, files and standard input, and leaves an exit status, what it printed and the
 * files that it wrote. There is no network and no other file.
 *
 * Source: the documents of WASI, snapshot preview 1; the numbers of errors, rights and kinds of files are theirs.
 */

import { HeldFile, HeldFolder, folderOf } from "./files";

/** What a run is given. */
export interface Request {
  words: string[];
  files: Iterable<[string, Uint8Array]>;
  stdin?: Uint8Array;
  /** Called with each piece of standard error as it comes. */
  onMessage?: (text: string) => void;
}

/** What a run leaves. */
export interface Outcome {
  status: number;
  stdout: Uint8Array;
  stderr: string;
  /** All files that are there at the end, those that were given included. */
  files: Map<string, Uint8Array>;
}

/** Runs the program. */
export async function run(module: WebAssembly.Module, request: Request): Promise<Outcome> {
  const system = new System(request);
  const instance = await WebAssembly.instantiate(module, system.imports(module));
  const { memory, _start: start } = instance.exports as unknown as { memory: WebAssembly.Memory; _start: () => void };
  system.memory = memory;
  try {
    start();
    return system.outcome(0);
  } catch (fault) {
    if (fault instanceof Exit) return system.outcome(fault.status);
    system.say(`error: ${reasonOf(fault)}\n`);
    return system.outcome(1);
  }
}

/** Why a run was broken off by the machine that runs it. */
function reasonOf(fault: unknown): string {
  if (fault instanceof RangeError || /stack|recursion/i.test(String(fault))) return "the work needs more memory than a page has; use the program, or ask for less";
  return `the program was stopped (${fault instanceof Error ? fault.message : String(fault)}); please report it with its input`;
}

class Exit extends Error {
  constructor(readonly status: number) {
    super(`exit status ${status}`);
  }
}

const OK = 0;
const BAD_FILE = 8;
const EXISTS = 20;
const INVALID = 28;
const IS_FOLDER = 31;
const NO_ENTRY = 44;
const NO_SYSTEM_CALL = 52;
const NOT_A_FOLDER = 54;
const NOT_EMPTY = 55;

const CHARACTERS = 2;
const FOLDER = 3;
const FILE = 4;

const CREATE = 1;
const FOLDERS_ONLY = 2;
const EXCLUSIVE = 4;
const TRUNCATE = 8;
const APPEND = 1;

/** The number of the folder that the program is started in. */
const ROOT = 3;
const ALL_RIGHTS = 0xffffffffffffffffn;

/** What is open under a number. */
interface Open {
  node: HeldFile | HeldFolder | "input" | "output" | "messages";
  position: number;
  appends: boolean;
}

class System {
  memory: WebAssembly.Memory | null = null;
  private readonly root: HeldFolder;
  private readonly open = new Map<number, Open>();
  private readonly input: HeldFile;
  private readonly output = new HeldFile();
  private readonly decoder = new TextDecoder();
  private messages = "";
  private next = ROOT + 1;
  private readonly words: Uint8Array[];

  constructor(private readonly request: Request) {
    this.root = folderOf(request.files);
    this.input = new HeldFile(request.stdin ?? new Uint8Array(0));
    this.words = ["coface", ...request.words].map((word) => new TextEncoder().encode(`${word}\0`));
    const nodes = ["input", "output", "messages", this.root] as const;
    nodes.forEach((node, number) => this.open.set(number, { node, position: 0, appends: false }));
  }

  outcome(status: number): Outcome {
    const files = new Map<string, Uint8Array>();
    for (const [path, file] of this.root.files()) files.set(path, file.content());
    return { status, stdout: this.output.content(), stderr: this.messages, files };
  }

  say(text: string): void {
    this.messages += text;
    this.request.onMessage?.(text);
  }

  /** All functions that the module asks for; one that is unknown answers that there is no such call. */
  imports(module: WebAssembly.Module): WebAssembly.Imports {
    const calls = this.calls();
    const imports: Record<string, Record<string, WebAssembly.ImportValue>> = {};
    for (const { module: space, name, kind } of WebAssembly.Module.imports(module)) {
      if (kind === "function") (imports[space] ??= {})[name] = calls[name] ?? (() => NO_SYSTEM_CALL);
    }
    return imports;
  }

  private view(): DataView {
    return new DataView(this.memory!.buffer);
  }

  private bytes(start: number, length: number): Uint8Array {
    return new Uint8Array(this.memory!.buffer, start >>> 0, length >>> 0);
  }

  private text(start: number, length: number): string {
    return new TextDecoder().decode(this.bytes(start, length));
  }

  /** The pieces of memory of a list of (start, length). */
  private *pieces(list: number, count: number): Generator<Uint8Array> {
    for (let i = 0; i < count; i++) {
      const view = this.view();
      yield this.bytes(view.getUint32(list + 8 * i, true), view.getUint32(list + 8 * i + 4, true));
    }
  }

  private setNumber(place: number, value: number): void {
    this.view().setUint32(place, value, true);
  }

  private setLong(place: number, value: number | bigint): void {
    this.view().setBigUint64(place, BigInt(value), true);
  }

  /** 64 bytes about a file: its kind and its size; all times are 0. */
  private setStatistics(place: number, node: Open["node"]): void {
    this.bytes(place, 64).fill(0);
    this.view().setUint8(place + 16, kindOf(node));
    this.setLong(place + 24, 1);
    if (typeof node !== "string" && node.kind === "file") this.setLong(place + 32, node.length);
  }

  private at(folder: number, start: number, length: number): ReturnType<HeldFolder["find"]> {
    const node = this.open.get(folder)?.node;
    if (node === undefined || typeof node === "string" || node.kind !== "folder") return null;
    return node.find(this.text(start, length));
  }

  private calls(): Record<string, (...numbers: never[]) => number | void> {
    const file = (number: number): (Open & { node: HeldFile }) | null => {
      const open = this.open.get(number);
      return open && typeof open.node !== "string" && open.node.kind === "file" ? (open as Open & { node: HeldFile }) : null;
    };
    const readAt = (node: HeldFile, from: number, list: number, count: number): number => {
      let done = 0;
      for (const piece of this.pieces(list, count)) {
        const got = node.read(from + done, piece);
        done += got;
        if (got < piece.length) break;
      }
      return done;
    };
    const writeAt = (node: HeldFile, from: number, list: number, count: number): number => {
      let done = 0;
      for (const piece of this.pieces(list, count)) {
        node.write(from + done, piece);
        done += piece.length;
      }
      return done;
    };
    const list = (texts: Uint8Array[], starts: number, buffer: number): number => {
      for (const text of texts) {
        this.setNumber(starts, buffer);
        this.bytes(buffer, text.length).set(text);
        starts += 4;
        buffer += text.length;
      }
      return OK;
    };
    return {
      args_sizes_get: (count: number, size: number) => {
        this.setNumber(count, this.words.length);
        this.setNumber(size, this.words.reduce((sum, word) => sum + word.length, 0));
        return OK;
      },
      args_get: (starts: number, buffer: number) => list(this.words, starts, buffer),
      environ_sizes_get: (count: number, size: number) => {
        this.setNumber(count, 0);
        this.setNumber(size, 0);
        return OK;
      },
      environ_get: () => OK,
      clock_res_get: (_clock: number, place: number) => {
        this.setLong(place, 1000);
        return OK;
      },
      clock_time_get: (clock: number, _precision: bigint, place: number) => {
        const milliseconds = clock === 0 ? Date.now() : performance.now();
        this.setLong(place, BigInt(Math.round(milliseconds * 1e6)));
        return OK;
      },
      random_get: (start: number, length: number) => {
        // As many as the browser gives at once.
        for (let from = 0; from < length; from += 65536) crypto.getRandomValues(this.bytes(start + from, Math.min(65536, length - from)) as Uint8Array<ArrayBuffer>);
        return OK;
      },
      sched_yield: () => OK,
      // Nothing that a run waits for ever comes: all clocks have struck, all files are ready.
      poll_oneoff: (asked: number, answers: number, count: number, place: number) => {
        for (let i = 0; i < count; i++) {
          this.bytes(answers + 32 * i, 32).fill(0);
          this.setLong(answers + 32 * i, this.view().getBigUint64(asked + 48 * i, true));
          this.view().setUint8(answers + 32 * i + 10, this.view().getUint8(asked + 48 * i + 8));
        }
        this.setNumber(place, count);
        return OK;
      },
      proc_exit: (status: number) => {
        throw new Exit(status);
      },
      fd_prestat_get: (number: number, place: number) => {
        if (number !== ROOT) return BAD_FILE;
        this.setNumber(place, 0);
        this.setNumber(place + 4, 1);
        return OK;
      },
      fd_prestat_dir_name: (number: number, place: number, length: number) => {
        if (number !== ROOT) return BAD_FILE;
        this.bytes(place, Math.min(length, 1)).fill(".".charCodeAt(0));
        return OK;
      },
      fd_fdstat_get: (number: number, place: number) => {
        const open = this.open.get(number);
        if (!open) return BAD_FILE;
        this.bytes(place, 24).fill(0);
        this.view().setUint8(place, kindOf(open.node));
        this.view().setUint16(place + 2, open.appends ? APPEND : 0, true);
        // The right to seek is what tells a terminal from a file: nobody is asked to draw progress.
        this.setLong(place + 8, ALL_RIGHTS);
        this.setLong(place + 16, ALL_RIGHTS);
        return OK;
      },
      fd_fdstat_set_flags: () => OK,
      fd_filestat_get: (number: number, place: number) => {
        const open = this.open.get(number);
        if (!open) return BAD_FILE;
        this.setStatistics(place, open.node);
        return OK;
      },
      fd_filestat_set_size: (number: number, size: bigint) => {
        const open = file(number);
        open?.node.resize(Number(size));
        return open ? OK : BAD_FILE;
      },
      fd_close: (number: number) => (this.open.delete(number) ? OK : BAD_FILE),
      fd_sync: () => OK,
      fd_datasync: () => OK,
      fd_advise: () => OK,
      fd_allocate: () => OK,
      fd_seek: (number: number, offset: bigint, whence: number, place: number) => {
        const open = file(number);
        if (!open) return INVALID;
        const from = [0, open.position, open.node.length][whence];
        const position = (from ?? 0) + Number(offset);
        if (from === undefined || position < 0) return INVALID;
        open.position = position;
        this.setLong(place, position);
        return OK;
      },
      fd_tell: (number: number, place: number) => {
        const open = file(number);
        if (!open) return INVALID;
        this.setLong(place, open.position);
        return OK;
      },
      fd_read: (number: number, pieces: number, count: number, place: number) => {
        const open = this.open.get(number);
        const node = open?.node === "input" ? this.input : open?.node;
        if (!open || node === undefined || typeof node === "string") return BAD_FILE;
        if (node.kind === "folder") return IS_FOLDER;
        const done = readAt(node, open.position, pieces, count);
        open.position += done;
        this.setNumber(place, done);
        return OK;
      },
      fd_pread: (number: number, pieces: number, count: number, offset: bigint, place: number) => {
        const open = file(number);
        if (!open) return BAD_FILE;
        this.setNumber(place, readAt(open.node, Number(offset), pieces, count));
        return OK;
      },
      fd_write: (number: number, pieces: number, count: number, place: number) => {
        const open = this.open.get(number);
        if (!open || open.node === "input") return BAD_FILE;
        if (open.node === "messages") {
          let done = 0;
          for (const piece of this.pieces(pieces, count)) {
            this.say(this.decoder.decode(piece.slice(), { stream: true }));
            done += piece.length;
          }
          this.setNumber(place, done);
          return OK;
        }
        const node = open.node === "output" ? this.output : open.node;
        if (node.kind === "folder") return IS_FOLDER;
        const from = open.appends || open.node === "output" ? node.length : open.position;
        const done = writeAt(node, from, pieces, count);
        open.position = from + done;
        this.setNumber(place, done);
        return OK;
      },
      fd_pwrite: (number: number, pieces: number, count: number, offset: bigint, place: number) => {
        const open = file(number);
        if (!open) return BAD_FILE;
        this.setNumber(place, writeAt(open.node, Number(offset), pieces, count));
        return OK;
      },
      fd_readdir: (number: number, buffer: number, length: number, cookie: bigint, place: number) => {
        const node = this.open.get(number)?.node;
        if (node === undefined || typeof node === "string" || node.kind !== "folder") return BAD_FILE;
        let done = 0;
        const entries = [...node.entries].slice(Number(cookie));
        entries.every(([name, entry], i) => {
          const text = new TextEncoder().encode(name);
          const record = new Uint8Array(24 + text.length);
          const view = new DataView(record.buffer);
          view.setBigUint64(0, cookie + BigInt(i + 1), true);
          view.setUint32(16, text.length, true);
          view.setUint8(20, kindOf(entry));
          record.set(text, 24);
          const part = record.subarray(0, length - done);
          this.bytes(buffer + done, part.length).set(part);
          done += part.length;
          return done < length;
        });
        this.setNumber(place, done);
        return OK;
      },
      path_open: (
        folder: number,
        _follow: number,
        start: number,
        length: number,
        how: number,
        _rights: bigint,
        _inherited: bigint,
        flags: number,
        place: number,
      ) => {
        const found = this.at(folder, start, length);
        if (!found) return NO_ENTRY;
        let { node } = found;
        if (node && how & CREATE && how & EXCLUSIVE) return EXISTS;
        if (node && how & FOLDERS_ONLY && node.kind !== "folder") return NOT_A_FOLDER;
        if (!node) {
          if (!(how & CREATE)) return NO_ENTRY;
          node = new HeldFile();
          found.folder.entries.set(found.name, node);
        }
        if (how & TRUNCATE) {
          if (node.kind === "folder") return IS_FOLDER;
          node.resize(0);
        }
        const number = this.next++;
        this.open.set(number, { node, position: 0, appends: (flags & APPEND) !== 0 });
        this.setNumber(place, number);
        return OK;
      },
      path_filestat_get: (folder: number, _follow: number, start: number, length: number, place: number) => {
        const node = this.at(folder, start, length)?.node;
        if (!node) return NO_ENTRY;
        this.setStatistics(place, node);
        return OK;
      },
      path_create_directory: (folder: number, start: number, length: number) => {
        const found = this.at(folder, start, length);
        if (!found) return NO_ENTRY;
        if (found.node) return EXISTS;
        found.folder.entries.set(found.name, new HeldFolder());
        return OK;
      },
      path_remove_directory: (folder: number, start: number, length: number) => {
        const found = this.at(folder, start, length);
        if (!found?.node) return NO_ENTRY;
        if (found.node.kind !== "folder") return NOT_A_FOLDER;
        if (found.node.entries.size > 0) return NOT_EMPTY;
        found.folder.entries.delete(found.name);
        return OK;
      },
      path_unlink_file: (folder: number, start: number, length: number) => {
        const found = this.at(folder, start, length);
        if (!found?.node) return NO_ENTRY;
        if (found.node.kind === "folder") return IS_FOLDER;
        found.folder.entries.delete(found.name);
        return OK;
      },
      path_rename: (from: number, start: number, length: number, to: number, newStart: number, newLength: number) => {
        const [old, target] = [this.at(from, start, length), this.at(to, newStart, newLength)];
        if (!old?.node || !target) return NO_ENTRY;
        if (target.node?.kind === "folder") return IS_FOLDER;
        old.folder.entries.delete(old.name);
        target.folder.entries.set(target.name, old.node);
        return OK;
      },
      // Calls of a library of C that was made without threads: starting one fails as what does not exist, so that all work is done by the first.
      pthread_create: () => NO_SYSTEM_CALL,
      pthread_attr_init: () => OK,
      pthread_attr_setstacksize: () => OK,
      pthread_attr_destroy: () => OK,
      pthread_detach: () => OK,
      pthread_join: () => OK,
      // No name is found for a path: the path is taken as it is.
      realpath: () => 0,
      // Files have no modes.
      fchmod: () => OK,
      // There are no links of either kind.
      path_readlink: () => INVALID,
      path_filestat_set_times: () => OK,
      fd_filestat_set_times: () => OK,
    };
  }
}

function kindOf(node: Open["node"]): number {
  if (typeof node === "string") return CHARACTERS;
  return node.kind === "folder" ? FOLDER : FILE;
}
