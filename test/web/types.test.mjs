// The types are those that TypeScript takes, and every option that they name is taken by the package.
//   PACKAGE=FOLDER WORK=FOLDER_WITH_node_modules node --test types.test.mjs

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { after, test } from "node:test";
import { pathToFileURL } from "node:url";

const { PACKAGE, WORK } = process.env;
const compiler = join(WORK ?? ".", "node_modules/typescript/lib/tsc.js");
const folder = mkdtempSync(join(tmpdir(), "types-"));
after(() => rmSync(folder, { recursive: true }));

const program = `
import { load, type Level, type Levels, type Options, type Quadrille } from "quadrille";
const quadrille: Quadrille = await load();
const positions = new Float32Array(9), indices = new Uint16Array(3);
const options: Options = { faces: 3, cost: "memoryless_quadric", progress: ({ progress }) => progress < 0.5 };
const levels: Levels = new quadrille.Levels();
const uv = { kind: "texture", values: new Float64Array(6), seams: "kept" } as const;
const result = quadrille.simplify({ positions, indices, attributes: { uv } }, { ...options, levels });
const same: Float32Array = result.positions, triangles: Uint16Array = result.indices, texture: Float64Array = result.attributes.uv.values;
const level: Level = levels.at({ faces: 3 });
console.log(same, triangles, texture, level.error, result.report.rejections["topology"], result.vertexMap?.[0]);
// @ts-expect-error there is no such option
quadrille.simplify({ positions, indices }, { face: 3 });
// @ts-expect-error there is no such cost
quadrille.simplify({ positions, indices }, { cost: "quadrics" });
// @ts-expect-error positions are no array
quadrille.simplify({ positions: [0, 0, 0], indices });
// @ts-expect-error a level is asked for by one thing
levels.at({ face: 3 });
// @ts-expect-error there is no such attribute
result.attributes.color;
`;

test("TypeScript takes the types", { skip: !existsSync(compiler) }, () => {
  mkdirSync(join(folder, "node_modules"));
  symlinkSync(resolve(PACKAGE), join(folder, "node_modules/quadrille"));
  writeFileSync(join(folder, "program.ts"), program);
  writeFileSync(join(folder, "package.json"), JSON.stringify({ type: "module" }));
  const compilerOptions = { noEmit: true, strict: true, target: "es2022", module: "nodenext", types: [], lib: ["es2022", "dom"] };
  writeFileSync(join(folder, "tsconfig.json"), JSON.stringify({ compilerOptions, files: ["program.ts"] }));
  try {
    execFileSync(process.execPath, [compiler], { cwd: folder, encoding: "utf8" });
  } catch (error) {
    assert.fail(error.stdout);
  }
});

test("every option of the types is taken", async () => {
  const { load } = await import(pathToFileURL(resolve(PACKAGE, "index.js")));
  const quadrille = await load();
  const types = ["index.d.ts", "option_table.d.ts"].map((file) => readFileSync(join(PACKAGE, file), "utf8")).join("\n");
  const members = (name) => [...types.match(new RegExp(`interface ${name}.* \\{\\n([^]*?)\\n\\}`))[1].matchAll(/^  (\w+)\??: /gm)].map(([, member]) => member);
  const said = (call) => { try { call(); } catch ({ message }) { return message; } return ""; };
  const refusal = said(() => quadrille.simplify({ positions: new Float32Array(9), indices: Uint8Array.of(0, 1, 2) }, { x: 1 }));
  assert.deepEqual([...members("Options"), ...members("CallOptions")].sort(), refusal.split("not one of ")[1].split(", ").sort());
  const ofAttribute = said(() => quadrille.simplify({ positions: new Float32Array(9), indices: Uint8Array.of(0, 1, 2), attributes: { a: { x: 1 } } }));
  assert.deepEqual([...members("Attribute"), ...members("ChannelOptions")].sort(), ofAttribute.split("not one of ")[1].split(", ").sort());
  const { report } = quadrille.simplify({ positions: Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0), indices: Uint8Array.of(0, 1, 2) });
  for (const name of Object.keys(report)) assert.ok(members("Report").includes(name), name);
});
