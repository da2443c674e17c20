"""Machines: findings, repairs, images and answers."""

from __future__ import annotations

import ctypes
import json
import os
from ctypes import byref

from ._library import Bytes, Files, ReadFile, axisc_library

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Mapping
    from typing import Any

    Path = str | os.PathLike[str]
    Document = dict[str, Any]

_NOT_FOUND = -2
_UNUSABLE = -3
#: What is no failure beside 0: findings with errors; a conversation that its client has ended.
_allowed = {"check": (1,), "message": (2, 3)}


class Error(Exception):
    """Why there is no result, in lines for people."""


class BadArgument(Error, ValueError):
    """A word or an option that there is not."""


class NotFound(Error, FileNotFoundError):
    """The file or folder does not exist."""


class Unusable(Error):
    """A file, a setting or a word of a question cannot be used."""


class Cancelled(Error):
    """Workspace.cancel() ended the call."""


class Busy(Error):
    """The workspace is in another call, in another thread."""


class InternalError(Error):
    """A defect of axisc."""


class FindingsError(Error):
    """Lists have errors, so that there is no image or no answer. `findings` has them where an image was asked for."""

    def __init__(self, text: str, findings: list[Finding] | None = None) -> None:
        super().__init__(text)
        self.findings = findings or []


_errors: dict[int, type[Error]] = {
    1: FindingsError, -1: BadArgument, -2: NotFound, -3: Unusable, -4: Cancelled, -5: Busy, -7: InternalError,
}


class Finding:
    """A finding: the keys of docs/findings.md are attributes; `document` has all of them."""

    __slots__ = ("axis", "code", "column", "document", "file", "line", "message", "name", "parameter", "severity")

    document: Document
    code: str
    name: str
    severity: str
    message: str
    file: str | None
    line: int | None
    column: int | None
    parameter: str | None
    axis: str | None

    def __init__(self, document: Document) -> None:
        self.document = document
        for key in self.__slots__:
            if key != "document":
                setattr(self, key, document[key])

    def __str__(self) -> str:
        place = ":".join(str(part) for part in (self.file, self.line, self.column) if part is not None)
        return f"{place}: {self.severity}[{self.code}]: {self.message}"

    def __repr__(self) -> str:
        return f"<Finding {self}>"


def _findings(report: bytes) -> list[Finding]:
    return [Finding(document) for document in json.loads(report)["diagnostics"]] if report else []


def _path(path: Path) -> bytes:
    # What no UTF-8 can say becomes bytes that the library refuses.
    return os.fspath(path).encode("utf-8", "surrogateescape")


def _text(value: object) -> str | list[str]:
    """As a question has it."""
    if isinstance(value, (list, tuple)):
        return [str(_text(one)) for one in value]
    if isinstance(value, bool):
        return "yes" if value else "no"
    return str(os.fspath(value) if isinstance(value, os.PathLike) else value)


def _take(result: Bytes) -> bytes:
    taken = ctypes.string_at(result.data, result.size) if result.data else b""
    axisc_library().axisc_free(byref(result))
    return taken


