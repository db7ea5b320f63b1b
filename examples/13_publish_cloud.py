#!/usr/bin/env python3
"""Publishes the cloud of a file as a camera driver would, five times a second until Ctrl-C.

    PYTHONPATH=build/python python3 examples/13_publish_cloud.py CLOUD.pcd [COUNT]
"""
import sys
import time

import numpy as np

import quadrille
from quadrille.drake import lcmt_point_cloud, lcmt_point_cloud_field

try:
    import lcm
except ImportError:  # LCM's own module, which Debian does not have
    from quadrille import lcm


def to_message(points: np.ndarray, utime: int) -> lcmt_point_cloud:
    """Converts points (N, 3) or (H, W, 3) [m], seen from the origin; NaN marks a missing one."""
    records = np.ascontiguousarray(points, dtype="<f4")
    message = lcmt_point_cloud()
    message.utime, message.frame_name = utime, "camera"
    message.width = records.shape[-2]
    message.height = records.shape[0] if records.ndim == 3 else 1
    for name in ("x", "y", "z"):
        field = lcmt_point_cloud_field()
        field.name, field.byte_offset, field.datatype, field.count = name, 4 * message.num_fields, 7, 1  # float32
        message.fields.append(field)
        message.num_fields += 1
    message.point_step, message.row_step = 12, 12 * message.width
    message.data = records.tobytes()
    message.data_size = len(message.data)
    return message


if len(sys.argv) not in (2, 3):
    sys.exit("usage: 13_publish_cloud.py CLOUD.pcd [COUNT]")
points, _ = quadrille.read_cloud(sys.argv[1])
count = int(sys.argv[2]) if len(sys.argv) > 2 else sys.maxsize
connection = lcm.LCM()
try:
    for _ in range(count):
        connection.publish("POINT_CLOUD", to_message(points, int(time.time() * 1e6)).encode())
        time.sleep(0.2)
except KeyboardInterrupt:
    pass
