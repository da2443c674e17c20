"""The shared libraries, and their functions as ctypes sees them."""

from __future__ import annotations

import ctypes
import os
from ctypes import CFUNCTYPE, POINTER, c_char_p, c_double, c_int, c_size_t, c_uint32, c_void_p

version = "0.2.0"

ABI_VERSION = 0
RUNTIME_ABI_VERSION = 5


class Bytes(ctypes.Structure):
    _fields_ = (("data", c_void_p), ("size", c_size_t))


ReadFile = CFUNCTYPE(c_int, c_void_p, c_char_p, POINTER(Bytes))


class Files(ctypes.Structure):
    _fields_ = (
        ("size", c_uint32),
        ("reserved", c_uint32),
        ("context", c_void_p),
        ("read", ReadFile),
        ("list", ReadFile),
    )


class RuntimeConfig(ctypes.Structure):
    _fields_ = (
        ("size", c_uint32),
        ("cycle_time_ns", c_uint32),
        ("image", c_void_p),
        ("image_size", c_size_t),
        ("memory", c_void_p),
        ("memory_size", c_size_t),
        ("level", c_uint32),
        ("reserved", c_uint32),
        ("verify_signature", c_void_p),
        ("verify_context", c_void_p),
    )


class FilterCommand(ctypes.Structure):
    _fields_ = (
        ("size", c_uint32),
        ("action", c_uint32),
        ("keywords", c_uint32),
        ("order", c_uint32),
        ("share", c_double),
        ("fcut", c_double),
        ("quality", c_double),
    )


_workspace_functions = {
    "axisc_abi_version": (c_uint32, ()),
    "axisc_open": (c_int, (c_char_p, POINTER(Files), POINTER(c_void_p))),
    "axisc_close": (None, (c_void_p,)),
    "axisc_put": (c_int, (c_void_p, c_char_p, c_char_p, c_size_t)),
    "axisc_drop": (c_int, (c_void_p, c_char_p)),
    "axisc_read": (c_int, (c_void_p, c_char_p, POINTER(Bytes))),
    "axisc_check": (c_int, (c_void_p, c_char_p, POINTER(Bytes))),
    "axisc_fix": (c_int, (c_void_p, c_char_p, c_int, POINTER(Bytes))),
    "axisc_compile": (c_int, (c_void_p, c_char_p, c_char_p, POINTER(Bytes), POINTER(Bytes))),
    "axisc_answer": (c_int, (c_void_p, c_char_p, POINTER(Bytes))),
    "axisc_message": (c_int, (c_void_p, c_char_p, POINTER(Bytes))),
    "axisc_cancel": (None, (c_void_p,)),
    "axisc_error": (c_char_p, (c_void_p,)),
    "axisc_copy": (c_int, (POINTER(Bytes), c_char_p, c_size_t)),
    "axisc_free": (None, (POINTER(Bytes),)),
}

_runtime_functions = {
    "axisrt_abi_version": (c_uint32, ()),
    "axisrt_status_name": (c_char_p, (c_int,)),
    "axisrt_status_text": (c_char_p, (c_int,)),
    "axisrt_memory_size": (c_int, (POINTER(RuntimeConfig), POINTER(c_size_t), POINTER(c_size_t))),
    "axisrt_create": (c_int, (POINTER(RuntimeConfig), POINTER(c_void_p))),
    "axisrt_axis_count": (c_uint32, (c_void_p,)),
    "axisrt_axis_name": (c_void_p, (c_void_p, c_uint32, POINTER(c_size_t))),
    "axisrt_group_count": (c_uint32, (c_void_p,)),
    "axisrt_group_name": (c_void_p, (c_void_p, c_uint32, POINTER(c_size_t))),
    "axisrt_reset": (c_int, (c_void_p, c_uint32, c_double)),
    "axisrt_run": (c_int, (c_void_p, c_void_p, c_void_p, c_size_t, c_void_p)),
    "axisrt_command": (c_int, (c_void_p, c_uint32, POINTER(FilterCommand))),
}


def _load(name: str, abi: int, functions: dict, version_function: str) -> ctypes.CDLL:
    file = f"lib{name}.so.{abi}"
    own = os.path.join(os.path.dirname(__file__), file)
    chosen = os.environ.get("AXISC_LIBRARIES")
    path = os.path.join(chosen, file) if chosen else own if os.path.exists(own) else file
    try:
        library = ctypes.CDLL(path)
    except OSError as error:
        raise ImportError(
            f"{path} cannot be loaded ({error}); install lib{name}, or name the folder with it in AXISC_LIBRARIES"
        ) from None
    for function, (result, arguments) in functions.items():
        try:
            bound = getattr(library, function)
        except AttributeError:
            raise ImportError(f"{path} has no {function}: it is older than this package") from None
        bound.restype = result
        bound.argtypes = arguments
    found = getattr(library, version_function)()
    if found != abi:
        raise ImportError(f"{path} has interface {found}, this package needs {abi}")
    return library


_loaded: dict[str, ctypes.CDLL] = {}


def axisc_library() -> ctypes.CDLL:
    if "axisc" not in _loaded:
        _loaded["axisc"] = _load("axisc", ABI_VERSION, _workspace_functions, "axisc_abi_version")
    return _loaded["axisc"]


def runtime_library() -> ctypes.CDLL:
    if "axisrt" not in _loaded:
        _loaded["axisrt"] = _load("axisrt", RUNTIME_ABI_VERSION, _runtime_functions, "axisrt_abi_version")
    return _loaded["axisrt"]
