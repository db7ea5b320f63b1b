#!/usr/bin/env python3
"""Prints the quadrics in a log, as written by quadrille-detector --out-log or lcm-logger.

    PYTHONPATH=build/python python3 examples/08_read_log.py LOG.lcm
"""
import sys

from quadrille import quadrics_t

try:
    import lcm
except ImportError:  # LCM's own module, which Debian does not have
    from quadrille import lcm

if len(sys.argv) != 2:
    sys.exit("usage: 08_read_log.py LOG.lcm")
for event in lcm.EventLog(sys.argv[1]):
    if event.channel != "QUADRICS":
        continue
    message = quadrics_t.decode(event.data)
    print(f"cloud {message.utime} us, frame '{message.frame}', quadrics: {message.num_detections}")
    for found in message.detections:
        sizes = "  ".join(f"{d.name} {d.value:.4f} ± {d.std:.4f}" for d in found.dimensions)
        at = " ".join(f"{value:.3f}" for value in found.pose.position)
        print(f"{found.id:4}  {found.type:22} score {found.score:.2f}  at [m] {at}  {sizes}")
