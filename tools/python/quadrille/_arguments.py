"""Answers wrong arguments in one line that names the function, the argument, and what is accepted.

Python does not say which name was meant, and pybind11 lists all signatures and all that was given.
"""

import difflib
import functools
import inspect
import numbers
import os
import re
from types import ModuleType
from typing import Any, Callable, Dict, List, Mapping, NamedTuple, Optional, Sequence, Tuple, TypeVar, cast

import numpy as np

_Function = Callable[..., Any]
_F = TypeVar("_F", bound=_Function)


class _Parameter(NamedTuple):
    """Its type as pybind11 writes it, empty if that is not known, and whether it has no default."""

    kind: str
    is_needed: bool


# A parameter in the signature that pybind11 writes: its name, its type, and the beginning of a default.
_PARAMETER = re.compile(r"(?:\(|, )(\w+): (.*?)(?=( = )|, \w+: |, \*, |\) ->)", re.S)
_ARRAY = re.compile(r"numpy\.ndarray\[numpy\.\w+?(?:\[([\w, ]+)\])?\]")
_SIMPLE: Dict[str, Tuple[type, ...]] = {
    "str": (str,), "bytes": (bytes,), "bool": (bool, np.bool_), "int": (numbers.Integral,), "float": (numbers.Real,),
    "os.PathLike": (str, os.PathLike), "dict": (dict,)}


def _parameters(function: _Function) -> Dict[str, _Parameter]:
    try:
        known = inspect.signature(function).parameters.values()
        found = {p.name: _Parameter("", p.default is p.empty) for p in known if p.kind is not p.VAR_KEYWORD}
    except ValueError:
        text = (function.__doc__ or "").split("\n\n")[0]
        # Newer versions of pybind11 write list for List.
        written = _PARAMETER.findall(text.replace("list[", "List[").replace("tuple[", "Tuple["))
        found = {name: _Parameter(kind, not default) for name, kind, default in written}
    found.pop("self", None)
    return found


def _parts(kind: str) -> List[str]:
    """Returns what stands between the outermost brackets: of "Tuple[int, List[int]]" "int" and "List[int]"."""
    parts, depth = [""], 0
    for letter in kind[kind.index("[") + 1:-1]:
        depth += (letter == "[") - (letter == "]")
        if letter == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += letter
    return [part.strip() for part in parts]


def _sizes(kind: str) -> List[str]:
    """Returns the sizes of an array, such as "m" and "3"; none if they are not fixed."""
    found = _ARRAY.fullmatch(kind)
    sizes = (found.group(1) or "").split(", ") if found else []
    return sizes[:1] if sizes[1:] == ["1"] else [size for size in sizes if size]


def _fits(value: Any, kind: str) -> bool:
    """Returns whether a value can be of a type; true if that cannot be told."""
    if kind.startswith("Optional["):
        return value is None or _fits(value, _parts(kind)[0])
    if _ARRAY.fullmatch(kind):
        try:
            shape = np.asarray(value, dtype=float).shape
        except (TypeError, ValueError):
            return False
        sizes = _sizes(kind)
        return not sizes or (len(shape) == len(sizes) and
                             all(not size.isdigit() or int(size) == n for size, n in zip(sizes, shape)))
    if kind.startswith(("List[", "Tuple[")):
        if not isinstance(value, (Sequence, np.ndarray)) or isinstance(value, (str, bytes)):
            return False
        parts = _parts(kind) if kind.startswith("Tuple[") else _parts(kind) * len(value)
        return len(parts) == len(value) and all(map(_fits, value, parts))
    if kind in _SIMPLE:
        return isinstance(value, _SIMPLE[kind])
    name = kind.rsplit(".", 1)[-1]
    return not kind.startswith("quadrille.") or name in (base.__name__ for base in type(value).__mro__)


def _misfit(name: str, value: Any, kind: str) -> Tuple[str, Any, str]:
    """Returns what does not fit in an argument that does not: the first such element of a list or tuple, with its
    name, such as "views[1][0]", and the type that it must have; or else the whole."""
    if kind.startswith("Optional["):
        return _misfit(name, value, _parts(kind)[0])
    if kind.startswith(("List[", "Tuple[")) and isinstance(value, Sequence) and not isinstance(value, (str, bytes)):
        parts = _parts(kind) if kind.startswith("Tuple[") else _parts(kind) * len(value)
        if len(parts) == len(value):
            for n, (element, part) in enumerate(zip(value, parts)):
                if not _fits(element, part):
                    return _misfit(f"{name}[{n}]", element, part)
    return name, value, kind


