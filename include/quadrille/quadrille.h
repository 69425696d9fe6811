/* SPDX-License-Identifier: MIT */
#ifndef QUADRILLE_QUADRILLE_H
#define QUADRILLE_QUADRILLE_H

/** \file
 * Quadrille for C, and for all languages that call C: surfaces of triangles as plain arrays. The
 * target quadrille::c has the functions. This header is C99 and C++.
 *
 *     quadrille_call* call = quadrille_call_new();
 *     quadrille_array points = {xyz, count, 3, 0, QUADRILLE_FLOAT32};
 *     quadrille_array triangles = {indices, faces, 3, 0, QUADRILLE_UINT32};
 *     if (quadrille_set_array(call, "points", &points) ||
 *         quadrille_set_array(call, "triangles", &triangles) ||
 *         quadrille_set_int(call, "faces", 1000) || quadrille_simplify(call))
 *       fprintf(stderr, "%s\n", quadrille_error(call));
 *     quadrille_call_delete(call);
 *
 * A function that may fail returns a quadrille_status_code, which is 0 if all went well; otherwise
 * quadrille_error() returns what is wrong. A handle is used by one thread at a time; different
 * handles may be used by different threads. No function throws, prints or ends the program. Names
 * and texts are UTF-8 and end with a null character.
 */

#include <stddef.h>
#include <stdint.h>

/** \def QUADRILLE_C
 * Marks a function that the library exports. */
#if defined(_WIN32) && defined(QUADRILLE_C_BUILDS)
#define QUADRILLE_C __declspec(dllexport)
#elif defined(_WIN32) && defined(QUADRILLE_C_IS_SHARED)
#define QUADRILLE_C __declspec(dllimport)
#elif defined(__GNUC__)
#define QUADRILLE_C __attribute__((visibility("default")))
#else
#define QUADRILLE_C
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** The version of this interface. Functions are added within a major version; none is changed. */
#define QUADRILLE_C_VERSION 1

/** Returns the QUADRILLE_C_VERSION of the library that is linked. */
QUADRILLE_C int32_t quadrille_c_version(void);
/** Returns the version of Quadrille, as "1.0.0". */
QUADRILLE_C const char* quadrille_version(void);
/** Returns 1 if more than one thread can be used, else 0. */
QUADRILLE_C int32_t quadrille_has_threads(void);

/** The reasons why a function fails. */
enum quadrille_status_code {
  QUADRILLE_OK = 0,
  QUADRILLE_INVALID = 1,         /**< an argument is invalid */
  QUADRILLE_OUT_OF_RANGE = 2,    /**< an index is out of range */
  QUADRILLE_OUT_OF_MEMORY = 3,   /**< there is not enough memory */
  QUADRILLE_FUNCTION_FAILED = 4, /**< a function of the caller has failed */
  QUADRILLE_FAILED = 5           /**< something else, such as a file, is wrong */
};

/* --- Arrays ---------------------------------------------------------------------------------- */

/** The types of the numbers of arrays. */
enum quadrille_type {
  QUADRILLE_FLOAT64 = 0,
  QUADRILLE_FLOAT32 = 1,
  QUADRILLE_UINT8 = 2, /**< for flags: 0 is false */
  QUADRILLE_UINT32 = 3,
  QUADRILLE_INT32 = 4,
  QUADRILLE_UINT64 = 5,
  QUADRILLE_INT64 = 6
};

/** A view of an array of rows, whose numbers are consecutive. */
typedef struct quadrille_array {
  const void* data;     /**< the first number */
  size_t rows;          /**< the number of rows */
  size_t columns;       /**< the number of numbers of a row */
  ptrdiff_t row_stride; /**< bytes from a row to the next; 0: rows are consecutive */
  int32_t type;         /**< a quadrille_type */
} quadrille_array;

/* --- Options --------------------------------------------------------------------------------- */

/** A row of the table of options. */
typedef struct quadrille_option {
  const char* name;       /**< the name, as functions take it */
  const char* kind;       /**< count, number, flag, word, numbers, point_numbers, … */
  const char* range;      /**< as "[0, inf)"; empty: any */
  const char* fallback;   /**< the default; empty: none */
  const char* unit;       /**< empty: none */
  const char* places;     /**< the interfaces that have it: C, program, Python, web */
  const char* short_form; /**< the short form in the program; empty: none */
  const char* sentence;   /**< the description; names of options and words are in backquotes */
} quadrille_option;

/** Returns the number of options of a call (`of_channels` is 0) or of a channel (1). */
QUADRILLE_C size_t quadrille_option_count(int32_t of_channels);
/** Returns a row of the table, which is the library's and lives as long; null past the end. */
QUADRILLE_C const quadrille_option* quadrille_option_at(int32_t of_channels, size_t index);

