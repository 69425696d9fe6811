/* Simplifies a surface by quadrille.h for same_bytes.py.
 *   same_bytes OPTION=NUMBER|WORD...
 * Standard input and output: a count of 64 bits and that many points of 3 doubles, then the same of
 * triangles of 3 integers of 32 bits. */
#include <quadrille/quadrille.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void* read_rows(uint64_t* count, size_t size) {
  if (fread(count, sizeof(*count), 1, stdin) != 1)
    return NULL;
  void* const rows = malloc((size_t)*count * size + 1);
  if (rows && fread(rows, size, (size_t)*count, stdin) != *count)
    return NULL;
  return rows;
}

static int write_result(quadrille_call* call, const char* name, size_t size) {
  quadrille_array view;
  if (quadrille_result(call, name, 0, &view))
    return 1;
  const uint64_t count = view.rows;
  return fwrite(&count, sizeof(count), 1, stdout) != 1 ||
         fwrite(view.data, size, view.rows, stdout) != view.rows;
}

static int set(quadrille_call* call, char* option) {
  char* const value = strchr(option, '=');
  char* end = NULL;
  if (!value)
    return 1;
  *value = '\0';
  const double number = strtod(value + 1, &end);
  return *end == '\0' ? quadrille_set_double(call, option, number)
                      : quadrille_set_text(call, option, value + 1);
}

int main(int count, char** options) {
  uint64_t points = 0, triangles = 0;
  double* const xyz = read_rows(&points, 3 * sizeof(double));
  uint32_t* const corners = read_rows(&triangles, 3 * sizeof(uint32_t));
  quadrille_call* const call = quadrille_call_new();
  if (!xyz || !corners || !call)
    return 1;
  const quadrille_array p = {xyz, (size_t)points, 3, 0, QUADRILLE_FLOAT64};
  const quadrille_array t = {corners, (size_t)triangles, 3, 0, QUADRILLE_UINT32};
  int failed =
      quadrille_set_array(call, "points", &p) || quadrille_set_array(call, "triangles", &t);
  for (int i = 1; i < count && !failed; ++i)
    failed = set(call, options[i]);
  failed = failed || quadrille_simplify(call) || write_result(call, "points", 3 * sizeof(double)) ||
           write_result(call, "triangles", 3 * sizeof(uint32_t)) || fflush(stdout) != 0;
  if (failed)
    fprintf(stderr, "%s\n", quadrille_error(call));
  quadrille_call_delete(call);
  free(xyz);
  free(corners);
  return failed;
}
