// Makes the page simplify.html: the viewer of examples/products/page, with a panel of its own, a worker, and the module in it.
//   node build.mjs MODULE.wasm OUTPUT.html
// It is run where node_modules is.

import { readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { gzipSync } from "node:zlib";

const [module, output] = process.argv.slice(2);
const here = import.meta.dirname, viewer = join(here, "../../page"), modules = join(process.cwd(), "node_modules");
const { buildSync } = createRequire(join(process.cwd(), "package.json"))("esbuild");

function bundled(file, options = {}) {
  const { outputFiles } = buildSync({
    entryPoints: [file], bundle: true, minify: true, write: false, charset: "utf8", target: "es2022", nodePaths: [modules], ...options,
  });
  return outputFiles[0].text.trim();
}

// The licence of three.js asks that its text goes along.
const license = readFileSync(join(modules, "three", "LICENSE"), "utf8").trim();
const script = bundled(join(here, "simplify.js"), { format: "iife", banner: { js: `/*! three.js\n\n${license}\n*/` } });
const worker = bundled(join(here, "worker.js"), { format: "iife", define: { "import.meta.url": '""' } });
const style = bundled(join(viewer, "page.css")) + bundled(join(here, "simplify.css"));
for (const text of [script, worker]) if (/<\/script|<!--/i.test(text)) throw new Error("a script would end the element that it is in");

let page = readFileSync(join(viewer, "page.html"), "utf8");
function replace(what, by) {
  const parts = page.split(what);
  if (parts.length !== 2) throw new Error(`page.html has not one ${what}`);
  page = parts.join(by);
}
const [drop, choices] = readFileSync(join(here, "simplify.html"), "utf8").split("<!-- choices -->\n");
// The policy lets nothing out: there is no address that the page or its worker may reach.
replace("script-src 'unsafe-inline';", "script-src 'unsafe-inline' 'wasm-unsafe-eval'; worker-src blob:;");
replace('<section id="panel"', `${drop.trim()}\n<section id="panel" hidden`);
replace('  <div class="choices">\n', `${choices.trimEnd()}\n  <div class="choices">\n`);
replace('<script id="header" type="application/json">{{header}}</script>\n', `<script id="worker" type="text/plain">${worker}</script>\n`);
replace("{{data}}", gzipSync(readFileSync(module), { level: 9 }).toString("base64"));
replace("{{title}}", "Simplify a mesh");
replace("{{style}}", style);
replace("{{script}}", script);
writeFileSync(output, page);
