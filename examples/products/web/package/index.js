// The package: `load` makes the module, whose `simplify` and `Levels` take and give typed arrays.

import { Instance, compiled } from "./instance.js";
import { Levels } from "./levels.js";
import { readMesh } from "./mesh.js";
import { readOptions } from "./options.js";
import { attributesLike, integersLike, realsLike } from "./arrays.js";

/** See index.d.ts. */
export async function load({ wasm } = {}) {
  return new Quadrille(new Instance(await compiled(wasm)));
}

class Quadrille {
  #instance;

  constructor(instance) {
    this.#instance = instance;
    const number = instance.exports.version();
    this.version = [Math.floor(number / 10000), Math.floor(number / 100) % 100, number % 100].join(".");
    this.Levels = class extends Levels {
      constructor() {
        super(instance);
      }
    };
  }

  simplify(mesh, options = {}) {
    const input = readMesh(mesh);
    const chosen = readOptions(options, input);
    if (chosen.levels && !chosen.levels.belongsTo(this.#instance))
      throw new TypeError("quadrille: levels are of another module: they come from Levels of the one that simplifies");
    const call = this.#instance.newCall();
    try {
      call.setMesh(input);
      call.setOptions(chosen);
      const report = run(call, input, chosen);
      return resultOf(call, input, chosen, report);
    } finally {
      call.free();
    }
  }
}

function run(call, input, { levels, progress }) {
  const report = (address) => call.run(address, progress);
  return levels ? levels.record(input, report) : report(0);
}

function resultOf(call, input, { splitVertices }, report) {
  const positions = realsLike(input.positions, call.reals("positions"));
  const points = positions.length / 3;
  const result = {
    positions,
    indices: integersLike(input.indices, call.integers("indices"), points),
    attributes: attributesLike(input.attributes, call),
    inputFaces: call.integers("inputFaces").slice(),
    report,
  };
  if (input.labels) result.labels = integersLike(input.labels, call.integers("labels"), Infinity);
  if (!splitVertices)
    result.vertexMap = new Int32Array(call.integers("vertex_map")); // what has vanished is -1
  return result;
}
