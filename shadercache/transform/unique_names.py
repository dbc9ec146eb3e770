"""Give every identifier one meaning in its module, so that later passes can work by name.

Locals and parameters that share a name with anything global, with a function, or with another
local of their function are renamed; so are overloads of functions, and locals and functions with
names that the GLSL of proof mode makes keywords (``sample``). Everything an engine sees (uniforms,
varyings, outputs, blocks) keeps its name::

    float a; float f(float x) { ... }           float a; float f(float x) { ... }
    float f(vec2 x) {                      =>   float f_1(vec2 x) {
        float a = x.x; { float a = 1.0; }           float a_1 = x.x; { float a_2 = 1.0; }
    }                                           }
"""

from __future__ import annotations

from collections.abc import Iterator

from shadercache.ast import nodes as n
from shadercache.ast.walk import walk
from shadercache.lang.builtins import overloads
from shadercache.lang.words import keywords, reserved_words
from shadercache.sema.facts import Facts
from shadercache.transform.names import FreshNames
from shadercache.transform.proof.make_precise import precise_version
from shadercache.transform.reachable import declared_names
from shadercache.transform.rename import Renamer


def make_names_unique(module: n.Module, facts: Facts) -> n.Module:
    """The module with unique names (the same module where they are unique already).

    ``facts`` are those of ``module`` as it is given.
    """
    finder = _Finder(module, facts)
    finder.find()
    return Renamer(finder.new.get).rewrite(module) if finder.new else module


def later_keywords(module: n.Module) -> frozenset[str]:
    """Names that the module's version allows and that of proof mode does not."""
    version, es = precise_version(module), module.profile == "es"
    if module.version == version:
        return frozenset()
    return keywords(version, es) | reserved_words(version, es)


class _Finder:
    """Finds out which nodes get which new name."""

    def __init__(self, module: n.Module, facts: Facts) -> None:
        self.module, self.facts = module, facts
        everything = {name for node in walk(module) if (name := getattr(node, "name", None))}
        self.names = FreshNames(everything)
        self.new: dict[n.Node, str] = {}
        self.later = later_keywords(module)

    def find(self) -> None:
        self._functions()
        taken = {name for decl in self.module.decls for name in declared_names(decl)} | self.later
        taken |= {c.name for c in walk(self.module) if isinstance(c, n.Call)}
        for decl in self.module.decls:
            if isinstance(decl, n.FunctionDef):
                self._locals(decl, taken)

    def _functions(self) -> None:
        """Rename all overloads of a function but the first, and overloads of built-ins."""
        seen = set(self.later)
        renamed: dict[n.FunctionDef, str] = {}
        for function in self.facts.functions:
            name = function.name
            if name in seen or overloads(name):
                renamed[function] = self.names.make(name)
            seen.add(name)
        if not renamed:
            return
        for call, callee in self.facts.calls.items():
            if isinstance(callee, n.FunctionDef) and callee in renamed:
                self.new[call] = renamed[callee]
        for function, name in renamed.items():
            self.new[function.proto] = name
            for proto in self._prototypes(function):
                self.new[proto] = name

    def _prototypes(self, function: n.FunctionDef) -> Iterator[n.FunctionProto]:
        wanted = self._signature(function.proto)
        for decl in self.module.decls:
            if not isinstance(decl, n.FunctionProto) or decl.name != function.name:
                continue
            if self._signature(decl) == wanted:
                yield decl

    def _signature(self, proto: n.FunctionProto) -> tuple[object, ...]:
        """Parameter types as written; sizes of arrays count by their number only."""
        return tuple((p.type.name, len(p.type.dims) + len(p.dims)) for p in proto.params)

    def _locals(self, function: n.FunctionDef, taken: set[str]) -> None:
        seen: set[str] = set()
        renamed: dict[object, str] = {}
        for node in walk(function):
            if isinstance(node, n.Param | n.Declarator) and node.name:
                symbol = self.facts.declared.get(node)
                if symbol is None:  # a field of a struct
                    continue
                if node.name in seen or node.name in taken:
                    renamed[symbol] = self.new[node] = self.names.make(node.name)
                seen.add(node.name)
        if renamed:
            for node in walk(function):
                if isinstance(node, n.Name):
                    name = renamed.get(self.facts.symbols[node])
                    if name is not None:
                        self.new[node] = name
