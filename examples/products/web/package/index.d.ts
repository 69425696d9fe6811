/** A typed array of real numbers, or of integers that stand for themselves. */
export type Reals =
  | Float64Array | Float32Array | Uint32Array | Uint16Array | Uint8Array | Uint8ClampedArray | Int32Array | Int16Array | Int8Array;
/** A typed array of integers. */
export type Integers = Uint32Array | Uint16Array | Uint8Array | Int32Array | Int16Array | Int8Array;

/** What a surface carries besides its shape: texture coordinates, normals, colours, or any numbers. */
export interface Attribute<V extends Reals = Reals> {
  /** What the numbers are. Default: `"attributes"`, which may be anything. */
  kind?: "texture" | "normals" | "colors" | "attributes";
  /** Numbers of a value: 2 of a texture, 3 of normals, 3 or 4 of colors. Needed only of others that have indices. */
  components?: number;
  /** One value after the other: one for each point, or, with `indices`, as many as you like. */
  values: V;
  /** Of each corner of each triangle, which value it has, as in OBJ files; as long as the indices of the mesh. */
  indices?: Integers;
  /** By how much more than by default it counts; above 0. */
  importance?: number;
  /** Lengths that a step of 1 in each component counts as; by default found from the surface. */
  weights?: ArrayLike<number>;
  /** What becomes of edges at which values differ. Default: `"soft"` of a texture, `"priced"` of others. */
  seams?: "kept" | "soft" | "priced" | "free";
  /** How firmly charts of a texture hold their borders; at least 0. */
  borderWeight?: number;
  /** What corners have whose values change. Default: `"optimal"`. */
  newValues?: "optimal" | "weights" | "existing" | "recomputed";
  /** Of colors in [0, 1]: they are averaged as light is. */
  linearLight?: boolean;
}

export type Attributes = Record<string, Attribute>;

/** A surface of triangles: any at all, open or closed, manifold or not. It is never changed. */
export interface Mesh<P extends Reals = Reals, I extends Integers = Integers, A extends Attributes = Attributes> {
  /** Three coordinates of each point, finite, in any unit. */
  positions: P;
  /** Three points of each triangle. */
  indices: I;
  /** What else it has, by names of yours. */
  attributes?: A;
  /** Of each triangle, its region (a material, say): regions stay, with their borders. At least 0. */
  labels?: Integers;
}

/** How to simplify. Names are those of the C++ policies. What is undefined has its default. */
export interface Options {
  // Targets, of which the first that is met ends it; half of the faces where there is none.
  /** So many triangles at most. */
  faces?: number;
  /** That part of the triangles, in [0, 1]. */
  ratio?: number;
  /** So many points at most. */
  vertices?: number;
  /** No point of the result is further from the input than that, in the unit of the points. */
  error?: number;
  /** The same as a part of the diagonal of the bounding box: 0.001, say. */
  relativeError?: number;
  /** These limits hold both ways: no point of the input is further from the result either. */
  bothWays?: boolean;
  /** Instead of a limit, one for each point: how far it may move. */
  tolerance?: Reals;
  /** The cost of the dearest contraction; at least 0. */
  costLimit?: number;

  /** `"quadric"` (default, the fastest), `"memoryless_quadric"` (a fifth more accurate, half as fast),
   *  `"thin_feature_quadric"` (the same, and thin parts stay), `"edge_length"`. */
  cost?: "quadric" | "memoryless_quadric" | "thin_feature_quadric" | "edge_length";
  /** Where the new point goes. Default: `"optimal"`, but `"midpoint"` of edge_length. */
  placement?: "optimal" | "endpoint" | "midpoint";
  /** The cheapest pair first, or in passes. Default: `"greedy"`. */
  order?: "greedy" | "relaxed";
  /** `"kept"` by default, `"free"` with pairsCloserThan. */
  topology?: "kept" | "free" | "parts_may_vanish";
  /** Points closer than that may be joined without an edge; 0 (default): along edges only. */
  pairsCloserThan?: number;
  /** How firmly borders stay, at least 0; default 100. */
  boundaryWeight?: number;
  /** With cost quadric: edges are held where normals differ by more degrees. Default 180: none is. */
  creaseDegrees?: number;
  /** How firmly they are; default 100. */
  creaseWeight?: number;
  /** With cost quadric: how much a triangle counts. Default: `"by_area"`. */
  weighting?: "by_area" | "uniform" | "by_squared_area";
  /** With cost quadric: how firmly points keep to their normals. 0.001 gives better triangles for a little distance. */
  lineWeight?: number;
  /** With cost quadric: standard deviation of unit normals. */
  normalNoise?: number;
  /** With cost quadric: standard deviation of points, in their unit. */
  positionNoise?: number;
  /** No triangle turns by so many degrees at once, in (0, 180]; default 90. */
  normalFlip?: number;
  /** No normal is further from those of the input that it stands for, in degrees; 180 (default): any may be. */
  normalDeviation?: number;
  /** No triangles come to intersect that do not in the input; takes several times as long. */
  noSelfIntersection?: boolean;
  /** A closed solid stays one, and the surface has to be one. */
  keepSolid?: boolean;
  /** Points that stay: bytes are a mask with one for each point, wider integers are their indices. */
  fixed?: Integers;
  /** Triangles that are simplified, and which targets count; the same. */
  selected?: Integers;
  /** How much each point counts, at least 0: for 8 times the number about twice as many triangles stay. */
  importance?: Reals;
  /** How firmly borders of labels keep their shape; default 1. */
  labelBorderWeight?: number;
  /** Points at exactly one place are one point, as in meshes that are split at seams (glTF, three.js); the result is
   *  split again. */
  splitVertices?: boolean;
  /** Of order relaxed: which part of the pairs a pass takes; in (0, 1], default 0.5. */
  share?: number;
  /** Of order relaxed: states are made anew between passes. */
  refresh?: boolean;

