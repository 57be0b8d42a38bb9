# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes what the package takes from C++: _docstrings.py, of the comments in the headers, and the stubs of the
modules with options, of visit_fields.

    write.py HEADERS PACKAGE CORE OUT    folders: the headers, python/rimline, the built _core, and for the result
"""
from __future__ import annotations

import ast
import pathlib
import re
import sys
import textwrap
from typing import Any

import words
from headers import Headers, Struct, read_headers

WIDTH = 110


def main(headers: str, package: str, core: str, out: str) -> None:
    sys.path.insert(0, core)
    import _core

    writer = Writer(read_headers(pathlib.Path(headers)), _core.fields())
    target = pathlib.Path(out)
    target.mkdir(parents=True, exist_ok=True)
    for path in sorted(pathlib.Path(package).glob("_*.py")):
        tree = ast.parse(path.read_text())
        for node in tree.body:
            if isinstance(node, (ast.FunctionDef, ast.ClassDef)) and _decorator(node, "documented") is not None:
                writer.document(node)
        if path.stem in ("_methods", "_stages"):
            (target / f"{path.stem}.pyi").write_text(writer.stub(tree))
    lines = [f"    {name!r}: {text!r},\n" for name, text in writer.made.items()]
    (target / "_docstrings.py").write_text(
        "# Written by the build (python/docs/write.py) from the C++ headers; not to be edited.\n"
        "DOCSTRINGS: dict[str, str] = {\n" + "".join(lines) + "}\n"
    )


def _decorator(node: Any, name: str) -> list[str] | None:
    """The arguments of a decorator, or None where it is not there."""
    for item in node.decorator_list:
        if isinstance(item, ast.Name) and item.id == name:
            return []
        if isinstance(item, ast.Call) and isinstance(item.func, ast.Name) and item.func.id == name:
            return [ast.literal_eval(argument) for argument in item.args]
    return None


def _filled(text: str, indent: str = "") -> str:
    return textwrap.fill(text, WIDTH, initial_indent=indent, subsequent_indent=indent, break_long_words=False)


def _entry(name: str, kind: str, text: str) -> str:
    return f"{name} : {kind}\n" + _filled(_sentence(text), "    ")


def _sentence(text: str) -> str:
    """As people write it: a capital first, a full stop last."""
    text = text.strip()
    return text[:1].upper() + text[1:] + ("" if text.endswith((".", "]")) else ".")


def _section(title: str, entries: list[str]) -> str:
    return "\n".join([title, "-" * len(title), *entries]) if entries else ""


class Writer:
    def __init__(self, headers: Headers, fields: list[dict[str, Any]]) -> None:
        self.headers = headers
        self.fields = fields
        self.made: dict[str, str] = {}
        self.attributes: dict[str, list[str]] = {}  # of classes, for those that derive from them

    def document(self, node: Any) -> None:
        self.made[node.name] = self._class(node) if isinstance(node, ast.ClassDef) else self._function(node)

    # What C++ says.

    def _struct(self, name: str) -> Struct:
        return self.headers.structs.get(words.CPP_NAMES.get(name, name)) or Struct("")

    def _prose(self, name: str, is_class: bool) -> tuple[str, list[str]]:
        """The comment without what it throws, and these sentences."""
        cpp = words.CPP_NAMES.get(name, name)
        if is_class:
            text = self._struct(name).text
        elif cpp in self.headers.functions:
            text = self.headers.functions[cpp]
        elif name in ("summarize_spacing",):
            text = ""
        else:
            raise SystemExit(f"docs: the C++ headers have no comment on {cpp}(), which rimline.{name} is")
        text = re.sub(r"\b(\w+)::(?=\w)", r"\1.", text)  # as Python writes it
        sentences = re.split(r"(?<=[.\])])\s+(?=[A-Z`\"])", text)
        throws = [s for s in sentences if s.startswith("Throws")]
        return " ".join(s for s in sentences if not s.startswith("Throws")), throws

    def _member(self, name: str) -> str | None:
        if name not in words.CPP_MEMBERS:
            return None
        struct, member = words.CPP_MEMBERS[name]
        found = self.headers.structs[struct]
        return found.members[member] if member else found.text

    # Docstrings.

    def _head(self, name: str, is_class: bool) -> tuple[list[str], list[str]]:
        prose, throws = self._prose(name, is_class)
        head = [words.SUMMARIES[name]]
        if prose:
            head.append(_filled(prose))
        return head, throws

    def _function(self, node: ast.FunctionDef) -> str:
        parts, throws = self._head(node.name, False)
        parameters = [self._parameter(node.name, argument) for argument in [*node.args.args, *node.args.kwonlyargs]]
        parts.append(_section("Parameters", parameters + [self._option(field) for field in self._fields_of(node)]))
        kind = ast.unparse(node.returns) if node.returns else "None"
        if kind != "None":
            parts.append(_section("Returns", [words.ANNOTATIONS.get(kind, kind)]))
        parts.append(_section("Raises", self._raises(throws)))
        return "\n\n".join(part for part in parts if part) + "\n"

    def _raises(self, throws: list[str]) -> list[str]:
        codes = " ".join(_sentence(re.sub(r"^Throws (also )?", "", s)) for s in throws)
        errors = ["Error\n" + _filled(codes, "    ")] if codes else []
        return [*errors, "ValueError\n    A shape or type does not fit."]

    def _parameter(self, function: str, argument: ast.arg) -> str:
        name = argument.arg
        kind = words.TYPES_OF.get((function, name)) or words.TYPES.get(name)
        if kind is None and argument.annotation is not None:
            kind = ast.unparse(argument.annotation)
        text = words.PARAMETERS_OF.get((function, name)) or self._member(name) or words.PARAMETERS[name]
        return _entry(name, str(kind), text)

    def _fields_of(self, node: Any) -> list[dict[str, Any]]:
        groups = _decorator(node, "takes_options")
        if groups is None:
            return []
        return [f for f in self.fields if not groups or f["group"] in groups or f["name"] in groups]

    def _option(self, field: dict[str, Any]) -> str:
        kind = "{" + ", ".join(map(repr, field["choices"])) + "}" if "choices" in field else field["type"]
        if "word" in field:
            kind += f" or {field['word']!r}"
        if "least" in field:
            kind += f", {field['least']} to {field['most']}"
        return _entry(field["name"], f"{kind}, default {field['default']!r}", field["help"])

    def _class(self, node: ast.ClassDef) -> str:
        parts, _ = self._head(node.name, True)
        struct = self._struct(node.name)
        attributes = [a for base in node.bases for a in self.attributes.get(ast.unparse(base), [])]
        for item in node.body:
            if not isinstance(item, ast.AnnAssign) or not isinstance(item.target, ast.Name):
                continue
            name = item.target.id
            text = (
                words.ATTRIBUTES_OF.get((node.name, name))
                or struct.members.get(name)
                or struct.members.get(words.RENAMED_MEMBERS.get(name, ""))
                or words.ATTRIBUTES[name]
            )
            attributes.append(_entry(name, self._annotation(item.annotation), text))
        self.attributes[node.name] = attributes
        parts.append(_section("Attributes", attributes))
        return "\n\n".join(part for part in parts if part) + "\n"

    def _annotation(self, node: ast.expr) -> str:
        text = ast.unparse(node)
        optional = re.fullmatch(r"Optional\[(\w+)\]", text)
        if optional:
            return words.ANNOTATIONS.get(optional[1], optional[1]) + ", or None"
        return words.ANNOTATIONS.get(text, text)

    # Stubs.

    def stub(self, tree: ast.Module) -> str:
        """The module without what its functions do, and with each option as a keyword argument."""
        body: list[ast.stmt] = []
        for node in tree.body:
            if isinstance(node, ast.FunctionDef):
                if not node.name.startswith("_"):
                    body.append(self._stub_function(node))
            elif isinstance(node, (ast.Import, ast.ImportFrom)) or _is_alias(node):
                body.append(node)
        module = ast.Module(body, [])
        return "# Written by the build (python/docs/write.py).\n" + ast.unparse(ast.fix_missing_locations(module)) + "\n"

    def _stub_function(self, node: ast.FunctionDef) -> ast.FunctionDef:
        arguments = node.args
        if _decorator(node, "takes_options") is not None:
            arguments.kwarg = None
            for field in self._fields_of(node):
                kind = "Literal" + repr(field["choices"]) if "choices" in field else field["type"]
                if "word" in field:
                    kind += f" | Literal[{field['word']!r}]"
                arguments.kwonlyargs.append(ast.arg(field["name"], ast.parse(kind, mode="eval").body))
                arguments.kw_defaults.append(ast.Constant(field["default"]))
        doc = self.made.get(node.name) or ast.get_docstring(node) or ""
        node.body = [ast.Expr(ast.Constant(doc)), ast.Expr(ast.Constant(...))]
        node.decorator_list = []
        return node


def _is_alias(node: ast.stmt) -> bool:
    """A type, written as an assignment with a capital."""
    return (
        isinstance(node, ast.Assign)
        and isinstance(node.targets[0], ast.Name)
        and node.targets[0].id[0].isupper()
        and not node.targets[0].id.isupper()
    )


if __name__ == "__main__":
    main(*sys.argv[1:])
