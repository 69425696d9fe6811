// What the package takes, gives and refuses, beside the bytes of its results.
//   PACKAGE=FOLDER node --test package.test.mjs

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import { brotliCompressSync, constants } from "node:zlib";

const { PACKAGE } = process.env;
const { load } = await import(pathToFileURL(resolve(PACKAGE, "index.js")));
const quadrille = await load();

// A bent sheet of n × n points.
function sheet(n, Reals = Float64Array, Integers = Uint32Array) {
  const positions = new Reals(3 * n * n), uv = new Float32Array(2 * n * n), indices = [];
  for (let i = 0; i < n * n; ++i) {
    const u = (i % n) / (n - 1), v = Math.floor(i / n) / (n - 1);
    positions.set([u, v, 0.1 * Math.sin(6 * u) * Math.cos(6 * v)], 3 * i);
    uv.set([u, v], 2 * i);
    if (i % n > 0 && i >= n) indices.push(i - n - 1, i - n, i - 1, i - n, i, i - 1);
  }
  return { positions, indices: Integers.from(indices), uv };
}

const { positions, indices, uv } = sheet(30);
const mesh = { positions, indices, attributes: { uv: { kind: "texture", values: uv } } };

test("arrays come back in the types in which they went in, and are not changed", () => {
  const { positions, indices } = sheet(30, Float32Array, Uint16Array);
  const heat = Uint8Array.from({ length: 900 }, (_, i) => i % 251);
  const labels = Int16Array.from({ length: indices.length / 3 }, (_, i) => (i % 58 > 29 ? 7 : 3));
  const before = structuredClone({ positions, indices, heat, labels });
  const result = quadrille.simplify({ positions, indices, labels, attributes: { heat: { values: heat } } }, { faces: 300 });
  assert.deepEqual({ positions, indices, heat, labels }, before);
  assert.ok(result.positions instanceof Float32Array && result.indices instanceof Uint16Array);
  assert.ok(result.labels instanceof Int16Array && result.attributes.heat.values instanceof Uint8Array);
  assert.equal(result.indices.length, 900);
  assert.equal(result.attributes.heat.components, 1);
  const inReals = quadrille.simplify({ positions, indices, labels, attributes: { heat: { values: Float64Array.from(heat) } } }, { faces: 300 });
  assert.deepEqual(result.attributes.heat.values, Uint8Array.from(inReals.attributes.heat.values, (x) => Math.min(Math.max(Math.round(x), 0), 255)));
  assert.equal(result.attributes.heat.values.length, result.positions.length / 3);
  assert.deepEqual(result.labels, Int16Array.from(result.inputFaces, (face) => labels[face]));
  assert.equal(result.vertexMap.length, 900);
  assert.ok(result.vertexMap.every((point) => point >= -1 && point < result.positions.length / 3));
});

// A plate of cubes with a tunnel of one square, of points for each square.
function plate() {
  const isFull = (x, y, z) => x >= 0 && x < 9 && y >= 0 && y < 7 && z >= 0 && z < 3 && !(x === 4 && y === 3);
  const positions = [], indices = [];
  for (let x = 0; x < 9; ++x) for (let y = 0; y < 7; ++y) for (let z = 0; z < 3; ++z)
    for (let side = 0; side < 6 && isFull(x, y, z); ++side) {
      const axis = side >> 1, beyond = side & 1, place = [x, y, z];
      if (isFull(...place.map((c, k) => (k === axis ? c + 2 * beyond - 1 : c)))) continue;
      const first = positions.length / 3;
      for (const [u, v] of [[0, 0], [1, 0], [1, 1], [0, 1]])
        for (let k = 0; k < 3; ++k) positions.push(place[k] + (k === axis ? beyond : k === (axis + 1) % 3 ? u : v));
      for (const t of [[0, 1, 2], [0, 2, 3]]) indices.push(...(beyond ? t : t.reverse()).map((corner) => first + corner));
    }
  return { positions: Float32Array.from(positions), indices: Uint32Array.from(indices) };
}

