// The surface that is to be simplified, with what it carries: what it has to look like.

import { described, requireIntegers, requireLength, requireReals, requireUnsigned } from "./arrays.js";
import { channelOptions } from "./option_table.js";
import { requireKeys } from "./options.js";

const componentsOfKind = { texture: 2, normals: 3 };
const keysOfMesh = ["positions", "indices", "labels", "attributes"];
const keysOfAttribute = ["kind", "components", "values", "indices", ...Object.keys(channelOptions)];

/** Looks at all arrays of a mesh; throws an error that names what is wrong. */
export function readMesh(mesh) {
  if (mesh === null || typeof mesh !== "object")
    throw new TypeError(`quadrille: the mesh is ${described(mesh)}, not an object with positions and indices`);
  requireKeys("the mesh has", mesh, keysOfMesh);
  const positions = requireReals("positions", mesh.positions, 3, "points");
  const indices = requireUnsigned("indices", requireIntegers("indices", mesh.indices, 3, "triangles"));
  const points = positions.length / 3, triangles = indices.length / 3;
  const labels = mesh.labels ?? null;
  if (labels) requireUnsigned("labels", requireLength("labels", requireIntegers("labels", labels), triangles, "triangles"));
  const attributes = Object.entries(mesh.attributes ?? {}).map(([name, attribute]) =>
    readAttribute(name, attribute, points, indices.length),
  );
  return { positions, indices, labels, attributes, points, triangles };
}

function readAttribute(key, attribute, points, corners) {
  const name = `attributes.${key}`;
  if (attribute === null || typeof attribute !== "object" || ArrayBuffer.isView(attribute))
    throw new TypeError(`quadrille: ${name} is ${described(attribute)}, not an object with values`);
  requireKeys(`${name} has`, attribute, keysOfAttribute);
  const kind = attribute.kind ?? "attributes";
  const values = requireReals(`${name}.values`, attribute.values);
  const indices = attribute.indices ?? null;
  if (indices) requireCorners(`${name}.indices`, indices, corners);
  const ofAPoint = indices ? undefined : points > 0 ? values.length / points : 1;
  const components = attribute.components ?? componentsOfKind[kind] ?? ofAPoint;
  if (!Number.isInteger(components) || components < 1)
    throw new RangeError(`quadrille: ${name} has ${values.length} numbers for ${points} points: set the number of components`);
  requireReals(`${name}.values`, values, components, "values");
  if (!indices) requireLength(`${name}.values`, values, components * points, `components of ${points} points`);
  return { name: key, kind, values, indices, components, options: optionsOf(name, attribute, components) };
}

function requireCorners(name, indices, corners) {
  requireUnsigned(name, requireLength(name, requireIntegers(name, indices), corners, "corners of triangles"));
}

function optionsOf(name, attribute, components) {
  const numbers = [], choices = [];
  for (const [option, kind] of Object.entries(channelOptions)) {
    const value = attribute[option] ?? null;
    if (value === null) continue;
    if (kind === "word") choices.push([option, value]);
    else if (kind === "flag") numbers.push([option, value ? 1 : 0]);
    else if (kind === "numbers")
      requireLength(`${name}.${option}`, Array.from(value), components, "components").forEach((number) => numbers.push([option, number]));
    else if (typeof value === "number") numbers.push([option, value]);
    else throw new TypeError(`quadrille: ${name}.${option} is ${described(value)}, not a number`);
  }
  return { numbers, choices };
}
