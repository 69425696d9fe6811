// Time of the package in JavaScript beside that of the npm package meshoptimizer, in node, from typed arrays to
// typed arrays, to a tenth of the faces; and the distance of the results to the input.
// Times are those of the processor, so that other work on the machine counts little.
//   node compare.mjs PACKAGE DISTANCE_PROGRAM MODEL...
// Models are OFF files, or OBJ files of triangles.
// It is run where node_modules/meshoptimizer is. See run.sh.

import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { basename, extname, join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { brotliCompressSync, constants, gzipSync } from "node:zlib";

const [folder, program, ...models] = process.argv.slice(2);
const modules = createRequire(join(process.cwd(), "package.json"));
const { MeshoptSimplifier } = await import(pathToFileURL(modules.resolve("meshoptimizer")));
const { load } = await import(pathToFileURL(resolve(folder, "index.js")));
const { version } = JSON.parse(readFileSync(join(process.cwd(), "node_modules/meshoptimizer/package.json")));
const rounds = Number(process.env.ROUNDS ?? 15);

function readOff(path) {
  const numbers = readFileSync(path, "utf8").replace(/#.*/g, "").replace(/^\s*OFF/, "").split(/\s+/).filter(Boolean).map(Number);
  const [points, faces] = numbers;
  const positions = Float32Array.from(numbers.slice(3, 3 + 3 * points)), indices = new Uint32Array(3 * faces);
  for (let face = 0, at = 3 + 3 * points; face < faces; ++face, at += 4) indices.set(numbers.slice(at + 1, at + 4), 3 * face);
  return { positions, indices };
}

function readObj(path) {
  const lines = readFileSync(path, "utf8").split("\n").map((line) => line.trim().split(/\s+/));
  const rows = (key, value) => lines.filter(([word]) => word === key).flatMap(([, ...words]) => words.slice(0, 3).map(value));
  return { positions: Float32Array.from(rows("v", Number)), indices: Uint32Array.from(rows("f", (word) => Number.parseInt(word) - 1)) };
}

// A unit vector at each point, of the areas around.
function normalsOf({ positions, indices }) {
  const normals = new Float32Array(positions.length), p = (i) => positions.subarray(3 * i, 3 * i + 3);
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => p(indices[i + k])), ab = b.map((x, k) => x - a[k]), ac = c.map((x, k) => x - a[k]);
    const normal = [ab[1] * ac[2] - ab[2] * ac[1], ab[2] * ac[0] - ab[0] * ac[2], ab[0] * ac[1] - ab[1] * ac[0]];
    for (let k = 0; k < 3; ++k) for (let x = 0; x < 3; ++x) normals[3 * indices[i + k] + x] += normal[x];
  }
  for (let i = 0; i < normals.length; i += 3) {
    const length = Math.hypot(...normals.subarray(i, i + 3)) || 1;
    for (let k = 0; k < 3; ++k) normals[i + k] /= length;
  }
  return normals;
}

function writeOff(path, { positions, indices }) {
  const lines = ["OFF", `${positions.length / 3} ${indices.length / 3} 0`];
  for (let i = 0; i < positions.length; i += 3) lines.push(positions.subarray(i, i + 3).join(" "));
  for (let i = 0; i < indices.length; i += 3) lines.push(`3 ${indices.subarray(i, i + 3).join(" ")}`);
  writeFileSync(path, `${lines.join("\n")}\n`);
}

const quadrille = await load();
await MeshoptSimplifier.ready;

// Points stay where they are in results of meshoptimizer.
const ofMeshoptimizer = (mesh, [indices]) => ({ positions: mesh.positions, indices });
const contenders = [
  ["Quadrille", (mesh, target) => quadrille.simplify(mesh, { faces: target })],
  ["Quadrille memoryless", (mesh, target) => quadrille.simplify(mesh, { faces: target, cost: "memoryless_quadric" })],
  ["Quadrille relaxed", (mesh, target) => quadrille.simplify(mesh, { faces: target, order: "relaxed" })],
  ["meshoptimizer", (mesh, target) => ofMeshoptimizer(mesh, MeshoptSimplifier.simplify(mesh.indices, mesh.positions, 3, 3 * target, 1))],
  ["Quadrille with normals", ({ normals, ...mesh }, target) =>
    quadrille.simplify({ ...mesh, attributes: { normals: { kind: "normals", values: normals } } }, { faces: target })],
  ["meshoptimizer with normals", (mesh, target) => ofMeshoptimizer(mesh, MeshoptSimplifier.simplifyWithAttributes(
    mesh.indices, mesh.positions, 3, mesh.normals, 3, [0.5, 0.5, 0.5], null, 3 * target, 1))],
];

// The least time, and the median.
const told = (times) => `${Math.min(...times).toFixed(1)} | ${times.sort((a, b) => a - b)[times.length >> 1].toFixed(1)}`;
const work = mkdtempSync(join(tmpdir(), "compare-"));

// Root mean square and greatest distance, both ways, in 1e-4 of the diagonal.
const distances = (input, result) => execFileSync(program, [input, result], { encoding: "utf8" }).trim().replace(" ", " | ");

console.log(`node ${process.version}, meshoptimizer ${version}, Quadrille ${quadrille.version}`);
for (const [name, path] of [["quadrille.wasm", join(folder, "quadrille.wasm")], ["meshopt_simplifier.js", join(process.cwd(), "node_modules/meshoptimizer/meshopt_simplifier.js")]]) {
  const bytes = readFileSync(path);
  const brotli = brotliCompressSync(bytes, { params: { [constants.BROTLI_PARAM_SIZE_HINT]: bytes.length, [constants.BROTLI_PARAM_LGWIN]: 24 } });
  console.log(`${name}: ${bytes.length} bytes, ${gzipSync(bytes, { level: 9 }).length} with gzip -9, ${brotli.length} with brotli -q 11 -w 24`);
}
for (const path of models) {
  const mesh = extname(path) === ".obj" ? readObj(path) : readOff(path), target = Math.round(mesh.indices.length / 30), input = join(work, "input.off");
  mesh.normals = normalsOf(mesh);
  writeOff(input, mesh);
  const { normals, ...bare } = mesh;
  const times = contenders.map(() => []), results = [];
  for (let round = 0; round < rounds; ++round)
    contenders.forEach(([name, simplify], i) => {
      const given = name.includes("normals") ? mesh : bare, begin = process.cpuUsage();
      results[i] = simplify(given, target);
      const { user, system } = process.cpuUsage(begin);
      times[i].push((user + system) / 1000);
    });
  contenders.forEach(([name], i) => {
    writeOff(join(work, "result.off"), results[i]);
    const error = distances(input, join(work, "result.off"));
    console.log(`| ${basename(path, extname(path))} | ${name} | ${results[i].indices.length / 3} | ${told(times[i])} | ${error} |`);
  });
}
rmSync(work, { recursive: true });
