// A modifier for geometries of three.js, with the signature of the one that three.js has in its addons.

import { BufferAttribute, BufferGeometry } from "three";
import { load } from "./index.js";
import { attributesOf, writtenAttributes } from "./three_attributes.js";
import { groupLabels, groupsOf } from "./three_groups.js";

let shared = null; // the module of all modifiers that bring none

function sharedModule() {
  shared ??= load().catch((error) => {
    shared = null;
    throw error;
  });
  return shared;
}

/** See three.d.ts. */
export class SimplifyModifier {
  #quadrille;
  #options;
  #attributes;

  constructor({ quadrille, attributes = {}, ...options } = {}) {
    this.#quadrille = quadrille;
    this.#options = options;
    this.#attributes = attributes;
  }

  async modify(geometry, count) {
    requireArguments(geometry, count);
    return simplified(await (this.#quadrille ?? sharedModule()), geometry, count, this.#options, this.#attributes);
  }
}

function requireArguments(geometry, count) {
  if (!geometry?.isBufferGeometry) throw new TypeError("quadrille: the geometry is not a BufferGeometry of three.js");
  if (geometry.isInstancedBufferGeometry) throw new TypeError("quadrille: an InstancedBufferGeometry cannot be simplified: modify the geometry that it repeats");
  if (geometry.getAttribute("position")?.itemSize !== 3) throw new TypeError("quadrille: the geometry has no positions of three coordinates");
  if (typeof count !== "number" || !(count >= 0)) throw new TypeError(`quadrille: the count of vertices to remove is ${count}, not a number of at least 0`);
}

function simplified(quadrille, geometry, count, options, attributeOptions) {
  const sources = attributesOf(geometry, attributeOptions), indices = indicesOf(geometry, sources);
  const { labels, groupsOfLabel } = groupLabels(geometry, indices.length / 3);
  const mesh = { positions: sources.positions, indices, attributes: sources.attributes, ...(labels && { labels }) };
  const result = quadrille.simplify(mesh, { splitVertices: true, ...target(indices, count, options), ...options });
  const simple = new BufferGeometry();
  simple.name = geometry.name;
  simple.setIndex(new BufferAttribute(shortest(result.indices, result.positions.length / 3), 1));
  writtenAttributes(geometry, sources, result, simple);
  for (const { start, count, materialIndex } of groupsOf(geometry, result.labels, groupsOfLabel)) simple.addGroup(start, count, materialIndex);
  return simple;
}

const targets = ["faces", "ratio", "vertices", "error", "relativeError", "tolerance", "costLimit"];

// As many triangles as three.js leaves: the fraction of the vertices, once those that are equal are one.
function target(indices, count, options) {
  if (targets.some((name) => options[name] !== undefined && options[name] !== null)) return {};
  const vertices = new Set(indices).size, ratio = Math.max(0, 1 - count / Math.max(vertices, 1));
  return { faces: Math.max(Math.floor((indices.length / 3) * ratio), Math.min(1, indices.length)) };
}

// A geometry without an index has a vertex for each corner; those that are equal in all attributes are one.
function indicesOf(geometry, { positions, attributes }) {
  const index = geometry.getIndex();
  if (index) return Uint32Array.from({ length: index.count - (index.count % 3) }, (_, i) => index.getX(i));
  const arrays = [[positions, 3], ...Object.values(attributes).map(({ values, components }) => [values, components])];
  const firsts = new Map(), corners = positions.length / 3;
  return Uint32Array.from({ length: corners - (corners % 3) }, (_, corner) => {
    const key = arrays.map(([array, size]) => array.subarray(size * corner, size * (corner + 1)).join()).join(";");
    if (!firsts.has(key)) firsts.set(key, corner);
    return firsts.get(key);
  });
}

const shortest = (indices, vertices) => (vertices <= 65535 ? Uint16Array.from(indices) : indices);
