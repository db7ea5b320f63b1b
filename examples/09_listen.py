#!/usr/bin/env python3
"""Prints the quadrics and grasps that are being published, until Ctrl-C.

    PYTHONPATH=build/python python3 examples/09_listen.py
"""
from quadrille import grasps_t, quadrics_t

try:
    import lcm
except ImportError:  # LCM's own module, which Debian does not have
    from quadrille import lcm


def on_quadrics(channel: str, data: bytes) -> None:
    message = quadrics_t.decode(data)
    print(f"cloud {message.utime} us:", ", ".join(d.type for d in message.detections), flush=True)


def on_grasps(channel: str, data: bytes) -> None:
    message = grasps_t.decode(data)
    scores = ", ".join(f"{grasp.score:.2f} on {grasp.target}" for grasp in message.grasps[:3])
    print(f"cloud {message.utime} us, grasps: {message.num_grasps}; best: {scores}", flush=True)


connection = lcm.LCM()
connection.subscribe("QUADRICS", on_quadrics)
connection.subscribe("GRASPS", on_grasps)
try:
    while True:
        connection.handle()
except KeyboardInterrupt:
    pass
