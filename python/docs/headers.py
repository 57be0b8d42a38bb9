# SPDX-License-Identifier: GPL-3.0-or-later
"""Comments of the public C++ headers, by the name of what they are about."""
from __future__ import annotations

import pathlib
import re
from dataclasses import dataclass, field


@dataclass
class Struct:
    text: str
    members: dict[str, str] = field(default_factory=dict)


@dataclass
class Headers:
    functions: dict[str, str] = field(default_factory=dict)
    structs: dict[str, Struct] = field(default_factory=dict)


def read_headers(folder: pathlib.Path) -> Headers:
    """Of all headers in a folder."""
    found = Headers()
    for path in sorted(folder.glob("*.h")):
        _Reader(found).read(path.read_text())
    return found


def _split(line: str) -> tuple[str, str]:
    """Code and comment of a line."""
    code, mark, comment = line.partition("//")
    return code.rstrip(), comment.strip() if mark else ""


class _Reader:
    def __init__(self, found: Headers) -> None:
        self.found = found
        self.block: list[str] = []  # comment lines above what comes
        self.code = ""  # of a declaration that is not complete
        self.struct: Struct | None = None
        self.last: list[str] = []  # members whose comment goes on

    def read(self, text: str) -> None:
        for line in text.splitlines():
            code, comment = _split(line)
            if not code.strip():
                self._comment(line, comment)
            elif self.struct is None:
                self._outside(code)
            else:
                self._inside(code, comment)

    def _comment(self, line: str, comment: str) -> None:
        if "//" not in line:
            self.block, self.last = [], []
        elif self.last and line.index("//") > 4:
            for name in self.last:
                self.struct_members()[name] += " " + comment
        else:
            self.last = []
            self.block.append(comment)

    def struct_members(self) -> dict[str, str]:
        assert self.struct is not None
        return self.struct.members

    def _text(self) -> str:
        text, self.block = " ".join(self.block), []
        return text

    def _outside(self, code: str) -> None:
        opened = re.match(r"(?:struct|class|enum class) (\w+)[^;]*\{$", code)
        if opened:
            self.struct = Struct(self._text())
            self.found.structs[opened[1]] = self.struct
            return
        self.code = f"{self.code} {code.strip()}".strip()
        if not self.code.endswith((";", "{", "}")):
            return
        function = re.search(r"(\w+)\(", self.code)
        if function and self.block:
            self.found.functions.setdefault(function[1], self._text())
        self.block, self.code = [], ""

    def _inside(self, code: str, comment: str) -> None:
        if code.startswith("}"):
            self.struct, self.code = None, ""
            return
        self.code = f"{self.code} {code.strip()}".strip()
        if not self.code.endswith((";", ",", "{", "}")):
            return
        names = _member_names(self.code)
        text = comment or self._text()
        for name in names:
            self.struct_members()[name] = text
        self.last = names if comment else []
        self.block, self.code = [], ""


def _member_names(code: str) -> list[str]:
    """Of `double mean = 0, least = 0;`: mean and least."""
    if "(" in re.split(r"[={]", code)[0]:
        return []
    plain = re.sub(r"<[^;]*>|\{[^}]*\}", "", code.rstrip(";,"))
    names = [re.search(r"(\w+)\s*(?:=.*)?$", part.strip()) for part in plain.split(",")]
    return [name[1] for name in names if name]
