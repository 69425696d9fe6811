// Threads and zstd are there, to compile with and to link with.
#include <oneapi/tbb/version.h>
#include <zstd.h>

#if !defined QUADRILLE_WITH_TBB || !defined QUADRILLE_WITH_ZSTD
#error "the components have not been told"
#endif

int main() {
  return TBB_runtime_interface_version() > 0 && ZSTD_versionNumber() > 0 ? 0 : 1;
}
