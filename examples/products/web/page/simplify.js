// The page: the file that it is given, what is chosen of it, and the download. The worker reads and simplifies, the viewer
// shows all levels of what it has recorded.

import { bytesOfBase64 } from "../../page/levels.js";
import { facesShown, show, showFaces } from "../../page/viewer.js";

const element = (id) => document.getElementById(id);
const textOfCount = (count) => count.toLocaleString("en");

// --- The worker: a promise for each task

const worker = new Worker(URL.createObjectURL(new Blob([element("worker").textContent], { type: "text/javascript" })));
const waiting = new Map();
let number = 0;

function ask(task, given = {}) {
  worker.postMessage({ id: ++number, task, ...given });
  return new Promise((resolve, reject) => waiting.set(number, { resolve, reject }));
}
worker.onmessage = ({ data: { id, progress, answer, error } }) => {
  if (progress !== undefined) return tell(`Simplifying: ${Math.floor(100 * progress)} %`);
  const { resolve, reject } = waiting.get(id);
  waiting.delete(id);
  if (error === undefined) resolve(answer);
  else reject(new Error(error));
};

async function unpacked() {
  const packed = new Blob([bytesOfBase64(element("data").textContent)]);
  element("data").remove();
  const stream = packed.stream().pipeThrough(new DecompressionStream("gzip"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}
const started = unpacked().then((module) => ask("start", { module })).then(() => document.body.classList.add("ready"));

// --- What is told and chosen

function tell(text, isFailure = false) {
  element("state").textContent = text;
  element("state").hidden = text === "";
  element("state").classList.toggle("failed", isFailure);
}
function choices() {
  const limit = element("limit").value;
  return {
    error: limit === "" ? Infinity : Number(limit) / 100,
    keepsSeams: element("keep").checked,
    isAccurate: element("accurate").checked,
  };
}

// One after the other; what goes wrong is told.
let last = started;
function then(task) {
  last = last.then(task).catch((error) => tell(error.message, true));
  return last;
}

let name = "";

async function record(faces) {
  tell("Simplifying");
  const chosen = choices(), { header, bytes, report } = await ask("record", { choices: chosen });
  if (chosen.error < Infinity)
    header.notes.push(`Down to ${textOfCount(report.facesAfter)} faces no point is further from the input than ${element("limit").value} % of the diagonal.`);
  element("drop").hidden = true;
  element("panel").hidden = false;
  show(header, bytes);
  if (faces) showFaces(faces);
  tell("");
}

async function open(file) {
  tell(`Reading ${file.name}`);
  const { hasTexture } = await ask("open", { name: file.name, content: await file.arrayBuffer() });
  name = file.name;
  element("seams").hidden = !hasTexture;
  const extension = name.slice(name.lastIndexOf(".")).toLowerCase();
  for (const option of element("format").options) option.selected = option.text === extension;
  await record();
}

async function download() {
  const extension = element("format").value, faces = facesShown();
  tell("Simplifying");
  const { content, report } = await ask("save", { choices: choices(), faces, extension });
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([content]));
  link.download = `${name.replace(/\.[^.]*$/, "")}-${report.facesAfter}${extension}`;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60000);
  tell(`${link.download}: ${textOfCount(report.facesAfter)} faces`);
}

// --- What the user does

const take = (file) => file && then(() => open(file));
element("file").addEventListener("change", ({ target }) => {
  take(target.files[0]);
  target.value = "";
});
for (const id of ["limit", "keep", "accurate"]) element(id).addEventListener("change", () => then(() => record(facesShown())));
element("download").addEventListener("click", () => then(download));
addEventListener("dragover", (event) => {
  event.preventDefault();
  document.body.classList.add("over");
});
addEventListener("dragleave", () => document.body.classList.remove("over"));
addEventListener("drop", (event) => {
  event.preventDefault();
  document.body.classList.remove("over");
  take(event.dataTransfer.files[0]);
});
