"""A running `quadrille view`, for tests with a browser and without."""

import os
import re
import signal
import subprocess

# A loaded machine without a graphics card may take long; nothing else depends on time.
PATIENCE_S = 120


class View:
    """A running quadrille view."""

    def __init__(self, bin_folder, *arguments):
        self.process = subprocess.Popen(
            [os.path.join(bin_folder, "quadrille"), "view", "--port", "0", *arguments],
            stdout=subprocess.PIPE, text=True)
        self.address = re.search(r"http://\S+", self.process.stdout.readline()).group(0)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.send_signal(signal.SIGTERM)
        assert self.process.wait(PATIENCE_S) == 0, "view ends with 0 after SIGTERM"
