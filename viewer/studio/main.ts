/** The studio: models on the left, the view in the middle, questions and answers on the right; everything is computed in this page. */

import { button, download, element } from "../src/panel/elements";
import { EXAMPLES, NOTICES, type Example } from "./examples";
import { moduleOfPage } from "./module";
import { TABLES } from "./tables/all";
import { commandOf, pythonOf, QUESTIONS, wordsOf, type Question } from "./questions";
import { ENDED, Runner } from "./runner";
import { fromFragment, Session, toFragment, type Step } from "./session";
import type { Outcome } from "./system";
import { tableOf } from "./table";

/** The longest fragment of a link: longer ones are cut off by programs that pass them on. */
const LONGEST_LINK = 60_000;

class Studio {
  private session = new Session();
  private readonly models = document.querySelector<HTMLElement>("#models")!;
  private readonly view = document.querySelector<HTMLElement>("#view")!;
  private readonly answers = document.querySelector<HTMLElement>("#answers")!;
  private readonly status = element("div", { id: "status", role: "status" });
  private readonly list = element("ul", { id: "list" });
  private readonly history = element("div", { id: "history" });
  private readonly second = element("select", { "aria-label": "the second model" });
  private readonly line = element("input", { id: "line", "aria-label": "words for the program", placeholder: "coface link torus.off --simplices 17", spellcheck: "false" });
  private readonly cancel = button("end", "end the run that is under way", () => this.runner.cancel());
  private seen = "";
  private close: (() => void) | null = null;

  constructor(private readonly runner: Runner) {
    this.cancel.disabled = true;
    this.fillModels();
    this.fillAnswers();
    this.listen();
    this.show();
  }

  private fillModels(): void {
    const input = element("input", { type: "file", multiple: "", hidden: "", id: "file" });
    input.addEventListener("change", () => void this.take(input.files ?? []));
    const examples = element("select", { "aria-label": "examples", id: "examples" }, element("option", { value: "" }, "an example .."));
    EXAMPLES.forEach(({ group, examples: held }, i) => {
      const options = held.map((example, k) => element("option", { value: `${i} ${k}` }, example.title));
      examples.append(element("optgroup", { label: group }, ...options));
    });
    examples.addEventListener("change", () => {
      const [i, k] = examples.value.split(" ").map(Number);
      if (examples.value !== "") void this.takeExample(EXAMPLES[i].examples[k]);
      examples.value = "";
    });
    const tables = element("div", { class: "row", id: "tables" });
    for (const table of TABLES) tables.append(button(table.title, table.about, () => this.openTable(table.title)));
    this.models.append(
      element("h1", {}, "coface studio"),
      element("p", { class: "detail" }, "Drop files anywhere. All is computed in this page, nothing is sent."),
      element("div", { class: "row" }, button("open files", "read files from disk", () => input.click()), button("paste text", "take a text as a file", () => this.paste()), input),
      examples,
      element("h2", {}, "models"),
      this.list,
      element("h2", {}, "by hand"),
      tables,
      element("h2", {}, "session"),
      element(
        "div",
        { class: "row" },
        button("undo", "take the last step back", () => this.undo()),
        button("save", "save models and answers as a file", () => download("session.coface.json", new Blob([this.session.toText()], { type: "application/json" }))),
        button("share", "copy a link to this session", () => void this.share()),
      ),
      element("details", {}, element("summary", {}, "licences of the examples"), element("pre", { class: "detail", tabindex: "0" }, NOTICES)),
    );
  }

