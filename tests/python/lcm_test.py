#!/usr/bin/env python3
"""The messages for Python, and what reads logs and subscribes: lcm_test.py CLOUDS.lcm RESULTS.lcm

CLOUDS.lcm was written by `quadrille log`, RESULTS.lcm by quadrille-detector from it.
"""
import pathlib
import sys
import tempfile
import unittest

import quadrille
import quadrille.bot_core
import quadrille.drake
from quadrille import lcm

CLOUDS, RESULTS = sys.argv[1:3]


def types_of(package):
    return [kind for name, kind in vars(package).items()
            if isinstance(kind, type) and hasattr(kind, "_get_packed_fingerprint")]


def values_of(message):
    """As lists, numbers and texts."""
    if hasattr(message, "__slots__"):
        return {name: values_of(getattr(message, name)) for name in message.__slots__}
    if isinstance(message, (list, tuple)):
        return [values_of(value) for value in message]
    return message


class Messages(unittest.TestCase):
    def test_what_was_just_made_can_be_sent(self):
        for package, count in ((quadrille, 28), (quadrille.drake, 6), (quadrille.bot_core, 4)):
            kinds = types_of(package)
            self.assertEqual(len(kinds), count)
            for kind in kinds:
                with self.subTest(kind.__name__):
                    message = kind()
                    decoded = kind.decode(message.encode())
                    self.assertEqual(values_of(decoded), values_of(message))
                    # Twice: nothing is used up by reading it.
                    self.assertEqual(decoded.encode(), message.encode())
                    self.assertEqual(decoded.encode(), message.encode())

    def test_a_cloud_as_a_driver_makes_it(self):
        cloud = quadrille.drake.lcmt_point_cloud()
        cloud.data = b"\0\1\2\3"
        cloud.data_size = 4
        decoded = quadrille.drake.lcmt_point_cloud.decode(cloud.encode())
        self.assertEqual(decoded.data, cloud.data)
        fingerprint = quadrille.drake.lcmt_point_cloud._get_packed_fingerprint()
        self.assertEqual(fingerprint.hex(), "17f2c128b5d25a95")

    def test_what_a_box_saw_of_its_sides_can_be_read_again(self):
        box = quadrille.box_t()
        box.seen = [True, False, True]
        decoded = quadrille.box_t.decode(box.encode())
        self.assertEqual(decoded.seen, [True, False, True])
        self.assertEqual(decoded.encode(), box.encode())


class Logs(unittest.TestCase):
    def test_results_carry_the_times_of_their_clouds(self):
        with lcm.EventLog(CLOUDS) as log:
            clouds = [quadrille.drake.lcmt_point_cloud.decode(event.data) for event in log]
        with lcm.EventLog(RESULTS) as log:
            found = [quadrille.quadrics_t.decode(event.data) for event in log
                     if event.channel == "QUADRICS"]
        self.assertEqual([m.utime for m in found], [c.utime for c in clouds])
        self.assertEqual([m.points_read for m in found], [c.width * c.height for c in clouds])
        self.assertIn("plane", [d.type for d in found[0].detections])

    def test_damaged_logs_are_told(self):
        data = pathlib.Path(CLOUDS).read_bytes()
        with tempfile.NamedTemporaryFile() as file:
            for broken, part in ((data[:1000], "cut short"), (data[:20], "cut short"),
                                 (b"\1" + data[1:], "no LCM log")):
                pathlib.Path(file.name).write_bytes(broken)
                with lcm.EventLog(file.name) as log, self.assertRaisesRegex(ValueError, part):
                    list(log)


class Connection(unittest.TestCase):
    def test_handlers_get_what_is_published_on_their_channels(self):
        connection, got = lcm.LCM("memq://"), []
        connection.subscribe("QUAD.*", lambda channel, data: got.append((channel, data)))
        other = connection.subscribe("GRASPS", lambda channel, data: got.append((channel, data)))
        self.assertEqual(connection.handle_timeout(0), 0)
        message = quadrille.quadrics_t()
        message.utime = 7
        connection.publish("QUADRICS", message.encode())
        connection.publish("GRASPS", b"\0g")
        connection.handle()
        self.assertGreater(connection.handle_timeout(1000), 0)
        self.assertEqual([channel for channel, _ in got], ["QUADRICS", "GRASPS"])
        self.assertEqual(quadrille.quadrics_t.decode(got[0][1]).utime, 7)
        self.assertEqual(got[1][1], b"\0g")
        connection.unsubscribe(other)
        connection.publish("GRASPS", b"")
        connection.handle_timeout(10)
        self.assertEqual(len(got), 2)

    def test_what_a_handler_raises_comes_to_who_waits(self):
        connection = lcm.LCM("memq://")
        connection.subscribe("A", lambda channel, data: quadrille.quadrics_t.decode(data))
        connection.publish("A", b"no message")
        with self.assertRaisesRegex(ValueError, "Decode error"):
            connection.handle()

    def test_a_log_is_played_to_its_end(self):
        connection, channels = lcm.LCM(f"file://{CLOUDS}?speed=0"), []
        connection.subscribe(".*", lambda channel, data: channels.append(channel))
        with self.assertRaises(OSError):
            while True:
                connection.handle()
        self.assertEqual(channels, ["POINT_CLOUD"] * 2)
        with self.assertRaisesRegex(OSError, "cannot open"):
            lcm.LCM("nothing://")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
