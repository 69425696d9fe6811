// The modifier for three.js beside the one of three.js itself, which is fetched with the page: geometries of all kinds.
//   PACKAGE=FOLDER node --test three.test.mjs

import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";

const folder = resolve(process.env.PACKAGE);
let THREE, Theirs, Ours;
try {
  const { resolve: found } = createRequire(join(folder, "three.js"));
  THREE = await import(pathToFileURL(found("three").replace(/\.cjs$/, ".module.js")));
  ({ SimplifyModifier: Theirs } = await import(pathToFileURL(found("three/examples/jsm/modifiers/SimplifyModifier.js"))));
  ({ SimplifyModifier: Ours } = await import(pathToFileURL(join(folder, "three.js"))));
} catch (error) {
  if (!/Cannot find|MODULE_NOT_FOUND/.test(`${error.code} ${error.message}`)) throw error;
}
const skip = THREE ? false : "three.js has not been fetched";
const triangles = (geometry) => geometry.index.count / 3;

function requireSound(geometry) {
  const vertices = geometry.attributes.position.count;
  for (const index of geometry.index.array) assert.ok(index < vertices);
  for (const [name, { count, array }] of Object.entries(geometry.attributes)) {
    assert.equal(count, vertices, name);
    assert.ok(array.every(Number.isFinite), name);
  }
}

// The number of edges that have not two triangles, where vertices at one place are one.
function openEdges({ index: { array }, attributes: { position } }) {
  const places = Array.from({ length: position.count }, (_, i) => [position.getX(i), position.getY(i), position.getZ(i)].join()), edges = new Map();
  for (let i = 0; i < array.length; i += 3)
    for (let corner = 0; corner < 3; ++corner) {
      const edge = [places[array[i + corner]], places[array[i + ((corner + 1) % 3)]]].sort().join(" ");
      edges.set(edge, (edges.get(edge) ?? 0) + 1);
    }
  return Array.from(edges.values()).filter((count) => count !== 2).length;
}

// The mean distance of the centres of triangles to a unit sphere.
function meanDistance({ index: { array }, attributes: { position } }) {
  let sum = 0;
  for (let i = 0; i < array.length; i += 3) {
    const centre = [0, 1, 2].map((k) => [0, 1, 2].reduce((mean, corner) => mean + position.getComponent(array[i + corner], k) / 3, 0));
    sum += Math.abs(Math.hypot(...centre) - 1);
  }
  return (3 * sum) / array.length;
}

test("the signature is that of three.js, and what it takes is not changed", { skip }, async () => {
  assert.equal(Ours.prototype.modify.length, Theirs.prototype.modify.length);
  const torus = new THREE.TorusKnotGeometry(1, 0.3, 200, 32), before = JSON.stringify(torus.toJSON());
  const promise = new Ours().modify(torus, 5000);
  assert.ok(promise instanceof Promise);
  const simple = await promise;
  assert.equal(JSON.stringify(torus.toJSON()), before);
  assert.ok(simple instanceof THREE.BufferGeometry && simple.type === "BufferGeometry");
});

test("as many triangles as three.js leaves, with the same attributes, closer to the surface", { skip }, async () => {
  const sphere = new THREE.SphereGeometry(1, 128, 64);
  for (const count of [2000, 6000, 8000]) {
    const ours = await new Ours().modify(sphere, count), theirs = await new Theirs().modify(sphere, count);
    requireSound(ours);
    assert.ok(Math.abs(triangles(ours) - triangles(theirs)) <= 3, `${triangles(ours)}, ${triangles(theirs)}`);
    assert.deepEqual(Object.keys(ours.attributes), Object.keys(theirs.attributes));
    for (const name of Object.keys(ours.attributes)) assert.equal(ours.attributes[name].array.constructor, theirs.attributes[name].array.constructor);
    assert.ok(meanDistance(ours) < meanDistance(theirs), `${meanDistance(ours)}, ${meanDistance(theirs)}`);
  }
  const { array } = (await new Ours().modify(sphere, 6000)).attributes.normal;
  for (let i = 0; i < array.length; i += 3) assert.ok(Math.abs(Math.hypot(...array.subarray(i, i + 3)) - 1) < 1e-3);
});

test("no crack opens where a texture has its seam", { skip }, async () => {
  const box = new THREE.BoxGeometry(1, 1, 1, 8, 8, 8).translate(0.3, 0.1, 0.7), modifier = new Ours();
  for (const geometry of [box, box.toNonIndexed()]) assert.equal(openEdges(await modifier.modify(geometry, 300)), 0);
});

