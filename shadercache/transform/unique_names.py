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

from collections.abc import Set

from shadercache.ast import nodes as n
from shadercache.ast.walk import walk
from shadercache.lang.builtins import overloads
from shadercache.lang.words import keywords, reserved_words
from shadercache.sema.facts import Facts
from shadercache.transform.names import FreshNames, all_names
from shadercache.transform.proof.make_precise import precise_version
from shadercache.transform.reachable import declared_names
from shadercache.transform.rename import rename_nodes


def make_names_unique(module: n.Module, facts: Facts) -> n.Module:
    """The module with unique names (the same module where they are unique already).

    ``facts`` are those of ``module`` as it is given.
    """
    fresh = FreshNames(all_names(module))
    later = later_keywords(module)
    new = _functions(module, facts, later, fresh)
    taken = {name for decl in module.decls for name in declared_names(decl)} | later
    # Built-in functions are global names too, where they are called.
    taken |= {node.name for node in walk(module) if isinstance(node, n.Call)}
    for decl in module.decls:
        if isinstance(decl, n.FunctionDef):
            new |= _locals(decl, facts, taken, fresh)
    return rename_nodes(module, new.get) if new else module


def later_keywords(module: n.Module) -> frozenset[str]:
    """Names that the module's version allows and that of proof mode does not."""
    version, es = precise_version(module), module.profile == "es"
    if module.version == version:
        return frozenset()
    return keywords(version, es) | reserved_words(version, es)


def _functions(
    module: n.Module, facts: Facts, later: Set[str], fresh: FreshNames
) -> dict[n.Node, str]:
    """New names of all overloads of a function but the first, and of overloads of built-ins."""
    # Overloads get names of their own, so that a name tells which function is called.
    seen = set(later)
    renamed: dict[object, str] = {}
    new: dict[n.Node, str] = {}
    for function in facts.functions:
        name = function.name
        if name in seen or overloads(name):
            renamed[function] = fresh.make(name)
            heads = (function.proto, *_prototypes(module, function))
            new |= dict.fromkeys(heads, renamed[function])
        seen.add(name)
    for call, callee in facts.calls.items():
        if isinstance(callee, n.FunctionDef) and callee in renamed:
            new[call] = renamed[callee]
    return new


def _prototypes(module: n.Module, function: n.FunctionDef) -> list[n.FunctionProto]:
    wanted = _signature(function.proto)
    protos = (decl for decl in module.decls if isinstance(decl, n.FunctionProto))
    named = (proto for proto in protos if proto.name == function.name)
    return [proto for proto in named if _signature(proto) == wanted]


def _signature(proto: n.FunctionProto) -> tuple[object, ...]:
    """Parameter types as written; sizes of arrays count by their number only."""
    return tuple((p.type.name, len(p.type.dims) + len(p.dims)) for p in proto.params)


def _locals(
    function: n.FunctionDef, facts: Facts, taken: Set[str], fresh: FreshNames
) -> dict[n.Node, str]:
    seen = set(taken)
    renamed: dict[object, str] = {}
    new: dict[n.Node, str] = {}
    for node in walk(function):
        # Of the declarators only fields of structs are not known.
        if isinstance(node, n.Param | n.Declarator) and node.name and node in facts.declared:
            if node.name in seen:
                renamed[facts.declared[node]] = new[node] = fresh.make(node.name)
            seen.add(node.name)
    for node in walk(function) if renamed else ():
        # By meaning, not by name: `float a = a;` reads the outer one (GLSL 3.30 section 4.2).
        if isinstance(node, n.Name) and facts.symbols[node] in renamed:
            new[node] = renamed[facts.symbols[node]]
    return new
