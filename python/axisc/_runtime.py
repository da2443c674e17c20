"""The runtime: executes an image as a controller does."""

from __future__ import annotations

import ctypes
import operator
import os
from array import array
from ctypes import byref

from ._library import FilterCommand, RuntimeConfig, runtime_library

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

_ALIGNMENT = 64
_CYCLE_TIME_AT = 32  # in the image's header, docs/image-format.md
_BAD_ARGUMENT, _NOT_RESET = 23, 41
_levels = {"automatic": 0, "portable": 1, "v2": 2, "v3": 3, "v4": 4, "neon": 16}
_actions = {"SET": 0, "ON": 1, "OFF": 2, "PROGRAM_END": 3}
_keywords = {"order": 1, "share": 2, "fcut": 4, "quality": 8}
_HSC, _GUARD = 16, 32


class RuntimeFailure(Exception):
    """A status of axisrt.h that is not AXISRT_OK; its name is `status`."""

    def __init__(self, number: int) -> None:
        library = runtime_library()
        self.status: str = library.axisrt_status_name(number).decode()
        super().__init__(f"{self.status}: {library.axisrt_status_text(number).decode()}")


def _require(number: int) -> None:
    if number != 0:
        raise RuntimeFailure(number)


def _uint32(name: str, value: int) -> int:
    """ctypes takes the lowest 32 bits of whatever number it is given."""
    if not 0 <= operator.index(value) < 1 << 32:
        raise ValueError(f"{name} cannot be {value}: a whole number from 0 to {(1 << 32) - 1}")
    return operator.index(value)


def _aligned(size: int) -> Any:
    """A ctypes array at a multiple of 64, and what keeps it."""
    memory = ctypes.create_string_buffer(size + _ALIGNMENT)
    return (ctypes.c_char * size).from_buffer(memory, -ctypes.addressof(memory) % _ALIGNMENT)


