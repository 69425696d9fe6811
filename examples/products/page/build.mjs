// Makes one HTML page of page.html, page.css and page.js with three.js, and writes it as C++ source.
//   node build.mjs FOLDER_OF_THIS_FILE OUTPUT.cpp
// It is run where node_modules is.

import { readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";

const [folder, output] = process.argv.slice(2);
const modules = join(process.cwd(), "node_modules");
const { buildSync } = createRequire(join(process.cwd(), "package.json"))("esbuild");

function bundled(file, options) {
  const { outputFiles } = buildSync({
    entryPoints: [join(folder, file)],
    bundle: true,
    minify: true,
    write: false,
    charset: "utf8",
    target: "es2020",
    nodePaths: [modules],
    ...options,
  });
  return outputFiles[0].text.trim();
}

// The licence of three.js asks that its text goes along.
const license = readFileSync(join(modules, "three", "LICENSE"), "utf8").trim();
const script = bundled("page.js", { format: "iife", banner: { js: `/*! three.js\n\n${license}\n*/` } });
const style = bundled("page.css", {});
if (/<\/script|<!--/i.test(script)) throw new Error("the script would end the element that it is in");

// What the program puts in between stands behind each part but the last.
const parts = readFileSync(join(folder, "page.html"), "utf8")
  .replace("{{style}}", () => style)
  .replace("{{script}}", () => script)
  .split(/\{\{(?:title|header|data)\}\}/);
if (parts.length !== 4) throw new Error("page.html is not of four parts");

// Each literal is short, for compilers that limit them; three digits end an octal escape.
const literals = (text) =>
  Buffer.from(text)
    .toString("latin1")
    .match(/[^]{1,4000}/g)
    .map((piece) => `    "${piece.replace(/[^ !#->@-[\]-~]/g, (c) => `\\${c.charCodeAt(0).toString(8).padStart(3, "0")}`)}"`)
    .join("\n");
writeFileSync(
  output,
  `#include "page_parts.h"

namespace quadrille_examples {

const std::array<std::string_view, 4> page_parts = {
${parts.map(literals).join(",\n")}};

} // namespace quadrille_examples
`,
);