/** A value of an option whose kind is word. */
typedef struct quadrille_word {
  const char* word;     /**< the value, as quadrille_set_text() takes it */
  const char* sentence; /**< the description */
} quadrille_word;

/** Returns a word of an option, which is the library's as a row is; null past the last one. */
QUADRILLE_C const quadrille_word* quadrille_word_at(int32_t of_channels, const char* option,
                                                    size_t index);

/* --- A call ---------------------------------------------------------------------------------- */

/** A surface with its options, and its result. */
typedef struct quadrille_call quadrille_call;
/** All levels of detail of a surface. */
typedef struct quadrille_levels quadrille_levels;

/** Returns a call, or null if there is not enough memory. */
QUADRILLE_C quadrille_call* quadrille_call_new(void);
/** Deletes a call with its result, or nothing if it is null. */
QUADRILLE_C void quadrille_call_delete(quadrille_call* call);
/** Returns what was wrong when a function last failed; it is valid until the next one fails. */
QUADRILLE_C const char* quadrille_error(const quadrille_call* call);

/** Sets an array by its name: `points`, `triangles`, `labels` or an option that is an array.
 *
 * Points, triangles and labels are read when the call runs, in place if they are consecutive numbers
 * of the types that the library uses (double, and integers of 32 bits), and must live until it
 * returns. Options are copied. Flags are one number for each point or triangle, 0 for false. */
QUADRILLE_C int32_t quadrille_set_array(quadrille_call* call, const char* name,
                                        const quadrille_array* array);
/** Sets an option that is a number. */
QUADRILLE_C int32_t quadrille_set_double(quadrille_call* call, const char* name, double value);
/** Sets an option that is an integer, a number or a flag, 0 or 1. */
QUADRILLE_C int32_t quadrille_set_int(quadrille_call* call, const char* name, int64_t value);
/** Sets an option that is a word. */
QUADRILLE_C int32_t quadrille_set_text(quadrille_call* call, const char* name, const char* word);

/** Adds a channel of attributes, whose options are then set by the functions below. Its arrays are
 * read as points are.
 *
 * \param call  the call
 * \param kind  texture, normals, colors or attributes
 * \param values  a row for each value
 * \param corners  for each triangle the values of its corners; null: a value for each point */
QUADRILLE_C int32_t quadrille_add_channel(quadrille_call* call, const char* kind,
                                          const quadrille_array* values,
                                          const quadrille_array* corners);
/** Sets an option of a channel that is a number, an integer or a flag. */
QUADRILLE_C int32_t quadrille_set_channel_double(quadrille_call* call, size_t channel,
                                                 const char* name, double value);
/** Sets an option of a channel that is a word. */
QUADRILLE_C int32_t quadrille_set_channel_text(quadrille_call* call, size_t channel,
                                               const char* name, const char* word);
/** Sets an option of a channel that is an array. */
QUADRILLE_C int32_t quadrille_set_channel_array(quadrille_call* call, size_t channel,
                                                const char* name, const quadrille_array* array);

/* --- Functions of the caller ----------------------------------------------------------------- */

/** The state of a surface just before the next contraction. Members may be added at the end. */
typedef struct quadrille_status {
  size_t initial_faces;    /**< the number of faces of the input */
  size_t initial_vertices; /**< the number of vertices of the input */
  size_t faces;            /**< the number of faces now */
  size_t vertices;         /**< the number of vertices now */
  size_t contractions;     /**< the number of contractions so far */
  double next_error;       /**< the error of the next contraction, a distance */
  double diagonal;         /**< the diagonal of the bounding box of the input */
  double progress;         /**< the estimated fraction that is done; 1 at the last call only */
  int32_t stage;           /**< 0: data is prepared, 1: pairs are contracted, 2: the result is written */
} quadrille_status;

/** A pair of vertices that may be contracted. Members may be added at the end. */
typedef struct quadrille_pair {
  size_t first_index;  /**< an end, as an index of the input */
  size_t second_index; /**< the other end */
  double first[3];     /**< the position of an end */
  double second[3];    /**< the position of the other end */
  double target[3];    /**< the position of the new vertex */
  double quadric;      /**< the cost by the quadric error metric */
} quadrille_pair;

/** A face that a contraction changes: its moving corner and its two other corners. */
typedef struct quadrille_changed_face {
  size_t index;     /**< in the input */
  double before[3]; /**< the position of its moving corner */
  double after[3];  /**< the new position of this corner */
  double second[3]; /**< the position of its next corner */
  double third[3];  /**< the position of its last corner */
} quadrille_changed_face;