  private fillAnswers(): void {
    const questions = element("ul", { id: "questions" });
    for (const question of QUESTIONS) {
      const verb = element("code", {}, question.words("MODEL", "OTHER").slice(0, question.words("", "")[0] === "yin" ? 2 : 1).join(" "));
      questions.append(element("li", {}, button(question.title, question.about, () => void this.ask(question)), verb));
    }
    const form = element("form", { id: "free" }, this.line, element("button", { type: "submit" }, "run"));
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      void this.runLine();
    });
    this.answers.append(
      element("h2", {}, "questions"),
      element("label", { class: "row" }, "of two, the second is ", this.second),
      questions,
      element("h2", {}, "any words of the program"),
      form,
      element("div", { class: "row" }, this.cancel, this.status),
      element("h2", {}, "answers"),
      this.history,
    );
  }

  private listen(): void {
    window.addEventListener("dragover", (event) => event.preventDefault());
    window.addEventListener("drop", (event) => {
      event.preventDefault();
      void this.take(event.dataTransfer?.files ?? []);
    });
    window.addEventListener("hashchange", () => void this.restore());
    void this.restore();
  }

  /** The session of the link that the page was opened by. */
  private async restore(): Promise<void> {
    const fragment = location.hash.slice(1);
    if (fragment === "") return;
    try {
      this.session = Session.of(await fromFragment(fragment));
    } catch (fault) {
      this.say(`the link holds no session: ${String(fault)}`);
    }
    this.show();
  }

  private async take(files: Iterable<File>): Promise<void> {
    for (const file of files) {
      const bytes = new Uint8Array(await file.arrayBuffer());
      if (file.name.endsWith(".coface.json")) {
        try {
          this.session = Session.of(new TextDecoder().decode(bytes));
        } catch (fault) {
          this.say(`${file.name}: ${fault instanceof Error ? fault.message : String(fault)}`);
        }
      } else this.session.add(file.name, bytes);
    }
    this.show();
  }

  private async takeExample(example: Example): Promise<void> {
    const name = this.session.freeName(example.name);
    if (typeof example.from === "string") {
      this.session.add(name, new TextEncoder().encode(example.from));
      this.show();
    } else await this.run(example.from.map((word) => (word === example.name ? name : word)), null, null, true);
  }

  private paste(): void {
    const name = element("input", { "aria-label": "name of the file", value: "pasted.json" });
    const text = element("textarea", { "aria-label": "text of the file", rows: "12", cols: "60" });
    const dialog = element("dialog", {}, element("p", {}, "The extension of the name says the format: .json, .off, .obj, .wkt, .sig, .txt"), name, text);
    const take = () => {
      this.session.add(name.value, new TextEncoder().encode(text.value));
      dialog.close();
      this.show();
    };
    dialog.append(element("div", { class: "row" }, button("take", "take it as a model", take), button("close", "take nothing", () => dialog.close())));
    dialog.addEventListener("close", () => dialog.remove());
    document.body.append(dialog);
    dialog.showModal();
  }

  private undo(): void {
    const step = this.session.undo();
    this.say(step ? `undone: ${commandOf(step.words)}` : "there is nothing to undo");
    this.show();
  }

  private async share(): Promise<void> {
    const fragment = await toFragment(this.session.toText());
    if (fragment.length > LONGEST_LINK) {
      this.say(`the session is too large for a link (${fragment.length.toLocaleString("en")} characters): save it as a file instead`);
      return;
    }
    history.replaceState(null, "", `#${fragment}`);
    const copied = await navigator.clipboard?.writeText(location.href).then(
      () => true,
      () => false,
    );
    this.say(copied ? "the link was copied" : "the link stands in the line of addresses");
  }

  private async ask(question: Question): Promise<void> {
    const chosen = this.session.chosen;
    if (chosen === null) {
      this.say("choose a model first: open a file, or take an example");
      return;
    }
    const names = question.models === 2 ? [chosen, this.second.value] : [chosen];
    if (names.includes("")) {
      this.say("two models are needed: take another one");
      return;
    }
    let words = question.words(...names);
    if (question.makes !== undefined) {
      const free = this.session.freeName(question.makes);
      words = words.map((word) => (word === question.makes ? free : word));
    }
    await this.run(words, chosen, question, question.makes !== undefined);
  }

  private async runLine(): Promise<void> {
    const words = wordsOf(this.line.value);
    if (words === null) {
      this.say("a quote has no end");
      return;
    }
    if (words.length > 0) await this.run(words, this.session.chosen, null, true);
  }

  /** Runs the program; what it wrote becomes models, or a layer over the model that it is about. */
  private async run(words: string[], about: string | null, question: Question | null, isShown: boolean): Promise<void> {
    const isLayer = question?.isLayer === true;
    const begin = performance.now();
    this.status.textContent = `${commandOf(words)} ..`;
    this.cancel.disabled = false;
    const outcome = await this.runner.run(isLayer ? [...words, "--json"] : words, this.session.files, (text) => {
      this.status.textContent = text.trim();
    });
    this.cancel.disabled = true;
    const seconds = ((performance.now() - begin) / 1000).toFixed(2);
    this.status.textContent = outcome.status === 0 ? `${seconds} s` : outcome.status === ENDED ? "ended" : `exit status ${outcome.status}`;
    const step: Step = { words, question: question?.title ?? null, about, status: outcome.status, text: new TextDecoder().decode(outcome.stdout), remarks: outcome.stderr, before: [], layer: null };
    if (outcome.status === 0) this.keepFiles(step, outcome, isShown);
    if (isLayer && outcome.status === 0) {
      step.layer = this.session.freeName(`${words[0]}.answer.json`);
      step.before.push([step.layer, null]);
      this.session.files.set(step.layer, outcome.stdout.slice());
      this.session.layers.add(step.layer);
    }
    this.session.steps.push(step);
    this.show();
  }

  private keepFiles(step: Step, { files }: Outcome, isShown: boolean): void {
    for (const [name, bytes] of files) {
      const held = this.session.files.get(name);
      if (held && held.length === bytes.length && held.every((byte, i) => byte === bytes[i])) continue;
      step.before.push([name, held ?? null]);
      this.session.files.set(name, bytes.slice());
      if (isShown) this.session.chosen = name;
    }
  }

  /** Everything as it is now. */
  private show(): void {
    const models = this.session.models();
    this.list.replaceChildren(
      ...models.map((name) => {
        const choose = button(name, "look at it, and ask about it", () => {
          this.session.chosen = name;
          this.show();
        });
        choose.setAttribute("aria-pressed", String(name === this.session.chosen));
        const drop = button("x", `take ${name} away`, () => {
          this.session.remove(name);
          this.show();
        });
        const save = button("save", `save ${name} to disk`, () => download(name, new Blob([this.session.files.get(name)! as Uint8Array<ArrayBuffer>])));
        return element("li", {}, choose, save, drop);
      }),
    );
    if (models.length === 0) this.list.append(element("li", { class: "detail" }, "none yet"));
    const before = this.second.value;
    const others = models.filter((name) => name !== this.session.chosen);
    this.second.replaceChildren(...others.map((name) => element("option", { value: name }, name)));
    if (others.includes(before)) this.second.value = before;
    this.history.replaceChildren(...this.session.steps.toReversed().map((step) => this.stepElement(step)));
    this.close?.();
    this.close = null;
    void this.showView();
  }

  private stepElement(step: Step): HTMLElement {
    const found = element("article", { class: step.status === 0 ? "step" : "step failed" }, element("code", { class: "command" }, commandOf(step.words)));
    const question = QUESTIONS.find(({ title }) => title === step.question);
    const python = question && step.about !== null ? pythonOf(question, step.words.filter((word) => this.session.files.has(word)).slice(0, question.models)) : null;
    const copy = (text: string, what: string) => void navigator.clipboard?.writeText(text).then(() => this.say(`${what} was copied`), () => this.say(text));
    found.append(
      element(
        "div",
        { class: "row" },
        button("copy as command", "for a shell", () => copy(commandOf(step.words), "the command")),
        python === null ? null : button("copy as Python", "for a notebook", () => copy(python, "the Python")),
        step.layer === null && step.status === 0 && !step.words.includes("--json") ? button("as a table", "the same answer for programs", (() => void this.addTable(step, found)) as () => void) : null,
      ),
    );
    if (step.remarks !== "") found.append(element("pre", { class: "remarks" }, step.remarks));
    if (step.layer !== null) found.append(tableOf(JSON.parse(step.text) as unknown));
    else if (step.text !== "") found.append(element("pre", {}, step.text));
    return found;
  }

  private async addTable(step: Step, place: HTMLElement): Promise<void> {
    const outcome = await this.runner.run([...step.words, "--json"], this.session.files);
    const text = new TextDecoder().decode(outcome.stdout);
    try {
      place.append(tableOf(JSON.parse(text) as unknown));
    } catch {
      this.say(outcome.stderr.trim() || "this verb has no answer for programs");
    }
  }

  /** The page that the program writes of the chosen model, with the answers about it as layers. */
  private async showView(): Promise<void> {
    const chosen = this.session.chosen;
    if (chosen === null) {
      this.seen = "";
      this.view.replaceChildren(element("p", { class: "empty" }, "Take an example or drop a file, and it is shown here."));
      return;
    }
    const layers = this.session.layersOf(chosen);
    const words = ["view", chosen, ...layers.flatMap((layer) => ["--with", layer]), "-o", "view.html"];
    const key = commandOf(words);
    if (key === this.seen && this.view.querySelector("iframe")) return;
    this.seen = key;
    const outcome = await this.runner.run(words, this.session.files);
    if (this.seen !== key) return;
    const page = outcome.files.get("view.html");
    if (outcome.status !== 0 || !page) {
      this.view.replaceChildren(element("pre", { class: "remarks" }, outcome.stderr), element("p", { class: "empty" }, "There is no picture of it; questions can be asked all the same."));
      return;
    }
    this.view.replaceChildren(element("iframe", { title: `view of ${chosen}`, srcdoc: new TextDecoder().decode(page) }));
  }

  private openTable(title: string): void {
    const table = TABLES.find((held) => held.title === title)!;
    this.close?.();
    this.seen = "";
    const place = element("section", { id: "table", "aria-label": table.title });
    this.view.replaceChildren(place);
    this.close = table.open(place, {
      run: (words, files) => this.runner.run(words, files),
      keep: (name, text) => {
        this.session.add(name, new TextEncoder().encode(text));
        this.show();
      },
    });
  }

  private say(text: string): void {
    this.status.textContent = text;
  }
}

async function begin(): Promise<void> {
  const view = document.querySelector<HTMLElement>("#view")!;
  try {
    view.textContent = "The program is unpacked ..";
    const studio = new Studio(new Runner(await moduleOfPage()));
    (window as unknown as { studio: Studio }).studio = studio;
  } catch (fault) {
    view.textContent = `The studio cannot start: ${fault instanceof Error ? fault.message : String(fault)}`;
  }
}

void begin();