test("nothing and all vertices may be removed", { skip }, async () => {
  const box = new THREE.BoxGeometry(1, 1, 1, 4, 4, 4), modifier = new Ours();
  assert.equal(triangles(await modifier.modify(box, 0)), triangles(box));
  const least = await modifier.modify(box, 1e6);
  requireSound(least);
  assert.ok(triangles(least) < 30);
});

test("a geometry without an index is like one with it", { skip }, async () => {
  const knot = new THREE.TorusKnotGeometry(1, 0.3, 120, 16), modifier = new Ours();
  const indexed = await modifier.modify(knot, 1500), loose = await modifier.modify(knot.toNonIndexed(), 1500);
  requireSound(loose);
  assert.ok(Math.abs(triangles(indexed) - triangles(loose)) <= 2);
  const bare = new THREE.BufferGeometry();
  bare.setAttribute("position", knot.toNonIndexed().attributes.position);
  const shape = await modifier.modify(bare, 1500);
  assert.deepEqual(Object.keys(shape.attributes), ["position"]);
  assert.ok(shape.attributes.position.count < 600, "vertices at one place are one");
});

test("groups stay, each with its material, on its side", { skip }, async () => {
  const box = new THREE.BoxGeometry(1, 1, 1, 12, 12, 12);
  const simple = await new Ours().modify(box, 700);
  assert.deepEqual(simple.groups.map(({ materialIndex }) => materialIndex), [0, 1, 2, 3, 4, 5]);
  assert.equal(simple.groups.reduce((sum, { count }) => sum + count, 0), simple.index.count);
  const axis = [[0, 0.5], [0, -0.5], [1, 0.5], [1, -0.5], [2, 0.5], [2, -0.5]];
  for (const { start, count, materialIndex } of simple.groups)
    for (let i = start; i < start + count; ++i) {
      const [component, side] = axis[materialIndex];
      assert.ok(Math.abs(simple.attributes.position.getComponent(simple.index.getX(i), component) - side) < 1e-5);
    }
  box.clearGroups();
  box.addGroup(0, 300, 3); // two materials on some triangles, none on others
  box.addGroup(150, 600, 1);
  const twice = await new Ours().modify(box, 300);
  assert.deepEqual(new Set(twice.groups.map(({ materialIndex }) => materialIndex)), new Set([3, 1]));
  assert.ok(twice.groups.every(({ start, count }) => start % 3 === 0 && count > 0 && start + count <= twice.index.count));
});

// A cylinder that bends: two bones, a morph target, tangents, colours in bytes, and numbers of the user's.
function limb() {
  const geometry = new THREE.CylinderGeometry(0.2, 0.2, 2, 32, 40, true), { position } = geometry.attributes;
  const { count } = position, of = (size, numbers) => Float32Array.from({ length: size * count }, (_, i) => numbers(Math.floor(i / size), i % size));
  const up = (i) => (position.getY(i) + 1) / 2;
  geometry.setAttribute("skinIndex", new THREE.Uint16BufferAttribute(Uint16Array.from({ length: 4 * count }, (_, i) => [7, 3, 0, 0][i % 4]), 4));
  geometry.setAttribute("skinWeight", new THREE.BufferAttribute(of(4, (i, k) => [up(i), 1 - up(i), 0, 0][k]), 4));
  geometry.setAttribute("tangent", new THREE.BufferAttribute(of(4, (i, k) => [-position.getZ(i) / 0.2, 0, position.getX(i) / 0.2, -1][k]), 4));
  geometry.setAttribute("part", new THREE.BufferAttribute(Uint8Array.from(of(1, (i) => 200 * up(i))), 1));
  geometry.setAttribute("color", new THREE.BufferAttribute(Uint8Array.from(of(4, (i, k) => (k === 3 ? 255 : 255 * up(i)))), 4, true));
  geometry.setAttribute("heat", new THREE.BufferAttribute(of(1, (i) => 20 + 10 * up(i)), 1));
  const half = new THREE.Float16BufferAttribute(new Uint16Array(count), 1);
  for (let i = 0; i < count; ++i) half.setX(i, up(i));
  geometry.setAttribute("half", half);
  geometry.morphAttributes.position = [new THREE.BufferAttribute(of(3, (i, k) => (k === 0 ? up(i) : 0)), 3)];
  geometry.morphTargetsRelative = true;
  geometry.name = "limb";
  return geometry;
}

