// What the native program takes and gives, as typed arrays.

import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

const inC = (name) => name.replace(/[A-Z]/g, (letter) => `_${letter.toLowerCase()}`);

// { options, attributes: {uv: {seams: "kept"}}, levels: [1000], fixed: 7, without: ["uv"] } as arguments.
function wordsOf({ options = {}, attributes = {}, levels = [], fixed, selected, without = [] }) {
  const words = Object.entries(options).map(([name, value]) => `${inC(name)}=${Number.isFinite(+value) ? +value : value}`);
  for (const [channel, given] of Object.entries(attributes))
    for (const [name, value] of Object.entries(given)) words.push(`${channel}.${inC(name)}=${Number.isFinite(+value) ? +value : value}`);
  if (levels.length > 0) words.push(`levels=${levels}`);
  if (fixed) words.push(`fixed=${fixed}`);
  if (selected) words.push(`selected=${selected}`);
  for (const name of without) words.push(`without=${name}`);
  return words;
}

// Simplifies natively. Returns the mesh as the package takes it, and arrays(prefix) of what has come out.
export function simplifiedNatively(program, model, asked) {
  const folder = mkdtempSync(join(tmpdir(), "native-"));
  try {
    const channels = execFileSync(program, [model, folder, ...wordsOf(asked)], { encoding: "utf8" }).trim().split("\n").filter(Boolean);
    const array = (Type, name) => new Type(new Uint8Array(readFileSync(join(folder, name))).buffer);
    const mesh = { positions: array(Float64Array, "in.positions"), indices: array(Uint32Array, "in.indices"), attributes: {} };
    const labels = array(Uint32Array, "in.labels");
    if (labels.length > 0) mesh.labels = labels;
    for (const [name, kind, components] of channels.map((line) => line.split(" "))) {
      const indices = array(Uint32Array, `in.${name}.indices`);
      mesh.attributes[name] = {
        kind, components: Number(components), values: array(Float64Array, `in.${name}.values`),
        ...(indices.length > 0 ? { indices } : {}), ...asked.attributes?.[name],
      };
    }
    const output = (prefix) => ({
      positions: array(Float64Array, `${prefix}positions`),
      indices: array(Uint32Array, `${prefix}indices`),
      inputFaces: array(Uint32Array, `${prefix}inputFaces`),
      labels: prefix === "out." ? array(Uint32Array, "out.labels") : new Uint32Array(),
      attributes: Object.fromEntries(Object.keys(mesh.attributes).map((name) =>
        [name, { values: array(Float64Array, `${prefix}${name}.values`), indices: array(Uint32Array, `${prefix}${name}.indices`) }])),
    });
    const levels = (asked.levels ?? []).map((faces) => ({ faces, ...output(`level.${faces}.`) }));
    return { mesh, result: output("out."), levels };
  } finally {
    rmSync(folder, { recursive: true });
  }
}

// Every n-th, as the native program takes them.
export const each = (count, n) => Uint8Array.from({ length: count }, (_, i) => (i % n === 0 ? 1 : 0));
