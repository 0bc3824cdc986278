#!/usr/bin/env python3
"""instructions.py fails where a count has grown or fallen by more than 3 %, and only there: check_instructions.py GAPCHECK"""

import json
import pathlib
import subprocess
import sys
import tempfile

SCRIPT = pathlib.Path(__file__).with_name("instructions.py")
CASE = "reading"


def run(program, record):
    call = [sys.executable, "-B", SCRIPT, program, "--only", CASE, "--record", record]
    return subprocess.run(call, capture_output=True, text=True)


def main():
    program = sys.argv[1]
    with tempfile.TemporaryDirectory() as name:
        record = pathlib.Path(name) / "record.json"
        on_record = json.loads(SCRIPT.with_suffix(".json").read_text())
        update = subprocess.run([sys.executable, "-B", SCRIPT, program, "--update", "--only", CASE, "--record", record],
                                capture_output=True, text=True)
        assert update.returncode == 0, update.stderr
        now = json.loads(record.read_text())
        assert set(now) == {CASE} and set(now[CASE]) == set(on_record[CASE]), now.keys()
        for share, fails in ((1, False), (1 / 1.02, False), (1 / 1.04, True), (1 / 0.96, True)):
            changed = json.loads(record.read_text())
            changed[CASE]["instructions"] = round(now[CASE]["instructions"] * share)
            function = max(changed[CASE]["functions"], key=changed[CASE]["functions"].get)
            changed[CASE]["functions"][function] = round(changed[CASE]["functions"][function] * share)
            other = pathlib.Path(name) / "changed.json"
            other.write_text(json.dumps(changed))
            ended = run(program, other)
            assert ended.returncode == (1 if fails else 0), (share, ended.stdout, ended.stderr)
            assert not fails or (f"{CASE}: " in ended.stderr and function in ended.stderr), ended.stderr
    return 0


if __name__ == "__main__":
    sys.exit(main())