def _wanted(kind: str) -> str:
    """Returns a type as people read it."""
    if kind.startswith("Optional["):
        return _wanted(_parts(kind)[0]) + " or None"
    if _sizes(kind):
        sizes = _sizes(kind)
        return f"an array of shape ({sizes[0]},)" if len(sizes) == 1 else f"an array of shape ({', '.join(sizes)})"
    return _ARRAY.sub("array", kind).replace("quadrille._core.", "")


def _has(value: Any, wanted: str) -> str:
    """Returns what a value is that is not of the type that is wanted."""
    shape = getattr(value, "shape", None)
    if shape is not None:
        return f"an array of shape {shape}"
    kind = type(value).__name__
    return f"a {kind} of {len(value)}" if wanted.startswith("Tuple[") and kind in ("list", "tuple") else f"of type {kind}"


def _complaint(name: str, own: Mapping[str, _Parameter], more: Mapping[str, _Parameter],
               arguments: Sequence[Any], keywords: Mapping[str, Any]) -> str:
    """Returns what is wrong with a call; empty if nothing is found."""
    accepted = {**own, **more}
    takes = f"it takes: {', '.join(accepted)}"
    if len(arguments) > len(own):
        return f"{name}() has {len(arguments)} arguments; {takes}"
    given = {**dict(zip(own, arguments)), **keywords}
    for keyword, value in given.items():
        if keyword not in accepted:
            near = difflib.get_close_matches(keyword, accepted, 1)
            return f"{name}() has no '{keyword}'; " + (f"did you mean '{near[0]}'?" if near else takes)
        kind = accepted[keyword].kind
        if kind and not _fits(value, kind):
            where, what, wanted = _misfit(keyword, value, kind)
            return f"{name}(): {where} is {_has(what, wanted)}, and must be {_wanted(wanted)}"
    for keyword, parameter in own.items():
        if parameter.is_needed and keyword not in given:
            return f"{name}() needs '{keyword}'; {takes}"
    return ""


def _is_of_caller(error: TypeError) -> bool:
    """Returns whether a function that the caller has given us, such as accept=, raised it."""
    trace = error.__traceback__
    while trace is not None and trace.tb_next is not None:
        trace = trace.tb_next
    return trace is not None and os.path.dirname(trace.tb_frame.f_code.co_filename) != os.path.dirname(__file__)


def _answering(function: _Function, name: str, is_method: bool, further: Optional[_Function] = None) -> _Function:
    """Returns a function that does the same, but answers wrong arguments.

    further  function to which keywords are passed on
    """

    @functools.wraps(function)
    def call(*arguments: Any, **keywords: Any) -> Any:
        try:
            return function(*arguments, **keywords)
        except TypeError as error:
            if _is_of_caller(error):
                raise
            text = told = str(error)
            if further is not None:
                # What it calls is not known to those who called it.
                text = re.sub(r"^Grasp\w+\(\)", name + "()", text)
            if "incompatible " in text or f"{function.__name__}() " in text:
                more = {} if further is None else _parameters(further)
                text = text.split("\n")[0].replace(function.__name__ + "()", name + "()", 1)
                text = _complaint(name, _parameters(function), more, arguments[is_method:], keywords) or (
                    f"{name}(): an argument is of a wrong type; help(quadrille.{name}) tells the types"
                    if text.endswith("supported:") else text if "()" in text else f"{name}(): {text}")
            if text == told:
                raise
            raise TypeError(text) from None

    return call


def answering(function: _F) -> _F:
    """Decorates a function or method, whose wrong arguments are then answered."""
    return answering_with(None)(function)


def answering_with(further: Optional[type]) -> Callable[[_F], _F]:
    """Decorates a function that passes further keywords on to the constructor of a class."""

    def decorate(function: _F) -> _F:
        parts = function.__qualname__.split(".")
        name = parts[-2] if parts[-1] == "__init__" else parts[-1]
        init = None if further is None else cast(Any, further).__init__
        return cast(_F, _answering(function, name, len(parts) > 1, init))

    return decorate


def answer_all(module: ModuleType) -> None:
    """Does the same with all functions of a module in C++, and with the methods of its classes."""
    for name, thing in list(vars(module).items()):
        if not inspect.isclass(thing):
            if callable(thing):
                setattr(module, name, _answering(thing, name, False))
        elif not issubclass(thing, BaseException):
            for method, function in list(vars(thing).items()):
                if isinstance(function, staticmethod):
                    setattr(thing, method, staticmethod(_answering(function.__func__, method, False)))
                elif method == "__init__":
                    setattr(thing, method, _answering(function, name, True))
                elif not method.startswith("_") and inspect.isroutine(function):
                    setattr(thing, method, _answering(function, method, True))
