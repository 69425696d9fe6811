// The module in its memory, and calls of it: all that knows of addresses and names of functions.

/** Its code: of the file beside this one, or of what is given. */
export async function compiled(wasm) {
  if (wasm instanceof WebAssembly.Module) return wasm;
  if (wasm instanceof ArrayBuffer || ArrayBuffer.isView(wasm)) return WebAssembly.compile(wasm);
  if (wasm === undefined || wasm instanceof URL || typeof wasm === "string") return fetched(wasm);
  return compiledResponse(await wasm); // a Response, or a promise of one
}

async function fetched(address) {
  const url = address === undefined ? new URL("quadrille.wasm", import.meta.url) : new URL(address, globalThis.document?.baseURI ?? import.meta.url);
  const files = url.protocol === "file:" ? globalThis.process?.getBuiltinModule?.("node:fs") : undefined;
  return files ? WebAssembly.compile(files.readFileSync(url)) : compiledResponse(await fetch(url));
}

async function compiledResponse(response) {
  if (!(response instanceof Response)) throw new TypeError("quadrille: wasm is not bytes, a module, an address or a response");
  if (!response.ok) throw new Error(`quadrille: ${response.url || "the module"} cannot be fetched: ${response.status} ${response.statusText}`);
  return WebAssembly.compile(await response.arrayBuffer());
}

const inC = (name) => name.replace(/[A-Z]/g, (letter) => `_${letter.toLowerCase()}`);

export class Instance {
  #progress = null; // of the call that runs

  // `more` are functions that a module of more parts imports.
  constructor(module, more = {}) {
    this.exports = new WebAssembly.Instance(module, this.#imports(more)).exports;
    this.exports._initialize();
  }

  #imports(more) {
    const nothing = () => 0;
    return {
      quadrille: { proceed: (...status) => this.#progress(...status) },
      env: { emscripten_notify_memory_growth() {}, ...more },
      wasi_snapshot_preview1: {
        clock_time_get: (clock, precision, time) => {
          const now = BigInt(Math.round(1e6 * performance.now()));
          new DataView(this.exports.memory.buffer).setBigUint64(time >>> 0, now, true);
          return 0;
        },
        environ_sizes_get: (count, size) => {
          this.array(Uint32Array, count, 1)[0] = this.array(Uint32Array, size, 1)[0] = 0;
          return 0;
        },
        environ_get: nothing,
        proc_exit(status) {
          throw new Error(`quadrille: the module ended with status ${status}`);
        },
        ...more,
      },
    };
  }

  // Addresses are signed numbers here. The view ends when memory grows.
  array(Type, address, count) {
    return new Type(this.exports.memory.buffer, address >>> 0, count);
  }
  viewAt(Type, address) {
    const [begin, count] = this.array(Uint32Array, address, 2);
    return this.array(Type, count > 0 ? begin : 0, count);
  }
  textAt(address) {
    return new TextDecoder().decode(this.viewAt(Uint8Array, address));
  }
  // Writes a name where `room(bytes)` says.
  write(text, room) {
    const bytes = new TextEncoder().encode(text);
    this.array(Uint8Array, existing(room(bytes.length)), bytes.length).set(bytes);
  }

  newCall() {
    return new Call(this, existing(this.exports.newCall()));
  }

  /** Calls a task that calls `progress` meanwhile. */
  withProgress(progress, task) {
    const before = this.#progress;
    this.#progress = progress;
    try {
      return task();
    } finally {
      this.#progress = before;
    }
  }
}

/** An address that is none says that memory has ended. */
export function existing(address) {
  if (address === 0) throw new RangeError("quadrille: out of memory");
  return address;
}

class Call {
  #instance;
  #address;

  constructor(instance, address) {
    this.#instance = instance;
    this.#address = address;
  }
  free() {
    this.#instance.exports.deleteCall(this.#address);
  }

  setMesh({ positions, indices, labels, attributes }) {
    this.#fill("positions", Float64Array, positions);
    this.#fill("indices", Uint32Array, indices);
    if (labels) this.#fill("labels", Uint32Array, labels);
    for (const attribute of attributes) this.#addChannel(attribute);
  }
  setOptions({ numbers, choices, masks, arrays }) {
    this.#set("", numbers, choices);
    for (const [name, array] of masks) this.#fill(name, Uint8Array, array);
    for (const [name, array] of arrays) this.#fill(name, Float64Array, array);
  }

  /** Runs, and returns the report; throws what the library throws, or what `progress` does. */
  run(levels, progress) {
    const thrown = [];
    const proceed = progress && sometimes(progress, thrown);
    const isDone = this.#instance.withProgress(proceed, () => this.#instance.exports.run(this.#address, levels, proceed !== null));
    if (thrown.length > 0) throw thrown[0];
    this.#require(isDone);
    return JSON.parse(this.#text());
  }

  /** Arrays of the result: views, which end when memory grows. */
  reals(name, channel = 0) {
    return this.#output(Float64Array, name, channel);
  }
  integers(name, channel = 0) {
    return this.#output(Uint32Array, name, channel);
  }

  #output(Type, name, channel) {
    this.#name(name);
    return this.#instance.viewAt(Type, this.#instance.exports.output(this.#address, channel));
  }
  #name(text) {
    this.#instance.write(text, (bytes) => this.#instance.exports.nameRoom(this.#address, bytes));
  }
  #fill(name, Type, array) {
    this.#name(name);
    this.#copy(Type, array, this.#instance.exports.inputRoom(this.#address, array.length));
  }
  #copy(Type, array, address) {
    if (array.length > 0) this.#instance.array(Type, existing(address), array.length).set(array);
  }
  #addChannel({ name, kind, components, values, indices, options }) {
    const { exports } = this.#instance, of = `quadrille: attributes.${name}: `;
    this.#name(kind);
    this.#require(exports.addChannel(this.#address, components), of);
    this.#copy(Float64Array, values, exports.channelRoom(this.#address, false, values.length));
    if (indices) this.#copy(Uint32Array, indices, exports.channelRoom(this.#address, true, indices.length));
    this.#set(of, options.numbers, options.choices);
  }
  // Of the call, or of the last attribute, whose name errors tell.
  #set(attribute, numbers, choices) {
    const isOfChannel = attribute !== "";
    for (const [name, value] of numbers) {
      this.#name(inC(name));
      this.#require(this.#instance.exports.setNumber(this.#address, isOfChannel, value), attribute);
    }
    for (const [name, value] of choices) {
      this.#name(`${inC(name)}=${value}`);
      this.#require(this.#instance.exports.setChoice(this.#address, isOfChannel), attribute);
    }
  }
  #text() {
    return this.#instance.textAt(this.#instance.exports.text(this.#address));
  }
  #require(isDone, attribute = "") {
    if (!isDone) throw new Error(attribute + this.#text());
  }
}

// Up to 25 times a second. 0 ends the call, -1 says that the function has thrown.
function sometimes(progress, thrown) {
  let last = -Infinity;
  return (part, faces, vertices, contractions, nextError, diagonal) => {
    const now = performance.now();
    if (now - last < 40 && part < 1) return 1;
    last = now;
    try {
      return progress({ progress: part, faces, vertices, contractions, nextError, diagonal }) === false ? 0 : 1;
    } catch (error) {
      thrown.push(error);
      return -1;
    }
  };
}
