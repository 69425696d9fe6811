// The package gives the same bytes as the library that is built for this machine.
//   NATIVE=PROGRAM PACKAGE=FOLDER CGAL_DATA_DIR=FOLDER node --test same_bytes.test.mjs

import assert from "node:assert/strict";
import { createHash } from "node:crypto";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { after, test } from "node:test";
import { pathToFileURL } from "node:url";
import { each, simplifiedNatively } from "./native.mjs";
import { ball, sheet } from "./surfaces.mjs";

const { NATIVE, PACKAGE, CGAL_DATA_DIR } = process.env;
const { load } = await import(pathToFileURL(resolve(PACKAGE, "index.js")));
const quadrille = await load();

const folder = mkdtempSync(join(tmpdir(), "web-"));
after(() => rmSync(folder, { recursive: true }));
const sheetFile = join(folder, "sheet.obj"), ballFile = join(folder, "ball.off");
sheet(sheetFile, 60);
ball(ballFile, 40);
const model = (name) => join(CGAL_DATA_DIR, "meshes", name);
const bare = ["uv", "normals", "labels"];

const cases = [
  ["a tenth", model("elephant.off"), { options: { ratio: 0.1 } }],
  ["a bound", model("elephant.off"), { options: { relativeError: 0.01, cost: "memoryless_quadric" } }],
  ["a bound both ways", model("cow.off"), { options: { error: 0.02, bothWays: true } }],
  ["creases", model("fandisk.off"), { options: { faces: 400, creaseDegrees: 40, creaseWeight: 10, lineWeight: 0.001 } }],
  ["weights", model("cow.off"), { options: { faces: 500, weighting: "by_squared_area", normalNoise: 0.01, positionNoise: 0.001 } }],
  ["edge lengths", model("cow.off"), { options: { ratio: 0.2, cost: "edge_length", placement: "midpoint" } }],
  ["thin features", model("dino.off"), { options: { ratio: 0.1, cost: "thin_feature_quadric", placement: "endpoint" } }],
  ["passes", model("elephant.off"), { options: { ratio: 0.1, order: "relaxed", refresh: true } }],
  ["pairs", model("elephant.off"), { options: { faces: 200, pairsCloserThan: 0.02 } }],
  ["parts that vanish", model("elephant.off"), { options: { faces: 50, topology: "components_may_vanish" } }],
  ["no self-intersection", model("cow.off"), { options: { faces: 600, noSelfIntersection: true } }],
  ["normals that stay", model("elephant.off"), { options: { faces: 600, normalDeviation: 60 } }],
  ["fixed and selected", model("cow.off"), { options: { ratio: 0.5 }, fixed: 7, selected: 2 }],
  ["levels", model("elephant.off"), { options: { faces: 200 }, levels: [3000, 1001, 200] }],
  ["a texture with labels", sheetFile, { options: { faces: 500 }, without: ["normals"] }],
  ["charts that are kept", sheetFile, { options: { ratio: 0.1, cost: "memoryless_quadric" }, attributes: { uv: { seams: "kept", importance: 2 } } }],
  ["levels of a texture", sheetFile, { options: { faces: 300 }, levels: [2000, 300], without: ["labels"] }],
  ["colours", ballFile, { options: { faces: 500 } }],
  ["colours of points that stay", ballFile, { options: { faces: 500 }, attributes: { colors: { newValues: "existing" } } }],
  ["points at one place", ballFile, { options: { faces: 700, splitVertices: true } }],
  ["the shape alone", sheetFile, { options: { costLimit: 1e-9 }, without: bare }],
];

const digest = (array) => createHash("sha256").update(new Uint8Array(array.buffer, array.byteOffset, array.byteLength)).digest("hex");

function assertSame(ours, native) {
  for (const name of ["positions", "indices", "inputFaces"]) assert.equal(digest(ours[name]), digest(native[name]), name);
  if (native.labels.length > 0) assert.equal(digest(ours.labels), digest(native.labels), "labels");
  for (const [name, { values, indices }] of Object.entries(native.attributes)) {
    assert.equal(digest(ours.attributes[name].values), digest(values), `values of ${name}`);
    assert.equal(digest(ours.attributes[name].indices ?? new Uint32Array()), digest(indices), `indices of ${name}`);
  }
}

for (const [name, file, asked] of cases)
  test(`the same bytes: ${name}`, () => {
    const { mesh, result, levels } = simplifiedNatively(NATIVE, file, asked);
    assert.ok(result.indices.length > 0 && result.indices.length < mesh.indices.length);
    const options = { ...asked.options };
    if (asked.fixed) options.fixed = each(mesh.positions.length / 3, asked.fixed);
    if (asked.selected) options.selected = each(mesh.indices.length / 3, asked.selected);
    if (levels.length > 0) options.levels = new quadrille.Levels();
    assertSame(quadrille.simplify(mesh, options), result);
    for (const { faces, ...level } of levels) assertSame(options.levels.at({ faces }), level);
  });
