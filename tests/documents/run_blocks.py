#!/usr/bin/env python3
"""Runs the commands that the documents show, block by block, as a reader would type them.

usage: run_blocks.py REPOSITORY BUILD DOCUMENT…

The blocks of a document run in their order in one shell and one folder, which begins with the repository's folders
and `build` as links. A block in `sh` runs and has to end with 0; one in `python` runs with the built package; one in
`cpp` is compiled behind the lines that a reader has to write; one in `toml` is read by `quadrille config`; one in
`cmake` is left to the tests of the installation. A comment before a block tells what is different about it:

  <!-- live: N -->          what it starts is stopped after N seconds
  <!-- not run: REASON -->  needs what a test has not: another machine, root, a robot; the reason is printed

LCM's multicast has to work: run this with tools/private_network.
"""

import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

TIMEOUT_S = 120
BLOCK = re.compile(r"(?:<!-- (live|not run): ([^\n]*?) -->\s*\n)?(?:<!-- the test command -->\n)?^```(\w*)\n(.*?)^```$", re.M | re.S)
LINKED = ["detector", "grasping", "examples", "lcmtypes", "tests", "tools", "CMakeLists.txt", "README.md"]
# What a reader has at hand before a block in C++: points of a driver's own.
CPP = """#include <vector>
{includes}
struct {{
  float x, y, z;
}} mine[1];
int main() {{
{body}
}}
"""
# What a reader has at hand before the block: an array of points.
PYTHON = """import subprocess, quadrille
subprocess.run(["quadrille", "scene", "block.ply", "--family", "tabletop", "--seed", "7"], check=True)
points, viewpoint = quadrille.read_cloud("block.ply")[:2]
"""


class Failure(Exception):
    pass


def blocks_of(text):
    for found in BLOCK.finditer(text):
        mark, detail, language, code = found.groups()
        yield text.count("\n", 0, found.start(4)) + 1, mark, detail, language, code


def environment(build, folder):
    paths = [str(build / "bin"), str(build / "bin" / "examples"), os.environ["PATH"]]
    return {**os.environ, "PATH": ":".join(paths), "PYTHONPATH": str(build / "python"), "HOME": str(folder),
            "BROWSER": "true", "LCM_DEFAULT_URL": "udpm://239.255.76.67:7667?ttl=0"}


def run(command, folder, env, seconds):
    """Runs a command in a session of its own, and ends all that it started; None if it took too long."""
    with tempfile.TemporaryFile("w+", errors="replace") as output:
        process = subprocess.Popen(command, cwd=folder, env=env, stdout=output, stderr=subprocess.STDOUT,
                                   start_new_session=True)
        try:
            status = process.wait(timeout=seconds)
        except subprocess.TimeoutExpired:
            status = None
        for end in (signal.SIGTERM, signal.SIGKILL):
            try:
                os.killpg(process.pid, end)
            except ProcessLookupError:
                break
            time.sleep(0.2)
        process.wait()
        output.seek(0)
        return status, output.read()


def run_shell(code, live, folder, env):
    # Variables that a block exports are there in the next one.
    script = f"set -euo pipefail\nif [[ -f .exports ]]; then source .exports; fi\n{code}\n"
    script += "wait\n" if live else "export -p | grep -v ' PATH=' >.exports\n"
    status, output = run(["bash", "-c", script], folder, env, float(live) if live else TIMEOUT_S)
    if status not in ((0, None) if live else (0,)):
        raise Failure(f"exit {status}: {output[-2000:]}")


def run_cpp(code, folder, env):
    includes = "\n".join(line for line in code.splitlines() if line.startswith("#include"))
    body = "\n".join("  " + line for line in code.splitlines() if not line.startswith("#include"))
    source = folder / "block.cpp"
    source.write_text(CPP.format(includes=includes, body=body))
    roots = [folder / "detector/include", folder / "grasping/include"]
    command = ["c++", "-std=c++20", "-fsyntax-only", *[f"-I{root}" for root in roots], "-I/usr/include/eigen3", str(source)]
    status, output = run(command, folder, env, TIMEOUT_S)
    if status != 0:
        raise Failure(output[-2000:])


def run_block(language, code, live, folder, env):
    if language == "sh":
        return run_shell(code, live, folder, env)
    if language == "cpp":
        return run_cpp(code, folder, env)
    if language == "python":
        (folder / "block.py").write_text(PYTHON + code)
        command = ["/usr/bin/python3", "block.py"]
    elif language == "toml":
        (folder / "block.toml").write_text(code)
        command = ["quadrille", "config", "--config", "block.toml"]
    else:
        return None
    status, output = run(command, folder, env, TIMEOUT_S)
    if status != 0:
        raise Failure(f"exit {status}: {output[-2000:]}")
    return None


def make_robot_log(folder, build):
    """The log of the reader's own robot."""
    commands = ["quadrille scene robot.ply --family tabletop --seed 3",
                "quadrille log my_robot.lcm robot.ply robot.ply --channel MY_CAMERA"]
    for command in commands:
        status, output = run(command.split(), folder, environment(build, folder), TIMEOUT_S)
        if status != 0:
            raise Failure(f"{command}: {output}")
    return folder / "my_robot.lcm"


def check_document(repository, build, document, robot_log, counts):
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        for name in LINKED:
            (folder / name).symlink_to(repository / name)
        (folder / "build").symlink_to(build)
        env = environment(build, folder)
        shutil.copy(robot_log, folder)
        failures = []
        for line, mark, detail, language, code in blocks_of((repository / document).read_text(encoding="utf-8")):
            place = f"{document}:{line}"
            if mark == "not run":
                print(f"{place}: not run: {detail}")
                counts["not run"] += 1
                continue
            if language not in ("sh", "cpp", "python", "toml"):
                counts["shown only"] += 1
                continue
            try:
                run_block(language, code, detail if mark == "live" else None, folder, env)
                counts["run"] += 1
            except Failure as failure:
                failures.append(f"{place}: {failure}")
        return failures


def main():
    repository, build = (pathlib.Path(path).resolve() for path in sys.argv[1:3])
    counts = {"run": 0, "not run": 0, "shown only": 0}
    failures = []
    with tempfile.TemporaryDirectory() as temporary:
        robot_log = make_robot_log(pathlib.Path(temporary), build)
        for document in sys.argv[3:]:
            failures += check_document(repository, build, document, robot_log, counts)
    print(", ".join(f"{count} blocks {what}" for what, count in counts.items()))
    for failure in failures:
        print(failure, file=sys.stderr)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
