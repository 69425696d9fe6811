"""Parts of a surface that does not fit into memory, by Dask; the same command again goes on:

python3 chunks.py SCHEDULER quadrille in.ply out.ply --faces 1000000 --out-of-core /scratch/a --memory 4G

SCHEDULER is the address of one, or - for processes of this computer.
"""
import subprocess
import sys

from dask.distributed import Client


def step(command, *words):
    """Does a step of the job, and returns how many parts the phase has then."""
    return int(subprocess.run([*command, *words], check=True, stdout=subprocess.PIPE).stdout)


def main():
    scheduler, command = sys.argv[1], sys.argv[2:]
    client = Client(None if scheduler == "-" else scheduler)
    parts = step(command, "--restart", "--step", "cut")
    while parts > 0:
        tasks = [client.submit(step, command, "--step", str(part), pure=False) for part in range(parts)]
        client.gather(tasks)
        parts = step(command, "--step", "close")


if __name__ == "__main__":
    main()
