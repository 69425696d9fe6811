import type { CallOptions, ChannelOptions } from "./option_table.js";

export type { CallOptions, ChannelOptions };

/** A typed array of real numbers, or of integers that stand for themselves. */
export type Reals =
  | Float64Array | Float32Array | Uint32Array | Uint16Array | Uint8Array | Uint8ClampedArray | Int32Array | Int16Array | Int8Array;
/** A typed array of integers. */
export type Integers = Uint32Array | Uint16Array | Uint8Array | Int32Array | Int16Array | Int8Array;

/** An attribute of a surface: texture coordinates, normals, colours, or any numbers. */
export interface Attribute<V extends Reals = Reals> extends ChannelOptions {
  /** The meaning of the numbers. Default: `"attributes"`, which may be anything. */
  kind?: "texture" | "normals" | "colors" | "attributes";
  /** The numbers per value: 2 for a texture, 3 for normals, 3 or 4 for colors. Needed only for other attributes with indices. */
  components?: number;
  /** The values one after another: one for each point or, with `indices`, any number. */
  values: V;
  /** The index of the value of each corner of each triangle, as in OBJ files; as long as the indices of the mesh. */
  indices?: Integers;
}

export type Attributes = Record<string, Attribute>;

/** Any triangle mesh: open or closed, manifold or not. It is never changed. */
export interface Mesh<P extends Reals = Reals, I extends Integers = Integers, A extends Attributes = Attributes> {
  /** Three coordinates of each point, finite, in any unit. */
  positions: P;
  /** Three indices of points for each triangle. */
  indices: I;
  /** Attributes, under names of your choice. */
  attributes?: A;
  /** The region of each triangle (a material, for example), at least 0: regions stay, with their boundaries. */
  labels?: Integers;
}

/** Options. Their table is made from that of all interfaces: see option_table.d.ts. */
export interface Options extends CallOptions {
  /** All levels of detail are recorded into these. */
  levels?: Levels;
  /** Called up to 25 times a second. Returning `false` ends the call with the current result; simplify rethrows exceptions. */
  progress?: (status: Status) => boolean | void;
}

/** The progress of a call. */
export interface Status {
  /** The completed fraction, from 0 to 1. */
  progress: number;
  faces: number;
  vertices: number;
  contractions: number;
  /** The error of the next contraction, as `Report.error`. */
  nextError: number;
  /** The diagonal of the bounding box of the input. */
  diagonal: number;
}

/** The figures of a call. */
export interface Report {
  facesBefore: number;
  /** Triangles without degenerate and duplicate ones; targets refer to these. */
  countedFaces: number;
  facesAfter: number;
  verticesBefore: number;
  verticesAfter: number;
  contractions: number;
  componentsBefore: number;
  componentsAfter: number;
  vanishedComponents: number;
  /** Gaps across which components were joined first, with `joinGaps`. */
  joinedGaps: number;
  /** Gaps that could not be joined. */
  openGaps: number;
  /** Handles and tunnels that were cut first, with `simplifiedTopology`. */
  cutHandles: number;
  /** Components that were cut in two by that. */
  splitComponents: number;
  /** No point of the triangles that close these cuts is further than this from the input. Other distances are from the surface after the cuts. */
  cutDistance: number;
  /** The diagonal of the bounding box of the largest removed component. */
  largestVanishedComponent: number;
  nonManifoldEdges: number;
  nonManifoldVertices: number;
  doubledFaces: number;
  /** Why the run stopped. */
  stop: "target met" | "target passed" | "no pair left" | "all pairs rejected" | "target unreachable" | "cancelled";
  /** Whether the target was met, exactly or almost. */
  isTargetReached: boolean;
  /** An estimate of the largest distance, in the unit of the points; not a bound. */
  error: number;
  /** No point of the result is further from the input. Infinity without error or relativeError. */
  distanceBound: number;
  /** No point of the input is further from the result, or the other way round. Infinity without bothWays. */
  hausdorffBound: number;
  /** Pairs of triangles that intersect, before and after; with noSelfIntersection. */
  selfIntersections?: [number, number];
  /** With normalDeviation: no normal deviates by more degrees from the normals that it replaces. */
  normalBoundDegrees?: number;
  /** The number of rejected contractions, by cause. */
  rejections: Record<string, number>;
  seconds: number;
  /** All figures in one line. */
  text: string;
}

