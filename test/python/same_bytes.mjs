// Simplifies a surface by the npm package for same_bytes.py, whose files same_bytes.c describes.
//   node same_bytes.mjs PACKAGE IN OUT OPTIONS    OPTIONS as JSON

import { readFileSync, writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

const [packageFolder, input, output, options] = process.argv.slice(2);
const { load } = await import(pathToFileURL(join(resolve(packageFolder), "index.js")));
const quadrille = await load();

const bytes = new Uint8Array(readFileSync(input)).buffer;
let at = 0;
const rows = (Type) => {
  const count = 3 * Number(new DataView(bytes).getBigUint64(at, true));
  const array = new Type(bytes.slice(at + 8, at + 8 + count * Type.BYTES_PER_ELEMENT));
  at += 8 + count * Type.BYTES_PER_ELEMENT;
  return array;
};
const result = quadrille.simplify({ positions: rows(Float64Array), indices: rows(Uint32Array) }, JSON.parse(options));
const written = [result.positions, result.indices].flatMap((array) => [
  new Uint8Array(new BigUint64Array([BigInt(array.length / 3)]).buffer),
  new Uint8Array(array.buffer, array.byteOffset, array.byteLength),
]);
writeFileSync(output, Buffer.concat(written));
