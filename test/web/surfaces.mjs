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

// The same sheet without its charts as glTF in one text, with a material for each half, of which one has a name, and with a node that
// shows it twice as large.
export function gltf(n) {
  const positions = new Float32Array(3 * n * n), uv = new Float32Array(2 * n * n), halves = [[], []];
  for (let i = 0; i < n * n; ++i) {
    const [u, v] = [(i % n) / (n - 1), Math.floor(i / n) / (n - 1)];
    positions.set([u, v, 0.1 * Math.sin(6 * u) * Math.cos(6 * v)], 3 * i);
    uv.set([u, v], 2 * i);
    if (i % n > 0 && i >= n) halves[Math.floor(i / n) > n / 2 ? 1 : 0].push(i - n - 1, i - n, i - 1, i - n, i, i - 1);
  }
  const arrays = [positions, uv, ...halves.map((half) => Uint32Array.from(half))];
  const bytes = Buffer.concat(arrays.map(({ buffer }) => Buffer.from(buffer)));
  let byteOffset = 0;
  const bufferViews = arrays.map(({ byteLength }) => ({ buffer: 0, byteOffset: (byteOffset += byteLength) - byteLength, byteLength }));
  const accessor = (bufferView, type, componentType, count, more = {}) => ({ bufferView, type, componentType, count, ...more });
  const indices = halves.map(({ length }, i) => accessor(2 + i, "SCALAR", 5125, length));
  return JSON.stringify({
    asset: { version: "2.0", copyright: "nobody" },
    buffers: [{ byteLength: bytes.length, uri: `data:application/octet-stream;base64,${bytes.toString("base64")}` }],
    bufferViews,
    accessors: [accessor(0, "VEC3", 5126, n * n, { min: [0, 0, -0.1], max: [1, 1, 0.1] }), accessor(1, "VEC2", 5126, n * n), ...indices],
    materials: [{ name: "lower", pbrMetallicRoughness: { baseColorFactor: [0.8, 0.2, 0.1, 1] } }, { doubleSided: true, extras: { mine: 1 } }],
    meshes: [{ primitives: indices.map((_, i) => ({ attributes: { POSITION: 0, TEXCOORD_0: 1 }, indices: 2 + i, material: i })) }],
    nodes: [{ mesh: 0, scale: [2, 2, 2] }],
    scenes: [{ nodes: [0] }],
    scene: 0,
  });
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
