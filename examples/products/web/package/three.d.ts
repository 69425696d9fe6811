import type { BufferGeometry } from "three";
import type { Attribute, Options, Quadrille } from "./index.js";

/** Options of a modifier: those of `simplify`, and of its attributes. A target among them replaces the count. */
export interface SimplifyModifierOptions extends Omit<Options, "levels" | "fixed" | "selected" | "tolerance" | "importance"> {
  /** The module to simplify with. By default all modifiers share one. */
  quadrille?: Quadrille | Promise<Quadrille>;
  /** Options of attributes by their names: `{ uv: { seams: "kept" }, normal: { importance: 2 } }`. */
  attributes?: Record<string, Partial<Omit<Attribute, "values" | "indices" | "components">>>;
}

/** Simplifies geometries, with the signature of SimplifyModifier of three.js. */
export declare class SimplifyModifier {
  constructor(options?: SimplifyModifierOptions);
  /**
   * Returns a new geometry with an index, without about so many of the vertices; the given one is not changed. All attributes
   * go along, with groups, skins and morph targets; interleaved attributes become plain ones. Throws a TypeError or RangeError
   * that names what is wrong with the geometry.
   *
   * @param geometry - triangles, with an index or without
   * @param count - the number of vertices to remove, of those that differ; as many triangles stay in proportion
   */
  modify(geometry: BufferGeometry, count: number): Promise<BufferGeometry>;
}
