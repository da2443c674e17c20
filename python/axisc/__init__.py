"""Axis parameter lists of CNC controls: checked, repaired, compiled; and their filters executed.

    import axisc

    machine = axisc.open("listen/")
    for finding in machine.check():
        print(finding)
    runtime = axisc.Runtime(machine.compile())
    runtime.reset("X", 0.0)

The functions are those of axisc.h and axisrt.h, called by ctypes: nothing is compiled, numpy is used where it is
given. The shared libraries are looked for in the folder that AXISC_LIBRARIES names, next to this package, and where
the system keeps libraries.
"""

from ._library import version
from ._runtime import Runtime, RuntimeFailure
from ._workspace import (
    BadArgument,
    Busy,
    Cancelled,
    Error,
    Finding,
    FindingsError,
    InternalError,
    Machine,
    NotFound,
    Unusable,
    Workspace,
    explain,
    inspect,
    open,
    response,
)

__all__ = [
    "BadArgument",
    "Busy",
    "Cancelled",
    "Error",
    "Finding",
    "FindingsError",
    "InternalError",
    "Machine",
    "NotFound",
    "Runtime",
    "RuntimeFailure",
    "Unusable",
    "Workspace",
    "explain",
    "inspect",
    "open",
    "response",
    "version",
]
