// What pages say of the looks of a mesh, and what the program refuses to write as a page.
//   node page_looks.mjs PROGRAM

import { ball, check, elementOf, Folder, headerOf, off } from "./page_files.mjs";

const folder = new Folder(process.argv[2]);
// One red pixel.
const png = "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR4nGP4z8AAAAMBAQDJ/pLvAAAAAElFTkSuQmCC";

const base64 = (numbers) => Buffer.from(numbers.buffer).toString("base64");

// A tetrahedron of a red material, and one of an image, twice: four meters to the right, and turned and
// larger far above.
function gltf() {
  const points = new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1]);
  const textures = new Float32Array([0, 0, 1, 0, 0, 1, 0.5, 0.25]);
  const corners = new Uint16Array([0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3]);
  const arrays = [points, textures, corners];
  return JSON.stringify({
    asset: { version: "2.0" },
    scene: 0,
    scenes: [{ nodes: [0, 1] }],
    nodes: [
      { mesh: 0 },
      { translation: [4, 0, 0], children: [2, 3] },
      { mesh: 1 },
      { mesh: 1, translation: [0, 10, 0], rotation: [0, 0, Math.SQRT1_2, Math.SQRT1_2], scale: [2, 2, 2] },
    ],
    meshes: [0, 1].map((material) => ({ primitives: [{ attributes: { POSITION: 0, TEXCOORD_0: 1 }, indices: 2, material }] })),
    materials: [
      { pbrMetallicRoughness: { baseColorFactor: [1, 0.25, 0, 1] } },
      { pbrMetallicRoughness: { baseColorTexture: { index: 0 } }, alphaMode: "MASK" },
    ],
    textures: [{ source: 0 }],
    images: [{ uri: `data:image/png;base64,${png}` }],
    accessors: [
      { bufferView: 0, componentType: 5126, count: 4, type: "VEC3", min: [0, 0, 0], max: [1, 1, 1] },
      { bufferView: 1, componentType: 5126, count: 4, type: "VEC2" },
      { bufferView: 2, componentType: 5123, count: 12, type: "SCALAR" },
    ],
    bufferViews: arrays.map((array, buffer) => ({ buffer, byteLength: array.byteLength })),
    buffers: arrays.map((array) => ({ byteLength: array.byteLength, uri: `data:application/octet-stream;base64,${base64(array)}` })),
  });
}

function testGltf() {
  const header = headerOf(folder.page("gltf.html", folder.write("scene.gltf", gltf())));
  check(header.inputFaces === 12, "the triangles of three nodes");
  // The last node spans x from 4 - 2 to 4, y from 10 to 12 and z to 2; the first begins at 0.
  check(header.center.join() === "2.5,6,1", `the centre of the box is ${header.center}`);
  check(Math.abs(header.unit - Math.hypot(2.5, 6, 1)) < 1e-6, "half of its diagonal");
  check(JSON.stringify(header.materials) === '[{"color":[1,0.25,0]},{"color":[1,1,1],"image":0,"cutoff":0.5}]', `materials are ${JSON.stringify(header.materials)}`);
  check(header.images.join() === `data:image/png;base64,${png}`, "the image");
  check(header.arrays.materials[2] === header.faces, "a material of each face");
}

function testObj() {
  folder.write("a.png", Buffer.from(png, "base64"));
  folder.write("a.mtl", "newmtl red\nKd 1 0 0\nnewmtl pixel\r\nmap_Kd -s 1 1 1 a.png\r\nnewmtl lost\nmap_Kd none.png\n");
  const faces = ["red", "pixel", "lost"].map((name, i) => `usemtl ${name}\nf ${3 * i + 1}/1 ${3 * i + 2}/2 ${3 * i + 3}/3`);
  const vertices = faces.map((_, i) => `v ${2 * i} 0 0\nv ${2 * i + 1} 0 0\nv ${2 * i} 1 0`);
  const mesh = ["mtllib a.mtl", "mtllib b.mtl", ...vertices, "vt 0 0\nvt 1 0\nvt 0 1", ...faces, ""].join("\n");
  const header = headerOf(folder.page("obj.html", folder.write("a.obj", mesh)));
  check(JSON.stringify(header.materials) === '[{"color":[1,0,0]},{"color":[1,1,1],"image":0},{"color":[1,1,1]}]', `materials are ${JSON.stringify(header.materials)}`);
  check(header.notes.join("; ") === "The materials of b.mtl are not shown: it cannot be read; The image none.png is not shown: it cannot be read", `notes are ${header.notes}`);
  check(header.isColored && header.images.length === 1, "the image");
}

function testLargest() {
  const { points, faces } = ball(230);
  const input = folder.write("large.off", off(points, faces));
  const { status, said } = folder.run(input, "large.html", "--faces", "50000");
  check(status === 0 && /large.off: the finest level of the page has (99\d\d\d|100000) of 105340 faces$/m.test(said), `of a large mesh is said: ${said}`);
  const page = folder.page("large.html", input, "--faces", "50000");
  const header = headerOf(page);
  check(header.inputFaces === faces.length && header.faces <= 100000 && header.faces > 99990, "the finest level");
  check(page.length < 10e6, "the size of a page");
  check(Buffer.from(elementOf(page, "data"), "base64").length === 4 * Object.values(header.arrays).reduce((sum, [, , n]) => sum + n, 0), "the data");
}

function testRejections() {
  const { points, faces } = ball(6);
  const input = folder.write("b.off", off(points, faces));
  const refuses = (what, ...args) => {
    const { status, said } = folder.run(...args);
    check(status === 2 && said.includes(what), `${args}: status ${status}, ${said}`);
  };
  for (const option of [["--levels", "50%"], ["--record", "b.qlv"], ["--measure"]])
    refuses("--levels, --record and --measure do not go with it", input, "b.html", ...option);
  folder.write("page.html", "page");
  refuses("extension '.html' is not one of", "page.html", "c.off");
  folder.run(input, "c.off", "--record", "b.qlv");
  refuses("--report and targets do not go with it", "--from", "b.qlv", "b.html", "--faces", "9");
  check(folder.run(input, "b.html").status === 0, "a page without a target");
  check(folder.run(input, "b.html", "--faces", "1").status === 1, "a page whose target is not reached");
}

try {
  testGltf();
  testObj();
  testLargest();
  testRejections();
} finally {
  folder.remove();
}
