// The page simplify.html in headless Chromium, without a network: what is dropped on it is simplified there, and comes
// out as the package simplifies it.
//   PAGE=simplify.html PACKAGE=FOLDER CHROMIUM=PROGRAM node --test page.test.mjs

import assert from "node:assert/strict";
import { existsSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { after, test } from "node:test";
import { pathToFileURL } from "node:url";
import { Chromium } from "../page/chromium.mjs";
import { ball, gltf, sheet } from "./surfaces.mjs";

const { PAGE, PACKAGE, CHROMIUM = "/usr/bin/chromium", SCREENSHOTS } = process.env;
const skip = !PAGE || !existsSync(PAGE) || !existsSync(CHROMIUM);
const browser = skip ? null : new Chromium(CHROMIUM);
const folder = mkdtempSync(join(tmpdir(), "simplify-"));
after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true });
});

const url = skip ? "" : String(pathToFileURL(resolve(PAGE)));
const state = "document.getElementById('state').textContent";
const facts = "document.getElementById('facts').textContent";
const isStill = "document.getElementById('state').hidden";
const change = (id, what) => `(() => { const e = document.getElementById("${id}"); ${what}; e.dispatchEvent(new Event("change")); })()`;

async function opened() {
  const tab = await browser.open(`${url}#turn=0`);
  await tab.until("document.body.classList.contains('ready')", 15);
  await browser.send("Browser.setDownloadBehavior", { behavior: "allow", downloadPath: folder });
  return tab;
}
async function picture(tab, name) {
  if (SCREENSHOTS) writeFileSync(join(SCREENSHOTS, `${name}.png`), await tab.screenshot());
}
// A file is dropped as a user drops it.
async function drop(tab, file, text) {
  await tab.value(`(() => {
    const data = new DataTransfer();
    data.items.add(new File([${JSON.stringify(text)}], ${JSON.stringify(file)}));
    dispatchEvent(new DragEvent("drop", { dataTransfer: data, cancelable: true }));
  })()`);
}
// The content of a file whose name is a pattern, as the page says that it has been saved.
async function downloaded(tab, pattern) {
  await tab.value("document.getElementById('download').click()");
  await tab.until(`new RegExp(${JSON.stringify(pattern)}).test(${state})`);
  const name = (await tab.value(state)).split(":")[0];
  for (let i = 0; i < 100 && !readdirSync(folder).includes(name); ++i) await new Promise((done) => setTimeout(done, 50));
  return readFileSync(join(folder, name), "utf8");
}
function close(tab) {
  assert.deepEqual(tab.complaints(), []);
  assert.deepEqual(tab.requests().filter((request) => request !== url && request !== `${url}#turn=0`), []);
  return tab.send("Page.close");
}

