"""The C library, and its functions as ricochet.h declares them."""

from __future__ import annotations

import ctypes
import functools
import os
import pathlib
from typing import Any, List, Mapping, Tuple

ABI = 3

_int, _long, _number, _text = ctypes.c_int32, ctypes.c_int64, ctypes.c_double, ctypes.c_char_p
_handle = _vector = ctypes.c_void_p  # an address

_FUNCTIONS = {  # name: what it returns, what it takes
    "abi": (_int, []),
    "version": (_text, []),
    "error": (_text, []),
    "open": (_handle, [_text, _text, _int, _long, ctypes.c_uint64]),
    "open_scene": (_handle, [_text, _text, _text, _int, _long, ctypes.c_uint64]),
    "close": (None, [_handle]),
    "problem_name": (_text, [_int]),
    "name": (_text, [_handle]),
    "unit": (_text, [_handle]),
    "dimension": (_int, [_handle]),
    "constraints": (_int, [_handle]),
    "equalities": (_int, [_handle]),
    "has_derivatives": (_int, [_handle]),
    "has_residuals": (_int, [_handle]),
    "bounds": (_int, [_handle, _vector, _vector]),
    "start": (_int, [_handle, _vector]),
    "variable_name": (_text, [_handle, _int]),
    "variable_unit": (_text, [_handle, _int]),
    "best_known": (_number, [_handle]),
    "tolerance": (_number, [_handle]),
    "values": (_int, [_handle, _vector, _vector, _vector]),
    "values_batch": (_long, [_handle, _vector, _long, _vector, _vector]),
    "derivatives": (_int, [_handle, _vector, _vector, _vector, _vector, _vector]),
    "residual_count": (_int, [_handle, _vector]),
    "residuals": (_int, [_handle, _vector, _vector, _vector]),
    "judge": (_int, [_handle, _vector, _vector, _vector]),
    "remaining": (_long, [_handle]),
    "uniform": (_number, [_handle]),
    "open_machine": (_handle, [_text]),
    "parse_machine": (_handle, [_text]),
    "close_machine": (None, [_handle]),
    "machine_text": (_text, [_handle]),
    "machine_speed": (_number, [_handle]),
    "limit_seconds": (_int, [_number]),
    "reached": (_number, []),
    "counts": (_int, [_handle, _vector, _long, _vector]),
    "simulate": (_int, [_handle, _number, _long, _vector, _vector]),
    "doubt": (_text, [_handle]),
    "impacts": (_long, [_handle, _vector, _vector, _vector]),
    "path": (_long, [_handle, _vector, _vector, _vector]),
    "regimes": (_long, [_handle, _number, _number]),
    "regime_table": (_long, [_handle, *[_vector] * 8]),
    "regime_end": (_text, [_handle, _long]),
    "quiet_speed": (_int, [_handle, _text, _number, _number, _vector, _vector, _vector]),
}


class Error(RuntimeError):
    """What went wrong, in the words of the library."""


@functools.lru_cache(maxsize=None)
def library() -> ctypes.CDLL:
    """The library, loaded at the first call. Raises ImportError if there is none that fits."""
    path, loaded = _loaded("libricochet.so.3", _FUNCTIONS)
    if loaded.ricochet_abi() != ABI:
        raise ImportError(f"ricochet: the interface of {path} is {loaded.ricochet_abi()}, not {ABI}")
    return loaded


@functools.lru_cache(maxsize=None)
def minimise_library() -> ctypes.CDLL:
    """The library with the solvers, which lies beside the other. Raises ImportError as `library`
    does."""
    return _loaded("libricochet_minimise.so.3", {"minimise": (_int, [_handle, _handle])})[1]


def _loaded(file: str, functions: Mapping[str, Tuple[Any, List[Any]]]) -> Tuple[str, ctypes.CDLL]:
    """Path of a library, and the library with these functions."""
    named = os.environ.get("RICOCHET_LIBRARY")
    beside = pathlib.Path(__file__).resolve().with_name(file)
    path = str(beside) if beside.exists() else file
    if named:  # libricochet.so.3 itself; others lie beside it
        path = named if file == "libricochet.so.3" else str(pathlib.Path(named).with_name(file))
    try:
        loaded = ctypes.CDLL(path)
        for name, (returned, taken) in functions.items():
            function = getattr(loaded, "ricochet_" + name)
            function.restype = returned
            function.argtypes = taken
    except (OSError, AttributeError) as error:
        raise ImportError(
            f"ricochet: {path} cannot be loaded ({error}); RICOCHET_LIBRARY may name another"
        ) from error
    return path, loaded


def last_error() -> str:
    """The message of the library's last error in this thread."""
    text: bytes = library().ricochet_error()
    return text.decode(errors="replace")
