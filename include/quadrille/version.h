#ifndef QUADRILLE_VERSION_H
#define QUADRILLE_VERSION_H

/// The version of the library, for `#if`; CMakeLists.txt reads it from here.
#define QUADRILLE_VERSION_MAJOR 1
/// Rises where something is added.
#define QUADRILLE_VERSION_MINOR 0
/// Rises where something is mended.
#define QUADRILLE_VERSION_PATCH 0

#endif // QUADRILLE_VERSION_H
