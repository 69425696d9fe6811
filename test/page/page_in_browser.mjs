// Pages in headless Chromium without network: they draw what their controls ask for, say nothing on the
// console and fetch nothing.
//   node page_in_browser.mjs PROGRAM CHROMIUM [FOLDER_FOR_SCREENSHOTS]

import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { Chromium } from "./chromium.mjs";
import { ball, check, Folder, off } from "./page_files.mjs";

const [program, chromium, screenshots] = process.argv.slice(2);
const folder = new Folder(program);
const browser = new Chromium(chromium);

const drawn = "Number(document.getElementById('model').dataset.triangles)";
const facts = "document.getElementById('facts').textContent";
const move = (step) => `(() => { const s = document.getElementById("level"); s.value = ${step}; s.dispatchEvent(new Event("input")); })()`;

// Of an element: does it lie in the window, and on top there?
const isOnTop = (selector) => `(() => {
  const e = document.querySelector("${selector}"), { left, right, top, bottom } = e.getBoundingClientRect();
  const hit = document.elementFromPoint((left + right) / 2, (top + bottom) / 2);
  return left >= 0 && top >= 0 && right <= innerWidth && bottom <= innerHeight && (e === hit || e.contains(hit) || hit.contains(e));
})()`;

async function open(name, hash = "", size = {}) {
  const url = `${pathToFileURL(folder.file(name))}#turn=0&${hash}`;
  const tab = await browser.open(url, size);
  await tab.until(`${drawn} > 0`);
  return { tab, url };
}

async function close({ tab, url }, name) {
  if (screenshots) writeFileSync(join(screenshots, `${name}.png`), await tab.screenshot());
  check(tab.complaints().length === 0, `${name}: the console says ${tab.complaints()}`);
  check(tab.requests().every((request) => request === url.split("#")[0]), `${name}: it fetches ${tab.requests()}`);
  await tab.send("Page.close");
}

// Of the part of a window that the model has for itself, the share that colours of errors or of the mesh
// cover, and the hues above and below the middle.
async function look(tab) {
  const picture = (await tab.screenshot()).toString("base64");
  return tab.value(`new Promise((resolve) => {
    const image = new Image();
    image.onload = () => {
      const copy = document.createElement("canvas"), scale = image.width / innerWidth;
      const top = document.querySelector("header").getBoundingClientRect().bottom * scale;
      const bottom = document.getElementById("panel").getBoundingClientRect().top * scale;
      Object.assign(copy, { width: image.width, height: bottom - top });
      const context = copy.getContext("2d");
      context.drawImage(image, 0, -top);
      const { data } = context.getImageData(0, 0, copy.width, copy.height);
      const halves = [[0, 0, 0], [0, 0, 0]];
      let count = 0;
      for (let i = 0; i < data.length; i += 4) {
        if (Math.max(...data.subarray(i, i + 3)) - Math.min(...data.subarray(i, i + 3)) < 40) continue;
        ++count;
        for (let k = 0; k < 3; ++k) halves[i < data.length / 2 ? 0 : 1][k] += data[i + k];
      }
      const hues = halves.map((sums) => ["red", "green", "blue"][sums.indexOf(Math.max(...sums))]);
      resolve({ share: (4 * count) / data.length, hues });
    };
    image.src = "data:image/png;base64,${picture}";
  })`);
}

async function testControls() {
  const { points, faces } = ball(24);
  folder.page("ball.html", folder.write("ball.off", off(points, faces)));
  const page = await open("ball.html");
  const { tab } = page;
  check((await tab.value(drawn)) === faces.length, "all faces are drawn");
  check((await tab.value(facts)).startsWith("1,104 faces (100 % of 1,104) · 554 vertices"), "the finest level is told");
  await tab.value(move(500));
  await tab.until(`${drawn} < 100`);
  const half = await tab.value(drawn);
  check(half > 40 && (await tab.value(facts)).startsWith(`${half} faces`), "the slider's middle is told");
  await tab.value(move(0));
  await tab.until(`${drawn} === 4`);
  await tab.value(`location.hash = "turn=0&faces=300&color=error&wireframe=1"`);
  await tab.until(`${drawn} === 300`);
  check(await tab.value(`!document.getElementById("legend").hidden`), "the legend of errors");
  check(/^0\.?\d* %$/.test(await tab.value(`document.getElementById("greatest").textContent`)), "the greatest error");
  check((await tab.value(`document.getElementById("edges").getAttribute("aria-pressed")`)) === "true", "the wireframe");
  await close(page, "controls");
}