class Runtime:
    """Executes the filters of an image, one row of setpoints for each NC cycle, in the list's unit (0.1 um).

    `cycle_time_ns`: the real NC cycle time, the image's own without one. `level`: automatic, portable (the same bits
    on every processor), v2, v3, v4 or neon.
    """

    def __init__(
        self, image: bytes | os.PathLike[str] | str, *, cycle_time_ns: int | None = None, level: str = "automatic"
    ) -> None:
        if not isinstance(image, (bytes, bytearray, memoryview)):
            with open(image, "rb") as file:
                image = file.read()
        image = bytes(image)
        if level not in _levels:
            raise ValueError(f"level cannot be {level!r}: {', '.join(_levels)}")
        if cycle_time_ns is None:
            cycle_time_ns = int.from_bytes(image[_CYCLE_TIME_AT : _CYCLE_TIME_AT + 4], "little")
        cycle_time_ns = _uint32("cycle_time_ns", cycle_time_ns)
        library = runtime_library()
        self._image = _aligned(len(image))
        self._image.raw = image
        config = RuntimeConfig(ctypes.sizeof(RuntimeConfig), cycle_time_ns, level=_levels[level])
        config.image = ctypes.addressof(self._image)
        config.image_size = len(image)
        size, alignment = ctypes.c_size_t(), ctypes.c_size_t()
        _require(library.axisrt_memory_size(byref(config), byref(size), byref(alignment)))
        self._memory = _aligned(size.value)
        config.memory = ctypes.addressof(self._memory)
        config.memory_size = size.value
        runtime = ctypes.c_void_p()
        _require(library.axisrt_create(byref(config), byref(runtime)))
        self._runtime = runtime
        self.cycle_time_ns = cycle_time_ns
        self.axes = self._names("axis")
        self.groups = self._names("group")
        self.status = "AXISRT_OK"

    def _names(self, kind: str) -> list[str]:
        """Of a stripped image: axis0, group0 and so on."""
        library = runtime_library()
        names = []
        for i in range(getattr(library, f"axisrt_{kind}_count")(self._runtime)):
            length = ctypes.c_size_t()
            address = getattr(library, f"axisrt_{kind}_name")(self._runtime, i, byref(length))
            names.append(ctypes.string_at(address, length.value).decode() or f"{kind}{i}")
        return names

    def reset(self, axis: str | int | None, position: float) -> None:
        """Puts an axis (None: all) into the steady state for a position."""
        chosen = range(len(self.axes)) if axis is None else [self._number(axis, self.axes)]
        for number in chosen:
            _require(runtime_library().axisrt_reset(self._runtime, number, position))

    def run(self, setpoints: Any) -> Any:
        """Filtered setpoints of a block of cycles, in the form of `setpoints`: a numpy array or a buffer of doubles,
        whose rows are cycles with a value for each axis, or a sequence of rows; for one axis also of numbers.

        Every axis is reset before the first cycle. `status` tells the worst status of the block afterwards: after
        AXISRT_BAD_INPUT and AXISRT_IMPLAUSIBLE outputs are nevertheless those of the runtime.
        """
        numpy_like = hasattr(setpoints, "__array_interface__")
        if numpy_like:
            import numpy

            block: Any = numpy.ascontiguousarray(setpoints, dtype=numpy.float64)
            self._require_rows(block.shape[-1] if block.ndim > 1 else 1)
            outputs = numpy.empty_like(block)
            self._execute(block.ctypes.data, outputs.ctypes.data, block.size)
            return outputs
        is_buffer = isinstance(setpoints, (array, memoryview))
        rows = [] if is_buffer else list(setpoints)
        has_rows = bool(rows) and hasattr(rows[0], "__len__")
        if is_buffer:
            is_array = isinstance(setpoints, array) and setpoints.typecode == "d"
            block = setpoints if is_array else array("d", setpoints)
        elif has_rows:
            for row in rows:
                self._require_rows(len(row))
            block = array("d", [value for row in rows for value in row])
        else:
            block = array("d", rows)
            self._require_rows(1)
        address = block.buffer_info()[0]
        outputs = array("d", [0.0]) * len(block)
        self._execute(address, outputs.buffer_info()[0], len(block))
        if is_buffer:
            return outputs
        axes = len(self.axes)
        return [list(outputs[i : i + axes]) for i in range(0, len(outputs), axes)] if has_rows else list(outputs)

    def command(
        self,
        action: str,
        group: str | int = 0,
        *,
        order: int | None = None,
        share: float | None = None,
        fcut: float | None = None,
        quality: float | None = None,
        hsc: bool = False,
        guard: bool = False,
    ) -> None:
        """#FILTER of an NC channel between two cycles: SET, ON, OFF or PROGRAM_END. With `guard` #VIB GUARD, where
        order, fcut and quality are MODE, FREQ and DAMPING. RuntimeFailure where the runtime refuses."""
        if action not in _actions:
            raise ValueError(f"action cannot be {action!r}: {', '.join(_actions)}")
        given = {"order": order, "share": share, "fcut": fcut, "quality": quality}
        keywords = (_HSC if hsc else 0) | (_GUARD if guard else 0)
        command = FilterCommand(ctypes.sizeof(FilterCommand), _actions[action], keywords)
        for name, value in given.items():
            if value is not None:
                command.keywords |= _keywords[name]
                setattr(command, name, _uint32(name, value) if name == "order" else value)
        _require(runtime_library().axisrt_command(self._runtime, self._number(group, self.groups), byref(command)))

    def _execute(self, setpoints: int, outputs: int, values: int) -> None:
        # An array without elements has no address.
        status = runtime_library().axisrt_run(self._runtime, setpoints, outputs, values, None) if values else 0
        self.status = runtime_library().axisrt_status_name(status).decode()
        if status in (_BAD_ARGUMENT, _NOT_RESET):
            raise RuntimeFailure(status)

    def _require_rows(self, length: int) -> None:
        if length != len(self.axes):
            raise ValueError(f"a row has {length} values, the image has {len(self.axes)} axes: {', '.join(self.axes)}")

    @staticmethod
    def _number(name: str | int, names: list[str]) -> int:
        if isinstance(name, int):
            if 0 <= name < len(names):
                return name
        elif name in names:
            return names.index(name)
        raise ValueError(f"there is no {name!r}: {', '.join(names)}")