/** An attribute of a result: in the form in which it was given, or with indices if points are now shared. */
export interface SimplifiedAttribute<V extends Reals = Reals> {
  components: number;
  values: V;
  indices?: Integers;
}

type SimplifiedAttributes<A extends Attributes> = { [K in keyof A]: SimplifiedAttribute<A[K]["values"]> };

/** A simplified surface: new arrays of the types of the old ones. The remaining elements keep their order. */
export interface Simplified<P extends Reals = Reals, I extends Integers = Integers, A extends Attributes = Attributes> {
  positions: P;
  /** Of the type of the input's indices, or of 32 bits if that type is too small. */
  indices: I;
  attributes: SimplifiedAttributes<A>;
  /** Present if the input has labels. */
  labels?: Integers;
  /** For each triangle, the index of its triangle in the input. */
  inputFaces: Uint32Array;
  /** For each point of the input, the index of the point that replaces it; -1 if it was removed. Absent with splitVertices. */
  vertexMap?: Int32Array;
  report: Report;
}

/** Selects a level: the finest with at most this many faces or vertices, the coarsest within an error or a distance
 *  (bound), or the one after this many contractions. */
export type LevelStop =
  | { faces: number } | { vertices: number } | { error: number } | { distance: number } | { contractions: number };

/** The figures of a level. */
export interface LevelInfo {
  faces: number;
  vertices: number;
  contractions: number;
  error: number;
  distanceBound: number;
  hausdorffBound: number;
}

/** A level: a surface whose points and triangles have their own order, the same for all levels of a recording. */
export interface Level extends LevelInfo {
  positions: Reals;
  indices: Integers;
  attributes: Record<string, SimplifiedAttribute>;
  labels?: Integers;
  /** For each point, the index of its point in the input. */
  inputVertices: Uint32Array;
  /** For each triangle, the index of its triangle in the input. */
  inputFaces: Uint32Array;
}

/** All levels of detail of one call of simplify, in the memory of the module. */
export interface Levels {
  /** Whether nothing has been recorded. */
  readonly isEmpty: boolean;
  /** The input. */
  readonly finest: LevelInfo;
  /** The last level that was recorded. */
  readonly coarsest: LevelInfo;
  /** The figures of a level, without computing it. */
  info(stop: LevelStop): LevelInfo;
  /** A level, in linear time. */
  at(stop: LevelStop): Level;
  /** Frees the memory, which otherwise happens when these levels are garbage-collected. */
  free(): void;
}

/** An instance of the library, with its own memory. */
export interface Quadrille {
  /** For example "1.0.0". */
  readonly version: string;
  /** Levels to record into. */
  readonly Levels: new () => Levels;
  /**
   * Simplifies a surface, and does not change its arrays.
   *
   * The call blocks until it is done: in a page, simplify large surfaces in a Worker. Throws a TypeError or RangeError
   * that names the wrong argument before anything is done, and an Error with the message of the library.
   */
  simplify<P extends Reals, I extends Integers, A extends Attributes = {}>(
    mesh: Mesh<P, I, A>, options?: Options,
  ): Simplified<P, I, A>;
}

/** The code of the module. Default: the file quadrille.wasm in the folder of index.js. */
export interface LoadOptions {
  wasm?: BufferSource | WebAssembly.Module | URL | string | Response | Promise<Response>;
}

/** Loads the library. Each call returns a new instance, for one thread. */
export function load(options?: LoadOptions): Promise<Quadrille>;
