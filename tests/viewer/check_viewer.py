"""Reads a log of the bus with decoders that lcm-gen made of the viewer's types for Python, and takes
the messages as Meldis does: usage: check_viewer.py DECODERS LOG"""

import struct
import sys

FINGERPRINTS = {
    "lcmt_viewer_load_robot": 0x8987209B10AA2D39,
    "lcmt_viewer_geometry_data": 0x5D2E34CB3257DB07,
    "lcmt_viewer_draw": 0x414F0BFE5B2F4244,
    "lcmt_point_cloud": 0x17F2C128B5D25A95,
}
NUMBERS = {1: 3, 2: 1, 3: 2, 6: 3}  # of a box, sphere, cylinder, ellipsoid


def events(path):
    """The channels and bytes of a log, in order."""
    with open(path, "rb") as file:
        while header := file.read(28):
            sync, _, _, name_size, size = struct.unpack(">IqqII", header)
            assert sync == 0xEDA1DA01, "the log is broken"
            yield file.read(name_size).decode(), file.read(size)


def check_mesh(numbers):
    vertices, triangles = int(numbers[0]), int(numbers[1])
    assert len(numbers) == 2 + 3 * vertices + 3 * triangles
    assert all(0 <= i < vertices and i == int(i) for i in numbers[2 + 3 * vertices :])


def check_unit(quaternion):
    assert abs(sum(x * x for x in quaternion) - 1) < 1e-5


def check_load(message):
    """Returns the names of the links."""
    for link in message.link:
        assert link.num_geom == len(link.geom) > 0
        for shape in link.geom:
            if shape.type == 4:
                assert shape.string_data == ""
                check_mesh(shape.float_data)
            else:
                assert len(shape.float_data) == NUMBERS[shape.type]
                assert min(shape.float_data) > 0
            check_unit(shape.quaternion)
            assert all(0 <= c <= 1 for c in shape.color)
    names = [link.name for link in message.link]
    assert len(set(names)) == len(names)
    return names


def check_cloud(message):
    assert message.flags == 2, "Meldis takes finite clouds alone"
    fields = [(f.name, f.byte_offset, f.datatype, f.count) for f in message.fields]
    assert fields == [("x", 0, 7, 1), ("y", 4, 7, 1), ("z", 8, 7, 1)]
    assert message.point_step == 12 and message.data_size == 12 * message.width * message.height
    values = struct.unpack(f"<{message.data_size // 4}f", bytes(message.data))
    assert len(values) > 300 and all(v == v and abs(v) < 100 for v in values)


class Viewer:
    """One scene: what was loaded, and how often it was drawn."""

    def __init__(self):
        self.names, self.loads, self.draws, self.types = None, 0, 0, set()

    def load(self, message):
        self.names = check_load(message)
        self.loads += 1
        self.types |= {shape.type for link in message.link for shape in link.geom}

    def draw(self, message):
        # Meldis places only what was loaded, and shows nothing before it is drawn.
        assert message.link_name == self.names
        for quaternion in message.quaternion:
            check_unit(quaternion)
        self.draws += 1


def main(decoders, log):
    sys.path.insert(0, decoders)
    import drake

    for name, fingerprint in FINGERPRINTS.items():
        known = getattr(drake, name)._get_packed_fingerprint()
        assert struct.unpack(">Q", known)[0] == fingerprint, name
    prefix, found, hand, clouds = "ARM_", Viewer(), Viewer(), 0
    for channel, data in events(log):
        assert not channel.startswith("DRAKE_"), f"{channel} lacks the prefix"
        if not channel.startswith(prefix + "DRAKE_"):
            continue
        viewer = hand if channel.endswith("_ILLUSTRATION") else found
        kind = channel.removeprefix(prefix).removesuffix("_ILLUSTRATION")
        if kind == "DRAKE_VIEWER_LOAD_ROBOT":
            viewer.load(drake.lcmt_viewer_load_robot.decode(data))
        elif kind == "DRAKE_VIEWER_DRAW":
            viewer.draw(drake.lcmt_viewer_draw.decode(data))
        else:
            assert kind == "DRAKE_POINT_CLOUD", channel
            check_cloud(drake.lcmt_point_cloud.decode(data))
            clouds += 1
    assert clouds == found.draws >= 3, (clouds, found.draws)
    assert 1 <= found.loads < 3 and found.names, "one scene, loaded once"
    assert hand.draws >= 3 and hand.names == ["quadrille::hand"] and hand.types == {1}
    # The fewest: a table and something curved.
    assert 1 in found.types and found.types - {1}, found.types
    print(f"check_viewer: {found.loads} + {hand.loads} loads, {found.draws} draws: {found.names}")


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2])
