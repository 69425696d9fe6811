// Simplifies an OFF file in node, and writes the bytes that the program writes for the same options:
//   node simplify_off.mjs IN.off OUT.off '{"ratio": 0.1}' [PACKAGE]
// PACKAGE is the folder of the built package, build/web/package/quadrille by default.

import { readFileSync, writeFileSync } from "node:fs";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";

// The shortest digits of a number, as std::to_chars writes them: without an exponent unless that is shorter.
function numberText(x) {
  if (Object.is(x, -0)) return "-0";
  const [digits, exponent] = x.toExponential().split("e"), sign = exponent[0], power = exponent.slice(1).padStart(2, "0");
  const scientific = `${digits}e${sign}${power}`;
  const places = Math.max(digits.replace(/^-?\d\.?/, "").length - Number(exponent), 0);
  const fixed = places > 100 ? null : Number.isInteger(x) ? BigInt(x).toString() : x.toFixed(places);
  return fixed !== null && fixed.length <= scientific.length ? fixed : scientific;
}

function readOff(path) {
  const words = readFileSync(path, "utf8").replace(/#.*/g, "").split(/\s+/).filter(Boolean);
  if (words[0] !== "OFF") throw new Error(`${path} does not begin with OFF`);
  const [points, faces] = words.slice(1, 3).map(Number), begin = 4 + 3 * points;
  const positions = Float64Array.from({ length: 3 * points }, (_, i) => Number(words[4 + i]));
  const indices = new Uint32Array(3 * faces);
  for (let face = 0; face < faces; ++face) {
    if (words[begin + 4 * face] !== "3") throw new Error(`${path}: face ${face} is not a triangle, without a colour`);
    for (let corner = 0; corner < 3; ++corner) indices[3 * face + corner] = Number(words[begin + 4 * face + 1 + corner]);
  }
  return { positions, indices };
}

function offOf({ positions, indices }) {
  const row = (array, i) => Array.from(array.subarray(3 * i, 3 * i + 3), numberText).join(" ");
  const rows = (array, prefix) => Array.from({ length: array.length / 3 }, (_, i) => `${prefix}${row(array, i)}\n`).join("");
  return `OFF\n${positions.length / 3} ${indices.length / 3} 0\n${rows(positions, "")}${rows(indices, "3 ")}`;
}

const [input, output, options = "{}", folder = resolve(import.meta.dirname, "../../../build/web/package/quadrille")] = process.argv.slice(2);
const { load } = await import(pathToFileURL(resolve(folder, "index.js")));
const { report, ...result } = (await load()).simplify(readOff(input), JSON.parse(options));
writeFileSync(output, offOf(result));
console.error(report.text);