class Workspace:
    """Files of the disk, unsaved text over them, a language. One call at a time; make one for each thread.

    `cycle_time` ("2ms") counts where no file says one. `control` is what counts whatever files say, as options of
    `axisc lint`: override_cycle_time, axis_type, kind, build. `read` gives lists, machine files and NC programs instead
    of the disk: the bytes of a path, or None where there is no such file; `names` the names of the files in a folder.
    """

    _handle: int | None = None

    def __init__(
        self,
        *,
        language: str = "en",
        cycle_time: str | None = None,
        read: Callable[[str], bytes | None] | None = None,
        names: Callable[[str], list[str]] | None = None,
        **control: str,
    ) -> None:
        self._raised: BaseException | None = None
        files = None
        if read is not None:
            # Kept as long as the library may call them.
            self._callbacks = (self._callback(read), self._callback(self._joined(names)))
            files = byref(Files(ctypes.sizeof(Files), 0, None, *self._callbacks))
        elif names is not None:
            raise BadArgument("names without read")
        handle = ctypes.c_void_p()
        options = json.dumps({"language": language, "cycle_time": cycle_time, **control}).encode()
        status = axisc_library().axisc_open(options, files, byref(handle))
        self._handle = handle.value
        if status != 0:
            error = self._error(status)
            self.close()
            raise error

    def close(self) -> None:
        """Frees it; a workspace that nothing refers to any more is closed, too."""
        handle, self._handle = self._handle, None
        if handle is not None:
            axisc_library().axisc_close(handle)

    __del__ = close

    def __enter__(self) -> Workspace:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def put(self, path: Path, text: bytes | str) -> None:
        """Unsaved text, in the place of a file or beside those of the disk. Texts become UTF-8."""
        data = text.encode() if isinstance(text, str) else text
        self._require(axisc_library().axisc_put(self._handle, _path(path), data, len(data)))

    def drop(self, path: Path) -> None:
        """Forgets unsaved text."""
        self._require(axisc_library().axisc_drop(self._handle, _path(path)))

    def read(self, path: Path) -> bytes:
        """The bytes of a file as they are now, unsaved text included."""
        return self._call("read", _path(path))

    def machine(self, path: Path) -> Machine:
        """A list in its machine, a machine file, a start-up list, a project, an NC program, a folder."""
        return Machine(self, path)

    def answer(self, question: str, *, format: str = "json", **options: object) -> Any:
        """A question of axisc.h. JSON as objects; other formats, pictures and pages as text; an FMU as bytes.
        Lists and tuples are several texts, True and False yes and no."""
        asked = {"question": question, "format": format, **options}
        if question in ("picture", "report", "fmu"):
            del asked["format"]
        texts = {key: _text(value) for key, value in asked.items() if value is not None}
        data = self._call("answer", json.dumps(texts).encode())
        if question == "fmu":
            return data
        text = data.decode()
        return json.loads(text) if "format" in asked and format == "json" else text

    def messages(self, *messages: Mapping[str, Any]) -> list[Document]:
        """Language server protocol: messages that arrived together, and those to be sent."""
        arrived = json.dumps([json.dumps(message) for message in messages]).encode()
        sent: list[Document] = json.loads(self._call("message", arrived))
        return sent

    def cancel(self) -> None:
        """Ends the present call before it reads its next file. From any thread."""
        axisc_library().axisc_cancel(self._handle)

    def _callback(self, give: Callable[[str], bytes | None]) -> Any:
        def called(_context: int, path: bytes, result: Any) -> int:
            try:
                data = give(path.decode())
                if data is None:
                    return _NOT_FOUND
                return int(axisc_library().axisc_copy(result, data, len(data)))
            except BaseException as raised:  # which no library may see
                self._raised = self._raised or raised
                return _UNUSABLE

        return ReadFile(called)

    @staticmethod
    def _joined(names: Callable[[str], list[str]] | None) -> Callable[[str], bytes]:
        return lambda folder: b"".join(name.encode() + b"\0" for name in names(folder)) if names else b""

    def _call(self, name: str, *arguments: object) -> bytes:
        result = Bytes()
        status = getattr(axisc_library(), "axisc_" + name)(self._handle, *arguments, byref(result))
        taken = _take(result)
        self._require(status, allowed=_allowed.get(name, ()))
        return taken

    def _require(self, status: int, allowed: tuple[int, ...] = ()) -> None:
        raised, self._raised = self._raised, None
        if raised is not None:
            raise raised
        if status != 0 and status not in allowed:
            raise self._error(status)

    def _error(self, status: int) -> BaseException:
        text = axisc_library().axisc_error(self._handle).decode().strip()
        if status not in _errors:
            return MemoryError(text)
        return _errors[status](text or "the workspace is closed, or in another call")


