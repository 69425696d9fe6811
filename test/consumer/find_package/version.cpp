// The version that find_package has told is that of the headers.
#include <quadrille/version.h>

static_assert(QUADRILLE_VERSION_MAJOR == FOUND_MAJOR && QUADRILLE_VERSION_MINOR == FOUND_MINOR &&
              QUADRILLE_VERSION_PATCH == FOUND_PATCH);