/** A contraction that is about to be done. Members may be added at the end. */
typedef struct quadrille_contraction {
  size_t first;                        /**< an end of the pair, as an index of the input */
  size_t second;                       /**< the other end */
  double target[3];                    /**< the position of the new vertex */
  const quadrille_changed_face* faces; /**< the faces that stay and change */
  size_t face_count;                   /**< their number */
  const size_t* removed_faces;         /**< the faces that go, as indices of the input */
  size_t removed_face_count;           /**< their number */
  size_t highest_degree;               /**< the higher degree of the two ends, in faces */
} quadrille_contraction;

/** Returns whether the call proceeds: 1 is yes, 0 is no.
 *
 * Functions get the `data` of the caller. What they point to lives until they return. An answer less
 * than 0, or a cost that is less than 0 or not finite, fails: the call ends with
 * QUADRILLE_FUNCTION_FAILED and without a result. */
typedef int32_t (*quadrille_progress_function)(void* data, const quadrille_status* status);
/** Returns whether the simplification stops: 1 is yes, 0 is no. */
typedef int32_t (*quadrille_stop_function)(void* data, const quadrille_status* status);
/** Returns whether a contraction is allowed: 1 is yes, 0 is no. */
typedef int32_t (*quadrille_filter_function)(void* data, const quadrille_contraction* contraction);
/** Returns the cost of a pair, at least 0. */
typedef double (*quadrille_cost_function)(void* data, const quadrille_pair* pair);

/** Sets a function that is called up to 25 times a second, and at the end: should the call proceed?
 * If it answers no, the call ends early with the result so far. Null removes it. */
QUADRILLE_C void quadrille_set_progress(quadrille_call* call, quadrille_progress_function function,
                                        void* data);
/** Sets a function that is asked before each contraction: does the run stop now? */
QUADRILLE_C void quadrille_set_stop(quadrille_call* call, quadrille_stop_function function,
                                    void* data);
/** Sets a function that is asked before each contraction: may it be done? With several threads it
 * is called by several at once, as the next one is. */
QUADRILLE_C void quadrille_set_filter(quadrille_call* call, quadrille_filter_function function,
                                      void* data);
/** Sets a function that replaces the cost of a contraction, at least 0. */
QUADRILLE_C void quadrille_set_cost(quadrille_call* call, quadrille_cost_function function,
                                    void* data);
/** Sets levels into which all contractions are recorded; null removes them. */
QUADRILLE_C void quadrille_set_levels(quadrille_call* call, quadrille_levels* levels);
/** Ends a call that another thread runs, as soon as it can, with the result so far. */
QUADRILLE_C void quadrille_cancel(quadrille_call* call);

/* --- The result ------------------------------------------------------------------------------ */

/** Simplifies. The arrays of the caller are not changed. If it fails, there is no result. */
QUADRILLE_C int32_t quadrille_simplify(quadrille_call* call);

/** Views an array of the result by its name. The view is valid until the call runs again or is
 * deleted.
 *
 * points: doubles; triangles, labels, input_faces (the triangle of the input that each is):
 * integers of 32 bits; vertex_map (for each point of the input its point of the result, or -1):
 * signed integers of 64 bits, none with split_vertices; values, corners: those of a channel. An
 * array that the result does not have has no rows.
 *
 * With the option maps also two sparse matrices by rows (CSR), whose products with a value for each
 * column are a value for each row. old_to_new has a row for each point of the input: its place on
 * the result, as up to three points with weights above 0 and of the sum 1; none where the surface
 * has vanished, and for points of no triangle. new_to_old has a row for each point of the result:
 * its place on the input. The arrays old_to_new_begins (for each row its first entry, and their
 * number at the end) and old_to_new_indices (points) are signed integers of 64 bits,
 * old_to_new_weights doubles; the same for new_to_old. */
QUADRILLE_C int32_t quadrille_result(quadrille_call* call, const char* name, size_t channel,
                                     quadrille_array* view);
/** Copies an array of the result into memory of the caller, with a type and a stride. */
QUADRILLE_C int32_t quadrille_copy_result(quadrille_call* call, const char* name, size_t channel,
                                          void* to, int32_t type, ptrdiff_t row_stride);
/** Returns the report of the last run as JSON: an object with the members of Report. A number that
 * is unknown or infinite is null. It is valid until the call runs again or is deleted. */
QUADRILLE_C const char* quadrille_report(quadrille_call* call);
/** Gets a number of the report by its name; a flag is 0 or 1, and an unknown number is infinite. */
QUADRILLE_C int32_t quadrille_report_number(quadrille_call* call, const char* name, double* value);
/** Returns the report as one line of text. It is valid as quadrille_report() is. */
QUADRILLE_C const char* quadrille_report_text(quadrille_call* call);

