// From a level to what is drawn: three corners for each triangle, with normals of their own.

// The cosine of the angle between two triangles from which on the edge between them looks sharp.
const smoothCosine = Math.cos((32 * Math.PI) / 180);

function copy(from, at, to, place, count) {
  for (let k = 0; k < count; ++k) to[place + k] = from[at + k];
}

export class Corners {
  // `places` says where colours and texture coordinates are among the values of a vertex.
  constructor(levels, places) {
    const faces = levels.firstFaces, corners = 3 * faces;
    this.levels = levels;
    this.places = places;
    this.vertices = new Uint32Array(corners); // of each corner
    this.positions = new Float32Array(3 * corners);
    this.normals = new Float32Array(3 * corners);
    this.errors = new Float32Array(corners);
    this.colors = places.color ? new Float32Array(3 * corners) : null;
    this.coordinates = places.texture || levels.textures ? new Float32Array(2 * corners) : null;
    this.faceNormals = new Float32Array(3 * faces);
    this.areas = new Float32Array(faces); // twice of them
    this.begins = new Uint32Array(levels.vertices.parents.length + 1);
    this.facesAround = new Uint32Array(corners);
    this.order = new Uint32Array(faces); // material by material
    this.groups = []; // {material, start, count} of corners
  }

  // To the level after so many contractions; returns how many faces it has.
  goTo(contractions) {
    const faces = this.levels.goTo(contractions);
    this.sortByMaterial(faces);
    this.takeValues(faces);
    this.findFaceNormals(faces);
    this.listFacesAround(faces);
    this.findNormals(faces);
    return faces;
  }

  sortByMaterial(faces) {
    const { materials } = this.levels;
    const counts = [];
    for (let face = 0; face < faces; ++face) {
      const material = materials ? materials[face] : 0;
      counts[material] = (counts[material] ?? 0) + 1;
    }
    this.groups = [];
    const ends = [];
    let end = 0;
    counts.forEach((count, material) => {
      this.groups.push({ material, start: 3 * end, count: 3 * count });
      ends[material] = end;
      end += count;
    });
    for (let face = 0; face < faces; ++face) this.order[ends[materials ? materials[face] : 0]++] = face;
  }

  takeValues(faces) {
    const { vertices, textures } = this.levels;
    const { current, width, images, corners } = vertices;
    const { color, texture } = this.places;
    for (let face = 0, corner = 0; face < faces; ++face)
      for (let from = 3 * this.order[face], k = 0; k < 3; ++k, ++from, ++corner) {
        const vertex = images[corners[from]], at = vertex * width;
        this.vertices[corner] = vertex;
        copy(current, at, this.positions, 3 * corner, 3);
        this.errors[corner] = current[at + 3];
        if (color) copy(current, at + color, this.colors, 3 * corner, 3);
        if (textures) copy(textures.current, 2 * textures.images[textures.corners[from]], this.coordinates, 2 * corner, 2);
        else if (texture) copy(current, at + texture, this.coordinates, 2 * corner, 2);
      }
  }

  findFaceNormals(faces) {
    const { positions: p, faceNormals, areas } = this;
    for (let face = 0; face < faces; ++face) {
      const a = 9 * face, n = 3 * face;
      const ux = p[a + 3] - p[a], uy = p[a + 4] - p[a + 1], uz = p[a + 5] - p[a + 2];
      const vx = p[a + 6] - p[a], vy = p[a + 7] - p[a + 1], vz = p[a + 8] - p[a + 2];
      const x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
      const length = Math.sqrt(x * x + y * y + z * z), scale = length > 0 ? 1 / length : 0;
      faceNormals[n] = x * scale;
      faceNormals[n + 1] = y * scale;
      faceNormals[n + 2] = z * scale;
      areas[face] = length;
    }
  }

  // By a counting sort.
  listFacesAround(faces) {
    const { begins, vertices, facesAround } = this;
    begins.fill(0);
    for (let corner = 0; corner < 3 * faces; ++corner) ++begins[vertices[corner]];
    for (let i = 0, end = 0; i < begins.length; ++i) begins[i] = end += begins[i];
    for (let face = faces - 1; face >= 0; --face)
      for (let k = 0; k < 3; ++k) facesAround[--begins[vertices[3 * face + k]]] = face;
  }

  // The normal of a corner is the sum of those around the vertex that are near to that of its face,
  // by areas, whichever way round their triangles are. At a vertex of very many faces it is that of
  // the face.
  findNormals(faces) {
    const { begins, vertices, facesAround, faceNormals: n, areas, normals } = this;
    for (let face = 0, corner = 0; face < faces; ++face)
      for (let k = 0; k < 3; ++k, ++corner) {
        const ax = n[3 * face], ay = n[3 * face + 1], az = n[3 * face + 2];
        const begin = begins[vertices[corner]], end = begins[vertices[corner] + 1];
        let x = 0, y = 0, z = 0;
        for (let i = begin; i < end && end - begin < 64; ++i) {
          const other = facesAround[i], b = 3 * other;
          const cosine = ax * n[b] + ay * n[b + 1] + az * n[b + 2];
          if (cosine < smoothCosine && cosine > -smoothCosine) continue;
          const weight = cosine < 0 ? -areas[other] : areas[other];
          x += weight * n[b];
          y += weight * n[b + 1];
          z += weight * n[b + 2];
        }
        const length = Math.sqrt(x * x + y * y + z * z);
        normals[3 * corner] = length > 0 ? x / length : ax;
        normals[3 * corner + 1] = length > 0 ? y / length : ay;
        normals[3 * corner + 2] = length > 0 ? z / length : az;
      }
  }
}
