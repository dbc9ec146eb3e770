"""Built-in variables of old, declared: the core profile and GLSL ES 3.00 have none of them.

=======================  ===========================================================================
``gl_FragColor``         ``out vec4 legacy_FragColor``
``gl_FragData[2]``       ``layout(location = 2) out vec4 legacy_FragData_2`` (0 is the colour)
``gl_Vertex``            ``in vec4 legacy_Vertex``, like every attribute
``gl_TexCoord[1]``       an element of ``out vec4 legacy_TexCoord[n]``, like every varying
``gl_Color``             in fragment shaders the varying that vertex shaders call ``gl_FrontColor``
``gl_ModelViewMatrix``   ``uniform mat4 legacy_ModelViewMatrix``, like all state; structs with their
                         type
``gl_MaxLights``         its least value
=======================  ===========================================================================
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, replace

from shadercache.ast import nodes as n
from shadercache.ast.walk import walk
from shadercache.front.preprocess import enabled_extensions
from shadercache.lang.builtins import BuiltinVariable, struct, variable
from shadercache.lang.types import StructType, Type
from shadercache.lang.words import ES_VERSIONS, VERSIONS
from shadercache.sema.facts import Facts, Symbol
from shadercache.source import NOWHERE, Span
from shadercache.transform.versions.legacy_calls import Place

_DATA = "gl_FragData"
_COLORS = {"gl_Color": "FrontColor", "gl_SecondaryColor": "FrontSecondaryColor"}
_TRANSFORM = ("gl_ModelViewProjectionMatrix", "gl_Vertex")
_TODAY = {"gl_FragDepthEXT": "gl_FragDepth", "gl_InstanceIDARB": "gl_InstanceID"}
_STRUCTS_OF_TODAY = ("gl_DepthRangeParameters",)
_LEAST_SIZE = 8
"""Of arrays that are indexed by what is not constant: as many lights and coordinates there are."""


@dataclass(slots=True)
class Shared:
    """What all stages of a program must declare alike.

    How long the built-in arrays are: as long as the program declares them, or else as its indices
    need. ``members``: the fields of structs that are used, with the name of the struct; an engine
    need not give the others.
    """

    declared: dict[str, int] = field(default_factory=dict)
    indexed: dict[str, int] = field(default_factory=dict)
    members: set[tuple[str, str]] = field(default_factory=set)

    def add(self, module: n.Module, facts: Facts) -> None:
        """Take account of one stage."""
        for node in walk(module):
            match node:
                case n.Member(object=owner, name=name):
                    self.members.add((facts.types[owner].name, name))
                case n.Construct(type=kind) if (built_in := struct(kind.name)) is not None:
                    assert built_in.struct is not None
                    self.members |= {(kind.name, name) for name in built_in.struct.fields}
                case n.Index(object=n.Name() as owner, index=index):
                    if facts.symbols[owner].kind == "builtin":
                        at = facts.constants.get(index)
                        size = _LEAST_SIZE if at is None else int(at) + 1
                        self.indexed[owner.name] = max(size, self.indexed.get(owner.name, 0))
        for declared in facts.declared.values():
            if declared.kind == "builtin" and declared.type.is_array:
                size = declared.type.dims[0] or 0
                self.declared[declared.name] = max(size, self.declared.get(declared.name, 0))

    def size(self, name: str) -> int:
        """The length of an array; of one that is only used as a whole, the most there can be."""
        return self.declared.get(name, 0) or self.indexed.get(name, _LEAST_SIZE)


def is_builtin(symbol: Symbol) -> bool:
    """Is it a built-in variable (even one that is declared again) or constant?"""
    return symbol.kind == "builtin" or symbol.node is None


class FixedFunction:
    """Which built-in variables of one stage are replaced, by what, and what declares them.

    ``names`` are the new names of the variables that are declared here, by the old ones.
    """

    def __init__(
        self, module: n.Module, facts: Facts, place: Place, stem: str, shared: Shared
    ) -> None:
        self._module, self._facts, self._place = module, facts, place
        self._stem, self._shared = stem, shared
        self.names: dict[str, str] = {}
        self._used: dict[str, BuiltinVariable] = {}
        self._structs: dict[str, StructType] = {}
        for node in walk(module):
            if isinstance(node, n.Name) and is_builtin(facts.symbols[node]):
                self._use(node.name)
            elif isinstance(node, n.Call) and node.name == "ftransform":
                for name in _TRANSFORM:
                    self._use(name)
            elif isinstance(node, n.TypeSpec):
                self._use_struct(struct(node.name))
        for declared in facts.declared.values():
            if declared.kind == "builtin":
                self._use(declared.name)
        self._elements = self._separate_outputs()

    def _use(self, name: str) -> None:
        if name in self.names or name in _TODAY or self._stays(name):
            return
        was, stage = self._module, self._place[2]
        # Before GLSL 1.50 there are no profiles, and all that was dropped later is there.
        profile, extensions = was.profile or "compatibility", enabled_extensions(was)
        known = variable(name, stage, was.version, profile, extensions)
        assert known is not None, name
        self._used[name] = known
        # What vertex shaders write as one variable fragment shaders read as another.
        color = _COLORS.get(name) if stage == "fragment" else None
        self.names[name] = self._stem + (color or name.removeprefix("gl_"))
        self._use_struct(known.type)

    def _stays(self, name: str) -> bool:
        """Is it there in the new version, and in the last as well? Drivers drop what is about to
        go before the specification does."""
        version, profile, stage, extensions = self._place
        last = ES_VERSIONS[-1] if profile == "es" else VERSIONS[-1]
        return all(variable(name, stage, at, profile, extensions) for at in (version, last))

    def _use_struct(self, kind: Type | None) -> None:
        if kind is not None and kind.struct is not None and kind.name not in _STRUCTS_OF_TODAY:
            self._structs[kind.name] = kind.struct

    def _separate_outputs(self) -> dict[int, str]:
        """The elements of ``gl_FragData`` that are written, as outputs of their own: none where
        the index is not a constant."""
        nodes = list(walk(self._module))
        indices = [
            self._facts.constants.get(node.index)
            for node in nodes
            if isinstance(node, n.Index) and self._is_data(node.object)
        ]
        if None in indices or len(indices) < sum(map(self._is_data, nodes)):
            return {}
        numbers = sorted({int(index) for index in indices if index is not None})
        return {at: self._stem + (f"FragData_{at}" if at else "FragColor") for at in numbers}

    def _is_data(self, node: n.Node) -> bool:
        return (
            isinstance(node, n.Name)
            and node.name == _DATA
            and self._facts.symbols[node].kind == "builtin"
        )

    def variable(self, node: n.Name) -> n.Expr:
        """What stands for a built-in variable; itself where it stays."""
        known = self._used.get(node.name)
        if known is not None and known.storage == "const":
            return n.Literal(node.span, str(known.value))
        new = _TODAY.get(node.name) or self.names.get(node.name)
        return replace(node, name=new) if new else node

    def element(self, node: n.Index) -> n.Expr | None:
        """What stands for an element of ``gl_FragData`` where each is an output of its own."""
        if not self._elements or not self._is_data(node.object):
            return None
        return n.Name(node.span, self._elements[int(self._facts.constants[node.index])])

    def transformed_vertex(self, span: Span) -> n.Expr:
        """``ftransform()``: the vertex as the fixed-function pipeline places it."""
        matrix, vertex = (n.Name(span, self.names[name]) for name in _TRANSFORM)
        return n.Binary(span, "*", matrix, vertex)

    def struct(self, name: str) -> str:
        """The new name of a built-in struct."""
        return self._stem + name.removeprefix("gl_") if name in self._structs else name

    def interface(self) -> dict[str, str]:
        """New names of what an engine gives and takes, by the old ones."""
        storages = ("in", "uniform") if self._place[2] == "vertex" else ("out", "uniform")
        names = {
            name: self.names[name]
            for name, known in self._used.items()
            if known.storage in storages and not (name == _DATA and self._elements)
        }
        return names | {f"{_DATA}[{at}]": name for at, name in self._elements.items()}

    def declarations(self) -> Iterator[n.Decl]:
        """What declares the new names: the types first."""
        for name, kind in self._structs.items():
            yield n.VarDecl(NOWHERE, n.NO_QUALIFIERS, self._struct_type(name, kind), ())
        for name, known in self._used.items():
            if name == _DATA and self._elements:
                for at, new in self._elements.items():
                    yield self._declaration(known, new, at if len(self._elements) > 1 else None)
            elif known.storage != "const":
                size = n.Literal(NOWHERE, str(self._shared.size(name)))
                dims = (size,) if known.type.is_array else ()
                yield self._declaration(known, self.names[name], dims=dims)

    def _declaration(
        self, known: BuiltinVariable, name: str, location: int | None = None, dims: n.Dims = ()
    ) -> n.VarDecl:
        # The outputs of GLSL ES 1.00 are mediump (section 7.2).
        embedded = known.storage == "out" and self._place[1] == "es"
        words = (known.storage, "mediump") if embedded else (known.storage,)
        layout = None
        if location is not None:
            layout = (n.LayoutItem(NOWHERE, "location", n.Literal(NOWHERE, str(location))),)
        return _variable(
            n.Qualifiers(NOWHERE, words, layout), self.struct(known.type.name), name, dims
        )

    def _struct_type(self, name: str, kind: StructType) -> n.TypeSpec:
        used = {struct for struct, _ in self._shared.members}
        fields = tuple(
            _variable(n.NO_QUALIFIERS, held.name, label)
            for label, held in kind.fields.items()
            if (name, label) in self._shared.members or name not in used
        )
        new = self.struct(name)
        return n.TypeSpec(NOWHERE, new, n.StructDef(NOWHERE, new, fields))


def _variable(words: n.Qualifiers, kind: str, name: str, dims: n.Dims = ()) -> n.VarDecl:
    variable = n.Declarator(NOWHERE, name, dims)
    return n.VarDecl(NOWHERE, words, n.TypeSpec(NOWHERE, kind), (variable,))
