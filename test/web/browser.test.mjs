// The package in headless Chromium: a page and a worker simplify, to the bytes of node, and fetch nothing but the package.
//   PACKAGE=FOLDER CHROMIUM=PROGRAM node --test browser.test.mjs

import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { createServer } from "node:http";
import { join, resolve } from "node:path";
import { after, test } from "node:test";
import { pathToFileURL } from "node:url";
import { Chromium } from "../page/chromium.mjs";

const { PACKAGE, CHROMIUM = "/usr/bin/chromium" } = process.env;
const isHere = existsSync(CHROMIUM);

// What is run in each place: a digest of a simplified sheet.
async function work(load) {
  const quadrille = await load();
  const n = 100, positions = new Float32Array(3 * n * n), indices = [];
  for (let i = 0; i < n * n; ++i) {
    positions.set([i % n, Math.floor(i / n), 5 * Math.sin(i / 700)], 3 * i);
    if (i % n > 0 && i >= n) indices.push(i - n - 1, i - n, i - 1, i - n, i, i - 1);
  }
  const mesh = { positions, indices: Uint32Array.from(indices), attributes: { height: { values: positions.filter((_, i) => i % 3 === 2) } } };
  const result = quadrille.simplify(mesh, { faces: 1000, relativeError: 0.01 });
  let message = "";
  try { quadrille.simplify(mesh, { relativeError: -1 }); } catch (error) { message = error.message; }
  const bytes = await new Blob([result.positions, result.indices, result.attributes.height.values]).arrayBuffer();
  let digest = 0;
  for (const byte of new Uint8Array(bytes)) digest = (31 * digest + byte) >>> 0;
  return `${result.report.facesAfter} ${bytes.byteLength} ${digest} ${message}`;
}

const types = { js: "text/javascript", wasm: "application/wasm", html: "text/html" };
const files = {
  "/page.html": `<!doctype html><link rel="icon" href="data:,"><script type="module">
    import { load } from "/quadrille/index.js";
    window.answer = await (${work})(load);
  </script>`,
  "/worker.html": `<!doctype html><link rel="icon" href="data:,"><script>
    const worker = new Worker("/worker.js", { type: "module" });
    worker.onmessage = ({ data }) => (window.answer = data);
  </script>`,
  "/worker.js": `import { load } from "/quadrille/index.js"; postMessage(await (${work})(load));`,
};
const server = createServer((request, response) => {
  const name = request.url.split("/").pop(), type = types[name.split(".").pop()];
  const content = files[request.url] ?? (request.url.startsWith("/quadrille/") ? readFileSync(join(PACKAGE, name)) : null);
  response.writeHead(content ? 200 : 404, { "Content-Type": type ?? "text/plain",
    "Content-Security-Policy": "default-src 'self' 'unsafe-inline' 'wasm-unsafe-eval'; img-src data:" }).end(content);
});
await new Promise((ready) => server.listen(0, "127.0.0.1", ready));
const address = `http://127.0.0.1:${server.address().port}`;
const browser = isHere ? new Chromium(CHROMIUM, ["127.0.0.1"]) : null;
after(async () => {
  await browser?.close();
  server.close();
});

for (const page of ["page.html", "worker.html"])
  test(`the same bytes in Chromium: ${page}`, { skip: !isHere }, async () => {
    const { load } = await import(pathToFileURL(resolve(PACKAGE, "index.js")));
    const tab = await browser.open(`${address}/${page}`);
    await tab.until("window.answer !== undefined", 30);
    const answer = await tab.value("window.answer");
    assert.equal(answer, await work(load));
    assert.match(answer, /^1000 .* the limit -1 is not a distance$/);
    assert.deepEqual(tab.complaints(), []);
    assert.ok(tab.requests().every((url) => url.startsWith(address)));
  });