test("a preset stands for options that are not given", () => {
  const options = { faces: 100, splitVertices: true };
  const { report } = quadrille.simplify(plate(), { ...options, preset: "generated" });
  assert.deepEqual([report.facesAfter, report.cutHandles, report.cutDistance], [100, 1, 0.5]);
  assert.equal(quadrille.simplify(plate(), options).report.cutHandles, 0);
  assert.equal(quadrille.simplify(plate(), { ...options, preset: "generated", simplifiedTopology: 0.1 }).report.cutHandles, 0);
  assert.throws(() => quadrille.simplify(plate(), { preset: "film" }), /preset is "film", which is not one of generated, scan/);
  const levels = new quadrille.Levels(); // have the indices of the input, so nothing is added to it
  assert.equal(quadrille.simplify(plate(), { ...options, preset: "generated", levels }).report.cutHandles, 0);
  assert.throws(() => quadrille.simplify(plate(), { ...options, manifold: true, levels }), /do not go with levels/);
  levels.free();
});

test("points at one place are one, and there are no images of them then", () => {
  const n = 17; // of each corner a point: 1,536 of them, of which few are at one place
  const { positions, indices } = sheet(n);
  const split = new Float64Array(3 * indices.length);
  indices.forEach((point, corner) => split.set(positions.subarray(3 * point, 3 * point + 3), 3 * corner));
  const result = quadrille.simplify({ positions: split, indices: Uint32Array.from(indices.keys()) }, { faces: 100, splitVertices: true });
  assert.equal(result.report.facesAfter, 100);
  assert.equal(result.vertexMap, undefined);
});

test("the report tells what was done", () => {
  const { report } = quadrille.simplify(mesh, { faces: 200, relativeError: 0.05, noSelfIntersection: true });
  assert.equal(report.facesBefore, 1682);
  assert.equal(report.facesAfter, 200);
  assert.equal(report.stop, "target met");
  assert.equal(report.isTargetReached, true);
  assert.ok(report.distanceBound > 0 && report.distanceBound < 0.1);
  assert.equal(report.hausdorffBound, Infinity);
  assert.deepEqual(report.selfIntersections, [0, 0]);
  assert.match(report.text, /^1682 -> 200 faces/);
});

test("without triangles nothing is left", () => {
  const result = quadrille.simplify({ positions, indices: new Uint32Array(), attributes: mesh.attributes });
  assert.equal(result.positions.length, 0);
  assert.equal(result.attributes.uv.values.length, 0);
  const nothing = quadrille.simplify({ positions: new Float32Array(), indices: new Uint16Array(), attributes: { a: { values: new Float32Array() } } });
  assert.equal(nothing.indices.length, 0);
});

const bad = (change) => ({ positions, indices, attributes: {}, ...change });
const ofUv = (change) => bad({ attributes: { uv: { kind: "texture", values: uv, ...change } } });
const refused = [
  ["no mesh", [undefined], /the mesh is undefined/],
  ["an array that is not typed", [bad({ positions: [0, 0, 0] })], /positions is a value of Array, not a typed array of numbers/],
  ["integers of 64 bits", [bad({ indices: new BigUint64Array(3) })], /indices is a value of BigUint64Array, not a typed array of integers/],
  ["real indices", [bad({ indices: new Float32Array(3) })], /indices is a value of Float32Array, not a typed array of integers/],
  ["a number too many", [bad({ positions: new Float32Array(4) })], /positions has 4 numbers, which is not a multiple of 3/],
  ["a negative index", [bad({ indices: Int32Array.of(0, 1, -2) })], /indices\[2\] is -2, which is negative/],
  ["an index beyond the points", [bad({ indices: Uint32Array.of(0, 1, 900) })], /face 0 names point 900 of 900/],
  ["a coordinate that is not finite", [bad({ positions: positions.map((x, i) => (i === 7 ? NaN : x)) })], /vertex 2 is not finite/],
  ["a key of a mesh", [bad({ normals: positions })], /the mesh has "normals", which is not one of positions, indices/],
  ["labels", [bad({ labels: new Uint32Array(2) })], /labels has 2 numbers for 1682 triangles/],
  ["an attribute that is an array", [bad({ attributes: { uv } })], /attributes\.uv is a value of Float32Array, not an object with values/],
  ["a kind", [ofUv({ kind: "textur" })], /attributes\.uv: kind is "textur", which is not one of texture, normals, colors, attributes/],
  ["seams", [ofUv({ seams: "keep" })], /attributes\.uv: seams is "keep", which is not one of kept, soft, priced, free/],
  ["a key of an attribute", [ofUv({ wrap: 1 })], /attributes\.uv has "wrap", which is not one of/],
  ["values for points", [ofUv({ values: uv.slice(2) })], /attributes\.uv\.values has 1798 numbers for 1800 components of 900 points/],
  ["corners of an attribute", [ofUv({ indices: new Uint32Array(3) })], /attributes\.uv\.indices has 3 numbers for 5046 corners/],
  ["an importance", [ofUv({ importance: 0 })], /importance 0 is not above 0/],
  ["components", [bad({ attributes: { a: { values: new Float32Array(901) } } })], /attributes\.a has 901 numbers for 900 points/],
  ["options that are a number", [mesh, 100], /the options are 100, not an object/],
  ["an option", [mesh, { face: 100 }], /the options have "face", which is not one of faces, ratio/],
  ["a count", [mesh, { faces: 0.5 }], /faces is 0.5, not an integer/],
  ["a negative count", [mesh, { faces: -1 }], /faces is -1, not in/],
  ["a ratio", [mesh, { ratio: 2 }], /ratio 2 /],
  ["a text for a number", [mesh, { error: "1" }], /error is "1", not a number/],
  ["a number for a boolean", [mesh, { bothWays: 1 }], /bothWays is 1, not a boolean/],
  ["a cost", [mesh, { cost: "quadrics" }], /cost is "quadrics", which is not one of quadric, memoryless_quadric/],
  ["a limit", [mesh, { relativeError: -1 }], /the limit -1 is not a distance/],
  ["options that do not go together", [mesh, { cost: "edge_length", creaseDegrees: 30 }], /crease_degrees needs the cost quadric/],
  ["a mask", [mesh, { fixed: new Uint8Array(3) }], /fixed has 3 numbers for 900 points/],
  ["a fixed point", [mesh, { fixed: Uint16Array.of(5, 900) }], /fixed\[1\] is 900, but there are 900/],
  ["importances", [mesh, { importance: new Float32Array(3) }], /importance has 3 numbers for 900 points/],
  ["levels", [mesh, { levels: {} }], /levels is a value of Object, not Levels/],
  ["progress", [mesh, { progress: true }], /progress is true, not a function/],
];
for (const [name, args, message] of refused)
  test(`refused: ${name}`, () => {
    assert.throws(() => quadrille.simplify(...args), (error) => error instanceof Error && message.test(error.message) || assert.fail(String(error)));
  });

