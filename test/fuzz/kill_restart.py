#!/usr/bin/env python3
"""Disturbs runs of the program by parts at random, and restarts them: are the bytes of the result those
of a run that nobody disturbed? They are killed; they find a disk that is full; a second job begins in
the same folder; and a file of the job is damaged, after which the next run has to end in a sentence that names
a file, or to give the right bytes; never others. The scratch folder has files of the user's, with names
that a job's might have: they are there before and after each run, as they were.

    kill_restart.py PROGRAM IN.ply FOLDER [--kills 100] [--damages 30] [--disks 30] [--pairs 15] [--seed 1] [OPTION...]

OPTION... are those of the program, by default --keep 5% --memory 128M, with which a surface of a
million faces has a dozen parts. FOLDER is for all that is written. Exits with 1 if anything is wrong.
"""
import argparse
import hashlib
import pathlib
import random
import resource
import shutil
import signal
import subprocess
import sys
import time


def content(path):
    return hashlib.sha256(path.read_bytes()).hexdigest() if path.exists() else None


USERS_FILES = ("notes.txt", "labels", "welded-1.ply", "phase-1/plan", "phase-1/left-0", "welding/run-0", "quadrille-jobs/job")


class Fuzz:
    def __init__(self, options):
        self.random = random.Random(options.seed)
        self.folder = pathlib.Path(options.folder)
        self.folder.mkdir(parents=True, exist_ok=True)
        self.output, self.scratch = self.folder / "out.ply", self.folder / "scratch"
        self.second_output = self.folder / "second.ply"
        self.job = self.scratch / "quadrille-job"
        rest = ["--force", "--quiet", "--restart", "--out-of-core", str(self.scratch)]
        rest += options.option or ["--keep", "5%", "--memory", "128M"]
        self.command = [options.program, options.input, str(self.output), *rest]
        self.second_command = [options.program, options.input, str(self.second_output), *rest]
        self.failures = 0
        self.clear()
        begin = time.monotonic()
        subprocess.run(self.command, check=True, stderr=subprocess.PIPE)
        self.seconds = time.monotonic() - begin
        self.right = content(self.output)
        self.clear()

    def clear(self):
        """No job, no result; the scratch folder is missing, empty, or has files of the user's."""
        shutil.rmtree(self.scratch, ignore_errors=True)
        for path in (self.output, self.second_output):
            path.unlink(missing_ok=True)
        kind = self.random.choice(["missing", "empty", "used", "used"])
        if kind != "missing":
            self.scratch.mkdir()
        for name in USERS_FILES if kind == "used" else ():
            path = self.scratch / name
            path.parent.mkdir(exist_ok=True)
            path.write_text("of the user's: " + name)
        self.users = self.users_tree()

    def users_tree(self):
        """What is in the scratch folder beside the job's, with its content; None if there is no folder."""
        if not self.scratch.exists():
            return None
        below = [p for p in self.scratch.rglob("*") if self.job != p and self.job not in p.parents]
        return {str(p): content(p) if p.is_file() else None for p in below}

    def check_users_files(self, is_over, when):
        now = self.users_tree()
        is_made_by_job = self.users is None and not is_over and not now  # an empty folder for its own
        if now != self.users and not is_made_by_job:
            self.fail(f"the user's files are not what they were, {when}: {self.users} became {now}")
        if is_over and self.job.exists():
            self.fail(f"the job's folder is left, {when}: {sorted(self.job.rglob('*'))[:5]}")

    def fail(self, what):
        self.failures += 1
        print("wrong:", what, flush=True)

    def start(self, command, most_bytes=None):
        """`most_bytes` are all that a file may have, as on a disk that is full."""
        def limit():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (most_bytes, most_bytes))
        return subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                                preexec_fn=limit if most_bytes is not None else None)

    def run(self, seconds, most_bytes=None):
        """Killed after so many seconds; its exit status, negative if it was, and what it said."""
        process = self.start(self.command, most_bytes)
        try:
            said = process.communicate(timeout=seconds)[1]
        except subprocess.TimeoutExpired:
            process.send_signal(signal.SIGKILL)
            said = process.communicate()[1]
        return process.returncode, said.decode()

    def damage(self):
        """Shortens, changes, lengthens or removes a file of the job; what was done, if there is one."""
        files = sorted(p for p in self.job.rglob("*") if p.is_file())
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

    def check_result(self, output, after):
        if content(output) not in (None, self.right):
            self.fail(f"{output.name} has other bytes, after {after}")

    def step(self, damaged):
        """One run, which may be killed. What became of it: killed, done or refused."""
        status, said = self.run(self.random.uniform(0, self.seconds * 0.6))
        self.check_result(self.output, damaged)
        if status == -signal.SIGKILL:
            self.check_users_files(False, "after a kill")
            return "killed"
        if status == 0:
            if not self.output.exists():
                self.fail("no result")
            self.check_users_files(True, "after a run to its end")
            self.clear()
            return "done"
        self.check_users_files(False, f"after {damaged}")
        if not damaged:
            self.fail(f"status {status}, and nothing was damaged: {said}")
        elif status != 2 or str(self.folder) not in said or len(said.strip().split("\n")) != 1:
            self.fail(f"status {status}, after {damaged}: {said}")
        self.clear()
        return "refused"

    def fill_disk(self):
        """A run on a full disk, which ends in a sentence; then it goes on where there is space."""
        most = int(10 ** self.random.uniform(1, 7))
        status, said = self.run(None, most)
        self.check_result(self.output, "a full disk")
        if status == 0:
            self.check_users_files(True, "after a run that did not need the space")
            return self.clear()
        if status != 2 or ": cannot be written" not in said or len(said.strip().split("\n")) != 1:
            self.fail(f"status {status} on a disk of {most} bytes a file: {said}")
        self.check_users_files(False, "after a full disk")
        if self.random.random() < 0.5:
            status, said = self.run(None)
            if status != 0 or content(self.output) != self.right:
                self.fail(f"status {status} after a full disk of {most} bytes a file: {said}")
            self.check_users_files(True, "after a full disk and a restart")
            self.clear()
        return None

    def run_two(self):
        """A second job begins in the folder of the first: one of them ends with its bytes, and the other is told who works
        there, or comes when the first is over."""
        first = self.start(self.command)
        time.sleep(self.random.choice([0, self.random.uniform(0, self.seconds)]))
        second = self.start(self.second_command)
        ends = []
        for process, other in ((first, second), (second, first)):
            said = process.communicate()[1].decode()
            ends.append(process.returncode)
            is_told = f"process {other.pid} of " in said and "uses it for an unfinished job" in said
            if process.returncode != 0 and not (process.returncode == 2 and is_told and said.count("\n") == 1):
                self.fail(f"status {process.returncode} of one of two jobs: {said}")
        if 0 not in ends:
            self.fail(f"neither of two jobs came to its end: {ends}")
        for output, status in ((self.output, ends[0]), (self.second_output, ends[1])):
            self.check_result(output, "two jobs at once")
            if status == 0 and not output.exists():
                self.fail("no result of one of two jobs")
        self.check_users_files(True, "after two jobs")
        self.clear()

    def __call__(self, kills, damages, disks, pairs):
        counts = {"killed": 0, "done": 0, "refused": 0}
        damaged, done_damages = [], 0
        others = [self.fill_disk] * disks + [self.run_two] * pairs
        self.random.shuffle(others)
        every = max(1, kills // (len(others) + 1))
        while counts["killed"] < kills or done_damages < damages or others:
            if others and not damaged and (counts["killed"] % every == 0 or counts["killed"] >= kills):
                others.pop()()
            outcome = self.step(damaged)
            counts[outcome] += 1
            if outcome != "killed":
                damaged = []
            elif done_damages < damages and self.random.random() < 0.4:
                what = self.damage()
                if what:
                    damaged.append(what)
                    done_damages += 1
        shutil.rmtree(self.scratch, ignore_errors=True)
        print(f"{counts['killed']} killed, {counts['done']} done, {done_damages} files damaged, "
              f"{counts['refused']} refused in a sentence, {disks} full disks, {pairs} pairs of jobs, "
              f"{self.failures} wrong")
        return self.failures == 0


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("input")
    parser.add_argument("folder")
    parser.add_argument("--kills", type=int, default=100)
    parser.add_argument("--damages", type=int, default=30)
    parser.add_argument("--disks", type=int, default=30)
    parser.add_argument("--pairs", type=int, default=15)
    parser.add_argument("--seed", type=int, default=1)
    options, options.option = parser.parse_known_args()
    return 0 if Fuzz(options)(options.kills, options.damages, options.disks, options.pairs) else 1


if __name__ == "__main__":
    sys.exit(main())
