#!/usr/bin/env python3
"""Attacks the server of quadrille view as hostile or broken clients would, and measures its memory.

usage: attacks_test.py BIN_FOLDER CLOUD
"""

import contextlib
import http.client
import os
import re
import signal
import socket
import struct
import subprocess
import sys
import tempfile
import threading
import time

MAX_RESIDENT_MB = 128
# What the process may keep of what an attack has made it allocate.
MAX_KEPT_MB = 16
MAX_OPENING_S = 2
# An attacker sends for this long, unless he is stopped.
POURING_S = 1
# A request has 5 s; the rest is for a loaded machine.
DEADLINE_S = 8
PIECE = b"a" * 65536
GET = b"GET / HTTP/1.1\r\nHost: 127.0.0.1\r\n"
ASK = b"POST /api/questions HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Type: application/json\r\n"
CHUNKED = ASK + b"Transfer-Encoding: chunked\r\n\r\n"


class View:
    """A running quadrille view."""

    def __init__(self, bin_folder, log):
        self.process = subprocess.Popen(
            [os.path.join(bin_folder, "quadrille"), "view", "--port", "0", "--in-log", log],
            stdout=subprocess.PIPE, text=True)
        self.port = int(re.search(r"http://\S+:(\d+)/", self.process.stdout.readline()).group(1))

    def memory_mb(self, name):
        with open(f"/proc/{self.process.pid}/status", encoding="ascii") as status:
            return int(re.search(name + r":\s+(\d+)", status.read()).group(1)) / 1024

    def forget_peak(self):
        with open(f"/proc/{self.process.pid}/clear_refs", "w", encoding="ascii") as file:
            file.write("5")

    def connect(self):
        return socket.create_connection(("127.0.0.1", self.port), DEADLINE_S)

    def status_of(self, request):
        """The status that a request is answered with; None if the connection ends without one."""
        with self.connect() as client:
            client.sendall(request)
            with contextlib.suppress(ConnectionError):
                line = client.makefile("rb").readline().split()
                return int(line[1]) if line else None

    def open_page(self):
        """Opens the page as a browser does that comes now, and says how long it took [s]."""
        start = time.monotonic()
        for path in ("/", "/app.js", "/three.min.js", "/api/session"):
            browser = http.client.HTTPConnection("127.0.0.1", self.port, timeout=DEADLINE_S)
            browser.request("GET", path, headers={"Accept-Encoding": "gzip"})
            answer = browser.getresponse()
            assert answer.status == 200 and answer.read(), path
            browser.close()
        return time.monotonic() - start


def expect(actual, expected, what):
    assert actual == expected, f"{what}: {actual!r} instead of {expected!r}"


def pour(view, beginning, pieces):
    """Sends a beginning and then pieces, until they or the time are over, or the server has enough."""
    end = time.monotonic() + POURING_S
    with view.connect() as client, contextlib.suppress(ConnectionError):
        client.sendall(beginning)
        for piece in pieces:
            if time.monotonic() > end:
                break
            client.sendall(piece)


def endless(piece):
    while True:
        yield piece


def pour_request_line(view):
    pour(view, b"GET /", endless(PIECE))


def pour_header(view):
    pour(view, GET + b"X: ", endless(PIECE))


def pour_headers(view):
    pour(view, GET, (b"".join(b"X-%d: y\r\n" % (block + i) for i in range(1000)) for block in range(0, 300000, 1000)))


def pour_chunks(view):
    pour(view, CHUNKED, endless(b"%x\r\n%s\r\n" % (len(PIECE), PIECE)))


def pour_chunk_extension(view):
    pour(view, CHUNKED + b"1;", endless(PIECE))


def pour_trailer(view):
    pour(view, CHUNKED + b"0\r\nX: ", endless(PIECE))


def four_at_once(view):
    attackers = [threading.Thread(target=attack, args=(view,))
                 for attack in (pour_request_line, pour_header, pour_headers, pour_chunks)]
    for attacker in attackers:
        attacker.start()
    for attacker in attackers:
        attacker.join()


def lie_about_lengths(view):
    expect(view.status_of(ASK + b"Content-Length: 2000\r\n\r\n" + b" " * 2000), 413, "a body over the limit")
    expect(view.status_of(ASK + b"Content-Length: 999999999999\r\n\r\n"), 413, "a huge length")
    for length in (b"-1", b"1" + 30 * b"0", b"0x10", b"1 1", b"ten", b"1\r\nContent-Length: 2"):
        expect(view.status_of(ASK + b"Content-Length: " + length + b"\r\n\r\n{}"), 400, f"length {length}")
    expect(view.status_of(ASK + b"Content-Length: 5\r\nTransfer-Encoding: chunked\r\n\r\n0\r\n\r\n"), 400, "two lengths")
    with view.connect() as client:
        client.sendall(ASK + b"Content-Length: 10\r\n\r\n{}")
        client.shutdown(socket.SHUT_WR)
        expect(client.recv(1), b"", "an answer to a body that is cut short")


