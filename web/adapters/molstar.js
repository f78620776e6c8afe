// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// A surface in Mol* (5.0 or later): a node of its state tree with a mesh, which the viewer hides, selects and removes like
// its own. Hovering names the atom.
import {SCHEMES, checkColouring, vertexColours} from "./colours.js";
import {atomName} from "./names.js";

/**
 * @param {object} plugin Mol*'s PluginContext: `viewer.plugin` of the ready-made viewer
 * @param {import("meniscus-surface").Surface} surface
 * @param {import("./molstar.js").MolstarOptions} options
 * @returns {Promise<import("./molstar.js").MolstarHandle>}
 */
export async function addSurface(plugin, surface, options = {}) {
  const {molstar = globalThis.molstar?.lib?.plugin, colour = "element", opacity = 1, label = "Meniscus surface", ...more} = options;
  if (!molstar) throw new TypeError("Mol* is not there; load its viewer first, or give its parts as options.molstar");
  checkColouring(colour);  // a wrong colour is the caller's error, not one of the state tree
  const {provider, representation} = transformsOf(molstar);
  const shape = plugin.state.data.build().toRoot().apply(provider, {surface, label, ...colourParameters(colour)});
  const drawn = shape.apply(representation, {alpha: opacity, ...more});
  await drawn.commit();
  return new Handle(plugin, surface, shape.ref, drawn.ref);
}

class Handle {
  constructor(plugin, surface, ref, representation) {
    Object.assign(this, {plugin, surface, ref, representation});
  }

  async update({colour, opacity, ...more}) {
    const build = this.plugin.state.data.build();
    if (colour !== undefined) {
      checkColouring(colour);
      build.to(this.ref).update(old => Object.assign(old, colourParameters(colour)));
    }
    build.to(this.representation).update(old => Object.assign(old, opacity === undefined ? {} : {alpha: opacity}, more));
    await build.commit();
  }

  async remove() {
    await this.plugin.state.data.build().delete(this.ref).commit();
  }

  /** The index of the atom that a loci of Mol*'s is about, or null if it is not about this surface. */
  atomOf(loci) {
    const mine = loci.kind === "group-loci" && loci.shape.sourceData.surface === this.surface;
    return mine && loci.groups.length > 0 ? loci.shape.sourceData.atomOf(first(loci.groups[0].ids)) : null;
  }
}

/** The first of one of Mol*'s ordered sets: an array, or an interval whose two ends are packed into one double. */
const first = ids => typeof ids === "number" ? new Int32Array(Float64Array.of(ids).buffer)[0] : ids[0];

/** Mol* can show a scheme in a list; any other colouring stays out of its sight. */
const colourParameters = colour => SCHEMES.includes(colour) ? {scheme: colour, other: null} : {scheme: "other", other: colour};

const known = new WeakMap();

/** Registered once with each copy of Mol*. */
function transformsOf(molstar) {
  if (!known.has(molstar)) known.set(molstar, {
    provider: surfaceProvider(molstar), representation: molstar.StateTransforms.Representation.ShapeRepresentation3D});
  return known.get(molstar);
}

function surfaceProvider({PluginStateTransform, PluginStateObject, StateTransforms}) {
  return PluginStateTransform.BuiltIn({
    name: "meniscus-surface", display: {name: "Meniscus Surface", description: "Solvent-excluded surface"},
    from: PluginStateObject.Root, to: PluginStateObject.Shape.Provider, params: PARAMETERS,
  })({
    canAutoUpdate: () => true,
    isSerializable: () => ({isSerializable: false, reason: "a surface is computed, not saved with a session"}),
    apply: async ({params}) => {
      const box = await emptyBox(StateTransforms);
      const data = {box, surface: params.surface, label: params.label, colour: params.other ?? params.scheme};
      return new PluginStateObject.Shape.Provider({...box, label: params.label, data, getShape: shapeOf}, {label: params.label});
    },
  });
}

const choices = [...SCHEMES.map(scheme => [scheme, scheme[0].toUpperCase() + scheme.slice(1)]), ["other", "As given"]];
const PARAMETERS = {
  surface: {type: "value", defaultValue: null, isHidden: true},
  label: {type: "value", defaultValue: "", isHidden: true},
  other: {type: "value", defaultValue: null, isHidden: true},
  scheme: {type: "select", label: "Colour", defaultValue: "element", options: choices},
};

/**
 * A mesh with everything that Mol* wants of one. Its viewer does not export what makes meshes, but a transform whose result
 * is a box; the arrays of the box are replaced.
 */
function emptyBox({Shape: {BoxShape3D}}) {
  const made = BoxShape3D.definition.apply({params: BoxShape3D.createDefaultParams()});
  return made.run().then(object => object.data);
}

async function shapeOf(context, {box, surface, label, colour}, properties, old) {
  const {id, transforms, geometry} = await box.getShape(context, box.data);
  const colours = vertexColours(surface, colour), {groups, vertices} = groupsOf(surface.atom, colours);
  const atomOf = group => surface.atom[vertices[group]];
  return {
    id, transforms, name: label, sourceData: {surface, atomOf}, groupCount: vertices.length,
    geometry: filled(old?.geometry ?? geometry, surface, groups),
    getColor: group => colours[vertices[group]],
    getSize: () => 1,
    getLabel: group => `${escaped(label)} | <b>${escaped(atomName(surface, atomOf(group)))}</b>`,
  };
}

/** Vertices of one atom and one colour are a group, which Mol* colours, picks and highlights as one. */
function groupsOf(atom, colours) {
  const ids = new Map(), vertices = [];
  const groups = Float32Array.from(atom, (index, vertex) => {
    const key = index * 0x1000000 + colours[vertex];
    if (!ids.has(key)) ids.set(key, vertices.push(vertex) - 1);
    return ids.get(key);
  });
  return {groups, vertices};
}

function filled(mesh, {positions, normals, indices}, groups) {
  const cells = {vertexBuffer: positions, normalBuffer: normals, indexBuffer: indices, groupBuffer: groups, varyingGroup: true};
  for (const [name, value] of Object.entries(cells)) {
    const {ref} = mesh[name];
    mesh[name].ref = {...ref, version: ref.version + 1, value};
  }
  return Object.assign(mesh, {vertexCount: positions.length / 3, triangleCount: indices.length / 3});
}

/** Mol* shows labels as HTML, and names come from a file. */
const escaped = text => text.replace(/[&<>"']/g, character => `&#${character.charCodeAt(0)};`);
