"""Reads LCM logs, and sends and receives messages, if LCM's own Python module is not installed.

    try:
        import lcm
    except ImportError:  # as on Debian, which does not have it
        from quadrille import lcm

The classes here have the same names as in that module, and cover what most programs need: LCM with
publish, subscribe, unsubscribe, handle and handle_timeout, and EventLog for reading. They use
liblcm.
"""

import ctypes
import ctypes.util
import struct
from types import TracebackType
from typing import Any, BinaryIO, Callable, Dict, Iterator, NamedTuple, Optional, Type

__all__ = ["Event", "EventLog", "LCM", "LCMSubscription"]


class Event(NamedTuple):
    """One message of a log; its timestamp is in microseconds."""

    eventnum: int
    timestamp: int
    channel: str
    data: bytes


class EventLog:
    """Iterates over the Events of a log, in order. Raises ValueError where the log is damaged."""

    _HEADER = struct.Struct(">IqqII")
    _SYNC = 0xEDA1DA01

    def __init__(self, path: str) -> None:
        self._path = path
        self._file: BinaryIO = open(path, "rb")

    def __iter__(self) -> Iterator[Event]:
        return self

    def __next__(self) -> Event:
        header = self._file.read(self._HEADER.size)
        if not header:
            raise StopIteration
        if len(header) < self._HEADER.size:
            raise self._broken("is cut short")
        sync, number, timestamp, name_size, size = self._HEADER.unpack(header)
        if sync != self._SYNC or name_size > 1000:
            raise self._broken("is no LCM log, or damaged")
        name, data = self._file.read(name_size), self._file.read(size)
        if len(name) + len(data) < name_size + size:
            raise self._broken("is cut short")
        return Event(number, timestamp, name.decode(errors="replace"), data)

    def _broken(self, what: str) -> ValueError:
        return ValueError(f"{self._path}: byte {self._file.tell()}: {what}; record it anew")

    def close(self) -> None:
        self._file.close()

    def __enter__(self) -> "EventLog":
        return self

    def __exit__(self, kind: Optional[Type[BaseException]], error: Optional[BaseException],
                 trace: Optional[TracebackType]) -> None:
        self.close()


class _Received(ctypes.Structure):
    """The struct lcm_recv_buf_t of liblcm."""

    _fields_ = [("data", ctypes.c_void_p), ("data_size", ctypes.c_uint32),
                ("recv_utime", ctypes.c_int64), ("lcm", ctypes.c_void_p)]


_Handler = ctypes.CFUNCTYPE(None, ctypes.POINTER(_Received), ctypes.c_char_p, ctypes.c_void_p)


def _load() -> ctypes.CDLL:
    library = ctypes.CDLL(ctypes.util.find_library("lcm") or "liblcm.so.1")
    pointer, text, number = ctypes.c_void_p, ctypes.c_char_p, ctypes.c_int
    for name, result, arguments in (
            ("create", pointer, [text]), ("destroy", None, [pointer]),
            ("publish", number, [pointer, text, ctypes.c_char_p, ctypes.c_uint]),
            ("subscribe", pointer, [pointer, text, _Handler, pointer]),
            ("unsubscribe", number, [pointer, pointer]),
            ("handle_timeout", number, [pointer, number])):
        function = getattr(library, "lcm_" + name)
        function.restype, function.argtypes = result, arguments
    return library


class LCMSubscription(NamedTuple):
    """The handle that LCM.subscribe() returns."""

    pointer: int


class LCM:
    """A connection to a url; without one, to the url in $LCM_DEFAULT_URL."""

    def __init__(self, url: str = "") -> None:
        self._library = _load()
        self._handlers: Dict[LCMSubscription, Any] = {}
        self._error: Optional[BaseException] = None
        self._lcm = self._library.lcm_create(url.encode() or None)
        if not self._lcm:
            raise OSError(f"LCM cannot open {url or 'its default address'}; is there a multicast "
                          "route? (ip route add 224.0.0.0/4 dev lo)")

    def __del__(self) -> None:
        if getattr(self, "_lcm", None):
            self._library.lcm_destroy(self._lcm)

    def publish(self, channel: str, data: bytes) -> None:
        """Sends the bytes of a message."""
        if self._library.lcm_publish(self._lcm, channel.encode(), data, len(data)) != 0:
            raise OSError(f"LCM cannot publish {len(data)} bytes on {channel}")

    def subscribe(self, channel: str, handler: Callable[[str, bytes], Any]) -> LCMSubscription:
        """Calls handler(channel, data) for each message on a channel, or a pattern of channels."""

        def call(received: Any, name: bytes, _user: Any) -> None:
            try:
                data = ctypes.string_at(received.contents.data, received.contents.data_size)
                handler(name.decode(errors="replace"), data)
            except BaseException as error:  # no exception may pass through LCM
                self._error = error

        kept = _Handler(call)
        pointer = self._library.lcm_subscribe(self._lcm, channel.encode(), kept, None)
        if not pointer:
            raise OSError(f"LCM cannot subscribe to {channel}")
        subscription = LCMSubscription(pointer)
        self._handlers[subscription] = kept
        return subscription

    def unsubscribe(self, subscription: LCMSubscription) -> None:
        """Ends a subscription."""
        self._library.lcm_unsubscribe(self._lcm, subscription.pointer)
        del self._handlers[subscription]

    def handle_timeout(self, milliseconds: int) -> int:
        """Waits for a message and handles it. Returns more than 0, or 0 after the timeout.

        Raises what a handler raised, and OSError at the end of a log.
        """
        handled = int(self._library.lcm_handle_timeout(self._lcm, milliseconds))
        if self._error is not None:
            error, self._error = self._error, None
            raise error
        if handled < 0:
            raise OSError("LCM receives no more")
        return handled

    def handle(self) -> None:
        """Like handle_timeout(), without a timeout; Ctrl-C works within a tenth of a second."""
        while self.handle_timeout(100) == 0:
            pass
