"""The limits of the package: names of one's own, and how large folders, files and calls may be."""

from __future__ import annotations

import ast
from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path

PACKAGE = Path(__file__).parents[1] / "shadercache"
FILES = sorted(PACKAGE.rglob("*.py"))
TREES = {
    str(file.relative_to(PACKAGE)): ast.parse(file.read_text(encoding="utf-8")) for file in FILES
}

MOST_FILES, MOST_LINES, MOST_PARAMETERS, MOST_FIELDS = 25, 400, 5, 12

NODES = "ast/nodes.py"
"""The classes of nodes: they have a field for each child, and stand together."""


def twice(names: Sequence[str]) -> list[str]:
    """What occurs more than once."""
    return [name for name, number in Counter(names).items() if number > 1]


def parameters(function: ast.FunctionDef) -> list[str]:
    """The names of the parameters, but for that of a method's object."""
    given = function.args
    lone = (one for one in (given.vararg, given.kwarg) if one is not None)
    names = [one.arg for one in (*given.posonlyargs, *given.args, *given.kwonlyargs, *lone)]
    return names[1:] if names[:1] in (["self"], ["cls"]) else names


def fields(kind: ast.ClassDef) -> int:
    """How many fields a dataclass declares; 0 of another class."""
    if not any("dataclass" in ast.unparse(decorator) for decorator in kind.decorator_list):
        return 0
    return sum(isinstance(part, ast.AnnAssign) for part in kind.body)


def functions(path: str, tree: ast.Module) -> Iterator[ast.FunctionDef]:
    """All functions and methods of a file, but for a subcommand's, whose options are parameters."""
    for node in ast.walk(tree):
        is_command = path.startswith("cli/") and getattr(node, "name", "") == "command"
        if isinstance(node, ast.FunctionDef) and not is_command:
            yield node


def classes() -> Iterator[tuple[str, ast.ClassDef]]:
    for path, tree in TREES.items():
        for node in ast.walk(tree):
            if isinstance(node, ast.ClassDef):
                yield path, node


def test_no_two_files_have_the_same_name() -> None:
    assert twice([file.name for file in FILES if file.name != "__init__.py"]) == []


def test_no_two_classes_have_the_same_name() -> None:
    assert twice([kind.name for _, kind in classes()]) == []


def test_folders_are_small() -> None:
    everything = (path for path in PACKAGE.rglob("*") if path.is_file())
    counts = Counter(file.parent for file in everything if file.parent.name != "__pycache__")
    assert {folder.name: size for folder, size in counts.items() if size > MOST_FILES} == {}


def test_files_are_short() -> None:
    lengths = {
        str(file.relative_to(PACKAGE)): file.read_text(encoding="utf-8").count("\n")
        for file in FILES
    }
    del lengths[NODES]
    assert {path: length for path, length in lengths.items() if length > MOST_LINES} == {}


def test_functions_have_few_parameters() -> None:
    counts = {
        f"{path}: {function.name}": len(parameters(function))
        for path, tree in TREES.items()
        for function in functions(path, tree)
    }
    assert {name: count for name, count in counts.items() if count > MOST_PARAMETERS} == {}


def test_dataclasses_have_few_fields() -> None:
    counts = {f"{path}: {kind.name}": fields(kind) for path, kind in classes() if path != NODES}
    assert {name: count for name, count in counts.items() if count > MOST_FIELDS} == {}


def test_what_is_too_much_would_be_found() -> None:
    source = """
@dataclass(frozen=True)
class Pair:
    one: int
    other: int = 0

    def join(self, a, /, b, *c, d, **e): ...

def command(a, b): ...
"""
    tree = ast.parse(source)
    pair = tree.body[0]
    assert isinstance(pair, ast.ClassDef)
    assert fields(pair) == 2
    counted = {node.name: parameters(node) for node in functions("scene/mesh.py", tree)}
    assert counted == {"join": list("abdce"), "command": ["a", "b"]}
    assert [node.name for node in functions("cli/check.py", tree)] == ["join"]
    assert twice(["a", "b", "a"]) == ["a"]
