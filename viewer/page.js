// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// A surface in the window: draws, and does what its controls ask for, until another one takes its place.
"use strict";

const Page = (() => {
  const {$} = Panel;
  const patchNames = ["contact", "toroidal", "reentrant"];
  const bodyOpacity = 0.75;  // of pockets
  const seeThrough = 0.35;   // opacity that lets one see what is beneath

  class Page {
    /**
     * data      of Decode.decode()
     * renderer  of Page.renderer(), which several pages may use one after another
     */
    constructor(data, renderer) {
      this.data = data;
      this.info = data.info;
      this.canvas = renderer.domElement;
      this.renderer = renderer;
      this.left = new AbortController();   // what listens, listens until then
      this.scene = new THREE.Scene();
      this.surface = new Surface(data);
      this.pick = new Pick(data);
      const {inPerspective, cut, planeInView} = this.surface.uniforms;
      this.shared = {inPerspective, cut, planeInView};
      this.atoms = new Atoms(data, this.shared, data.stream("colours-" + this.paletteOfAtoms()));
      this.scene.add(this.surface.group, this.atoms.group);
      this.addLigands(data.ligands);
      this.addBodies(data.bodies);
      this.addTubes(data.tubes);
      this.marker = this.makeMarker();
      this.controls = new Controls(this.canvas, this.extent(), this.info.view, () => this.draw(), this.left.signal);
      this.plane = null;
      this.size = this.canvas.clientWidth + " " + this.canvas.clientHeight;
      this.setScheme(this.info.scheme);
      this.fill();
      this.listen();
    }

    /** Ligands are whole or not there, whatever is cut. */
    addLigands(ligands) {
      if (!ligands) return;
      const shared = {...this.shared, cut: {value: false}};
      this.ligands = new Atoms(ligands, shared, this.data.stream("ligand-colours"), ligands.info.stick);
      this.ligands.show("both");
      this.surface.setBeside(true);
      this.scene.add(this.ligands.group);
    }

    addBodies(mesh) {
      if (!mesh) return;
      const colours = this.info.pockets.map(pocket => Surface.rgb(pocket.colour).map(c => Math.round(255 * c)));
      this.bodies = new Bodies(mesh, v => colours[mesh.component[v]], bodyOpacity, this.shared);
      this.surface.setFilled(true);
      this.scene.add(this.bodies.group);
    }

    /** Tunnels are solid, and seen through the bodies of pockets. */
    addTubes(mesh) {
      if (!mesh) return;
      const planes = this.data.stream("tube-colours"), n = mesh.component.length;
      this.tubes = new Bodies(mesh, v => [planes[v], planes[n + v], planes[2 * n + v]], 1, this.shared);
      this.tubes.order(3);
      this.surface.setFilled(true);
      this.scene.add(this.tubes.group);
    }

    /** What the first view shows: the surface with what is beside it, or the atoms if there is no surface. */
    extent() {
      const {mesh, atoms, ligands, tubes} = this.data;
      if (mesh.points.length === 0) return {points: atoms.points, margin: 2};
      const shown = [mesh.points, ...(ligands ? [ligands.atoms.points] : []), ...(tubes ? [tubes.points] : [])];
      if (shown.length === 1) return {points: mesh.points, margin: 0};
      const points = new Float32Array(shown.reduce((sum, part) => sum + part.length, 0));
      shown.reduce((place, part) => {
        points.set(part, place);
        return place + part.length;
      }, 0);
      return {points, margin: 0};
    }

    /** Elements where they are told apart, else what the page shows first. */
    paletteOfAtoms() {
      const schemes = this.info.schemes.filter(s => s.kind === "atom");
      return (schemes.find(s => s.id === "element") || schemes[0]).id;
    }

    makeMarker() {
      const marker = new THREE.Mesh(new THREE.SphereBufferGeometry(0.25, 24, 16),
                                    new THREE.MeshBasicMaterial({color: 0xe60d59}));
      marker.visible = false;
      marker.renderOrder = 5;
      this.scene.add(marker);
      return marker;
    }

    fill() {
      Panel.fillSchemes(this.info.schemes, this.info.scheme);
      // Pockets are drawn with closed cavities among them, which then stand in one list.
      const listed = this.info.bodies || (this.info.pockets || []).some(pocket => pocket.cavity);
      Panel.fillCavities(listed ? [] : this.info.cavities, this.info.ligandsLeftOut, i => this.flyToCavity(i));
      Panel.fillPockets(this.info.pockets || [], i => this.flyToPocket(i));
      const ways = this.info.ways ? this.info.ways.list : [];
      Panel.fillWays(ways, i => this.flyToWay(i));
      if (ways.length > 0) Panel.plotWay(ways[0], this.info.ways.scale);
      for (const [id, bodies] of [["body-row", this.bodies], ["tube-row", this.tubes]]) $(id).hidden = !bodies;
      for (const id of ["bodies", "tubes"]) $(id).checked = true;
      if (this.bodies || this.tubes) this.setOpacity(100 * seeThrough);
      const {grouped} = Panel;
      $("subtitle").textContent = `${grouped(this.info.atoms.count)} atoms · ${grouped(this.info.triangles)} triangles`;
      $("perspective").checked = this.controls.inPerspective;
      $("ligand-row").hidden = !this.ligands;
      $("ligand-names").textContent = this.ligands ? this.data.ligands.info.text : "";
      $("ligands").checked = true;
    }

    // Drawing: once per frame, and only if something has changed.

    draw() {
      if (this.waiting || this.left.signal.aborted) return;
      this.waiting = requestAnimationFrame(() => this.drawNow());
    }

    drawNow() {
      cancelAnimationFrame(this.waiting);
      this.waiting = 0;
      const {renderer, canvas, controls} = this;
      if (!this.fits()) {
        renderer.setPixelRatio(this.ratio());
        renderer.setSize(canvas.clientWidth, canvas.clientHeight, false);
      }
      controls.place();
      this.surface.uniforms.inPerspective.value = controls.inPerspective;
      this.planeForView(controls.camera);
      renderer.render(this.scene, controls.camera);
    }

    ratio() { return Math.min(devicePixelRatio || 1, 2); }

    /** Whether the picture is as large as its place. */
    fits() {
      const {width, height, clientWidth, clientHeight} = this.canvas, ratio = this.ratio();
      return width === Math.round(clientWidth * ratio) && height === Math.round(clientHeight * ratio);
    }

    /** Called at the beginning, too, when there is nothing to do. */
    resize() {
      const {clientWidth, clientHeight} = this.canvas, size = clientWidth + " " + clientHeight;
      if (size !== this.size) this.controls.refit();
      this.size = size;
    }

    planeForView(camera) {
      if (!this.plane) return;
      const plane = new THREE.Plane(this.plane.normal.clone(), this.plane.constant);
      plane.applyMatrix4(camera.matrixWorldInverse);
      this.shared.planeInView.value.set(plane.normal.x, plane.normal.y, plane.normal.z, plane.constant);
    }

    // What the controls ask for.

    setScheme(id) {
      const scheme = this.info.schemes.find(s => s.id === id);
      $("scheme").value = id;
      this.surface.setScheme(scheme);
      const isListed = scheme.kind === "class" && this.info.pockets;   // with the same colours
      Panel.showLegend(isListed ? {ramp: [], entries: []}
                       : scheme.kind === "component" ? this.legendOfPieces(scheme) : scheme.legend);
      this.draw();
    }

    /** With the numbers that the list of cavities has. */
    legendOfPieces(scheme) {
      const cavities = this.info.cavities.map((c, i) => ["cavity " + (i + 1), scheme.colours[c.component]]);
      const outer = scheme.legend.entries.filter(([label]) => label === "outer");
      return {...scheme.legend, entries: [...outer, ...cavities.filter(([, colour]) => colour)]};
    }

    /** As the list of schemes asks: cavities are not seen through a solid surface. */
    chooseScheme(id) {
      this.setScheme(id);
      if (id === "component" && !this.plane && this.surface.opacity === 1) this.setOpacity(100 * seeThrough);
    }

    setOpacity(percent) {
      $("opacity").value = percent;
      $("opacity-text").textContent = percent + " %";
      this.surface.setOpacity(percent / 100);
      // Before a surface through which they are seen, or after one that shines through them.
      if (this.bodies) this.bodies.order(percent < 100 ? 6 : 20);
      this.draw();
    }

    setAtoms(how) {
      $("atoms-" + how).checked = true;
      this.atoms.show(how);
      if (how !== "none" && this.surface.opacity === 1) this.setOpacity(100 * seeThrough);
      else if (how === "none" && this.surface.opacity < 0.1) this.setOpacity(100);
      this.draw();
    }

    showLigands(shown) {
      this.ligands.show(shown ? "both" : "none");
      this.surface.setBeside(shown);
      this.draw();
    }

    showBodies() {
      const pockets = this.bodies && $("bodies").checked, tunnels = this.tubes && $("tubes").checked;
      if (this.bodies) this.bodies.show(pockets);
      if (this.tubes) this.tubes.show(tunnels);
      this.surface.setFilled(Boolean(pockets || tunnels));
      this.draw();
    }

    /** Leaves out the ligands of which the cut keeps no atom. */
    cutLigands() {
      if (!this.ligands) return;
      const {points: p, residue, count} = this.data.ligands.atoms, kept = new Set(), {plane} = this;
      for (let i = 0; i < count; ++i)
        if (!plane || plane.normal.dot(new THREE.Vector3(p[3 * i], p[3 * i + 1], p[3 * i + 2])) + plane.constant <= 0)
          kept.add(residue[i]);
      this.isThere = i => kept.has(residue[i]);
      this.ligands.restrict(this.isThere);
    }

    /** 0 is no cut; 1 cuts everything away. Across the view at the time it was begun. */
    setCut(share) {
      $("clip").value = Math.round(1000 * share);
      if (share > 0 && !this.cutAxis) this.cutAxis = this.controls.view.axis(0, 0, 1);
      if (share === 0) this.cutAxis = null;
      $("align").disabled = share === 0;
      this.plane = null;
      if (share > 0) {
        const [low, high] = this.controls.extent(this.cutAxis);
        this.plane = {normal: this.cutAxis, constant: -(high - share * (high - low))};
      }
      this.surface.setPlane(this.plane);
      this.cutLigands();
      this.draw();
    }

    alignCut() {
      if (!this.cutAxis) return;
      this.cutAxis = this.controls.view.axis(0, 0, 1);
      this.setCut($("clip").value / 1000);
    }

    flyToCavity(i) {
      const cavity = this.info.cavities[i];
      const point = new THREE.Vector3(...cavity.centre.map((c, k) => c - this.info.low[k]));
      if (!this.plane && this.surface.opacity > seeThrough) this.setOpacity(100 * seeThrough);
      if (this.plane) this.cutThrough(point);
      this.surface.mark(null);
      this.surface.markComponent(cavity.component);
      this.marker.visible = false;
      this.unmarkLists();
      Panel.markCavity(i);
      Panel.showFacts("Cavity " + (i + 1), [["volume", Panel.grouped(cavity.volume, 1) + " Å³"],
                                            ["area", Panel.grouped(cavity.area, 1) + " Å²"], ["lined by", cavity.lining]]);
      this.controls.lookAt(point, Math.max(4, 3 * cavity.radius));
    }

    flyToPocket(i) {
      const pocket = this.info.pockets[i], {grouped} = Panel;
      const point = new THREE.Vector3(...pocket.centre.map((c, k) => c - this.info.low[k]));
      if (pocket.cavity && !this.plane && this.surface.opacity > seeThrough) this.setOpacity(100 * seeThrough);
      if (this.plane) this.cutThrough(point);
      this.forget();
      Panel.markPocket(i);
      if (this.bodies) this.bodies.mark(i);
      const holes = (number, area) => number ? `${number}, ${grouped(area, 1)} Å²` : "none";
      Panel.showFacts("Pocket " + pocket.name, [["score", Panel.plain(pocket.score, 2)], ["volume", grouped(pocket.volume, 1) + " Å³"],
                                                ["wall", grouped(pocket.area, 1) + " Å²"], ["depth", Panel.plain(pocket.depth, 1) + " Å"],
                                                ["mouths", pocket.cavity ? "none, a closed cavity" : holes(pocket.mouths, pocket.mouthArea)],
                                                ["opens further in", pocket.cavity ? "" : holes(pocket.openings, pocket.openingArea)],
                                                ["ligand", pocket.ligand], ["lined by", pocket.lining]]);
      this.controls.lookAt(point, Math.max(6, 2.5 * Math.cbrt(pocket.volume * 3 / (4 * Math.PI))));
    }

    flyToWay(i) {
      const {list, scale} = this.info.ways, way = list[i];
      const point = new THREE.Vector3(...way.bottleneck.map((c, k) => c - this.info.low[k]));
      if (!this.plane && this.surface.opacity > seeThrough) this.setOpacity(100 * seeThrough);
      if (this.plane) this.cutThrough(point);
      this.forget();
      Panel.markWay(i);
      Panel.plotWay(way, scale);
      Panel.showFacts(way.name[0].toUpperCase() + way.name.slice(1),
                      [["narrowest", Panel.plain(way.radius, 3) + " Å"],
                       ["at", Panel.plain(way.distance, 1) + " of " + Panel.plain(way.length, 1) + " Å"],
                       ["curvature", Panel.plain(way.curvature, 2)], ["atoms there", way.atoms]]);
      const along = new THREE.Vector3(...way.end).sub(new THREE.Vector3(...way.begin));
      this.controls.lookAt(point, Math.max(10, 4 * way.radius), this.controls.aside(along));
    }

    cutThrough(point) {
      const [low, high] = this.controls.extent(this.cutAxis);
      this.setCut(Math.min(1, Math.max(0.001, (high - this.cutAxis.dot(point)) / (high - low))));
    }

    // Asking what a point is.

    /** The first atom that is shown on a ray: {of, atom, distance}, or null. */
    lookAtAtoms(ray) {
      const {data, plane, isThere} = this, how = this.atoms.shown, found = [];
      const look = (of, options) => {
        const ball = this.pick.atom(ray, of.atoms, options);
        if (ball) found.push({of, ...ball});
      };
      if (how && how !== "none")
        look(data, {scale: Atoms.scale, fixed: how === "sticks" ? 1.5 * Atoms.thickness : 0, plane});
      if (this.ligands && this.ligands.shown !== "none") look(data.ligands, {scale: 1.2, isThere});
      return found.reduce((first, ball) => !first || ball.distance < first.distance ? ball : first, null);
    }

    /**
     * What is seen at a point of the window: {of, atom, point, hit}, or null. of: what has the atom, the page's data or
     * its ligands. Atoms are preferred to a surface through which they are seen.
     */
    look(x, y) {
      const ray = this.controls.ray(x, y), {plane, data} = this;
      const at = distance => ray.origin.clone().addScaledVector(ray.direction, distance);
      const cavities = {from: this.surface.outer.count, plane};
      const hit = this.pick.surface(ray, this.surface.opacity > 0 ? {plane} : cavities);
      const isSolid = this.surface.opacity === 1;
      const solid = isSolid ? hit : this.surface.cavityOpacity === 1 ? this.pick.surface(ray, cavities) : null;
      const ball = this.lookAtAtoms(ray);
      if (ball && (!solid || ball.distance < solid.distance))
        return {of: ball.of, atom: ball.atom, point: at(ball.distance), hit: null};
      if (!hit || (plane && !hit.front)) return null;
      const point = at(hit.distance);
      return {of: data, atom: this.pick.atomAt(hit, point), point, hit};
    }

    ask(x, y) {
      const seen = this.look(x, y);
      if (!seen) return this.forget();
      const {data} = this, {residue} = data.atoms, isLigand = seen.of !== data;
      this.unmarkLists();
      this.surface.markComponent(null);
      Panel.showFacts(Panel.atomTitle(seen.of, seen.atom), this.facts(seen));
      this.marker.position.copy(seen.point);
      this.marker.visible = true;
      this.surface.mark(isLigand ? null : i => residue[i] === residue[seen.atom]);
      this.draw();
    }

    facts({of, atom, hit, point}) {
      const {atoms} = of, {mesh, info} = this.data, {name, chain} = Panel.residueOf(of, atom);
      const facts = [
        ["atom", Panel.atomName(of, atom) + " (" + (of.info.atoms.elements[atoms.element[atom]] || "?") + ")"],
        ["residue", name], ["chain", chain], ["serial", String(atoms.serial[atom])],
        of === this.data ? ["radius", Panel.plain(atoms.radius[atom], 2) + " Å"]
                         : ["ligand", of.info.inSurface ? "part of the surface" : "beside the surface"],
      ];
      if (hit) {
        const v = this.pick.corner(hit), component = mesh.component[v];
        const cavity = info.cavities.findIndex(c => c.component === component);
        facts.push(["patch", patchNames[mesh.patch[v]]],
                   ["part of", cavity >= 0 ? "cavity " + (cavity + 1)
                     : hit.triangle >= this.surface.outer.count ? "a cavity" : "outer surface"]);
        if (mesh.curvature) facts.push(["mean curvature", Panel.plain(this.pick.at(hit, mesh.curvature), 3) + " Å⁻¹"]);
        if (mesh.shape) {
          const index = this.pick.at(hit, mesh.shape);
          facts.push(["shape index", Panel.plain(index, 2) + " (" + Panel.shapeWord(index) + ")"]);
        }
        if (mesh.depth) facts.push(["depth", this.depthAt(hit)]);
        info.values.forEach(({name, step, low}, i) => {
          if (mesh.values[i][v] >= 0) facts.push([name, Panel.short(mesh.values[i][v] * step + low)]);
        });
      }
      if (atoms.bFactor[atom] !== 0) facts.push(["B factor", Panel.plain(atoms.bFactor[atom], 2)]);
      facts.push(["position", point.toArray().map((c, k) => Panel.plain(c + info.low[k], 2)).join("  ")]);
      return facts;
    }

    depthAt(hit) {
      const steps = this.pick.at(hit, this.data.mesh.depth);   // 255 stands for more
      return (steps > 254 ? "over " : "") + Panel.plain(steps * this.info.depthStep, 1) + " Å";
    }

    forget() {
      $("picked").hidden = true;
      this.marker.visible = false;
      this.surface.mark(null);
      this.surface.markComponent(null);
      this.unmarkLists();
      this.draw();
    }

    unmarkLists() {
      Panel.markCavity(-1);
      Panel.markPocket(-1);
      Panel.markWay(-1);
      if (this.bodies) this.bodies.mark(-1);
    }

    hover(e) {
      if (e.pointerType !== "mouse" || e.buttons !== 0 || this.hovering) return;
      this.hovering = requestAnimationFrame(() => {
        this.hovering = 0;
        const seen = this.look(e.clientX, e.clientY);
        Panel.showTip(seen ? Panel.atomTitle(seen.of, seen.atom) : "", e.clientX, e.clientY);
      });
    }

    // The page around the surface.

    setTheme(theme) {
      document.documentElement.dataset.theme = theme;
      const style = getComputedStyle(document.documentElement);
      this.renderer.setClearColor(new THREE.Color(style.getPropertyValue("--paper").trim()), 1);
      this.surface.uniforms.inside.value.set(theme === "dark" ? 0x6b6862 : 0xcfc8bd);
      this.draw();
    }

    toggleTheme() { this.setTheme(document.documentElement.dataset.theme === "dark" ? "light" : "dark"); }

    togglePanel() {
      const folded = document.body.classList.toggle("folded");
      $("toggle").setAttribute("aria-expanded", String(!folded));
      this.draw();
    }

    save() {
      this.drawNow();
      this.canvas.toBlob(blob => Panel.download(blob, this.info.name + ".png"));
    }

    /** The first view in another size, before nothing: a PNG, as a promise of a Blob. */
    still(width, height) {
      const {renderer, canvas, controls} = this, view = controls.view, colour = renderer.getClearColor().clone();
      renderer.setPixelRatio(1);
      renderer.setSize(width, height, false);
      renderer.setClearColor(colour, 0);
      controls.view = controls.firstView(width / height);
      controls.place(width / height);
      renderer.render(this.scene, controls.camera);
      const made = new Promise(resolve => canvas.toBlob(resolve));
      renderer.setClearColor(colour, 1);
      controls.view = view;
      this.drawNow();
      return made;
    }

    listen() {
      const {signal} = this.left;
      const on = (id, name, f) => $(id).addEventListener(name, f, {signal});
      on("scheme", "change", () => this.chooseScheme($("scheme").value));
      on("opacity", "input", () => this.setOpacity(+$("opacity").value));
      for (const how of ["none", "sticks", "spheres"]) on("atoms-" + how, "change", () => this.setAtoms(how));
      on("ligands", "change", () => this.showLigands($("ligands").checked));
      for (const id of ["bodies", "tubes"]) on(id, "change", () => this.showBodies());
      on("clip", "input", () => this.setCut($("clip").value / 1000));
      on("align", "click", () => this.alignCut());
      on("perspective", "change", () => {
        this.controls.inPerspective = $("perspective").checked;
        this.draw();
      });
      on("reset", "click", () => this.controls.reset());
      on("save", "click", () => this.save());
      on("theme", "click", () => this.toggleTheme());
      on("toggle", "click", () => this.togglePanel());
      on("unpick", "click", () => this.forget());
      on("view", "pointermove", e => this.hover(e));
      on("view", "pointerleave", () => Panel.showTip(""));
      on("view", "pointerdown", () => Panel.showTip(""));
      on("view", "dblclick", e => this.approach(e));
      this.controls.clicked = e => this.ask(e.clientX, e.clientY);
      document.addEventListener("keydown", e => this.key(e), {signal});
      const sizes = new ResizeObserver(() => this.resize());
      sizes.observe($("stage"));
      signal.addEventListener("abort", () => sizes.disconnect());
      this.setCut(0);
      const dark = matchMedia("(prefers-color-scheme: dark)");
      dark.addEventListener("change", () => this.setTheme(dark.matches ? "dark" : "light"), {signal});
      this.setTheme(document.documentElement.dataset.theme || (dark.matches ? "dark" : "light"));
    }

    /** Makes room for another page: nothing is drawn any more, and the graphics card forgets the molecule. */
    dispose() {
      this.left.abort();
      this.controls.stop();
      cancelAnimationFrame(this.waiting);
      cancelAnimationFrame(this.hovering);
      this.surface.dispose();
      this.scene.traverse(({geometry, material}) => {
        if (geometry) geometry.dispose();
        if (material) material.dispose();
      });
    }

    approach(e) {
      const seen = this.look(e.clientX, e.clientY);
      if (seen) this.controls.lookAt(seen.point, Math.min(this.controls.view.half, 10));
    }

    key(e) {
      if (e.ctrlKey || e.metaKey || e.altKey || /^(SELECT|INPUT)$/.test(e.target.tagName)) return;
      const actions = {r: () => this.controls.reset(), s: () => this.save(), d: () => this.toggleTheme(),
                       p: () => this.togglePanel(), Escape: () => this.forget()};
      if (e.key in actions) actions[e.key]();
    }
  }

  /** Of the canvas; a second getContext() with it answers with the same. */
  Page.context = {antialias: true, preserveDrawingBuffer: false};

  /** three.js lies compressed in the page; its fingerprint is in the page's policy. */
  Page.loadThree = async () => {
    const script = document.createElement("script");
    script.textContent = new TextDecoder().decode(await Decode.embedded("three"));
    document.head.append(script);
  };

  /** What draws; three.js must be there. */
  Page.renderer = () => {
    const canvas = $("view"), context = canvas.getContext("webgl2", Page.context);
    if (!context) throw new Error("this browser has no WebGL 2");
    return new THREE.WebGLRenderer({canvas, context});
  };

  return Page;
})();
