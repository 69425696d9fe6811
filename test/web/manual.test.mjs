// The programs of the manual and of the package's own page run, and are short.
//   PACKAGE=FOLDER node --test manual.test.mjs

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { after, test } from "node:test";

const root = resolve(import.meta.dirname, "../..");
const folder = mkdtempSync(join(tmpdir(), "manual-"));
after(() => rmSync(folder, { recursive: true }));
mkdirSync(join(folder, "node_modules"));
symlinkSync(resolve(process.env.PACKAGE), join(folder, "node_modules/quadrille"));
const three = resolve(process.env.PACKAGE, "../node_modules/three"); // if it has been fetched for the page
if (existsSync(three)) symlinkSync(three, join(folder, "node_modules/three"));

for (const document of ["doc/manual/web.md", "doc/manual/for_games.md", "examples/products/web/package/README.md"]) {
  const blocks = [...readFileSync(join(root, document), "utf8").matchAll(/^```js\n([^]*?)^```$/gm)].map(([, code]) => code);
  blocks.forEach((code, i) =>
    test(`program ${i + 1} of ${document}`, { skip: code.includes('from "three"') && !existsSync(three) }, () => {
      const file = join(folder, `program${i}.mjs`);
      writeFileSync(file, code);
      assert.ok(code.split("\n").length <= 16, "longer than 15 lines");
      const output = execFileSync(process.execPath, [file], { encoding: "utf8", stdio: ["ignore", "pipe", "pipe"] });
      assert.equal(/NaN|undefined/.test(output), false, output);
      assert.ok(output.length > 5 || !code.includes("console.log"), output);
    }),
  );
  test(`there are programs in ${document}`, () => assert.ok(blocks.length > 0));
}
