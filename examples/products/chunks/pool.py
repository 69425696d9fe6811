"""Simplifies a file by parts with a pool of processes of this computer, by the module quadrille.

    python3 pool.py IN.ply OUT.ply FACES SCRATCH

If it was interrupted, it goes on where it was.
"""
import multiprocessing
import sys

import quadrille


def main(source, target, faces, scratch):
    job = quadrille.FileJob(source, faces=faces, scratch=scratch, memory="1G", restart=True)
    with multiprocessing.Pool() as pool:
        parts = job.partition()
        while parts > 0:
            pool.map(job.simplify, range(parts), chunksize=1)
            parts = job.close()
    print(job.merge(target).report)


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2], int(sys.argv[3]), sys.argv[4])
