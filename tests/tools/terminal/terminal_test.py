#!/usr/bin/env python3
"""Runs quadrille in a pseudo-terminal, and without one: colours and progress belong to terminals alone.

usage: terminal_test.py QUADRILLE
"""

import os
import pty
import subprocess
import sys
import tempfile

ESCAPE = "\033"


def on_terminal(command, **variables):
    """What a terminal shows of a command."""
    shown = []
    environment = {name: value for name, value in os.environ.items() if name != "NO_COLOR"}
    environment.update({"TERM": "xterm", **variables})
    pid, descriptor = pty.fork()
    if pid == 0:
        os.execvpe(command[0], command, environment)
    while True:
        try:
            if not (data := os.read(descriptor, 65536)):
                break
        except OSError:  # the end of a terminal
            break
        shown.append(data)
    _, status = os.waitpid(pid, 0)
    assert os.waitstatus_to_exitcode(status) == 0, b"".join(shown)
    return b"".join(shown).decode()


def main():
    quadrille = sys.argv[1]
    with tempfile.TemporaryDirectory() as folder:
        scans = [os.path.join(folder, f"scan{i}.ply") for i in range(3)]
        for seed, scan in enumerate(scans):
            subprocess.run([quadrille, "scene", scan, "--seed", str(seed)], check=True, capture_output=True)
        plan = [quadrille, "plan", scans[0], "--gripper", "franka"]
        assert ESCAPE + "[1m" in on_terminal(plan), "heads are bold on a terminal"
        assert ESCAPE not in on_terminal(plan, NO_COLOR="1"), "NO_COLOR is respected"
        assert ESCAPE + "[1m" in on_terminal(plan, NO_COLOR=""), "an empty NO_COLOR says nothing"
        assert ESCAPE not in on_terminal(plan, TERM="dumb"), "a dumb terminal has no colours"
        piped = subprocess.run(plan, check=True, capture_output=True, text=True)
        assert ESCAPE not in piped.stdout + piped.stderr, "a pipe gets no colours"

        # Results go to a file: the terminal shows how far it is, and is wiped at the end.
        table = os.path.join(folder, "table.txt")
        many = ["sh", "-c", f"{quadrille} detect {' '.join(scans)} >{table}"]
        shown = on_terminal(many)
        assert "33 %" in shown and "100 %" in shown, shown
        assert shown.endswith("\r" + ESCAPE + "[K"), shown
        with open(table, encoding="utf-8") as file:
            assert "%" not in file.read(), "results are without progress"
        # Results on the terminal show themselves how far it is.
        assert "33 %" not in on_terminal([quadrille, "detect", *scans])
        # Short work in a pipe: not a word.
        quiet = subprocess.run([quadrille, "detect", *scans], check=True, capture_output=True, text=True)
        assert quiet.stderr == "", quiet.stderr
    print("terminal_test: all is well")


if __name__ == "__main__":
    main()