test("skins, morph targets, tangents, colours in bytes and any numbers go along", { skip }, async () => {
  const simple = await new Ours().modify(limb(), 1320);
  requireSound(simple);
  assert.equal(simple.name, "limb");
  const { position, skinIndex, skinWeight, tangent, color, heat, half, part } = simple.attributes, [morph] = simple.morphAttributes.position;
  assert.equal(simple.morphTargetsRelative, true);
  assert.ok(color.normalized && color.array instanceof Uint8Array && skinIndex.array instanceof Uint16Array);
  assert.ok(triangles(simple) < 100 && morph.count === position.count);
  for (let i = 0; i < position.count; ++i) {
    const up = (position.getY(i) + 1) / 2, weights = [0, 1, 2, 3].map((k) => skinWeight.getComponent(i, k));
    assert.ok(Math.abs(weights.reduce((a, b) => a + b) - 1) < 1e-6);
    const ofSeven = weights.reduce((sum, weight, k) => sum + (skinIndex.getComponent(i, k) === 7 ? weight : 0), 0);
    const near = (value, what, tolerance = 0.05) => assert.ok(Math.abs(value - up) < tolerance, `${what} ${value} at ${up}`);
    near(ofSeven, "weight");
    near(color.getX(i), "colour");
    near((heat.getX(i) - 20) / 10, "heat");
    near(half.getX(i), "half float");
    near(part.getX(i) / 200, "whole number", 0.0035);
    near(morph.getX(i), "morph target");
    assert.equal(tangent.getW(i), -1);
    assert.ok(Math.abs(Math.hypot(tangent.getX(i), tangent.getY(i), tangent.getZ(i)) - 1) < 1e-6);
  }
});

test("interleaved attributes come back as plain ones", { skip }, async () => {
  const plane = new THREE.PlaneGeometry(1, 1, 20, 20), { position, uv } = plane.attributes;
  const buffer = new THREE.InterleavedBuffer(new Float32Array(5 * position.count), 5);
  for (let i = 0; i < position.count; ++i) buffer.array.set([position.getX(i), position.getY(i), 0, uv.getX(i), uv.getY(i)], 5 * i);
  const geometry = new THREE.BufferGeometry().setIndex(plane.index);
  geometry.setAttribute("position", new THREE.InterleavedBufferAttribute(buffer, 3, 0));
  geometry.setAttribute("uv", new THREE.InterleavedBufferAttribute(buffer, 2, 3));
  const simple = await new Ours().modify(geometry, 400);
  requireSound(simple);
  for (let i = 0; i < simple.attributes.uv.count; ++i)
    assert.ok(Math.abs(simple.attributes.uv.getX(i) - simple.attributes.position.getX(i) - 0.5) < 1e-5);
});

test("options are those of the package", { skip }, async () => {
  const sphere = new THREE.SphereGeometry(1, 64, 32);
  const close = await new Ours({ relativeError: 1e-3, cost: "memoryless_quadric", attributes: { uv: { seams: "kept" } } }).modify(sphere, 0);
  assert.ok(triangles(close) < triangles(sphere) && meanDistance(close) < 4e-3);
});

const refused = [
  ["no geometry", () => [{}, 10], /not a BufferGeometry/],
  ["no count", () => [new THREE.BoxGeometry()], /the count of vertices to remove is undefined/],
  ["no positions", () => [new THREE.BufferGeometry(), 1], /no positions/],
  ["instances", () => [new THREE.InstancedBufferGeometry().copy(new THREE.BoxGeometry()), 1], /InstancedBufferGeometry/],
  ["an attribute of another length", () => [new THREE.BoxGeometry().setAttribute("heat", new THREE.Float32BufferAttribute([1, 2], 1)), 1], /heat has 2 values for 24 vertices/],
  ["a coordinate that is not finite", () => {
    const box = new THREE.BoxGeometry();
    box.attributes.position.setX(3, NaN);
    return [box, 1];
  }, /not finite/],
];
for (const [name, args, message] of refused)
  test(`refused: ${name}`, { skip }, () => assert.rejects(new Ours().modify(...args()), (error) => error instanceof Error && message.test(error.message) || assert.fail(error)));

test("an option that there is not is told", { skip }, async () => {
  const box = new THREE.BoxGeometry();
  await assert.rejects(new Ours({ face: 3 }).modify(box, 1), /the options have "face"/);
  await assert.rejects(new Ours({ attributes: { colour: {} } }).modify(box, 1), /no attribute colour, but one of normal, uv/);
});
