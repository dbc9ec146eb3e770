"""The compiler is cheap to import: neither numpy nor OpenGL nor the command line's libraries."""

from __future__ import annotations

import subprocess
import sys

import grimp
import pytest

HEAVY = {"matplotlib", "moderngl", "numpy", "PIL", "rich", "typer"}


def imported_by(code: str) -> set[str]:
    """Top-level modules in memory after a fresh interpreter has run ``code``."""
    probe = f"{code}\nimport sys; print(*{{name.partition('.')[0] for name in sys.modules}})"
    done = subprocess.run(
        [sys.executable, "-W", "error", "-c", probe], capture_output=True, text=True, check=True
    )
    return set(done.stdout.split())


@pytest.mark.parametrize(
    "code",
    [
        "import shadercache",
        "import shadercache.compiler",
        "import shadercache; shadercache.parse, shadercache.analyse, shadercache.rewrite",
    ],
)
def test_the_compiler_is_light(code: str) -> None:
    assert imported_by(code) & HEAVY == set()


def test_the_package_itself_loads_no_layer() -> None:
    probe = (
        "import shadercache, sys; print(*[n for n in sys.modules if n.startswith('shadercache.')])"
    )
    done = subprocess.run([sys.executable, "-c", probe], capture_output=True, text=True, check=True)
    assert done.stdout.split() == []


def test_starting_the_command_line_loads_nothing_heavy() -> None:
    code = "from shadercache.cli.app import main\nassert main(['nodes', '--help']) == 0"
    assert imported_by(code) & (HEAVY - {"typer"} | {"lark"}) == set()


def test_public_names_exist() -> None:
    import shadercache

    for name in shadercache.__all__:
        assert getattr(shadercache, name) is not None
    assert set(shadercache.__all__) <= set(dir(shadercache))
    with pytest.raises(AttributeError, match="no attribute 'nonsense'"):
        _ = shadercache.nonsense


def cycles(imports: dict[str, set[str]]) -> list[set[str]]:
    """The groups of modules that import one another, directly or through others."""
    reached = {module: set[str]() for module in imports}
    for start in imports:
        stack = [start]
        while stack:
            for other in imports[stack.pop()] - reached[start]:
                reached[start].add(other)
                stack.append(other)
    groups = ({start, *reached[start]} for start in imports if start in reached[start])
    found = [{item for item in group if group <= {item, *reached[item]}} for group in groups]
    return [group for at, group in enumerate(found) if group not in found[:at]]


def test_no_modules_import_one_another() -> None:
    """Imports for type checkers count; but the package's own names are loaded lazily."""
    graph = grimp.build_graph("shadercache")
    imports = {
        module: graph.find_modules_directly_imported_by(module) - {"shadercache"}
        for module in graph.modules - {"shadercache"}
    }
    assert cycles(imports) == []


def test_cycles_would_be_found() -> None:
    imports = {"a": {"b"}, "b": {"c"}, "c": {"b"}, "d": {"a"}}
    assert cycles(imports) == [{"b", "c"}]