  /** All levels of detail are recorded into these. */
  levels?: Levels;
  /** Called up to 25 times a second. `false` ends it with the result so far; what it throws comes out of simplify. */
  progress?: (status: Status) => boolean | void;
}

/** How far a call is. */
export interface Status {
  /** The part that is done, from 0 to 1. */
  progress: number;
  faces: number;
  vertices: number;
  contractions: number;
  /** Of the next contraction, as `Report.error`. */
  nextError: number;
  /** Of the bounding box of the input. */
  diagonal: number;
}

/** What a call did. */
export interface Report {
  facesBefore: number;
  /** Without degenerate and doubled triangles: what targets count. */
  countedFaces: number;
  facesAfter: number;
  verticesBefore: number;
  verticesAfter: number;
  contractions: number;
  componentsBefore: number;
  componentsAfter: number;
  vanishedParts: number;
  /** The diagonal of the bounding box of the largest of them. */
  largestVanishedPart: number;
  nonManifoldEdges: number;
  nonManifoldVertices: number;
  doubledFaces: number;
  /** Why it ended. */
  stop: "target met" | "target passed" | "no pair left" | "all pairs rejected" | "target unreachable" | "cancelled";
  /** Whether the target was met, or passed by a triangle or so. */
  isTargetReached: boolean;
  /** An estimate of the greatest distance, in the unit of the points; no bound. */
  error: number;
  /** No point of the result is further from the input. Infinity, but with error and relativeError. */
  distanceBound: number;
  /** Nor any point of the input from the result. Infinity, but with bothWays. */
  hausdorffBound: number;
  /** Pairs of triangles that intersect, before and after; with noSelfIntersection. */
  selfIntersections?: [number, number];
  /** With normalDeviation: no normal is further from those that it stands for, in degrees. */
  normalBoundDegrees?: number;
  /** How many contractions were refused, by cause. */
  rejections: Record<string, number>;
  seconds: number;
  /** All of it in one line. */
  text: string;
}

/** An attribute of a result: in the form in which it was given, or with indices where points are shared now. */
export interface SimplifiedAttribute<V extends Reals = Reals> {
  components: number;
  values: V;
  indices?: Integers;
}

type SimplifiedAttributes<A extends Attributes> = { [K in keyof A]: SimplifiedAttribute<A[K]["values"]> };

/** A simplified surface: new arrays of the types of the old ones. What is left keeps its order. */
export interface Simplified<P extends Reals = Reals, I extends Integers = Integers, A extends Attributes = Attributes> {
  positions: P;
  /** Of the type of the input's; of 32 bits if that could not hold them. */
  indices: I;
  attributes: SimplifiedAttributes<A>;
  /** If the input has any. */
  labels?: Integers;
  /** Of each triangle, which one of the input it is. */
  inputFaces: Uint32Array;
  /** Of each point of the input, which one it has become; -1 of those that are gone. Not with splitVertices. */
  image?: Int32Array;
  report: Report;
}

/** Which level: the finest of at most so many faces or vertices, the coarsest within an error or a distance (bound), or
 *  the one after so many contractions. */
export type LevelStop =
  | { faces: number } | { vertices: number } | { error: number } | { distance: number } | { contractions: number };

/** What is known of a level. */
export interface LevelInfo {
  faces: number;
  vertices: number;
  contractions: number;
  error: number;
  distanceBound: number;
  hausdorffBound: number;
}

/** A level: a surface whose points and triangles have an order of their own, the same for all levels of a recording. */
export interface Level extends LevelInfo {
  positions: Reals;
  indices: Integers;
  attributes: Record<string, SimplifiedAttribute>;
  labels?: Integers;
  /** Of each point, which one of the input it is. */
  inputVertices: Uint32Array;
  /** Of each triangle, which one of the input it is. */
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
  /** What is known of a level, at once. */
  info(stop: LevelStop): LevelInfo;
  /** A level, in a time that is linear in its size. */
  at(stop: LevelStop): Level;
  /** Gives the memory back, which else happens when nobody holds these levels any more. */
  free(): void;
}

/** The library, in a memory of its own. */
export interface Quadrille {
  /** As "1.0.0". */
  readonly version: string;
  /** Levels to record into. */
  readonly Levels: new () => Levels;
  /**
   * Simplifies a surface, and leaves its arrays alone.
   *
   * It works until it is done: in a page, large surfaces belong into a Worker. Throws a TypeError or RangeError that
   * names an argument and what is wrong with it before anything is done, and an Error with what the library says.
   */
  simplify<P extends Reals, I extends Integers, A extends Attributes = {}>(
    mesh: Mesh<P, I, A>, options?: Options,
  ): Simplified<P, I, A>;
}

/** The code of the module. Default: the file quadrille.wasm beside index.js. */
export interface LoadOptions {
  wasm?: BufferSource | WebAssembly.Module | URL | string | Response | Promise<Response>;
}

/** Loads the library. Each call gives one of its own, for one thread. */
export function load(options?: LoadOptions): Promise<Quadrille>;
