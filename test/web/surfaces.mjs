// Surfaces of the tests, as files that the native program reads.

import { writeFileSync } from "node:fs";

// A bent sheet of n × n points with a texture of two charts, normals and two materials, as OBJ.
export function sheet(path, n) {
  const lines = ["mtllib sheet.mtl"], at = (i) => [(i % n) / (n - 1), Math.floor(i / n) / (n - 1)];
  for (let i = 0; i < n * n; ++i) {
    const [u, v] = at(i);
    lines.push(`v ${u} ${v} ${0.1 * Math.sin(6 * u) * Math.cos(6 * v)}`);
  }
  for (const shift of [0, 2]) for (let i = 0; i < n * n; ++i) lines.push(`vt ${at(i)[0] + shift} ${at(i)[1]}`);
  for (let i = 0; i < n * n; ++i) lines.push(`vn ${-0.6 * Math.cos(6 * at(i)[0])} 0 1`);
  let material = "";
  for (let i = n; i < n * n; ++i) {
    if (i % n === 0) continue;
    const isRight = i % n > n / 2, used = Math.floor(i / n) > n / 3 ? "upper" : "lower";
    if (used !== material) lines.push(`usemtl ${(material = used)}`);
    const corner = (p) => `${p + 1}/${p + 1 + (isRight ? n * n : 0)}/${p + 1}`;
    for (const [p, q, r] of [[i - n - 1, i - n, i - 1], [i - n, i, i - 1]]) lines.push(`f ${[p, q, r].map(corner).join(" ")}`);
  }
  writeFileSync(path, `${lines.join("\n")}\n`);
}

// A ball of rings with colours, as OFF.
export function ball(path, n) {
  const points = [], faces = [];
  for (let i = 0; i <= n; ++i)
    for (let k = 0; k < 2 * n; ++k) {
      const polar = (Math.PI * (i + 0.25)) / (n + 0.5), angle = (Math.PI * k) / n;
      const p = [Math.sin(polar) * Math.cos(angle), Math.sin(polar) * Math.sin(angle), Math.cos(polar)];
      points.push(`${p.join(" ")} ${p.map((x) => Math.round(127.5 * (1 + x))).join(" ")} 255`);
      const here = 2 * n * i + k, next = 2 * n * i + ((k + 1) % (2 * n));
      if (i < n) faces.push(`3 ${here} ${here + 2 * n} ${next}`, `3 ${next} ${here + 2 * n} ${next + 2 * n}`);
    }
  writeFileSync(path, `COFF\n${points.length} ${faces.length} 0\n${points.join("\n")}\n${faces.join("\n")}\n`);
}
