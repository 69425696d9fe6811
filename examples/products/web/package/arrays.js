// Typed arrays of the user's: which they are, and numbers as such ones.

const realTypes = { Float64Array, Float32Array };
const integerTypes = { Uint32Array, Uint16Array, Uint8Array, Uint8ClampedArray, Int32Array, Int16Array, Int8Array };
const types = { ...realTypes, ...integerTypes };

const typeName = (value) => (ArrayBuffer.isView(value) ? value[Symbol.toStringTag] : undefined);

/** How an error names what is not the array that is wanted. */
export function described(value) {
  if (value === null || value === undefined) return String(value);
  if (typeof value !== "object") return typeof value === "string" ? JSON.stringify(value) : String(value);
  return `a value of ${typeName(value) ?? value.constructor?.name ?? "Object"}`;
}

function require(names, wanted, name, value, size, unit) {
  if (!names[typeName(value)]) throw new TypeError(`quadrille: ${name} is ${described(value)}, not ${wanted}`);
  if (value.length % size !== 0)
    throw new RangeError(`quadrille: ${name} has ${value.length} numbers, which is not a multiple of ${size}, as for ${unit}`);
  return value;
}

/** Checks that a value is a typed array of numbers, so many for each of a unit. */
export function requireReals(name, value, size = 1, unit = "numbers") {
  return require(types, "a typed array of numbers", name, value, size, unit);
}
/** The same of integers. */
export function requireIntegers(name, value, size = 1, unit = "numbers") {
  return require(integerTypes, "a typed array of integers", name, value, size, unit);
}
/** Checks how long it is. */
export function requireLength(name, value, length, ofWhat) {
  if (value.length !== length)
    throw new RangeError(`quadrille: ${name} has ${value.length} numbers for ${length} ${ofWhat}`);
  return value;
}
/** Checks that no integer is negative. */
export function requireUnsigned(name, value) {
  const place = typeName(value).startsWith("Int") ? value.findIndex((number) => number < 0) : -1;
  if (place >= 0) throw new RangeError(`quadrille: ${name}[${place}] is ${value[place]}, which is negative`);
  return value;
}

const limits = (type) => {
  const bits = 8 * type.BYTES_PER_ELEMENT, isSigned = type.name.startsWith("Int");
  return isSigned ? [-(2 ** (bits - 1)), 2 ** (bits - 1) - 1] : [0, 2 ** bits - 1];
};

/** A copy of doubles in the type of an array: the nearest integers of integers. */
export function realsLike(array, doubles) {
  const name = typeName(array), type = types[name];
  if (realTypes[name]) return new type(doubles);
  const [least, greatest] = limits(type);
  return type.from(doubles, (x) => Math.min(Math.max(Math.round(x), least), greatest));
}

/** A copy of integers in the type of an array, or of 32 bits if it does not hold all below a count. */
export function integersLike(array, integers, count) {
  const type = types[typeName(array)];
  return new (Number.isFinite(count) && count - 1 > limits(type)[1] ? Uint32Array : type)(integers);
}

/** The attributes of a call or of a level, in the forms in which they were given: `arrays` has
 *  reals(name, channel) and integers(name, channel). */
export function attributesLike(attributes, arrays) {
  const result = {};
  attributes.forEach(({ name, components, values, indices }, channel) => {
    const changed = realsLike(values, arrays.reals("values", channel));
    result[name] = { components, values: changed };
    const corners = arrays.integers("corners", channel);
    if (indices || corners.length > 0)
      result[name].indices = integersLike(indices ?? corners, corners, changed.length / components);
  });
  return result;
}
