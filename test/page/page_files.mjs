// Pages as files: what the program writes, and the data in them.

import { execFileSync, spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

// A folder for the time of a test, and the program in it.
export class Folder {
  constructor(program) {
    this.program = program;
    this.path = mkdtempSync(join(tmpdir(), "pages-"));
  }
  file(name) {
    return join(this.path, name);
  }
  write(name, content) {
    writeFileSync(this.file(name), content);
    return this.file(name);
  }
  // The status and what is said of a run, of which paths are in the folder.
  run(...args) {
    const { status, stdout, stderr } = spawnSync(this.program, args, { cwd: this.path, encoding: "utf8" });
    return { status, said: stdout + stderr };
  }
  // The content of the page that a run writes.
  page(name, ...args) {
    execFileSync(this.program, [...args, name, "--quiet"], { cwd: this.path, stdio: ["ignore", "ignore", "inherit"] });
    return readFileSync(this.file(name), "utf8");
  }
  remove() {
    rmSync(this.path, { recursive: true, force: true });
  }
}

export function headerOf(page) {
  return JSON.parse(elementOf(page, "header"));
}
export function elementOf(page, id) {
  return page.match(new RegExp(`<script id="${id}"[^>]*>([^<]*)</script>`))[1];
}

export const off = (points, faces) =>
  [`OFF\n${points.length} ${faces.length} 0`, ...points.map((p) => p.join(" ")), ...faces.map((f) => `3 ${f.join(" ")}`), ""].join("\n");

// A bumpy ball of 2n(n - 1) triangles.
export function ball(n, [x, y, z] = [0, 0, 0]) {
  const points = [[x, y, z + 1]];
  for (let i = 1; i < n; ++i)
    for (let j = 0; j < n; ++j) {
      const a = (Math.PI * i) / n, b = (2 * Math.PI * j) / n, r = 1 + 0.1 * Math.sin(3 * a) * Math.cos(4 * b + i);
      points.push([x + r * Math.sin(a) * Math.cos(b), y + r * Math.sin(a) * Math.sin(b), z + r * Math.cos(a)]);
    }
  points.push([x, y, z - 1]);
  const at = (i, j) => (i === 0 ? 0 : i === n ? points.length - 1 : 1 + (i - 1) * n + (j % n));
  const faces = [];
  for (let i = 0; i < n; ++i)
    for (let j = 0; j < n; ++j) {
      if (i > 0) faces.push([at(i, j), at(i + 1, j), at(i, j + 1)]);
      if (i < n - 1) faces.push([at(i, j + 1), at(i + 1, j), at(i + 1, j + 1)]);
    }
  return { points, faces };
}

export function check(condition, what) {
  if (!condition) throw new Error(`wrong: ${what}`);
}