test("fixed points stay, by a mask and by indices", () => {
  const stay = [0, 33, 451, 899];
  const byIndex = quadrille.simplify(mesh, { faces: 100, fixed: Uint32Array.from(stay) });
  const mask = new Uint8Array(900);
  for (const point of stay) mask[point] = 255;
  assert.deepEqual(quadrille.simplify(mesh, { faces: 100, fixed: mask }).positions, byIndex.positions);
  for (const point of stay) {
    const at = 3 * byIndex.vertexMap[point];
    assert.deepEqual(byIndex.positions.slice(at, at + 3), positions.slice(3 * point, 3 * point + 3));
  }
});

test("progress is told, ends a call with what is done, and with nothing if it throws", () => {
  const parts = [];
  quadrille.simplify(mesh, { faces: 10, progress: ({ progress }) => void parts.push(progress) });
  assert.equal(parts.at(-1), 1);
  const levels = new quadrille.Levels();
  assert.equal(quadrille.simplify(mesh, { faces: 10, progress: () => false }).report.stop, "cancelled");
  const mine = new Error("mine");
  assert.throws(() => quadrille.simplify(mesh, { faces: 10, levels, progress() { throw mine; } }), mine);
  assert.ok(levels.isEmpty);
});

test("a progress function may simplify", () => {
  const inner = [];
  const progress = () => void inner.push(quadrille.simplify(mesh, { faces: 50 }).report.facesAfter);
  const outer = quadrille.simplify(mesh, { faces: 10, progress });
  assert.equal(outer.report.facesAfter, 10);
  assert.ok(inner.length > 0 && inner.every((faces) => faces === 50));
});

test("levels are told, read, and freed", () => {
  const levels = new quadrille.Levels();
  assert.throws(() => levels.at({ faces: 10 }), /nothing has been recorded/);
  const labels = Uint8Array.from({ length: indices.length / 3 }, (_, i) => (i % 58 > 29 ? 7 : 3));
  quadrille.simplify({ ...mesh, labels }, { faces: 20, relativeError: 0.5, levels });
  assert.equal(levels.finest.faces, 1682);
  assert.equal(levels.coarsest.faces, 20);
  const level = levels.at({ faces: 500 });
  assert.equal(level.indices.length, 1500);
  assert.equal(level.positions.length, 3 * level.vertices);
  assert.equal(level.attributes.uv.values.constructor, Float32Array);
  assert.deepEqual(level.labels, Uint8Array.from(level.inputFaces, (face) => labels[face]));
  assert.ok(levels.info({ distance: level.distanceBound }).faces <= 500);
  for (const stop of [undefined, {}, { face: 3 }, { faces: "3" }, { faces: 1, vertices: 1 }, { faces: -1 }])
    assert.throws(() => levels.at(stop), /a level is chosen by one of faces, vertices/);
  levels.free();
  levels.free();
  assert.throws(() => levels.at({ faces: 10 }), /have been freed/);
});

