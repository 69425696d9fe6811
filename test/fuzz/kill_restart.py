#!/usr/bin/env python3
"""Kills runs of the program by parts at random times, and restarts them: are the bytes of the result
those of a run that nobody disturbed? Between some of them a file of the scratch folder is damaged:
then the next run has to end in a sentence that names a file, or to give the right bytes; never others.

    kill_restart.py PROGRAM IN.ply FOLDER [--kills 100] [--damages 30] [--seed 1] [OPTION...]

OPTION... are those of the program, by default --keep 5% --memory 128M, with which a surface of a
million faces has a dozen parts. FOLDER is for all that is written. Exits with 1 if anything is wrong.
"""
import argparse
import hashlib
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import time


def content(path):
    return hashlib.sha256(path.read_bytes()).hexdigest() if path.exists() else None


class Fuzz:
    def __init__(self, options):
        self.random = random.Random(options.seed)
        self.folder = pathlib.Path(options.folder)
        self.folder.mkdir(parents=True, exist_ok=True)
        self.output, self.scratch = self.folder / "out.ply", self.folder / "scratch"
        self.command = [options.program, options.input, str(self.output), "--force", "--quiet", "--restart",
                        "--out-of-core", str(self.scratch)] + (options.option or ["--keep", "5%", "--memory", "128M"])
        self.failures = 0
        self.clear()
        begin = time.monotonic()
        subprocess.run(self.command, check=True, stderr=subprocess.PIPE)
        self.seconds = time.monotonic() - begin
        self.right = content(self.output)

    def clear(self):
        shutil.rmtree(self.scratch, ignore_errors=True)
        self.output.unlink(missing_ok=True)

    def fail(self, what):
        self.failures += 1
        print("wrong:", what, flush=True)

    def run(self, seconds):
        """Killed after so many seconds; its exit status, negative if it was, and what it said."""
        process = subprocess.Popen(self.command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        try:
            said = process.communicate(timeout=seconds)[1]
        except subprocess.TimeoutExpired:
            process.send_signal(signal.SIGKILL)
            said = process.communicate()[1]
        return process.returncode, said.decode()

    def damage(self):
        """Shortens, changes, lengthens or removes a file of the scratch folder; what was done, if there is one."""
        files = sorted(p for p in self.scratch.rglob("*") if p.is_file())
        if not files:
            return None
        path = self.random.choice(files)
        size = path.stat().st_size
        kind = self.random.choice(["shorten", "change", "lengthen", "remove"])
        if kind == "remove":
            path.unlink()
        elif kind == "lengthen":
            with path.open("ab") as file:
                file.write(b"\0" * self.random.randint(1, 64))
        elif size == 0:
            return None
        else:
            at = self.random.randrange(size)
            with path.open("r+b") as file:
                if kind == "shorten":
                    file.truncate(at)
                else:
                    file.seek(at)
                    byte = file.read(1)[0]
                    file.seek(at)
                    file.write(bytes([byte ^ self.random.randint(1, 255)]))
        return f"{kind} {path.relative_to(self.scratch)}"

    def step(self, damaged):
        """One run, which may be killed. What became of it: killed, done or refused."""
        status, said = self.run(self.random.uniform(0, self.seconds * 0.6))
        was_there = content(self.output)
        if was_there not in (None, self.right):
            self.fail(f"the result has other bytes, after {damaged}")
        if status == -signal.SIGKILL:
            return "killed"
        if status == 0:
            if was_there is None:
                self.fail("no result")
            if self.scratch.exists():
                self.fail(f"the scratch folder is left: {sorted(self.scratch.rglob('*'))[:5]}")
            self.clear()
            return "done"
        if not damaged:
            self.fail(f"status {status}, and nothing was damaged: {said}")
        elif status != 2 or str(self.folder) not in said:
            self.fail(f"status {status}, after {damaged}: {said}")
        self.clear()
        return "refused"

    def __call__(self, kills, damages):
        counts = {"killed": 0, "done": 0, "refused": 0}
        damaged, done_damages = [], 0
        while counts["killed"] < kills or done_damages < damages:
            outcome = self.step(damaged)
            counts[outcome] += 1
            if outcome != "killed":
                damaged = []
            elif done_damages < damages and self.random.random() < 0.4:
                what = self.damage()
                if what:
                    damaged.append(what)
                    done_damages += 1
        self.clear()
        print(f"{counts['killed']} killed, {counts['done']} done, {done_damages} files damaged, "
              f"{counts['refused']} refused in a sentence, {self.failures} wrong")
        return self.failures == 0


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("input")
    parser.add_argument("folder")
    parser.add_argument("--kills", type=int, default=100)
    parser.add_argument("--damages", type=int, default=30)
    parser.add_argument("--seed", type=int, default=1)
    options, options.option = parser.parse_known_args()
    return 0 if Fuzz(options)(options.kills, options.damages) else 1


if __name__ == "__main__":
    sys.exit(main())
