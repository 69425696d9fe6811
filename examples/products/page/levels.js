// The levels of detail that a page holds, and any one of them on demand.
//
// Items (vertices, or the texture coordinates at corners) and faces are numbered by when they go, the
// last to go first. Of each item the page knows after how many contractions it goes, and which item,
// of a lower number, it becomes; and what contractions make of the values of items, in their order.
// So a level takes one pass over the items, one over the changes before it and one over its faces.

const none = 0xffffffff;

export function bytesOfBase64(text) {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

// Views of the arrays that `places` names: {name: [type, offset in bytes, length]}.
export function arraysOf(places, bytes) {
  const types = { f32: Float32Array, u32: Uint32Array };
  const arrays = {};
  for (const [name, [type, offset, length]] of Object.entries(places))
    arrays[name] = new types[type](bytes.buffer, bytes.byteOffset + offset, length);
  return arrays;
}

class Track {
  constructor(arrays, name, width) {
    for (const part of ["corners", "values", "parents", "ends", "changed", "changeEnds", "changedValues"])
      this[part] = arrays[`${name}.${part}`];
    this.width = width;
    this.images = new Uint32Array(this.parents.length);
    this.current = new Float32Array(this.values.length);
  }

  // After so many contractions: `images` says which item an item has become, `current` the values.
  goTo(contractions) {
    const { parents, ends, images, current, changed, changedValues, width } = this;
    for (let i = 0; i < images.length; ++i)
      images[i] = ends[i] > contractions ? i : parents[i] === none ? none : images[parents[i]];
    current.set(this.values);
    const end = contractions === 0 ? 0 : this.changeEnds[contractions - 1];
    for (let change = 0; change < end; ++change) {
      const to = changed[change] * width, from = change * width;
      for (let k = 0; k < width; ++k) current[to + k] = changedValues[from + k];
    }
  }
}

export class Levels {
  constructor(header, bytes) {
    const arrays = arraysOf(header.arrays, bytes);
    this.facesAfter = arrays.facesAfter;
    this.errors = arrays.errors;
    this.materials = arrays.materials; // of each face, if there are several
    this.firstFaces = header.faces;
    this.vertices = new Track(arrays, "vertices", header.width);
    this.textures = arrays["textures.corners"] ? new Track(arrays, "textures", 2) : null;
  }

  get contractions() {
    return this.facesAfter.length;
  }
  facesAt(contractions) {
    return contractions === 0 ? this.firstFaces : this.facesAfter[contractions - 1];
  }
  errorAt(contractions) {
    return this.errors[contractions];
  }
  // Vertices go in descending order of their numbers.
  verticesAt(contractions) {
    return this.first(this.vertices.ends.length, (i) => this.vertices.ends[i] <= contractions);
  }
  // The finest level with at most so many faces, as a number of contractions.
  find(faces) {
    return Math.min(this.first(this.contractions + 1, (c) => this.facesAt(c) <= faces), this.contractions);
  }
  // The first of `count` numbers that something holds of, as it does of all behind it.
  first(count, holds) {
    let low = 0, high = count;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (holds(middle)) high = middle;
      else low = middle + 1;
    }
    return low;
  }

  goTo(contractions) {
    this.vertices.goTo(contractions);
    this.textures?.goTo(contractions);
    return this.facesAt(contractions);
  }
}