test("levels are not read while they are recorded, nor recorded by another module", async () => {
  const levels = new quadrille.Levels(), said = [];
  const progress = () => { try { levels.at({ faces: 1 }); } catch (error) { said.push(error.message); } };
  quadrille.simplify(mesh, { levels, progress });
  assert.match(said[0], /are being recorded/);
  const other = await load({ wasm: readFileSync(join(PACKAGE, "quadrille.wasm")) });
  assert.throws(() => other.simplify(mesh, { levels }), /levels are of another module/);
});

test("memory is given back, whatever happens", async () => {
  const { instance } = await WebAssembly.instantiate(readFileSync(join(PACKAGE, "quadrille.wasm")), new Proxy({}, { get: () => new Proxy({}, { get: () => () => 0 }) }));
  assert.deepEqual(Object.keys(instance.exports).filter((name) => /memory/.test(name)), ["memory"]);
  let memory;
  const Instance = WebAssembly.Instance;
  WebAssembly.Instance = class extends Instance { constructor(...args) { super(...args); memory = this.exports.memory; } };
  const own = await load().finally(() => (WebAssembly.Instance = Instance));
  const round = () => {
    const levels = new own.Levels();
    own.simplify(mesh, { faces: 100, levels });
    levels.at({ faces: 300 });
    levels.free();
    for (const [, args] of refused) assert.throws(() => own.simplify(...args));
    assert.throws(() => own.simplify(mesh, { progress() { throw new Error(); } }));
    return memory.buffer.byteLength;
  };
  const first = [round(), round(), round()].at(-1);
  for (let i = 0; i < 60; ++i) round();
  assert.equal(memory.buffer.byteLength, first);
});

test("more than there is memory for is told, and the module goes on", () => {
  const huge = new Float32Array(2 ** 29 - 2); // 4 GiB as doubles
  assert.throws(() => quadrille.simplify({ positions: huge, indices }), /out of memory/);
  assert.equal(quadrille.simplify(mesh, { faces: 100 }).report.facesAfter, 100);
});

test("the module is as small as it is said to be", () => {
  const bytes = readFileSync(join(PACKAGE, "quadrille.wasm"));
  const compressed = brotliCompressSync(bytes, { params: { [constants.BROTLI_PARAM_LGWIN]: 24 } });
  assert.ok(compressed.length < 400e3, `${bytes.length} bytes, ${compressed.length} with brotli`);
});

test("a script writes OFF files with the numbers of the program", () => {
  const folder = mkdtempSync(join(tmpdir(), "off-"));
  try {
    const written = "-0 1e-07 1e+22\n1e-04 1e+05 1e+06\n123456.5 0.1 -2.5e-09\n17 5e-324 12345678901234568";
    const [input, output] = ["in.off", "out.off"].map((name) => join(folder, name));
    const text = (points) => `OFF\n4 2 0\n${points}\n3 0 1 2\n3 1 3 2\n`;
    writeFileSync(input, text("-0 0.0000001 10000000000000000000000\n1e-4 1e5 1000000\n123456.5 0.1 -0.0000000025\n17 5e-324 12345678901234567"));
    execFileSync(process.execPath, [join(import.meta.dirname, "../../examples/products/web/simplify_off.mjs"), input, output, '{"faces": 2}', resolve(PACKAGE)], { stdio: "pipe" });
    assert.equal(readFileSync(output, "utf8"), text(written));
  } finally {
    rmSync(folder, { recursive: true });
  }
});

test("the module asks for nothing but a clock", () => {
  const module = new WebAssembly.Module(readFileSync(join(PACKAGE, "quadrille.wasm")));
  const names = WebAssembly.Module.imports(module).map(({ name }) => name);
  assert.deepEqual(names.sort(), ["clock_time_get", "emscripten_notify_memory_growth", "environ_get", "environ_sizes_get", "proc_exit", "proceed"]);
});
