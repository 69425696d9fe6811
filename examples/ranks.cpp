// A surface larger than memory, simplified over the ranks of MPI:
//   mpirun -n 4 ranks IN.ply OUT.ply FACES SCRATCH [BYTES_OF_MEMORY [FACES_OF_A_PART]]
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/mpi.h>
#include <string>

int main(int argc, char* argv[]) {
  using namespace quadrille;
  MPI_Init(&argc, &argv);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  int status = EXIT_SUCCESS;
  try {
    if (argc < 5)
      throw std::runtime_error("ranks IN.ply OUT.ply FACES SCRATCH [MEMORY [FACES_OF_A_PART]]");
    OutOfCore options{.scratch = argv[4], .restart = true};
    if (argc > 5)
      options.memory = std::stoull(argv[5]);
    if (argc > 6) // the whole has to fit into twice as much then
      options.whole_faces = 2 * (options.chunk_faces = std::stoull(argv[6]));
    const FileReport report = simplify_file<MemorylessQuadric, OptimalPlacement>(
        MPI_COMM_WORLD, argv[1], argv[2], FaceCount{std::stoul(argv[3])}, options);
    if (rank == 0)
      std::cout << report << '\n';
  } catch (const std::exception& error) {
    // At once, so that what several ranks say is not mixed.
    std::cerr << "rank " + std::to_string(rank) + ": " + error.what() + '\n';
    status = EXIT_FAILURE;
  }
  MPI_Finalize();
  return status;
}