test("it says that nothing leaves the machine, and its policy lets nothing out", { skip }, async () => {
  const tab = await opened();
  await picture(tab, "drop");
  assert.match(await tab.value("document.body.innerText"), /Nothing leaves your machine/);
  assert.match(readFileSync(PAGE, "utf8"), /default-src 'none';[^"]* connect-src data: blob:"/);
  assert.equal(await tab.value("fetch('http://127.0.0.1/').then(() => 'sent', () => 'refused')"), "refused");
  await tab.send("Page.close");
});

test("a textured OBJ file: levels, seams, an error limit, and the file that comes out", { skip }, async () => {
  const tab = await opened(), file = join(folder, "sheet.obj");
  sheet(file, 60);
  await drop(tab, "sheet.obj", readFileSync(file, "utf8"));
  await tab.until(`${facts}.startsWith("6,962 faces") && ${isStill}`);
  assert.equal(await tab.value("document.getElementById('seams').hidden"), false);
  await tab.value(`(() => { const e = document.getElementById("count"); e.value = 500; e.dispatchEvent(new Event("input")); })()`);
  await tab.until(`${facts}.startsWith("500 faces")`);
  await picture(tab, "sheet");
  const obj = await downloaded(tab, "sheet-500.obj");
  assert.equal(obj.match(/^f /gm).length, 500);
  assert.ok(obj.match(/^vt /gm).length > 250 && /^usemtl upper$/m.test(obj) && /^mtllib sheet.mtl$/m.test(obj));
  await tab.value(change("keep", "e.checked = true"));
  await tab.until(`${facts}.startsWith("500 faces") && ${isStill}`);
  await tab.value(change("limit", "e.value = 0.2"));
  await tab.until(`document.getElementById("notes").textContent.includes("0.2 % of the diagonal") && ${isStill}`);
  const coarsest = Number(await tab.value("document.getElementById('count').min"));
  assert.ok(coarsest > 60 && coarsest < 3000, String(coarsest));
  await close(tab);
});

test("positions are those of the package", { skip }, async () => {
  const { load } = await import(pathToFileURL(resolve(PACKAGE, "index.js")));
  const tab = await opened(), file = join(folder, "ball.off");
  ball(file, 30);
  const text = readFileSync(file, "utf8").replace("COFF", "OFF").replace(/^((?:\S+ ){2}\S+) \d+ \d+ \d+ 255$/gm, "$1");
  await drop(tab, "ball.off", text);
  await tab.until(`${facts}.includes("3,600 faces") && ${isStill}`);
  await tab.value(`(() => { const e = document.getElementById("count"); e.value = 300; e.dispatchEvent(new Event("input")); })()`);
  await tab.until(`${facts}.startsWith("300 faces")`);
  const lines = (await downloaded(tab, "ball-300.off")).split("\n").filter((line) => /^[-0-9]/.test(line));
  const [points] = lines[0].split(" ").map(Number);
  const written = lines.slice(1, 1 + points).flatMap((line) => line.split(" ").slice(0, 3).map(Number));
  const rows = text.trim().split("\n").slice(2).map((line) => line.split(" ").map(Number));
  const positions = Float64Array.from(rows.filter((row) => row.length === 3).flat());
  const indices = Uint32Array.from(rows.filter((row) => row.length === 4).flatMap((row) => row.slice(1)));
  assert.deepEqual(written, Array.from((await load()).simplify({ positions, indices }, { faces: 300 }).positions));
  await picture(tab, "ball");
  await close(tab);
});

const indicesOf = ({ meshes, accessors }) => meshes.flatMap(({ primitives }) => primitives).reduce((sum, { indices }) => sum + accessors[indices].count, 0);

test("glTF comes in and goes out with all that it has, and to other formats and from them", { skip }, async () => {
  const tab = await opened();
  await drop(tab, "sheet.gltf", gltf(40));
  await tab.until(`${facts}.startsWith("3,042 faces") && ${isStill}`);
  await tab.value(`(() => { const e = document.getElementById("count"); e.value = 400; e.dispatchEvent(new Event("input")); })()`);
  await tab.until(`/^(399|400) faces/.test(${facts})`); // a contraction may take two
  await picture(tab, "gltf");
  const simple = JSON.parse(await downloaded(tab, "^sheet-(398|399|400).gltf: "));
  assert.ok(indicesOf(simple) >= 3 * 398 && indicesOf(simple) <= 1200, String(indicesOf(simple)));
  assert.deepEqual(simple.materials, JSON.parse(gltf(40)).materials);
  assert.deepEqual([simple.nodes, simple.asset.copyright], [[{ mesh: 0, scale: [2, 2, 2] }], "nobody"]);
  await tab.value(change("format", 'e.value = ".obj"'));
  const obj = await downloaded(tab, "^sheet-(398|399|400).obj: ");
  assert.ok(obj.match(/^f /gm).length >= 398);
  assert.ok(Math.max(...obj.match(/^v \S+/gm).map((line) => Number(line.slice(2)))) > 1.99, "nodes place meshes");
  await tab.value(change("limit", "e.value = 0.5"));
  await tab.until(`document.getElementById("notes").textContent.includes("0.5 % of the diagonal") && ${isStill}`);
  await drop(tab, "flat.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2\n3 1 3 2\n");
  await tab.until(`${facts}.startsWith("2 faces") && ${isStill}`);
  await tab.value(change("format", 'e.value = ".glb"'));
  assert.match(await downloaded(tab, "flat-2.glb"), /^glTF/);
  await close(tab);
});

test("glTF with its bytes in another file is refused, since that is not here", { skip }, async () => {
  const tab = await opened(), document = JSON.parse(gltf(4));
  document.buffers[0].uri = "sheet.bin";
  await drop(tab, "sheet.gltf", JSON.stringify(document));
  await tab.until(`${state}.includes("sheet.bin: no such file")`);
  await drop(tab, "broken.glb", "glTF");
  await tab.until(`${state}.startsWith("broken.glb: ")`);
  await close(tab);
});

test("what is no mesh is told, and the page goes on", { skip }, async () => {
  const tab = await opened();
  await drop(tab, "notes.txt", "hello");
  await tab.until(`${state}.includes("notes.txt: the extension '.txt' is not one of .off .obj .ply .stl .ts .gltf .glb")`);
  await drop(tab, "broken.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 x 0\n3 0 1 2\n");
  await tab.until(`${state}.includes("broken.off:5: ")`);
  await drop(tab, "one.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  await tab.until(`${facts}.startsWith("1 face")`);
  await close(tab);
});
