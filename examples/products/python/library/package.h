/* What the Python package calls beside quadrille.h, by ctypes: see quadrille/_library.py. */
#ifndef QUADRILLE_EXAMPLES_PACKAGE_H
#define QUADRILLE_EXAMPLES_PACKAGE_H

#include <quadrille/quadrille.h>

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Named arrays that a function takes, and those that it gives. Texts are arrays of bytes. */
typedef struct quadrille_bag quadrille_bag;

QUADRILLE_C quadrille_bag* quadrille_bag_new(void);
QUADRILLE_C void quadrille_bag_delete(quadrille_bag* bag);
/** What was wrong when a function last failed. */
QUADRILLE_C const char* quadrille_bag_error(const quadrille_bag* bag);
/** Puts an array in; it is read in place. */
QUADRILLE_C int32_t quadrille_bag_put(quadrille_bag* bag, const char* name,
                                      const quadrille_array* array);
/** How many arrays a function gave; their names and views, which live as long as the bag. */
QUADRILLE_C size_t quadrille_bag_count(const quadrille_bag* bag);
QUADRILLE_C const char* quadrille_bag_take(const quadrille_bag* bag, size_t index,
                                           quadrille_array* view);

/** Functions of one argument, each of which is called by one thread at a time. What is less than 0,
 * or no cost, ends the call. Null: none. */
typedef struct quadrille_asked {
  int32_t (*progress)(quadrille_status);
  int32_t (*stop)(quadrille_status);
  int32_t (*filter)(quadrille_contraction);
  double (*cost)(quadrille_pair);
} quadrille_asked;
/** The functions of a call, which has to be deleted before them. Null if there is no memory. */
typedef struct quadrille_functions quadrille_functions;
QUADRILLE_C quadrille_functions* quadrille_functions_new(quadrille_call* call,
                                                         const quadrille_asked* asked);
QUADRILLE_C void quadrille_functions_delete(quadrille_functions* functions);
/** Answers whether to proceed, of a part that is done. */
typedef int32_t (*quadrille_part_function)(double);

/** Sets a number of a call, or of a channel from 0 on, whose range is checked by the library when
 * the call runs: the messages are those of its policies. */
QUADRILLE_C int32_t quadrille_set_unchecked(quadrille_call* call, int64_t channel, const char* name,
                                            double value);
/** Does what a name says: see jobs.cpp. The options of the call are used by `simplify_gltf`, and
 * `progress` by `verify`. */
QUADRILLE_C int32_t quadrille_do(const char* name, quadrille_bag* bag, quadrille_call* call,
                                 quadrille_part_function progress);

/** How far a run from a file to a file is. */
typedef struct quadrille_file_status {
  int32_t stage;
  uint32_t phase, phases;
  size_t chunks, chunks_done;
  uint64_t faces;
  double progress;
  uint64_t estimated_faces, memory, scratch, output;
  double seconds;
} quadrille_file_status;
typedef int32_t (*quadrille_file_progress)(quadrille_file_status);

/** A simplification from a file to a file: the bag has its options beside those of the call. */
typedef struct quadrille_file_job quadrille_file_job;
QUADRILLE_C quadrille_file_job* quadrille_file_job_new(quadrille_bag* bag,
                                                       const quadrille_call* call,
                                                       quadrille_file_progress progress,
                                                       int32_t* code);
QUADRILLE_C void quadrille_file_job_delete(quadrille_file_job* job);
/** Does a step: estimate, partition, join, simplify (a part), close, sew or run (to a path). */
QUADRILLE_C int32_t quadrille_file_job_step(quadrille_file_job* job, const char* step,
                                            quadrille_bag* bag);

#ifdef __cplusplus
}
#endif

#endif