def pipeline_garbage(view):
    with view.connect() as client:
        client.sendall(3 * (GET + b"\r\n") + b"\x16\x03\x01\x02\x00 garbage \xff\r\n\r\n")
        statuses = re.findall(rb"HTTP/1.1 (\d+)", client.makefile("rb").read())
        expect(statuses, [b"200", b"200", b"200", b"400"], "answers to three requests and garbage")
    pour(view, b"", endless(200 * (GET + b"\r\n")))
    pour(view, b"", [os.urandom(1 << 20)])


def close_in_the_middle(view):
    for _ in range(200):
        client = view.connect()
        client.sendall(b"GET /three.min.js HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n")
        client.recv(1000)
        # Closed with a reset.
        client.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
        client.close()


def open_fifty(view):
    seconds = []
    browsers = [threading.Thread(target=lambda: seconds.append(view.open_page())) for _ in range(50)]
    for browser in browsers:
        browser.start()
    for browser in browsers:
        browser.join()
    expect(len(seconds), 50, "browsers of fifty that were served")


class Loris:
    """Clients that send a byte now and then; each is served as if it were the slowest of browsers."""

    BEGINNINGS = (b"", b"GET /", GET + b"X: ", ASK + b"Content-Length: 1000\r\n\r\n")

    def __init__(self, view, count):
        self.clients = [view.connect() for _ in range(count)]
        for i, client in enumerate(self.clients):
            client.setblocking(False)
            client.sendall(self.BEGINNINGS[i % len(self.BEGINNINGS)])

    def drip(self):
        """Sends a byte on each connection, and forgets those that the server has closed."""
        self.clients = [client for client in self.clients if self.is_open(client)]
        return len(self.clients)

    @staticmethod
    def is_open(client):
        try:
            client.sendall(b"a")
            if client.recv(1):
                return True
        except BlockingIOError:
            return True
        except ConnectionError:
            pass
        client.close()
        return False

    def close(self):
        for client in self.clients:
            client.close()


def drip_hundred(view):
    """While 100 clients drip the page opens; none of them is kept for longer than a request may take."""
    with contextlib.closing(Loris(view, 100)) as loris:
        expect(loris.drip(), 100, "clients of a hundred that have a place")
        slowest = view.open_page()
        end = time.monotonic() + DEADLINE_S
        while loris.drip():
            assert time.monotonic() < end, "a client that drips keeps its place"
            slowest = max(slowest, view.open_page())
            time.sleep(0.3)
        print(f"    the page opened within {slowest:.2f} s")
        assert slowest < MAX_OPENING_S, f"the page opened within {slowest:.1f} s"


def drip_more_than_there_are_places(view):
    with contextlib.closing(Loris(view, 400)) as loris:
        seconds = view.open_page()
        print(f"    the page opened within {seconds:.2f} s")
        assert seconds < MAX_OPENING_S, f"the page opened within {seconds:.1f} s"
        assert loris.drip() <= 128, "the slowest have given way"


ATTACKS = (pour_request_line, pour_header, pour_headers, pour_chunks, pour_chunk_extension, pour_trailer,
           four_at_once, lie_about_lengths, pipeline_garbage, close_in_the_middle, open_fifty, drip_hundred,
           drip_more_than_there_are_places)


def check_memory(view, attack):
    view.open_page()
    view.forget_peak()
    before = view.memory_mb("VmRSS")
    attack(view)
    peak, after = view.memory_mb("VmHWM"), view.memory_mb("VmRSS")
    print(f"{attack.__name__:32} {before:5.0f} MB before, {peak:5.0f} at most, {after:5.0f} after", flush=True)
    assert peak <= MAX_RESIDENT_MB, f"{attack.__name__}: {peak:.0f} MB"
    assert after <= before + MAX_KEPT_MB, f"{attack.__name__}: {after - before:.0f} MB are not given back"


def main():
    bin_folder, cloud = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        log = os.path.join(folder, "cloud.lcm")
        subprocess.run([os.path.join(bin_folder, "quadrille"), "log", log, cloud], check=True, stdout=subprocess.DEVNULL)
        view = View(bin_folder, log)
        try:
            for attack in ATTACKS:
                check_memory(view, attack)
            with contextlib.closing(Loris(view, 100)):
                view.process.send_signal(signal.SIGTERM)
                expect(view.process.wait(2), 0, "the end after SIGTERM while clients drip")
        finally:
            view.process.kill()


if __name__ == "__main__":
    main()
