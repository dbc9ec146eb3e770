"""State that the parts of the checker share while they go through one module."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from itertools import islice

from shadercache.ast.nodes import (
    BlockDecl,
    Call,
    Expr,
    FunctionDef,
    FunctionProto,
    Member,
    Module,
    Name,
    Node,
    StructDef,
)
from shadercache.diagnostics import Diagnostic, Severity
from shadercache.lang import builtins, unsupported
from shadercache.lang.builtins import BuiltinVariable, Signature
from shadercache.lang.types import StructType, Type
from shadercache.lang.words import type_names
from shadercache.sema.conversions import Conversions
from shadercache.sema.facts import Declares, Stage, Symbol
from shadercache.sema.qualifiers import words_problem
from shadercache.sema.scopes import Overload, Scopes
from shadercache.source import Source

ERROR = Type("<error>")
"""Type of an expression that was already complained about: whoever uses it stays silent."""

NEVER = 9999
"""A version that there will not be."""

_HINTS = 20

_INTERFACE_VERSIONS = {
    "GL_ARB_separate_shader_objects": 410,
    "GL_ARB_explicit_uniform_location": 430,
}
_QUALIFIER_VERSIONS = {"GL_ARB_shading_language_420pack": 420}
_INDEXING = ("GL_ARB_gpu_shader5", "GL_EXT_gpu_shader5", "GL_OES_gpu_shader5")
_CONVERTING = ("GL_ARB_gpu_shader5", "GL_ARB_gpu_shader_fp64")


@dataclass(slots=True)
class Context:
    """The module, its language version, the scopes and the tables that are being filled."""

    module: Module
    source: Source
    stage: Stage
    scopes: Scopes = field(init=False)
    types: dict[Expr, Type] = field(default_factory=dict)
    symbols: dict[Name, Symbol] = field(default_factory=dict)
    declared: dict[Declares, Symbol] = field(default_factory=dict)
    calls: dict[Call, Overload | Signature] = field(default_factory=dict)
    structs: dict[StructType, StructDef] = field(default_factory=dict)
    called: dict[FunctionDef, list[Call]] = field(default_factory=dict)
    function: FunctionDef | None = None
    diagnostics: list[Diagnostic] = field(default_factory=list)
    version: int = 330
    es: bool = False
    profile: str | None = None
    extensions: frozenset[str] = frozenset()
    interface_version: int = 330
    qualifier_version: int = 330
    blocks: dict[str, set[str]] = field(default_factory=dict)
    conversions: Conversions = field(init=False)
    _undeclared: set[str] = field(default_factory=set)
    _used: set[tuple[str, Node | None]] = field(default_factory=set)
    _counted: int = 0
    _read_only: dict[BlockDecl, frozenset[str]] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.version, self.profile = self.module.version, self.module.profile
        self.es = self.profile == "es"
        extensions = self.extensions = enabled_extensions(self.module)
        if "GL_ARB_compatibility" in extensions and not self.es:
            self.profile = "compatibility"
        # 1.10 keeps the names of functions and of variables apart, and so do its compilers.
        self.scopes = Scopes(separate=self.version == 110)
        self.interface_version = _lifted(self.version, extensions, _INTERFACE_VERSIONS)
        self.qualifier_version = _lifted(self.version, extensions, _QUALIFIER_VERSIONS)
        lifts = not self.es and not extensions.isdisjoint(_CONVERTING)
        self.conversions = Conversions(max(self.version, 400 if lifts else 0), self.es)

    def at_least(self, desktop: int, es: int) -> bool:
        """Is it this version of GLSL, or this one of GLSL ES, or a later one?"""
        return self.version >= (es if self.es else desktop)

    @property
    def es_version(self) -> int:
        """The version of GLSL ES; 0 for desktop GLSL."""
        return self.version if self.es else 0

    def is_used(self, name: str) -> bool:
        """Was the global variable that ``name`` means here used already?"""
        if len(self.symbols) > self._counted:
            new = islice(self.symbols.values(), self._counted, None)
            self._used.update((symbol.name, symbol.node) for symbol in new if symbol.is_global)
            self._counted = len(self.symbols)
        entry = self.scopes.visible.get(name)
        return (name, entry.node if isinstance(entry, Symbol) else None) in self._used

    def read_only_members(self, block: BlockDecl) -> frozenset[str]:
        """The members of a block that are ``readonly`` by themselves."""
        known = self._read_only.get(block)
        if known is None:
            found = (decl for decl in block.fields if decl.qualifiers.has("readonly"))
            known = frozenset(node.name for decl in found for node in decl.declarators)
            self._read_only[block] = known
        return known

    def words_problem(self, words: tuple[str, ...]) -> str | None:
        """What is wrong with these qualifiers beside each other."""
        free = self.qualifier_version >= (310 if self.es else 420)
        return words_problem(words, es=self.es, in_any_order=free)

    @property
    def arrays_are_values(self) -> bool:
        """Can arrays be assigned, compared, returned, constructed and asked for their length?"""
        return self.at_least(120, 300) or "GL_3DL_array_objects" in self.extensions

    @property
    def has_integer_operators(self) -> bool:
        """Are there ``%``, ``&``, ``<<`` and the like (1.30 section 5.9)?"""
        return self.at_least(130, 300) or "GL_EXT_gpu_shader4" in self.extensions

    def has_type(self, kind: Type) -> bool:
        """Is the built-in type one of this version?"""
        return kind.name in type_names(self.version, self.es, self.extensions)

    @property
    def bindless(self) -> bool:
        """Are samplers and images values like any other (ARB_bindless_texture)?"""
        return "GL_ARB_bindless_texture" in self.extensions

    def only_handles(self, kind: Type) -> bool:
        """Does it hold a sampler or image, which is no value (4.60 section 4.1.7)?"""
        return kind.holds_opaque and (kind.name == "atomic_uint" or not self.bindless)

    @property
    def indexes_samplers(self) -> bool:
        """May an array of samplers be indexed with what is not constant (4.00 section 4.1.7)?"""
        # Before 1.30 any index will do, and GLSL ES 1.00 leaves it to the driver (appendix A.5).
        old = self.version < (300 if self.es else 130)
        return old or self.at_least(400, 320) or not self.extensions.isdisjoint(_INDEXING)

    def error(self, code: str, message: str, node: Node, hint: str | None = None) -> Type:
        """Report a mistake at ``node``; returns the type that silences what depends on it."""
        self.diagnostics.append(Diagnostic(code, message, self.source, node.span, hint))
        return ERROR

    def warn(self, code: str, message: str, node: Node, hint: str | None = None) -> None:
        """Report something legal but doubtful."""
        self.diagnostics.append(
            Diagnostic(code, message, self.source, node.span, hint, Severity.WARNING)
        )

    def undeclared(
        self, what: str, name: str, node: Node, known: Callable[[], Iterable[str]]
    ) -> Type:
        """Report an unknown name, once, with the nearest known one as a hint."""
        if name in self._undeclared:
            return ERROR
        self._undeclared.add(name)
        of_extension = unsupported.told(name)
        if of_extension is not None:
            message, hint = of_extension
            return self.error("SC111", message, node, hint)
        # Looking for similar names is slow, and nobody reads the hundredth hint.
        hint = did_you_mean(name, known()) if len(self._undeclared) <= _HINTS else None
        return self.error("SC201", f"undeclared {what} '{name}'", node, hint)

    def no_field(self, message: str, node: Node, fields: Iterable[str]) -> Type:
        """Report an unknown field."""
        name = node.name if isinstance(node, Member) else ""
        return self.error("SC213", message, node, did_you_mean(name, fields))

    def check_name(self, name: str, node: Node) -> None:
        """Names with ``gl_`` are reserved, those with ``__`` doubtful (section 3.7)."""
        if name.startswith("gl_"):
            self.error("SC203", "names with 'gl_' are reserved", node)
        elif "__" in name and self.es_version == 100:
            self.error("SC203", f"'{name}': names with '__' are reserved", node)
        elif "__" in name:
            self.warn("SC292", f"'{name}': names with '__' are reserved", node)

    def builtin_functions(self, name: str) -> tuple[Signature, ...]:
        """The overloads of a built-in function in this version and stage."""
        return builtins.functions(name, self.version, self.profile, self.stage, self.extensions)

    def builtin_variable(self, name: str) -> BuiltinVariable | None:
        """The built-in variable or constant of that name in this version and stage."""
        return builtins.variable(name, self.stage, self.version, self.profile, self.extensions)

    def check_block_name(self, name: str, node: Node) -> None:
        """A global name cannot be that of an interface block too."""
        if name in self.blocks and self.scopes.depth == 0:
            self.error("SC202", f"'{name}' is already the name of a block", node)

    def known_functions(self) -> list[str]:
        """Names of all functions that can be called here (for hints)."""
        own = self.scopes.names()
        return own + [name for name in builtins.function_names() if self.builtin_functions(name)]

    def known_variables(self) -> list[str]:
        """Names of all variables that can be read here (for hints)."""
        names = builtins.variable_names()
        return self.scopes.names() + [name for name in names if self.builtin_variable(name)]


def _lifted(version: int, extensions: frozenset[str], versions: dict[str, int]) -> int:
    return max([version, *(versions.get(name, 0) for name in extensions)])


def enabled_extensions(module: Module) -> frozenset[str]:
    """Names of the extensions that the kept directives turn on."""
    found: set[str] = set()
    for directive in module.directives:
        text = directive.text.replace("#", " ").replace(":", " : ").split()
        if text[:1] == ["extension"] and len(text) > 2:
            if text[-1] in ("enable", "require", "warn"):
                found.add(text[1])
            else:
                found.discard(text[1])
    return frozenset(found)


def did_you_mean(name: str, known: Iterable[str]) -> str | None:
    """``did you mean 'x'?`` for the known name nearest to ``name``."""
    from difflib import get_close_matches  # only mistakes need it, and it is slow to import

    best = get_close_matches(name, set(known), 1, 0.7)
    return f"did you mean '{best[0]}'?" if best else None


def callee(target: Overload | Signature) -> FunctionDef | FunctionProto | Signature:
    """What the facts name as called: a definition where there is one."""
    if isinstance(target, Signature):
        return target
    return target.definition or target.proto