async function testTurning() {
  const page = await open("ball.html");
  const { tab } = page;
  const rotation = `document.getElementById("rotation")`;
  await tab.value(`(() => { window.pictures = 0;
    new MutationObserver(() => ++window.pictures).observe(document.getElementById("model"), { attributes: true }); })()`);
  await new Promise((resolve) => setTimeout(resolve, 1500));
  check((await tab.value("window.pictures")) < 3, "no pictures are drawn while nothing moves");
  await tab.value(`${rotation}.click()`);
  await tab.until("window.pictures > 5"); // it turns
  const press = (type, x) => tab.send("Input.dispatchMouseEvent", { type, x, y: 300, button: "left", clickCount: 1 });
  await press("mousePressed", 600);
  await press("mouseMoved", 650);
  await press("mouseReleased", 650);
  check((await tab.value(`${rotation}.getAttribute("aria-pressed")`)) === "false", "it stops when it is touched");
  await tab.value(`document.getElementById("level").focus()`);
  await tab.send("Input.dispatchKeyEvent", { type: "keyDown", key: "Home", code: "Home", windowsVirtualKeyCode: 36 });
  await tab.until(`${drawn} === 4`);
  await close(page, "turning");
}

async function testPhone() {
  const page = await open("ball.html", "color=error", { width: 390, height: 844, mobile: true });
  const { tab } = page;
  for (const selector of ["#level", "#count", "#colorings", "#edges", "#rotation", "#up", "#ramp"])
    check(await tab.value(isOnTop(selector)), `${selector} is to be seen on a phone`);
  check(await tab.value("document.documentElement.scrollWidth <= innerWidth"), "nothing is wider than a phone");
  const header = await tab.value(`document.querySelector("header").getBoundingClientRect().bottom`);
  check(header < (await tab.value(`document.getElementById("panel").getBoundingClientRect().top`)), "header and panel are apart");
  const { share } = await look(tab);
  check(share > 0.25 && share < 0.7, `the model fills ${share} of a phone`);
  await close(page, "phone");
}

async function testNames() {
  const evil = `a'b"c<img src=x onerror=alert(1)> &amp;.off`;
  folder.page("evil.html", folder.write(evil, off([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])));
  const page = await open("evil.html");
  const { tab } = page;
  check((await tab.value(`document.getElementById("name").textContent`)) === evil, "the name of the file");
  check((await tab.value("document.title")) === evil, "the title");
  check((await tab.value(drawn)) === 1, "a mesh of one triangle");
  check(await tab.value(`document.getElementById("level").disabled`), "it has one level");
  await close(page, "names");
}

async function testColors() {
  const { points, faces } = ball(16);
  const lines = [`ply\nformat ascii 1.0\nelement vertex ${points.length}`, ...["x", "y", "z"].map((k) => `property float ${k}`),
    ...["red", "green", "blue"].map((k) => `property uchar ${k}`), `element face ${faces.length}\nproperty list uchar int vertex_indices\nend_header`,
    ...points.map(([x, y, z]) => `${x} ${y} ${z} ${z > 0 ? "250 10 10" : "10 10 250"}`), ...faces.map((f) => `3 ${f.join(" ")}`), ""];
  folder.page("colors.html", folder.write("colors.ply", lines.join("\n")));
  const page = await open("colors.html", "up=z&faces=200");
  const { hues } = await look(page.tab);
  check(hues[0] === "red" && hues[1] === "blue", `colours of vertices are ${hues}`);
  await close(page, "colors");
}

try {
  await testControls();
  await testTurning();
  await testPhone();
  await testNames();
  await testColors();
} finally {
  await browser.close();
  folder.remove();
}
