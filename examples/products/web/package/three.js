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
  const corners = positions.length / 3;
  return firstOfEqual(arrays, corners - (corners % 3));
}

// Of each of so many rows of numbers the first that is equal, by a table of hashes.
function firstOfEqual(arrays, count) {
  const slots = new Int32Array(2 ** Math.ceil(Math.log2(2 * count + 2))).fill(-1), last = slots.length - 1;
  const hash = hashOf(arrays);
  const areEqual = (a, b) => arrays.every(([array, size]) => {
    for (let k = 0; k < size; ++k) if (array[size * a + k] !== array[size * b + k]) return false;
    return true;
  });
  return Uint32Array.from({ length: count }, (_, row) => {
    let slot = hash(row) & last;
    while (slots[slot] >= 0 && !areEqual(slots[slot], row)) slot = (slot + 1) & last;
    if (slots[slot] < 0) slots[slot] = row;
    return slots[slot];
  });
}

function hashOf(arrays) {
  const number = new Float64Array(1), words = new Uint32Array(number.buffer);
  return (row) => {
    let hash = 0;
    for (const [array, size] of arrays)
      for (let i = size * row; i < size * (row + 1); ++i) {
        number[0] = array[i] + 0; // not -0
        hash = Math.imul(hash ^ words[0], 0x9e3779b1);
        hash = Math.imul(hash ^ (hash >>> 15) ^ words[1], 0x85ebca6b);
      }
    return hash ^ (hash >>> 13);
  };
}

const shortest = (indices, vertices) => (vertices <= 65535 ? Uint16Array.from(indices) : indices);
