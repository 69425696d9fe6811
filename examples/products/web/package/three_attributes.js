// Attributes of a geometry of three.js as those of a mesh, and back: texture coordinates, normals, colours, tangents, the
// weights of a skin, morph targets, and any other numbers.

import { BufferAttribute, Float16BufferAttribute } from "three";

const skin = "skinWeight"; // stands for both attributes of a skin

/** The positions of a geometry, and its attributes as the package takes them. */
export function attributesOf(geometry, options) {
  const position = geometry.getAttribute("position"), bones = bonesOf(geometry);
  const attributes = {};
  for (const [name, attribute] of namedAttributes(geometry)) {
    if (attribute.isInstancedBufferAttribute) throw new TypeError(`quadrille: the attribute ${name} has values of instances, not of vertices`);
    if (attribute.count !== position.count)
      throw new RangeError(`quadrille: the attribute ${name} has ${attribute.count} values for ${position.count} vertices`);
    if (name === "skinIndex" && bones) continue;
    attributes[name] = { ...(name === skin && bones ? boneWeights(geometry, bones) : formOf(name, attribute)), ...options[name] };
  }
  for (const name of Object.keys(options))
    if (!attributes[name]) throw new TypeError(`quadrille: the geometry has no attribute ${name}, but one of ${Object.keys(attributes).join(", ") || "none"}`);
  return { positions: valuesOf(position, position.array instanceof Float32Array ? Float32Array : Float64Array), attributes, bones };
}

/** Sets the attributes of a simplified geometry, in the types of those before. */
export function writtenAttributes(geometry, { bones }, result, simple) {
  const write = (name, attribute) => {
    if (name === "position") return likeValues(attribute, result.positions);
    if (name === "skinIndex" && bones) return skinOf(geometry, result.attributes[skin].values, bones).indices;
    if (name === skin && bones) return skinOf(geometry, result.attributes[skin].values, bones).weights;
    const { values } = result.attributes[name];
    return likeValues(attribute, name === "tangent" ? unitTangents(values) : values);
  };
  for (const name of Object.keys(geometry.attributes)) simple.setAttribute(name, write(name, geometry.attributes[name]));
  for (const [name, targets] of Object.entries(geometry.morphAttributes))
    simple.morphAttributes[name] = targets.map((attribute, i) => write(morphName(name, i), attribute));
  simple.morphTargetsRelative = geometry.morphTargetsRelative;
}

const morphName = (name, i) => `morph.${name}.${i}`;

// All but the positions.
function namedAttributes(geometry) {
  const ofVertices = Object.entries(geometry.attributes).filter(([name]) => name !== "position");
  const ofTargets = Object.entries(geometry.morphAttributes).flatMap(([name, targets]) =>
    targets.map((attribute, i) => [morphName(name, i), attribute]));
  return [...ofVertices, ...ofTargets];
}

// What kind of values a name says, and how they count. A morph target counts like the shape: its unit is that of positions.
function formOf(name, attribute) {
  const components = attribute.itemSize, form = { components, values: valuesOf(attribute) };
  if (/^uv\d*$/.test(name) && components === 2) return { kind: "texture", ...form };
  if (name === "normal" && components === 3) return { kind: "normals", ...form };
  if (name === "color" && (components === 3 || components === 4)) return { kind: "colors", ...form };
  if (name.startsWith("morph.position.")) return { ...form, weights: [1, 1, 1] };
  if (name === "tangent") return { ...form, importance: 1 / 64 }; // they follow the texture
  return form;
}

// As numbers that shaders see: in [0, 1] or [-1, 1] where an attribute is normalized.
function valuesOf(attribute, Type = Float64Array) {
  const { itemSize, count } = attribute, values = new Type(itemSize * count);
  for (let i = 0, at = 0; i < count; ++i)
    for (let component = 0; component < itemSize; ++component, ++at) values[at] = read(attribute, i, component);
  return values;
}

// getComponent() and setComponent() of three.js do not know half floats.
const letters = ["X", "Y", "Z", "W"];
function read(attribute, i, component) {
  return component < 4 ? attribute[`get${letters[component]}`](i) : attribute.getComponent(i, component);
}
function set(attribute, i, component, value) {
  if (component < 4) attribute[`set${letters[component]}`](i, value);
  else attribute.setComponent(i, component, value);
}

// An attribute of the same type with other values.
function likeValues(attribute, values) {
  const { itemSize, normalized } = attribute, { array } = attribute.isInterleavedBufferAttribute ? attribute.data : attribute;
  const Attribute = attribute.isFloat16BufferAttribute ? Float16BufferAttribute : BufferAttribute;
  const like = new Attribute(new array.constructor(values.length), itemSize, normalized);
  like.name = attribute.name;
  if (attribute.gpuType !== undefined) like.gpuType = attribute.gpuType;
  const isWhole = !normalized && !attribute.isFloat16BufferAttribute && !(array instanceof Float32Array) && !(array instanceof Float64Array);
  for (let i = 0, at = 0; i < like.count; ++i)
    for (let component = 0; component < itemSize; ++component, ++at) set(like, i, component, isWhole ? Math.round(values[at]) : values[at]);
  return like;
}

function unitTangents(values) {
  for (let i = 0; i + 3 < values.length; i += 4) {
    const length = Math.hypot(values[i], values[i + 1], values[i + 2]) || 1;
    for (let k = 0; k < 3; ++k) values[i + k] /= length;
    values[i + 3] = values[i + 3] < 0 ? -1 : 1;
  }
  return values;
}

// --- A skin: each vertex has a weight for each bone that any vertex has

// The bones that have a weight, in their order; null where a geometry has no skin.
function bonesOf({ attributes: { skinIndex, skinWeight } }) {
  if (!skinIndex || !skinWeight) return null;
  const bones = new Set();
  for (let i = 0; i < skinIndex.count; ++i)
    for (let k = 0; k < skinIndex.itemSize; ++k) if (read(skinWeight, i, k) > 0) bones.add(read(skinIndex, i, k));
  return bones.size > 0 ? Uint32Array.from(bones).sort() : null;
}

function boneWeights({ attributes: { skinIndex, skinWeight } }, bones) {
  const components = bones.length, values = new Float64Array(components * skinIndex.count);
  const place = new Map(Array.from(bones, (bone, i) => [bone, i]));
  for (let i = 0; i < skinIndex.count; ++i)
    for (let k = 0; k < skinIndex.itemSize; ++k) {
      const weight = read(skinWeight, i, k);
      if (weight > 0) values[components * i + place.get(read(skinIndex, i, k))] += weight;
    }
  return { components, values, newValues: "weights" };
}

// The greatest weights of each vertex, as many as it had, with the sum 1.
function skinOf({ attributes: { skinIndex, skinWeight } }, values, bones) {
  const size = skinIndex.itemSize, vertices = values.length / bones.length;
  const indices = new Float64Array(size * vertices), weights = new Float64Array(size * vertices);
  for (let i = 0; i < vertices; ++i) {
    const ofVertex = values.subarray(bones.length * i, bones.length * (i + 1));
    const greatest = Array.from(ofVertex.keys()).sort((a, b) => ofVertex[b] - ofVertex[a] || a - b).slice(0, size);
    const sum = greatest.reduce((all, bone) => all + ofVertex[bone], 0) || 1;
    greatest.forEach((bone, k) => {
      indices[size * i + k] = ofVertex[bone] > 0 ? bones[bone] : 0;
      weights[size * i + k] = ofVertex[bone] / sum;
    });
  }
  return { indices: likeValues(skinIndex, indices), weights: likeValues(skinWeight, weights) };
}
