// meshoptimizer on a surface with colours: node front_peer.mjs IN OUT COUNT WEIGHT UPDATE, with the npm package meshoptimizer in
// the folder that NODE_MODULES names. IN and OUT: counts of vertices and of triangles as 32-bit integers, then positions and
// colours as floats, three each a vertex, and triangles. Prints the milliseconds of the call.
import { readFileSync, writeFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';

const { MeshoptSimplifier } = await import(pathToFileURL(`${process.env.NODE_MODULES}/meshoptimizer/meshopt_simplifier.js`));
await MeshoptSimplifier.ready;

const [input, output, count, weight, update] = process.argv.slice(2);
const bytes = readFileSync(input);
const data = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length);
const [vertices, triangles] = new Uint32Array(data, 0, 2);
const positions = new Float32Array(data, 8, 3 * vertices);
const colours = new Float32Array(data, 8 + 12 * vertices, 3 * vertices);
let indices = new Uint32Array(data, 8 + 24 * vertices, 3 * triangles);

const weights = Array(3).fill(Number(weight));
const simplify = update === '1' ? MeshoptSimplifier.simplifyWithUpdate : MeshoptSimplifier.simplifyWithAttributes;
const start = process.cpuUsage();
const result = simplify(indices, positions, 3, colours, 3, weights, null, 3 * Number(count), 1e6);
const { user, system } = process.cpuUsage(start);
console.log((user + system) / 1000);
indices = update === '1' ? indices.subarray(0, result[0]) : result[0];
writeFileSync(output, Buffer.concat([new Uint32Array([vertices, indices.length / 3]), positions, colours, indices].map(
  (a) => Buffer.from(a.buffer, a.byteOffset, a.byteLength))));
