// Every tenth level that levels.js makes of a page is the one that the program reads from a record of the
// same run.
//   node page_levels.mjs PROGRAM FOLDER_OF_THE_VIEWER

import { readFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { ball, check, elementOf, Folder, headerOf, off } from "./page_files.mjs";

const [program, viewer] = process.argv.slice(2);
const load = (name) => import(pathToFileURL(join(viewer, name)));
const { bytesOfBase64, Levels } = await load("levels.js");
const { Corners } = await load("corners.js");
const folder = new Folder(program);

function trianglesOfOff(text, { center, unit }) {
  const numbers = text.trim().split(/\s+/).slice(1).map(Number);
  const [vertices, faces] = numbers;
  const triangles = [];
  for (let f = 0; f < faces; ++f) {
    const at = 3 + 3 * vertices + 4 * f;
    triangles.push(
      turned(numbers.slice(at + 1, at + 4).map((v) =>
        [0, 1, 2].map((k) => Math.fround(numbers[3 + 3 * v + k] / unit - center[k] / unit)).join(" "))),
    );
  }
  return triangles.sort();
}

// With the least corner first.
function turned(corners) {
  const least = corners.indexOf([...corners].sort()[0]);
  return [0, 1, 2].map((i) => corners[(least + i) % 3]).join(", ");
}

function trianglesOfPage(corners, faces) {
  const triangles = [];
  for (let f = 0; f < faces; ++f)
    triangles.push(turned([0, 1, 2].map((k) => corners.positions.subarray(9 * f + 3 * k, 9 * f + 3 * k + 3).join(" "))));
  return triangles.sort();
}

function compare(name, mesh, ...options) {
  const input = folder.write(`${name}.off`, off(mesh.points, mesh.faces));
  const page = folder.page(`${name}.html`, input, "--faces", "4", ...options);
  folder.run(input, "coarsest.off", "--record", "levels.qlv", "--faces", "4", ...options);
  check(folder.page("again.html", input, "--faces", "4", ...options) === page, "the same page twice");

  const header = headerOf(page);
  const levels = new Levels(header, bytesOfBase64(elementOf(page, "data")));
  const ofRecord = folder.page("record.html", "--from", "levels.qlv");
  check(elementOf(ofRecord, "data") === elementOf(page, "data"), `${name}: the page of a record`);

  const corners = new Corners(levels, header.places);
  for (let c = 0; c <= levels.contractions; c += levels.contractions < 30 ? 1 : 10) {
    const faces = levels.facesAt(c);
    if (c < levels.contractions && levels.facesAt(c + 1) === faces) continue; // the record has the coarser one
    folder.run("--from", "levels.qlv", "level.off", "--faces", String(faces), "--quiet");
    const wanted = trianglesOfOff(readFileSync(folder.file("level.off"), "utf8"), header);
    check(corners.goTo(levels.find(faces)) === wanted.length, `${name}: the number of faces at ${faces}`);
    const shown = trianglesOfPage(corners, wanted.length);
    check(shown.join() === wanted.join(), `${name}: the level of ${faces} faces`);
    check(corners.normals.subarray(0, 9 * faces).every(Number.isFinite), `${name}: normals`);
  }
}

try {
  const a = ball(12), b = ball(6);
  b.points = b.points.map(([x, y, z]) => [5 + x / 20, y / 20, z / 20]); // small parts may vanish
  const both = { points: [...a.points, ...b.points], faces: [...a.faces, ...b.faces.map((f) => f.map((v) => v + a.points.length))] };
  const leaf = [0, 1, 2].map((k) => [k, 9, k * k]);
  compare("ball", a);
  compare("parts", both, "--drop-parts");
  compare("joined", both, "--pairs", "4");
  compare("non-manifold", { points: [...a.points, [0, 0, 3], [0, 3, 0]], faces: [...a.faces, [0, 1, a.points.length], [0, 1, a.points.length + 1]] },
    "--topology", "free");
  compare("triangle", { points: leaf, faces: [[0, 1, 2]] });
} finally {
  folder.remove();
}
