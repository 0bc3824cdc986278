"""What the measuring scripts share: running a command and measuring it, and putting tables into pages.

A page marks the place of a table NAME with <!-- NAME: begin --> and <!-- NAME: end -->.
"""

import datetime
import os
import pathlib
import platform
import statistics
import subprocess
import time


def section(name, text, body):
    """The text with the part between the marks of that name replaced."""
    begin, end = f"<!-- {name}: begin -->", f"<!-- {name}: end -->"
    before, rest = text.split(begin, 1)
    return f"{before}{begin}\n{body}\n{end}{rest.split(end, 1)[1]}"


def run_once(command):
    """Wall time in seconds, peak resident memory in MB and the exit status of one run."""
    start = time.perf_counter()
    # Not to /dev/null: grep would notice and stop at the first match.
    process = subprocess.Popen(command, stdout=subprocess.PIPE)
    process.stdout.read()
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    return time.perf_counter() - start, usage.ru_maxrss / 1024, process.returncode


def measure(command, runs):
    run_once(command)  # warms the file cache
    samples = [run_once(command) for _ in range(runs)]
    # Exit 1: findings at or above the limit. Anything else but 0 is a failure, not a time.
    bad = [status for _, _, status in samples if status not in (0, 1)]
    if bad:
        raise SystemExit(f"{' '.join(command)}: exit {bad[0]}")
    times = [wall for wall, _, _ in samples]
    return min(times), statistics.median(times), max(rss for _, rss, _ in samples)


def commit():
    """The commit that is measured, marked if code differs from it; empty outside a repository."""
    def git(*arguments):
        return subprocess.run(["git", *arguments], cwd=pathlib.Path(__file__).parents[2], capture_output=True, text=True)
    try:
        name = git("rev-parse", "--short", "HEAD").stdout.strip()
        changed = git("diff", "--quiet", "HEAD", "--", "lib", "apps", "tests", "cmake").returncode == 1
    except OSError:
        return ""
    return name + " with changes" if name and changed else name


def machine():
    """Processor, system, day and commit: what a table of times is worth nothing without."""
    model = platform.processor() or "unknown processor"
    try:
        for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
            if line.startswith("model name"):
                model = line.split(":", 1)[1].strip()
                break
    except OSError:
        pass
    parts = [f"{model}, {os.cpu_count()} processors, {platform.system()} {platform.release().split('-')[0]}",
             datetime.date.today().isoformat()]
    if now := commit():
        parts.append(f"commit {now}")
    return ", ".join(parts)
