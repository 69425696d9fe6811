/* Simplifies a surface by the interface of C: links quadrille::c. */
#include <quadrille/quadrille.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { n = 100 }; /* a bent sheet of n x n points */

/* Faces whose middle lies above the plane of zero cost ten times as much. */
static double cost(void* data, const quadrille_pair* pair) {
  const double* const factor = data;
  return pair->target[2] > 0 ? *factor * pair->quadric : pair->quadric;
}

static void make_sheet(float* xyz, float* uv, uint32_t* triangles) {
  for (uint32_t i = 0; i < n * n; ++i) {
    uv[2 * i] = (float)(i % n) / (n - 1);
    uv[2 * i + 1] = (float)(i / n) / (n - 1);
    xyz[3 * i] = uv[2 * i];
    xyz[3 * i + 1] = uv[2 * i + 1];
    xyz[3 * i + 2] = 0.1f * sinf(6 * uv[2 * i]) * cosf(6 * uv[2 * i + 1]);
    if (i % n > 0 && i >= n) {
      const uint32_t corners[6] = {i - n - 1, i - n, i, i - n - 1, i, i - 1};
      for (int k = 0; k < 6; ++k)
        *triangles++ = corners[k];
    }
  }
}

int main(void) {
  const size_t points = n * n, faces = 2 * (n - 1) * (n - 1);
  float* const xyz = malloc(3 * points * sizeof(float));
  float* const uv = malloc(2 * points * sizeof(float));
  uint32_t* const triangles = malloc(3 * faces * sizeof(uint32_t));
  quadrille_call* const call = quadrille_call_new();
  if (!xyz || !uv || !triangles || !call)
    return 1;
  make_sheet(xyz, uv, triangles);

  const quadrille_array p = {xyz, points, 3, 0, QUADRILLE_FLOAT32}; /* looks at arrays of yours */
  const quadrille_array t = {triangles, faces, 3, 0, QUADRILLE_UINT32};
  const quadrille_array u = {uv, points, 2, 0, QUADRILLE_FLOAT32};
  double factor = 10;
  quadrille_set_cost(call, cost, &factor);
  const int failed =
      quadrille_set_array(call, "points", &p) || quadrille_set_array(call, "triangles", &t) ||
      quadrille_add_channel(call, "texture", &u, NULL) || quadrille_set_int(call, "faces", 1000) ||
      quadrille_set_double(call, "relative_error", 0.01) || quadrille_simplify(call);
  quadrille_array result;
  if (failed || quadrille_result(call, "triangles", 0, &result))
    fprintf(stderr, "%s\n", quadrille_error(call));
  else
    printf("%s\n", quadrille_report_text(call));
  quadrille_call_delete(call);
  free(xyz);
  free(uv);
  free(triangles);
  return failed || result.rows > 1000;
}
