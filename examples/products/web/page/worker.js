// The worker of the page: the module, with the file that it has been given.

import { existing, Instance } from "../package/instance.js";

let instance, page;

const text = () => instance.textAt(instance.exports.pageText(page));
function require(isDone) {
  if (!isDone) throw new Error(text());
}

// Progress, ten times a second at most.
let last = 0;
function tell(progress) {
  const now = performance.now();
  if (now - last > 100) postMessage({ progress });
  if (now - last > 100) last = now;
  return 1;
}
const run = (task) => {
  instance.withProgress(tell, () => require(task(instance.exports)));
  return JSON.parse(text());
};

// There are no files: what is read is in memory. Files beside a file that is read are asked for, and not there.
const noSuchFile = -44;
function filesOf(code) {
  const ofFiles = WebAssembly.Module.imports(code).filter(({ name }) => /^__syscall_|^fd_/.test(name));
  return Object.fromEntries(ofFiles.map(({ name }) => [name, () => noSuchFile]));
}

const numbersOf = ({ error, keepsSeams, isAccurate }) => [error, keepsSeams, isAccurate];

const tasks = {
  async start({ module }) {
    const code = await WebAssembly.compile(module);
    instance = new Instance(code, filesOf(code));
    page = existing(instance.exports.newPage());
  },
  open({ name, content }) {
    const bytes = new TextEncoder().encode(name), { exports } = instance;
    const room = existing(exports.textRoom(page, bytes.length + content.byteLength));
    const array = instance.array(Uint8Array, room, bytes.length + content.byteLength);
    array.set(bytes);
    array.set(new Uint8Array(content), bytes.length);
    require(exports.openFile(page, bytes.length));
    return { hasTexture: exports.hasTexture(page) !== 0 };
  },
  record({ choices }) {
    const report = run((exports) => exports.record(page, ...numbersOf(choices)));
    const header = JSON.parse(instance.textAt(instance.exports.pageHeader(page)));
    return { report, header, bytes: instance.viewAt(Uint8Array, instance.exports.pageData(page)).slice() };
  },
  save({ choices, faces, extension }) {
    instance.write(extension, (bytes) => instance.exports.textRoom(page, bytes));
    const report = run((exports) => exports.saveFile(page, faces, ...numbersOf(choices)));
    return { report, content: instance.viewAt(Uint8Array, instance.exports.savedFile(page)).slice() };
  },
};

onmessage = async ({ data: { id, task, ...given } }) => {
  try {
    postMessage({ id, answer: await tasks[task](given) });
  } catch (error) {
    postMessage({ id, error: error.message });
  }
};
