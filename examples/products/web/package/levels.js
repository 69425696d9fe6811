// Levels of detail: what one run has recorded, and each level of it.

import { attributesLike, integersLike, realsLike } from "./arrays.js";
import { existing } from "./instance.js";

const stops = ["faces", "vertices", "error", "distance", "contractions"];

const isCount = (stop) => stop !== "error" && stop !== "distance";

export class Levels {
  #instance;
  #address;
  #input = null; // the forms of what was recorded
  #isRecording = false;

  constructor(instance) {
    this.#instance = instance;
    this.#address = existing(instance.exports.newLevels());
    registry.register(this, { instance, address: this.#address }, this);
  }

  get isEmpty() {
    return this.#input === null;
  }
  get finest() {
    return this.info({ contractions: 0 });
  }
  get coarsest() {
    return this.info({ faces: 0 });
  }

  info(stop) {
    return this.#find(stop, false);
  }
  at(stop) {
    const info = this.#find(stop, true);
    try {
      return { ...info, ...this.#arrays() };
    } finally {
      this.#instance.exports.forgetLevel(this.#address);
    }
  }

  free() {
    if (this.#address === 0) return;
    this.#requireFree();
    registry.unregister(this);
    this.#instance.exports.deleteLevels(this.#address);
    this.#address = 0;
    this.#input = null;
  }

  /** Whether these are levels of that module. Called by simplify(), as the next. */
  belongsTo(instance) {
    return this.#instance === instance;
  }
  /** Calls a task that records into the address that it is given. */
  record({ positions, indices, labels, attributes }, task) {
    this.#requireFree();
    this.#isRecording = true;
    try {
      const done = task(this.#address);
      const like = (array) => array && array.slice(0, 0);
      this.#input = {
        positions: like(positions),
        indices: like(indices),
        labels: labels && integersLike(labels, labels, Infinity),
        attributes: attributes.map(({ name, components, values, indices: corners }) => ({
          name, components, values: like(values), indices: like(corners),
        })),
      };
      return done;
    } finally {
      this.#isRecording = false;
    }
  }

  #arrays() {
    const { positions, indices, labels, attributes } = this.#input;
    const points = realsLike(positions, this.#output(Float64Array, "positions", 0));
    const inputFaces = this.#output(Uint32Array, "inputFaces", 0).slice();
    const level = {
      positions: points,
      indices: integersLike(indices, this.#output(Uint32Array, "indices", 0), points.length / 3),
      attributes: attributesLike(attributes, {
        reals: (name, channel) => this.#output(Float64Array, name, channel),
        integers: (name, channel) => this.#output(Uint32Array, name, channel),
      }),
      inputVertices: this.#output(Uint32Array, "inputVertices", 0).slice(),
      inputFaces,
    };
    if (labels) level.labels = integersLike(labels, inputFaces, Infinity).map((_, i) => labels[inputFaces[i]]);
    return level;
  }

  #find(stop, withSurface) {
    this.#requireFree();
    const entries = Object.entries(stop ?? {});
    if (entries.length !== 1 || !stops.includes(entries[0][0]) || typeof entries[0][1] !== "number" || !(entries[0][1] >= 0))
      throw new TypeError(`quadrille: a level is chosen by one of ${stops.join(", ")}, such as {faces: 1000}`);
    const [name, number] = entries[0];
    this.#name(name);
    const least = isCount(name) ? Math.min(Math.floor(number), 2 ** 32 - 1) : number;
    const isFound = this.#instance.exports.findLevel(this.#address, least, withSurface);
    const text = this.#instance.textAt(this.#instance.exports.levelText(this.#address));
    if (!isFound) throw new Error(text);
    return JSON.parse(text);
  }
  #name(text) {
    this.#instance.write(text, (bytes) => this.#instance.exports.levelNameRoom(this.#address, bytes));
  }
  #output(Type, name, channel) {
    this.#name(name);
    return this.#instance.viewAt(Type, this.#instance.exports.levelOutput(this.#address, channel));
  }
  #requireFree() {
    if (this.#address === 0) throw new Error("quadrille: these levels have been freed");
    if (this.#isRecording) throw new Error("quadrille: these levels are being recorded");
  }
}

// What nobody holds any more.
const registry = new FinalizationRegistry(({ instance, address }) => instance.exports.deleteLevels(address));
