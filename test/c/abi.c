/* Prints the sizes of the types of quadrille.h and the places of their members. It is compiled as
 * C99. */
#include <quadrille/quadrille.h>

#include <stddef.h>
#include <stdio.h>

#define SIZE(type) printf("%s %zu\n", #type, sizeof(type))
#define PLACE(type, member) printf("%s.%s %zu\n", #type, #member, offsetof(type, member))

int main(void) {
  SIZE(quadrille_array);
  PLACE(quadrille_array, row_stride);
  PLACE(quadrille_array, type);
  SIZE(quadrille_option);
  PLACE(quadrille_option, sentence);
  SIZE(quadrille_word);
  SIZE(quadrille_status);
  PLACE(quadrille_status, next_error);
  PLACE(quadrille_status, progress);
  PLACE(quadrille_status, stage);
  SIZE(quadrille_pair);
  PLACE(quadrille_pair, first);
  PLACE(quadrille_pair, target);
  PLACE(quadrille_pair, quadric);
  SIZE(quadrille_changed_face);
  PLACE(quadrille_changed_face, before);
  PLACE(quadrille_changed_face, third);
  SIZE(quadrille_contraction);
  PLACE(quadrille_contraction, target);
  PLACE(quadrille_contraction, faces);
  PLACE(quadrille_contraction, removed_faces);
  PLACE(quadrille_contraction, highest_degree);
  SIZE(quadrille_level_info);
  PLACE(quadrille_level_info, hausdorff_bound);
  printf("version %d\n", QUADRILLE_C_VERSION);
  return 0;
}
