// The options of a call: their names and types. Their ranges are looked at where they are used.

import { described, requireIntegers, requireLength, requireReals, requireUnsigned } from "./arrays.js";
import { Levels } from "./levels.js";
import { callOptions } from "./option_table.js";

const of = (...kinds) => Object.keys(callOptions).filter((name) => kinds.includes(callOptions[name]));
const counts = of("count");
const numbers = of("number");
const booleans = of("flag");
const choices = of("word");
const masks = of("point_flags", "face_flags");
const arrays = of("point_numbers");
const others = ["levels", "progress"];
const all = [...Object.keys(callOptions), ...others];

/** Throws a TypeError for a key that nothing reads. */
export function requireKeys(name, object, keys) {
  for (const key of Object.keys(object))
    if (!keys.includes(key)) throw new TypeError(`quadrille: ${name} ${JSON.stringify(key)}, which is not one of ${keys.join(", ")}`);
}

/** Looks at the options for a mesh; throws an error that names what is wrong. */
export function readOptions(options, { points, triangles }) {
  if (options === null || typeof options !== "object")
    throw new TypeError(`quadrille: the options are ${described(options)}, not an object such as {faces: 1000}`);
  requireKeys("the options have", options, all);
  const given = (names) => names.filter((name) => options[name] !== undefined && options[name] !== null);
  return {
    numbers: [
      ...given(counts).map((name) => [name, count(name, options[name])]),
      ...given(numbers).map((name) => [name, typed("number", name, options[name])]),
      ...given(booleans).map((name) => [name, Number(typed("boolean", name, options[name]))]),
    ],
    choices: given(choices).map((name) => [name, typed("string", name, options[name])]),
    masks: given(masks).map((name) => [name, mask(name, options[name], ...(callOptions[name] === "face_flags" ? [triangles, "triangles"] : [points, "points"]))]),
    arrays: given(arrays).map((name) => [name, requireLength(name, requireReals(name, options[name]), points, "points")]),
    levels: levelsOf(options),
    progress: options.progress === undefined ? null : typed("function", "progress", options.progress),
    splitVertices: options.splitVertices === true,
  };
}

function typed(type, name, value) {
  if (typeof value !== type || Number.isNaN(value)) throw new TypeError(`quadrille: ${name} is ${described(value)}, not a ${type}`);
  return value;
}

function count(name, value) {
  if (!Number.isInteger(value)) throw new TypeError(`quadrille: ${name} is ${described(value)}, not an integer`);
  if (value < 0 || value >= 2 ** 32) throw new RangeError(`quadrille: ${name} is ${value}, not in [0, 2**32)`);
  return value;
}

function levelsOf({ levels }) {
  if (levels === undefined || levels === null) return null;
  if (!(levels instanceof Levels)) throw new TypeError(`quadrille: levels is ${described(levels)}, not Levels to record into`);
  return levels;
}

// Bytes are a mask; other integers are indices.
function mask(name, value, size, what) {
  requireUnsigned(name, requireIntegers(name, value));
  if (value.BYTES_PER_ELEMENT === 1) return requireLength(name, value, size, what).map((byte) => (byte ? 1 : 0));
  const result = new Uint8Array(size);
  value.forEach((index, i) => {
    if (index >= size) throw new RangeError(`quadrille: ${name}[${i}] is ${index}, but there are ${size}`);
    result[index] = 1;
  });
  return result;
}
