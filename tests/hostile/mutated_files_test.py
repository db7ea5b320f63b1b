#!/usr/bin/env python3
"""Damages files of all kinds that the programs read, and judges how these end: with 0 or 1, within limits of memory
and time, and with lines for people, of bounded length, in UTF-8, without control characters and without a library's
own words.

usage: mutated_files_test.py PROGRAMS [ROUNDS]

Each of some sixty files is damaged ROUNDS times (by default 3) and read by the commands for it in turn. What is done
to a file depends on its name and the round alone.
"""

import concurrent.futures
import os
import pathlib
import random
import re
import resource
import signal
import subprocess
import sys
import tempfile

import samples

MAX_LINE_BYTES, MAX_MEMORY_KB, MAX_CPU_S = 500, 100 * 1024, 10
# What libraries say, and nobody else.
FOREIGN = re.compile(r"Invalid header|_M_\w+|std::|basic_string|parse_error|json\.exception|\bsto[ild]+\b|bad_alloc|"
                     r"Assertion|terminate called|what\(\)|vector::")
HUGE = [b"1e30", b"-1e308", b"99999999999999999999", b"4294967295", b"-1", b"nan", b"inf", b"0"]
HUGE_BYTES = [b"\xff\xff\x7f\x7f", b"\xff" * 8, b"\x00\x00\x80\x7f", b"\x00\x00\xc0\x7f", b"\x7f\xff\xff\xff", b"\x80\0\0\0"]
INSERTED = [b"\xff", b"\xff\xfe\xff", b"\0", b"\x1b[31m", b"\r\n", b"\x7f\x85", b"\xed\xa0\x80", b"\xc0\xaf"]


def flip_bits(data, choose):
    for _ in range(choose.randint(1, 20)):
        at = choose.randrange(len(data))
        data[at] ^= 1 << choose.randrange(8)


def cut(data, choose):
    del data[choose.randrange(len(data)):]


def double_block(data, choose):
    at, size = choose.randrange(len(data)), choose.randint(1, 4096)
    data[at:at] = data[at:at + size]


def enlarge_number(data, choose):
    numbers = list(re.finditer(rb"-?\d+(\.\d+)?", bytes(data[:20000])))
    if numbers:
        data[slice(*choose.choice(numbers).span())] = choose.choice(HUGE)


def overwrite(data, choose):
    new, at = choose.choice(HUGE_BYTES), choose.randrange(len(data))
    data[at:at + len(new)] = new


def insert(data, choose):
    at = choose.randrange(min(len(data), choose.choice([200, len(data)])))
    data[at:at] = choose.choice(INSERTED)


def insert_into_word(data, choose):
    words = list(re.finditer(rb"[A-Za-z_]{2,}", bytes(data[:20000])))
    if words:
        at = choose.choice(words).end()
        data[at:at] = choose.choice(INSERTED + [b"k" * 3_000_000, b"\xff" * 3_000_000])


MUTATIONS = [flip_bits, cut, double_block, enlarge_number, overwrite, insert, insert_into_word]


def damaged(name, content, number):
    choose = random.Random(f"{name} {number}")
    data = bytearray(content)
    for _ in range(choose.randint(1, 3)):
        if data:
            choose.choice(MUTATIONS)(data, choose)
    return bytes(data)


def start_limited():
    resource.setrlimit(resource.RLIMIT_CPU, (2 * MAX_CPU_S, 2 * MAX_CPU_S))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def run(line, folder):
    """The exit code, the use of resources, and what was written to both outputs."""
    with open(folder / "stdout", "w+b") as out, open(folder / "stderr", "w+b") as err:
        process = subprocess.Popen(line, stdin=subprocess.DEVNULL, stdout=out, stderr=err, preexec_fn=start_limited)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        out.seek(0), err.seek(0)
        return process.returncode, usage, out.read(), err.read()


def faults_of_text(what, raw, max_line_bytes):
    try:
        text = raw.decode()
    except UnicodeDecodeError as error:
        return [f"{what} is no UTF-8: {error}"]
    found = [f"{what} has the control character {c!r}" for c in set(text) if (c < " " and c != "\n") or "\x7f" <= c < "\xa0"]
    longest = max((len(line.encode()) for line in text.split("\n")), default=0)
    if longest > max_line_bytes:
        found.append(f"{what} has a line of {longest} bytes")
    if foreign := FOREIGN.search(text):
        found.append(f"{what} has a library's words '{foreign.group()}'")
    return found


def faults_of(line, folder):
    code, usage, out, err = run(line, folder)
    faults = []
    if code < 0:
        return [f"killed by {signal.Signals(-code).name}"]
    if code not in (0, 1):
        faults.append(f"ended with {code}")
    # JSON has a whole result in a line.
    faults += faults_of_text("stdout", out, 1 << 30) + faults_of_text("stderr", err, MAX_LINE_BYTES)
    lines = err.count(b"\n")
    if code == 1 and "--in-log" not in line and lines - err.count(b": warning: ") != 1:
        faults.append(f"{lines} lines on stderr tell of a failure")
    # What is packed may grow.
    if usage.ru_maxrss > MAX_MEMORY_KB and not any(".gz" in word or ".npz" in word for word in line):
        faults.append(f"took {usage.ru_maxrss // 1024} MB")
    if usage.ru_utime + usage.ru_stime > MAX_CPU_S:
        faults.append(f"took {usage.ru_utime + usage.ru_stime:.1f} s")
    return [f"{fault}: {err[:200]!r}" for fault in faults]


def main():
    bin_folder = pathlib.Path(sys.argv[1])
    rounds = int(sys.argv[2]) if len(sys.argv) > 2 else 3
    tests = pathlib.Path(__file__).resolve().parent.parent
    with tempfile.TemporaryDirectory() as root:
        root = pathlib.Path(root)
        contents, cloud = samples.all_samples(bin_folder, tests, root)

        def judge(case):
            name, number = case
            folder = root / f"{name}.{number}"
            folder.mkdir()
            (folder / name).write_bytes(damaged(name, contents[name], number))
            lines = samples.lines_of(name, bin_folder, folder, cloud)
            line = [str(word) for word in lines[number % len(lines)]]
            faults = faults_of(line, folder)
            kept = os.environ.get("QUADRILLE_KEEP")
            if faults and kept:
                (pathlib.Path(kept) / f"{number}_{name}").write_bytes((folder / name).read_bytes())
            for path in folder.iterdir():
                path.unlink()
            words = [word.replace(str(folder) + "/", "") for word in line[1:]]
            return [f"round {number}, {os.path.basename(line[0])} {' '.join(words)}: {fault}" for fault in faults]

        cases = [(name, number) for name in contents for number in range(rounds)]
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            faults = [fault for found in pool.map(judge, cases) for fault in found]
    for fault in faults:
        print(fault)
    print(f"{len(contents)} files, {len(cases)} damaged ones, {len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
