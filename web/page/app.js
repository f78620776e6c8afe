// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// meniscus.html: takes files, has the engine compute their surfaces in a worker, and shows them as pages do.
"use strict";

const App = (() => {
  const {$, plain, grouped} = Panel;

  const stages = {read: "Reading the file", estimate: "Estimating", geometry: "Rolling the probe over the atoms",
                  exact: "Measuring exactly", interfaces: "Measuring between chains", band: "Laying out the grid",
                  flow: "Letting the surface flow", mesh: "Making the mesh", page: "Lighting the picture"};

  // What lights the picture and packs it for the viewer takes so long per vertex (docs/design/portable.md).
  const secondsPerVertex = 7.5e-6;

  // What is asked about before it is begun, and what a browser cannot hold at all.
  const longWait = 60;          // seconds
  const muchMemory = 1500;      // MB
  const mostMemory = 3500;      // MB: WebAssembly addresses 4 GB
  const heldMemory = 1500;      // MB: of surfaces that are kept for saving, beside the one that is shown
  const leastMemory = 50;       // MB: of an engine with a small surface

  const isAbort = error => error.name === "AbortError";

  const aborted = () => Object.assign(new Error("left"), {name: "AbortError"});

  class App {
    /** newEngine: () => Meniscus, with a worker of its own; example: () => File */
    constructor(newEngine, example) {
      this.newEngine = newEngine;
      this.example = example;
      this.items = [];       // files: {file, name, failed, result}
      this.current = null;   // the item that was chosen last
      this.shown = null;     // the item whose result is in the window
      this.page = null;
      this.runs = [];
      this.held = [];        // results whose surfaces are in the memory of their engines, the last one used at the end
      this.listen();
      this.list();
      document.body.dataset.ready = "true";
    }

    // Files.

    /** Takes files in and shows the first of them. */
    open(files) {
      const items = [...files].map(file => ({file, name: file.name}));
      if (items.length === 0) return;
      this.items.push(...items);
      this.choose(items[0]);
    }

    choose(item) {
      if (this.run && this.run.item === item) return;
      this.closeNotices();
      this.current = item;
      this.list();
      return this.isUpToDate(item) ? this.show(item) : this.compute(item);
    }

    /** The options as text, to tell whether they have changed; throws as Settings.read(). */
    asked() { return JSON.stringify(Settings.read()); }

    /** Whether an item has been computed with the options of the form. Options that make no sense are said when they are used. */
    isUpToDate({result}) {
      try {
        return Boolean(result) && result.asked === this.asked();
      } catch {
        return false;
      }
    }

    // Computing. A run is {item, engine, stopped, ...}: an engine of its own computes the surface of an item. Stopping it
    // leaves all other engines alone, so that what is shown stays whole and can be saved. this.run, if there is one, will be
    // shown; other runs of this.runs are for files to save.

    begin(item, title) {
      const run = {item, title, engine: this.newEngine(), stopped: new AbortController()};
      this.runs.push(run);
      this.progress(run, {stage: "read", fraction: 0});
      return run;
    }

    async compute(item) {
      this.stop(this.run);
      const run = this.run = this.begin(item, this.shown && item !== this.shown ? item.name + ": " : "");
      item.failed = null;
      this.list();
      try {
        const result = await this.computed(run, await this.agreed(run));
        if (item.result) this.release(item.result);
        item.result = result;
        this.hold(result);
        if (item === this.current) this.show(item);
      } catch (error) {
        const stopped = isAbort(error) || run.stopped.signal.aborted;
        item.failed = stopped ? "stopped" : "failed";
        if (!stopped) this.complain(item.name, error);
      }
      this.end(run);
    }

    /** The options, after a question where it would take long; rejects where that is declined, or what is asked for cannot be. */
    async agreed(run) {
      const {item, engine, stopped: {signal}} = run;
      for (let answer = null; ;) {
        const options = Settings.read();
        const cost = await engine.estimate(await bytesOf(item), {...options, name: item.name, signal});
        cost.seconds += secondsPerVertex * cost.vertices;
        run.megabytes = cost.megabytes;
        run.expected = cost.seconds >= 5 ? `, about ${duration(cost.seconds)} in all` : "";
        if (cost.seconds <= longWait && cost.megabytes <= muchMemory) return options;
        if (answer === null || cost.megabytes > mostMemory) answer = await this.question(item, cost, options.spacing);
        else answer = "go";   // to a coarser mesh, as the answer was
        if (answer === "no") throw aborted();
        if (answer === "go") {
          for (const other of this.held) this.release(other);   // it may need their memory
          return options;
        }
        $("spacing").value = coarser(options.spacing, cost.megabytes);
      }
    }

    /** What is shown of a surface, and the means to ask for more of it; hold() it. */
    async computed(run, options) {
      const {item, engine, megabytes, stopped: {signal}} = run;
      const surface = await engine.surface(await bytesOf(item), {
        ...options, name: item.name, signal, progress: p => this.progress(run, p)});
      this.progress(run, {stage: "page", fraction: 0});
      const {report, notes, warnings, interfaces} = surface, content = await surface.page({});
      signal.throwIfAborted();
      return {item, asked: JSON.stringify(options), content, report, notes, warnings, interfaces, megabytes, engine, surface};
    }

    /** Keeps the surface of a result for saving; others, of what is not shown, make room. */
    hold(result) {
      this.held.push(result);
      let room = heldMemory;
      for (const other of [...this.held].reverse()) {
        room -= Math.max(other.megabytes, leastMemory);
        if (room < 0 && other !== result && !(this.shown && other === this.shown.result)) this.release(other);
      }
    }

    /** Ends the engine of a result, after what is being saved. */
    release(result) {
      const {engine, answered} = result;
      if (!engine) return;
      Promise.resolve(answered).catch(() => {}).then(() => engine.stop());
      result.engine = result.surface = null;
      this.held = this.held.filter(other => other !== result);
    }

    /** Stops a run, if there is one, also while its file is read. */
    stop(run) {
      if (!run) return;
      run.stopped.abort();
      run.engine.stop();
      this.end(run);
    }

    end(run) {
      this.runs = this.runs.filter(other => other !== run);
      if (this.run === run) this.run = null;
      if (!this.held.some(({engine}) => engine === run.engine)) run.engine.stop();
      this.drawProgress();
      this.list();
    }

    complain(title, error) {
      console.warn(error);
      $("failure-title").textContent = title;
      $("failure-text").textContent = Settings.inFields(error.message);
      $("failure").hidden = false;
    }

    closeNotices() {
      $("failure").hidden = true;
      if (this.answer) this.answer("no");
    }

    question(item, {atoms, seconds, megabytes}, spacing) {
      const possible = megabytes <= mostMemory, gigabytes = plain(megabytes / 1024, 1);
      $("question-title").textContent = possible ? "This one takes a while" : "Too large for a browser at this spacing";
      $("question-text").textContent =
        `${item.name} has ${grouped(atoms)} atoms. At a spacing of ${spacing} Å they take about ` +
        `${duration(seconds)} and ${gigabytes} GB of memory` +
        (possible ? "." : "; a page has 4 GB at most. A coarser mesh needs less, and the exact numbers stay the same.");
      $("question-go").hidden = !possible;
      $("question-coarse").textContent = `Use ${coarser(spacing, megabytes)} Å`;
      $("question").hidden = false;
      $(possible ? "question-go" : "question-coarse").focus();
      return new Promise(resolve => {
        this.answer = answer => {
          this.answer = null;
          $("question").hidden = true;
          this.drawProgress();
          resolve(answer);
        };
        this.drawProgress();
      });
    }

    progress(run, {stage, fraction}) {
      Object.assign(run, {text: run.title + (stages[stage] || stage) + (run.expected || ""), fraction});
      this.drawProgress();
    }

    /** Of the run that has begun last. */
    drawProgress() {
      const run = this.runs.at(-1);
      $("busy").hidden = !run || Boolean(this.answer);
      if (!run) return;
      if ($("busy-text").textContent !== run.text) $("busy-text").textContent = run.text;   // read aloud once
      $("progress").value = run.fraction;
    }

    // Showing.

    show(item) {
      const {content, report, interfaces} = item.result;
      const data = Decode.decode(content.data), theme = document.documentElement.dataset.theme;
      if (this.page) this.page.dispose();
      document.body.classList.remove("empty");
      this.renderer = this.renderer || Page.renderer();
      this.page = new Page(data, this.renderer);
      if (theme) this.page.setTheme(theme);
      document.title = content.title;
      $("name").textContent = data.info.name;
      $("view").setAttribute("aria-label", `The surface of ${data.info.name}. Drag or use the arrow keys to rotate it.`);
      Tables.numbers(data.info.rows, report.exact ? report.exact.errors : {});
      Tables.keyNumbers(report, data.info.cavities.length);
      Tables.interfaces(interfaces);
      Tables.remarks(item.result);
      $("settings").open = false;
      this.shown = item;
      this.list();
      this.page.forget();
      this.page.drawNow();
      document.body.dataset.shown = item.name;
    }

    /** Marks the file that is shown, or is being computed to be shown. */
    list() {
      const chosen = this.run && this.run.item === this.current ? this.current : this.shown || this.current;
      Tables.files(this.items.map(item => ({name: item.name, ...this.stateOf(item)})), this.items.indexOf(chosen),
                   i => this.choose(this.items[i]));
      this.offer();
    }

    stateOf(item) {
      if (this.run && this.run.item === item) return {state: "running", text: "…"};
      if (item.result) return {state: "ready", text: grouped(item.result.report.input.atoms) + " atoms"};
      return {state: item.failed || "waiting", text: item.failed || "not computed yet"};
    }

    /** Offers to compute again where the options are others than those of what is shown. */
    offer() {
      const item = this.current;
      $("compute").hidden = !item || Boolean(this.run);
      if (!item) return;
      $("compute").textContent = item === this.shown ? "Compute again" : this.shown ? `Compute ${item.name}` : "Compute";
      $("compute").disabled = this.isUpToDate(item);
    }

    // Saving: what is shown, whatever else is being computed.

    async save(kind) {
      const {result} = this.shown, name = this.shown.name.replace(/\.gz$/i, "").replace(/\.[^.]*$/, "") || "surface";
      if (kind === "png") return this.page.save();
      try {
        if (kind === "html") return Panel.download(new Blob([await this.asPage(result)], {type: "text/html"}), name + ".html");
        if (!result.surface) await (result.again ||= this.again(result));
        const bytes = await (result.answered = result.surface.file(kind));   // surfaces answer in the order of questions
        Panel.download(new Blob([bytes]), kind === "report.json" ? name + ".json" : `${name}.${kind}`);
      } catch (error) {
        if (!isAbort(error)) this.complain("Saving", error);
      }
    }

    /** Computes a surface anew that has been let go, with the options that it had. */
    async again(result) {
      const run = this.begin(result.item, `To save ${result.item.name}: `);
      try {
        const {engine, surface} = await this.computed(run, JSON.parse(result.asked));
        this.hold(Object.assign(result, {engine, surface}));
      } finally {
        result.again = null;
        this.end(run);
      }
    }

    async asPage({content: {title, data}}) {
      const {info} = this.page;
      return Saving.page({title, data, name: info.name, rows: info.rows, picture: await this.page.still(640, 480)});
    }

    // What is heard.

    listen() {
      const on = (id, name, f) => $(id).addEventListener(name, f);
      const input = $("files-input");
      for (const id of ["choose", "add"]) on(id, "click", () => input.click());
      input.addEventListener("change", () => {
        this.open(input.files);
        input.value = "";
      });
      on("example", "click", async () => this.open([await this.example()]));
      on("stop", "click", () => this.stop(this.runs.at(-1)));
      on("failure-close", "click", () => this.closeNotices());
      for (const answer of ["go", "coarse", "no"]) on("question-" + answer, "click", () => this.answer && this.answer(answer));
      for (const button of document.querySelectorAll("[data-save]"))
        button.addEventListener("click", () => this.save(button.dataset.save));
      Settings.listen({changed: () => this.offer(), submitted: () => this.recompute()});
      this.listenToDrops();
      document.addEventListener("keydown", e => {
        if (e.key === "Escape") this.closeNotices();
      });
    }

    recompute() {
      this.closeNotices();
      try {
        this.asked();
      } catch (error) {
        return this.complain("Options", error);
      }
      if (this.current) this.compute(this.current);
    }

    /** Takes what is dropped. A page that has been opened from a file may not look into folders. */
    take({items, files}) {
      const folders = [...items].filter(i => i.kind === "file").map(i => i.webkitGetAsEntry())
                                .filter(e => e && e.isDirectory).map(e => e.name);
      this.open([...files].filter(({name}) => !folders.includes(name)));
      if (folders.length > 0) this.complain(folders.join(", "), new Error("A folder cannot be read: drop the files in it."));
    }

    listenToDrops() {
      const has = e => e.dataTransfer && [...e.dataTransfer.types].includes("Files");
      let depth = 0;   // of elements entered
      const mark = () => document.body.classList.toggle("dragging", depth > 0);
      const on = (name, f) => document.addEventListener(name, e => {
        if (!has(e)) return;
        e.preventDefault();
        f(e);
        mark();
      });
      on("dragenter", () => ++depth);
      on("dragleave", () => --depth);
      on("dragover", e => { e.dataTransfer.dropEffect = "copy"; });
      on("drop", e => {
        depth = 0;
        this.take(e.dataTransfer);
      });
    }
  }

  async function bytesOf({file}) {
    try {
      return new Uint8Array(await file.arrayBuffer());
    } catch {
      throw new Error("the browser cannot read it any more: it has been moved, changed or removed; open it again");
    }
  }

  /** The next spacing, Å, that needs much less, and fits into a browser: memory goes by its square. */
  function coarser(spacing, megabytes) {
    const fitting = Math.ceil(20 * spacing * Math.sqrt(megabytes / (0.9 * mostMemory))) / 20;
    return Math.max(fitting, spacing < 0.8 ? 0.8 : +(spacing * 1.5).toFixed(2));
  }

  const duration = seconds => seconds < 90 ? `${Math.ceil(seconds)} s` : `${Math.ceil(seconds / 60)} minutes`;

  return App;
})();
