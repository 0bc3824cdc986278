#!/usr/bin/env python3
"""Tries docs/ci/slurm on a Slurm of one node: 200 decks, one of them no deck at all, in eight tasks, one of which is
killed in the middle and sent again. Nothing may be lost, nothing audited twice, and the merged output must equal that of
one call. Puts what happened and what it cost into docs/campaigns.md.

usage: slurm_campaign.py GAPCHECK FOLDER [--decks 200]
Needs root and the Debian packages slurm-wlm and munge; FOLDER is emptied.
"""

import argparse
import os
import pathlib
import re
import shutil
import signal
import socket
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tests/bench"))
from page import machine, section  # noqa: E402

SHARES, KILLED = 8, 3
CONFIGURATION = """ClusterName=one
SlurmctldHost={host}
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
NodeName={host} CPUs={cpus} State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


def plates(path, side):
    """A mesh that decks include: two plates of side x side shells of 5, 0.7 apart."""
    lines, row = ["*NODE"], side + 1
    for plate in (0, 1):
        for j in range(row):
            for i in range(row):
                node = plate * row * row + j * row + i + 1
                lines.append(f"{node},{5 * i + 1.5 * plate},{5 * j + 2 * plate},{0.7 * plate}")
    lines.append("*ELEMENT_SHELL")
    for plate in (0, 1):
        for j in range(side):
            for i in range(side):
                first = plate * row * row + j * row + i + 1
                element = plate * side * side + j * side + i + 1
                lines.append(f"{element},{plate + 1},{first},{first + 1},{first + row + 1},{first + row}")
    path.write_text("\n".join(lines) + "\n")


def deck(path, mesh, thickness):
    text = content((ROOT / "data/two_plates.k"))
    keep = re.split(r"(?m)^(?=\*)", text)
    frame = [block for block in keep if not block.startswith(("*NODE", "*ELEMENT", "*END", "*SECTION"))]
    sections = "".join(f"*SECTION_SHELL\n{i},2\n" + ",".join([str(thickness)] * 4) + "\n" for i in (1, 2))
    path.write_text("".join(frame) + sections + f"*INCLUDE\n{mesh}\n*END\n")


def content(path):
    return path.read_text(encoding="utf-8", errors="replace")


def make_decks(models, count):
    models.mkdir()
    for kind, side in enumerate((40, 80, 120, 160)):
        plates(models / f"mesh_{kind}.inc", side)
    for i in range(count - 1):
        deck(models / f"deck_{i:03}.k", f"mesh_{i % 4}.inc", round(0.5 + i / count, 6))
    (models / "hostile.k").write_bytes(bytes(range(256)) * 40)


class Slurm:
    """A controller and a node on this machine, while the block lasts."""

    def __init__(self, folder):
        self.folder = folder
        self.environment = {**os.environ, "SLURM_CONF": str(folder / "slurm.conf")}
        self.daemons = []

    def __enter__(self):
        for name in ("state", "spool"):
            (self.folder / name).mkdir()
        (self.folder / "slurm.conf").write_text(
            CONFIGURATION.format(host=socket.gethostname().split(".")[0], folder=self.folder, cpus=os.cpu_count()))
        pathlib.Path("/run/munge").mkdir(exist_ok=True)
        shutil.chown("/run/munge", "munge", "munge")
        self.start("runuser", "-u", "munge", "--", "munged", "--foreground", "--force")
        time.sleep(2)
        self.start("slurmctld", "-D")
        self.start("slurmd", "-D")
        for _ in range(60):
            time.sleep(1)
            ended = [daemon.args[0] for daemon in self.daemons if daemon.poll() is not None]
            if ended or "idle" in self.call("sinfo", "--noheader", "--format=%t", check=False):
                break
        else:
            ended = ["the node"]
        if not ended:
            return self
        self.stop()
        raise SystemExit(f"{ended[0]} does not run; see slurmctld.log and slurmd.log in {self.folder}")

    def start(self, *command):
        self.daemons.append(subprocess.Popen(command, env=self.environment, stdout=subprocess.DEVNULL,
                                             stderr=subprocess.DEVNULL, start_new_session=True))

    def __exit__(self, *_):
        self.stop()

    def stop(self):
        for daemon in reversed(self.daemons):
            if daemon.poll() is None:
                os.killpg(daemon.pid, signal.SIGTERM)
        for daemon in self.daemons:
            daemon.wait()

    def call(self, *command, check=True):
        return subprocess.run(command, env=self.environment, check=check, capture_output=True, text=True,
                              cwd=self.folder).stdout.strip()

    def wait(self, job):
        while self.call("squeue", "--noheader", f"--job={job}", check=False):
            time.sleep(0.5)


def kill_in_the_middle(folder, gapcheck):
    """Kills the task as soon as it has done some of its decks; how many bytes of results it had."""
    results = folder / "results" / str(KILLED)
    while not results.exists() or results.stat().st_size < 200_000:
        time.sleep(0.02)
    subprocess.run(["pkill", "-KILL", "-f", f"{gapcheck} audit .*--shard {KILLED}/{SHARES} "], check=True)
    return results.stat().st_size


def without_times(text):
    return re.sub(r'_s":\s*[0-9.e+-]+', '_s": t', text)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("gapcheck", type=lambda text: pathlib.Path(text).resolve())
    parser.add_argument("folder", type=lambda text: pathlib.Path(text).resolve())
    parser.add_argument("--decks", type=int, default=200)
    arguments = parser.parse_args()
    folder = arguments.folder
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    make_decks(folder / "models", arguments.decks)
    os.environ["PATH"] = f"{arguments.gapcheck.parent}:{os.environ['PATH']}"

    begin = time.perf_counter()
    one = subprocess.run([arguments.gapcheck, "audit", "models/*.k", "--fail-on", "never", "--quiet", "--format", "json",
                          "--output", "one.json"], cwd=folder)
    one_call = time.perf_counter() - begin

    with Slurm(folder) as slurm:
        begin = time.perf_counter()
        shutil.copy(ROOT / "docs/ci/slurm", folder)
        out = slurm.call("sbatch", f"--array=1-{SHARES}", "--cpus-per-task=1", "slurm", "models/*.k")
        job = out.split()[-1]
        had = kill_in_the_middle(folder, arguments.gapcheck.name)
        slurm.wait(f"{job}_{KILLED}")
        slurm.call("scontrol", "requeue", f"{job}_{KILLED}", check=False)
        time.sleep(1)
        slurm.wait(job)
        first = time.perf_counter() - begin
        # Slurm forgets finished tasks: these are submitted anew.
        environment = f"SHARES={SHARES}"
        out = slurm.call("env", environment, "sbatch", f"--array={KILLED}", "--cpus-per-task=1", "slurm", "models/*.k")
        slurm.wait(out.split()[-1])

    begin = time.perf_counter()
    merged = subprocess.run([arguments.gapcheck, "merge", *sorted(map(str, (folder / "results").iterdir())), "--fail-on",
                             "never", "--quiet", "--format", "json", "--output", "merged.json"], cwd=folder)
    merging = time.perf_counter() - begin
    same = without_times(content(folder / "one.json")) == without_times(content(folder / "merged.json"))
    if not same or one.returncode != merged.returncode:
        raise SystemExit("the merged output is not that of one call")
    decks = len(re.findall(r'"input":', content(folder / "merged.json")))
    whole = (folder / "results" / str(KILLED)).stat().st_size
    lines = [f"{machine()}:", "", "| | |", "|---|---|",
             f"| decks, of them read | {arguments.decks}, {decks} |",
             f"| results of task {KILLED} when it was killed, at the end | {had:,} bytes, {whole:,} bytes |",
             f"| one call with all threads | {one_call:.1f} s, {one_call / arguments.decks * 1e3:.0f} ms per deck |",
             f"| {SHARES} tasks of one thread, one sent again, which Slurm delays by two minutes | {first:.1f} s, {first / arguments.decks * 1e3:.0f} ms per deck |",
             f"| merging | {merging:.2f} s |",
             f"| exit codes of one call and of merge | {one.returncode}, {merged.returncode} |",
             "| JSON of one call and of merge, without times | equal |"]
    page = ROOT / "docs/campaigns.md"
    page.write_text(section("slurm", page.read_text(encoding="utf-8"), "\n".join(lines)), encoding="utf-8")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