/* --- Levels of detail ------------------------------------------------------------------------ */

/** Returns levels of which nothing is recorded, or null if there is not enough memory. */
QUADRILLE_C quadrille_levels* quadrille_levels_new(void);
/** Returns a copy, or null if there is not enough memory. */
QUADRILLE_C quadrille_levels* quadrille_levels_copy(const quadrille_levels* levels);
/** Deletes levels, or nothing if they are null. */
QUADRILLE_C void quadrille_levels_delete(quadrille_levels* levels);
/** Returns what was wrong when a function of these levels last failed. */
QUADRILLE_C const char* quadrille_levels_error(const quadrille_levels* levels);
/** Returns 1 if nothing has been recorded, else 0. */
QUADRILLE_C int32_t quadrille_levels_empty(const quadrille_levels* levels);
/** Writes levels to a file, with a comment. */
QUADRILLE_C int32_t quadrille_levels_save(quadrille_levels* levels, const char* path,
                                          const char* comment);
/** Replaces levels with those of a file. */
QUADRILLE_C int32_t quadrille_levels_load(quadrille_levels* levels, const char* path);
/** Returns the comment of the file that was loaded last. */
QUADRILLE_C const char* quadrille_levels_comment(const quadrille_levels* levels);

/** The figures of a level. */
typedef struct quadrille_level_info {
  size_t faces;           /**< the number of faces */
  size_t vertices;        /**< the number of vertices */
  size_t contractions;    /**< the number of contractions from the input to the level */
  double error;           /**< as in the report */
  double distance_bound;  /**< as in the report */
  double hausdorff_bound; /**< as in the report */
} quadrille_level_info;

/** A level with its surface. */
typedef struct quadrille_level quadrille_level;

/** Gets the figures of a level: `stop` is faces or vertices (the finest of so many at most), error
 * or distance (the coarsest within it), contractions (after so many), finest or coarsest. Reading
 * functions may be called by several threads at once; their errors are in `error`, a text of the
 * caller of `error_size` bytes. */
QUADRILLE_C int32_t quadrille_levels_info(const quadrille_levels* levels, const char* stop,
                                          double number, quadrille_level_info* info, char* error,
                                          size_t error_size);
/** Makes a level, with its points and triangles in the order of the input. */
QUADRILLE_C int32_t quadrille_levels_at(const quadrille_levels* levels, const char* stop,
                                        double number, quadrille_level** level, char* error,
                                        size_t error_size);
/** Deletes a level, or nothing if it is null. */
QUADRILLE_C void quadrille_level_delete(quadrille_level* level);
/** Returns the figures of a level. */
QUADRILLE_C quadrille_level_info quadrille_level_figures(const quadrille_level* level);
/** Returns the number of its channels. */
QUADRILLE_C size_t quadrille_level_channels(const quadrille_level* level);
/** Views an array of a level: points, triangles, input_points and input_faces (the point and the
 * triangle of the input that each is), or values and corners of a channel. */
QUADRILLE_C int32_t quadrille_level_array(const quadrille_level* level, const char* name,
                                          size_t channel, quadrille_array* view);

/** All levels as arrays: the coarsest level, and the vertex splits that refine it to the input. */
typedef struct quadrille_splits quadrille_splits;

/** Makes the vertex splits of levels, with errors as quadrille_levels_info() has them. */
QUADRILLE_C int32_t quadrille_levels_splits(const quadrille_levels* levels,
                                            quadrille_splits** splits, char* error,
                                            size_t error_size);
/** Deletes splits, or nothing if they are null. */
QUADRILLE_C void quadrille_splits_delete(quadrille_splits* splits);
/** Views an array of splits: points, merged_points, parent_points and errors are doubles, faces,
 * input_points, input_faces, point_counts, face_counts, parents, children, corner_begins and
 * corners integers of 32 bits.
 *
 * Level s has the first point_counts[s] points and the first face_counts[s] faces; level 0 is the
 * coarsest. Split s leads to level s + 1. The corners number corner_begins[s] up to the next begin,
 * each as 3 * face + corner, become the point children[s]; the next points and faces are appended;
 * and the point parents[s] moves from merged_points[s] to parent_points[s]. Parents and children of
 * a split that only restores faces are UINT32_MAX. */
QUADRILLE_C int32_t quadrille_splits_array(const quadrille_splits* splits, const char* name,
                                           quadrille_array* view);

#ifdef __cplusplus
}
#endif

#endif
