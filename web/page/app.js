// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// meniscus.html: takes files, has the engine compute their surfaces in a worker, and shows them as pages do.
"use strict";

const App = (() => {
  const {$, plain} = Panel;

  const stages = {read: "Reading the file", estimate: "Estimating", geometry: "Rolling the probe over the atoms",
                  exact: "Measuring exactly", interfaces: "Measuring between chains", band: "Laying out the grid",
                  flow: "Letting the surface flow", mesh: "Making the mesh", page: "Lighting the picture"};

  // What lights the picture and packs it for the viewer takes so long per vertex (docs/design/portable.md).
  const secondsPerVertex = 7.5e-6;

  // What is asked about before it is begun, and what a browser cannot hold at all.
  const longWait = 60;          // seconds
  const muchMemory = 1500;      // MB
  const mostMemory = 3500;      // MB: WebAssembly addresses 4 GB
  const kept = 3;               // surfaces that the engine holds for saving, the last ones shown

  const isAbort = error => error.name === "AbortError";

  class App {
    /** engine: Meniscus; example: () => File */
    constructor(engine, example) {
      this.engine = engine;
      this.example = example;
      this.items = [];
      this.current = null;
      this.page = null;
      this.held = [];
      this.listen();
      this.list();
      document.body.dataset.ready = "true";
    }

    // Files.

    /** Takes files in and shows the first of them. */
    open(files) {
      const items = [...files].map(file => ({file, name: file.name, state: "waiting", text: ""}));
      if (items.length === 0) return;
      this.items.push(...items);
      this.choose(items[0]);
    }

    choose(item) {
      if (this.run && this.run.item === item) return;
      this.current = item;
      this.list();
      return this.isUpToDate(item) ? this.show(item) : this.compute(item);
    }

    /** The options as text, to tell whether they have changed; throws as Settings.read(). */
    asked() { return JSON.stringify(Settings.read()); }

    /** Whether an item has been computed with the options of the form. Options that make no sense are said when they are used. */
    isUpToDate(item) {
      try {
        return Boolean(item.content) && item.asked === this.asked();
      } catch {
        return false;
      }
    }

    // Computing. this.run is what is being computed: {item, stopped}; stopped: AbortController.

    begin(item) {
      this.stop();
      return this.run = {item, stopped: new AbortController()};
    }

    async compute(item) {
      this.closeNotices();
      const run = this.begin(item);
      this.progress({stage: "read", fraction: 0});
      Object.assign(item, {state: "running", text: "…"});
      this.list();
      try {
        await this.agreed(item);
        if (this.run !== run) return;
        await this.surfaceOf(item, Settings.read());
        if (this.run !== run) return;
        this.finish(item);
      } catch (error) {
        if (this.run === run) this.fail(item, error);
      } finally {
        if (this.run === run) this.run = null;
        if (!this.run) $("busy").hidden = true;
        this.list();
      }
    }

    /** Asks first where it would take long; rejects where that is declined, or what is asked for cannot be. */
    async agreed(item) {
      const options = Settings.read(), {signal} = this.run.stopped;
      const cost = await this.engine.estimate(await bytesOf(item), {...options, name: item.name, signal});
      cost.seconds += secondsPerVertex * cost.vertices;
      item.expected = cost.seconds >= 5 ? `, about ${duration(cost.seconds)} in all` : "";
      if (cost.seconds <= longWait && cost.megabytes <= muchMemory) return;
      const answer = await this.question(item, cost, options.spacing);
      if (answer === "no") throw Object.assign(new Error("left"), {name: "AbortError"});
      if (answer === "coarse") $("spacing").value = coarser(options.spacing);
      for (const other of this.held) this.release(other);   // it may need their memory
    }

    /** The live surface of an item, computed again where the engine no longer holds it. */
    async surfaceOf(item, options) {
      const asked = JSON.stringify(options), {signal} = this.run.stopped;
      if (item.surface && item.asked === asked) return item.surface;
      this.release(item);
      const surface = await this.engine.surface(await bytesOf(item), {
        ...options, name: item.name, signal, progress: p => this.progress(p)});
      this.progress({stage: "page", fraction: 0});
      item.content = await surface.page({});
      Object.assign(item, {surface, asked, report: surface.report, notes: surface.notes, warnings: surface.warnings,
                           interfaces: surface.interfaces});
      this.hold(item);
      return surface;
    }

    hold(item) {
      this.held.push(item);
      while (this.held.length > kept) this.release(this.held[0]);
    }

    release(item) {
      if (item.surface) item.surface.close();
      item.surface = null;
      this.held = this.held.filter(other => other !== item);
    }

    /** Ends what is being computed; the engine forgets its surfaces, and pages stay what they are. */
    stop() {
      if (!this.run) return;
      const {item, stopped} = this.run;
      this.run = null;
      stopped.abort();   // also where a file is still being read
      this.engine.stop();
      for (const other of this.held) other.surface = null;
      this.held = [];
      if (!item.content) Object.assign(item, {state: "stopped", text: "stopped"});
      $("busy").hidden = true;
      this.list();
    }

    finish(item) {
      Object.assign(item, {state: "ready", text: item.report.input.atoms.toLocaleString("en") + " atoms"});
      if (item === this.current) this.show(item);
    }

    fail(item, error) {
      if (isAbort(error)) return Object.assign(item, {state: "stopped", text: "stopped"});
      Object.assign(item, {state: "failed", text: "failed"});
      this.complain(item.name, error);
    }

    complain(title, error) {
      console.warn(error);
      $("failure-title").textContent = title;
      $("failure-text").textContent = error.message;
      $("failure").hidden = false;
    }

    closeNotices() {
      $("failure").hidden = true;
      if (this.answer) this.answer("no");
    }

    question(item, {atoms, seconds, megabytes}, spacing) {
      const possible = megabytes <= mostMemory, gigabytes = plain(megabytes / 1024, 1);
      $("busy").hidden = true;
      $("question-title").textContent = possible ? "This one takes a while" : "Too large for a browser at this spacing";
      $("question-text").textContent =
        `${item.name} has ${atoms.toLocaleString("en")} atoms. At a spacing of ${spacing} Å they take about ` +
        `${duration(seconds)} and ${gigabytes} GB of memory` +
        (possible ? "." : "; a page has 4 GB at most. A coarser mesh needs less, and the exact numbers stay the same.");
      $("question-go").hidden = !possible;
      $("question-coarse").textContent = `Use ${coarser(spacing)} Å`;
      $("question").hidden = false;
      $(possible ? "question-go" : "question-coarse").focus();
      return new Promise(resolve => {
        this.answer = answer => {
          this.answer = null;
          $("question").hidden = true;
          $("busy").hidden = false;
          resolve(answer);
        };
      });
    }

    progress({stage, fraction}) {
      const text = (stages[stage] || stage) + (this.run && this.run.item.expected || "");
      $("busy").hidden = false;
      if ($("busy-text").textContent !== text) $("busy-text").textContent = text;   // read aloud once
      $("progress").value = fraction;
    }

    // Showing.

    show(item) {
      this.closeNotices();
      const data = Decode.decode(item.content.data), theme = document.documentElement.dataset.theme;
      if (this.page) this.page.dispose();
      document.body.classList.remove("empty");
      this.renderer = this.renderer || Page.renderer();
      this.page = new Page(data, this.renderer);
      if (theme) this.page.setTheme(theme);
      document.title = item.content.title;
      $("name").textContent = data.info.name;
      $("view").setAttribute("aria-label", `The surface of ${data.info.name}. Drag or use the arrow keys to rotate it.`);
      Tables.numbers(data.info.rows, item.report.exact ? item.report.exact.errors : {});
      Tables.keyNumbers(item.report, data.info.cavities.length);
      Tables.interfaces(item.interfaces);
      Tables.remarks(item);
      $("settings").open = false;
      this.shown = item;
      this.list();
      this.page.forget();
      this.page.drawNow();
      document.body.dataset.shown = item.name;
    }

    list() {
      Tables.files(this.items, this.current, item => this.choose(item));
      this.offer();
    }

    /** Offers to compute again where the options are others than those of what is shown. */
    offer() {
      const item = this.current;
      $("compute").hidden = !item || Boolean(this.run);
      if (!item) return;
      $("compute").textContent = item.content ? "Compute again" : "Compute";
      $("compute").disabled = this.isUpToDate(item);
    }

    // Saving.

    async save(kind) {
      const item = this.shown, name = item.name.replace(/\.gz$/i, "").replace(/\.[^.]*$/, "") || "surface";
      if (kind === "png") return this.page.save();
      try {
        if (kind === "html") return Panel.download(new Blob([await this.asPage(item)], {type: "text/html"}), name + ".html");
        const before = this.run, surface = item.surface || await this.again(item);
        const bytes = await surface.file(kind);
        if (this.run === before) $("busy").hidden = !this.run;
        Panel.download(new Blob([bytes]), kind === "report.json" ? name + ".json" : `${name}.${kind}`);
      } catch (error) {
        if (!isAbort(error)) this.complain("Saving", error);
      }
    }

    /** A surface that the engine has forgotten, with the options that it had. */
    async again(item) {
      const run = this.begin(item);
      try {
        return await this.surfaceOf(item, JSON.parse(item.asked));
      } finally {
        if (this.run === run) this.run = null;
        $("busy").hidden = true;
        this.list();
      }
    }

    async asPage(item) {
      const {title, data} = item.content, {info} = this.page;
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
      on("stop", "click", () => this.stop());
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
      try {
        this.asked();
      } catch (error) {
        return this.complain("Options", error);
      }
      if (this.current) this.compute(this.current);
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
        this.open(e.dataTransfer.files);
      });
    }
  }

  const bytesOf = async item => new Uint8Array(await item.file.arrayBuffer());

  /** The next spacing, Å, that needs much less. */
  const coarser = spacing => spacing < 0.8 ? 0.8 : +(spacing * 1.5).toFixed(2);

  const duration = seconds => seconds < 90 ? `${Math.ceil(seconds)} s` : `${Math.ceil(seconds / 60)} minutes`;

  return App;
})();