class Machine:
    """What `path` names, in a workspace: every call reads the files as they are now."""

    def __init__(self, workspace: Workspace, path: Path) -> None:
        self.workspace = workspace
        self.path = path

    def check(self) -> list[Finding]:
        """Findings, as `axisc lint`; for a list those of the list, judged in its machine."""
        return _findings(self.workspace._call("check", _path(self.path)))

    def fix(self, *, all: bool = False) -> dict[str, bytes]:
        """What repairs change, by path, as `axisc lint --fix` (or --fix=all): nothing is written to the disk, the
        workspace keeps the new bytes as unsaved text."""
        report = json.loads(self.workspace._call("fix", _path(self.path), int(all)))
        return {path: self.workspace.read(path) for path in report["files"]}

    def compile(self, *, strip: bool = False, bounds: bool = True, image_version: int = 0) -> bytes:
        """The coefficient image, as `axisc compile`. FindingsError where lists have errors."""
        words = {"strip": "yes" if strip else "no", "bounds": "yes" if bounds else "no",
                 "image_version": str(image_version)}
        image, report = Bytes(), Bytes()
        workspace = self.workspace
        status = axisc_library().axisc_compile(
            workspace._handle, _path(self.path), json.dumps(words).encode(), byref(image), byref(report))
        taken, found = _take(image), _take(report)
        if status == 1 and workspace._raised is None:
            raise FindingsError(str(workspace._error(status)), _findings(found))
        workspace._require(status)
        return taken

    def answer(self, question: str, **options: Any) -> Any:
        """Workspace.answer() about this input."""
        return self.workspace.answer(question, input=self.path, **options)

    def machine(self) -> Document:
        """What it consists of."""
        return self.answer("machine")

    def get(self, axis: str, *parameters: str) -> Document:
        """Values in force, and where they come from."""
        return self.answer("get", words=" ".join((axis, *parameters)))

    def contour(self) -> Document:
        """What the filters do to corners, circles and lines."""
        return self.answer("contour")

    def circle(self, *recordings: Path, **options: object) -> Document:
        """The circular test, as `axisc circle`: predicted for `feed` (mm/min, one or several) and `radius` (mm), or
        evaluated beside recordings; `plane`, `tolerance` and the other words of axisc.h."""
        return self.answer("circle", recording=recordings, **options)

    def identify(self, *recordings: Path, **options: object) -> Document:
        """Mass and friction of an axis in recordings of its motion, as `axisc identify`: `axis`, `actual` and `force`
        (columns), `unit`, `numbers`."""
        return self.answer("identify", recording=recordings, **options)

    def delay_budget(self) -> Document:
        """What delays each axis."""
        return self.answer("delay_budget")

    def diff(self, before: Path) -> Document:
        """What differs from another input."""
        return self.answer("diff", before=before)

    def picture(self, kind: str, **options: object) -> str:
        """An SVG, as `axisc plot --kind`."""
        return self.answer("picture", kind=kind, **options)

    def report(self, *, before: Path | None = None) -> str:
        """The acceptance report, an HTML page."""
        return self.answer("report", before=before)

    def __repr__(self) -> str:
        return f"axisc.open({os.fspath(self.path)!r})"


def open(path: Path, **options: Any) -> Machine:
    """A Machine in a Workspace of its own, which takes `options`. NotFound where there is nothing."""
    if "read" not in options and not os.path.exists(path):
        raise NotFound(f"{os.fspath(path)}: there is no such file or folder")
    return Machine(Workspace(**options), path)


def explain(word: str, **options: Any) -> Document:
    """A code, a parameter, a number or message of the panel, as `axisc explain`."""
    with Workspace(**options) as workspace:
        return workspace.answer("explain", word=word)


def _of_image(question: str, image: bytes | Path, **options: object) -> Document:
    with Workspace() as workspace:
        path: Path = "image.axim"
        if isinstance(image, (bytes, bytearray, memoryview)):
            workspace.put(path, bytes(image))
        else:
            path = image
        return workspace.answer(question, input=path, **options)


def inspect(image: bytes | Path, *, axis: str | None = None) -> Document:
    """What is in an image."""
    return _of_image("inspect", image, axis=axis)


def response(
    image: bytes | Path, *, axis: str | None = None, port: str = "setpoint", frequencies: list[float] | None = None
) -> Document:
    """The frequency response of an image's axes, at given frequencies in Hz or at 200 logarithmic ones."""
    listed = None if frequencies is None else ",".join(repr(float(frequency)) for frequency in frequencies)
    return _of_image("response", image, axis=axis, port=port, frequencies=listed)
