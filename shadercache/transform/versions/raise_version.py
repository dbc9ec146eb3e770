"""Raise a shader of an older version to one in which variants can be written.

Variants write several targets and calculate with unsigned integers: they need GLSL 3.30 or GLSL ES
3.00. What a shader does stays the same; only the words change::

    #version 120                                #version 330 core
    varying vec2 uv;                            out vec4 legacy_FragColor;
    uniform sampler2D texture;            =>    in vec2 uv;
    void main() {                               uniform sampler2D legacy_texture;
        gl_FragColor = texture2D(texture, uv);  void main() {
    }                                               legacy_FragColor = texture(legacy_texture, uv);
                                                }

The state of the fixed-function pipeline (``gl_Vertex``, ``gl_ModelViewMatrix``, ``gl_LightSource``,
``gl_TexCoord``) is declared: the core profile has none, so an engine gives it like any other
attribute or uniform (:mod:`transform.versions.fixed_function`). The compatibility profile is left
as well. A struct with the name of a type of another version gets another name in every version.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence, Set
from dataclasses import dataclass, replace
from typing import Any, TypeVar

from shadercache.ast import nodes as n
from shadercache.ast.rewriter import Rewriter
from shadercache.ast.walk import walk
from shadercache.diagnostics import Diagnostic, InputError, Severity
from shadercache.front.preprocess import enabled_extensions
from shadercache.lang.builtins import functions
from shadercache.lang.types import builtin_type
from shadercache.lang.words import keywords, reserved_words
from shadercache.sema.facts import Facts, Stage
from shadercache.sema.infer import infer
from shadercache.source import Source
from shadercache.transform.unique_names import make_names_unique
from shadercache.transform.versions.builtin_block import BUILTIN_BLOCK
from shadercache.transform.versions.fixed_function import FixedFunction, Shared, is_builtin
from shadercache.transform.versions.legacy_calls import Place, modern_call
from shadercache.valid.validate import validate

N = TypeVar("N", bound=n.Node)

DESKTOP_VERSION, ES_VERSION = 330, 300

_CORE = frozenset(
    (
        *("GL_ARB_blend_func_extended", "GL_ARB_compatibility", "GL_ARB_draw_buffers"),
        *("GL_ARB_draw_instanced", "GL_ARB_explicit_attrib_location"),
        *("GL_ARB_fragment_coord_conventions", "GL_ARB_shader_bit_encoding"),
        *("GL_ARB_shader_texture_lod", "GL_ARB_texture_multisample", "GL_ARB_texture_rectangle"),
        *("GL_ARB_uniform_buffer_object", "GL_ATI_shader_texture_lod", "GL_EXT_draw_instanced"),
        *("GL_EXT_gpu_shader4", "GL_EXT_texture_array"),
    )
)
_CORE_ES = frozenset(
    (
        *("GL_EXT_draw_buffers", "GL_EXT_frag_depth", "GL_EXT_shader_texture_lod"),
        *("GL_EXT_shadow_samplers", "GL_OES_fragment_precision_high"),
        *("GL_OES_standard_derivatives", "GL_OES_texture_3D"),
    )
)
"""Extensions that are part of the version to which a shader is raised: nobody asks for them."""

# GLSL ES 3.00 has the samplers of external images by an extension of its own.
_RENAMED = {"GL_OES_EGL_image_external": "GL_OES_EGL_image_external_essl3"}


@dataclass(frozen=True, slots=True, eq=False)
class StageTree:
    """One stage of a program: its tree, and what the checker found out about it."""

    module: n.Module
    facts: Facts
    source: Source
    stage: Stage


@dataclass(frozen=True, slots=True, eq=False)
class Raised:
    """A stage in its new version (the same tree where nothing was to do).

    ``renamed`` leads from what an engine knew of it (attributes, uniforms, outputs) to its name
    now; ``notes`` say the same to the user.
    """

    module: n.Module
    facts: Facts
    renamed: Mapping[str, str]
    notes: tuple[Diagnostic, ...]


def raise_versions(stages: Sequence[StageTree], stem: str) -> list[Raised]:
    """The stages of a program in versions that variants can be written in.

    ``stem`` begins the names that are made here; no name of the program begins with it. Raises
    :class:`InputError` SC412 for what has no counterpart there.
    """
    shared = Shared()
    for stage in stages:
        shared.add(stage.module, stage.facts)
    return [_raise(stage, stem, shared) for stage in stages]


def _raise(tree: StageTree, stem: str, shared: Shared) -> Raised:
    tree = _without_hidden_parameters(tree)
    raiser = _Raiser(tree, stem, shared)
    if not raiser.raises and not raiser.fixed.names and not raiser.structs:
        return Raised(tree.module, tree.facts, {}, ())
    module = raiser.raised()
    try:
        # What only the older version allowed is found by the rules of the new one.
        facts = validate(module, tree.source, tree.stage)
    except InputError as error:
        message = f"the shader cannot be raised to {raiser.language}: "
        problems = [
            replace(problem, code="SC412", message=message + problem.message)
            for problem in error.diagnostics
            if problem.severity is Severity.ERROR
        ]
        raise InputError(problems) from None
    return Raised(module, facts, raiser.interface(), tuple(raiser.notes()))


def _without_hidden_parameters(tree: StageTree) -> StageTree:
    """In GLSL ES 1.00 the body of a function may declare the names of its parameters again."""
    if tree.module.version != 100:
        return tree
    module = make_names_unique(tree.module, tree.facts)
    return replace(tree, module=module, facts=infer(module, tree.source, tree.stage))


def language_name(version: int, profile: str | None) -> str:
    """``GLSL ES 1.00``, ``GLSL 3.30 core``."""
    if profile == "es":
        return f"GLSL ES {version / 100:.2f}"
    return f"GLSL {version / 100:.2f}{f' {profile}' if profile else ''}"


def target_version(module: n.Module) -> tuple[int, str | None]:
    """Version and profile in which the variants of a shader are written."""
    if module.profile == "es":
        return max(module.version, ES_VERSION), "es"
    extensions = enabled_extensions(module)
    compatible = module.profile == "compatibility" or "GL_ARB_compatibility" in extensions
    if module.version < DESKTOP_VERSION or compatible:
        return max(module.version, DESKTOP_VERSION), "core"
    return module.version, module.profile


def _place(module: n.Module, stage: Stage) -> Place:
    return module.version, module.profile, stage, enabled_extensions(module)


class _Raiser(Rewriter):
    """Rewrites one stage."""

    def __init__(self, tree: StageTree, stem: str, shared: Shared) -> None:
        self.tree, self.stem = tree, stem
        version, profile = self.target = target_version(tree.module)
        self.raises = self.target != (tree.module.version, tree.module.profile)
        self.language = language_name(version, profile)
        directives = tuple(self._directives())
        self.bare = replace(tree.module, version=version, profile=profile, directives=directives)
        self.place = _place(self.bare, tree.stage)
        self.fixed = FixedFunction(tree.module, tree.facts, self.place, stem, shared)
        # From here on names tell types, also those of versions that this is not raised to.
        self.structs = {name for name in _structs(tree.module) if builtin_type(name) is not None}
        self.variables, self.functions, self.words = self._clashes()
        # Only outputs may be invariant in GLSL ES 3.00 (section 4.6.1).
        self.drops_invariant_inputs = profile == "es" and tree.stage == "fragment"

    def raised(self) -> n.Module:
        decls = self.rewrite(self.tree.module).decls
        return replace(self.bare, decls=(*self.fixed.declarations(), *decls))

    def interface(self) -> dict[str, str]:
        """New names of what an engine sees."""
        names = self.fixed.interface()
        for decl in self.tree.module.decls:
            if isinstance(decl, n.VarDecl) and decl.qualifiers.has("uniform", "attribute", "in"):
                own = (variable.name for variable in decl.declarators)
                names |= {name: self.variables[name] for name in own if name in self.variables}
        return names

    def notes(self) -> Iterator[Diagnostic]:
        module, source = self.tree.module, self.tree.source
        if self.raises:
            old = language_name(module.version, module.profile)
            message = (
                f"{source.name} is {old}; the variants are {self.language}, for they write several "
                "targets and calculate with unsigned integers"
            )
            yield Diagnostic("SC410", message, severity=Severity.NOTE)
        for name, new in self.interface().items():
            message = f"{source.name}: '{name}' is called '{new}' in the variants"
            yield Diagnostic("SC411", message, severity=Severity.NOTE)

    def _clashes(self) -> tuple[dict[str, str], dict[str, str], dict[str, str]]:
        """New names of variables and types, of functions, and of everything that is a keyword now.

        What bears the name of a function that is built in now would hide it, and functions of GLSL
        ES may not.
        """
        version, profile = self.target
        words = keywords(version, profile == "es") | reserved_words(version, profile == "es")
        module = self.tree.module
        was = _place(module, self.tree.stage)
        called = {function.name for function in self.tree.facts.functions}
        declared = _declared(module)
        keyed = {name for name in declared | called if name in words}
        hiding = {name for name in declared | called if functions(name, *self.place)}
        shadowing = {name for name in hiding if not functions(name, *was)}
        if module.version == 110:  # Its functions and variables have names apart.
            shadowing |= called

        def renamed(names: Set[str]) -> dict[str, str]:
            return {name: self.stem + name for name in names}

        variables = keyed | (declared & shadowing) | self.structs
        functions_ = keyed | (called & hiding)
        return renamed(variables), renamed(functions_), renamed(keyed)

    def expression(self, node: n.Expr, original: n.Expr) -> n.Expr:
        match node, original:
            case n.Name(), n.Name():
                return self._name(original)
            case n.Index(), n.Index():
                return self.fixed.element(original) or node
            case n.Call(), n.Call():
                return self._call(node, original)
            case n.Member(name=name), n.Member(object=owner) if name in self.words:
                structured = self.tree.facts.types[owner].is_struct
                return replace(node, name=self.words[name]) if structured else node
        return node

    def _name(self, node: n.Name) -> n.Expr:
        if is_builtin(self.tree.facts.symbols[node]):
            return self.fixed.variable(node)
        return _renamed(node, self.variables)

    def _call(self, node: n.Call, original: n.Call) -> n.Expr:
        callee = self.tree.facts.calls[original]
        if isinstance(callee, n.FunctionDef | n.FunctionProto):
            return _renamed(node, self.functions)
        if callee.name == "ftransform":
            return self.fixed.transformed_vertex(node.span)
        modern = modern_call(node, callee, self.place)
        if modern is None:
            message = f"'{callee}' has no counterpart in {self.language}"
            raise InputError(Diagnostic("SC412", message, self.tree.source, original.span))
        return modern

    def declaration(self, node: n.Decl, original: n.Decl) -> n.Decl | Sequence[n.Decl]:
        match node, original:
            case n.VarDecl(), n.VarDecl(declarators=items) if items:
                # A built-in variable that was declared again is declared here, under its new name.
                kept = tuple(
                    new
                    for new, old in zip(node.declarators, items, strict=True)
                    if old.name not in self.fixed.names
                )
                return replace(node, declarators=kept) if kept else ()
            case n.QualifierDecl(names=names), _ if names:
                known = self.fixed.names | self.variables
                news = tuple(known.get(name, name) for name in names)
                if self.drops_invariant_inputs and node.qualifiers.has("invariant"):
                    news = tuple(name for name in news if name in self.fixed.names.values())
                return replace(node, names=news) if news else ()
            case n.BlockDecl(), _:
                block = self._of_today(_renamed(node, self.variables))
                if block.instance in self.variables:
                    return replace(block, instance=self.variables[block.instance])
                return block
            case n.FunctionProto(), _:
                return _renamed(node, self.functions)
        return node

    def other(self, node: n.Node, original: n.Node) -> n.Node:
        match node:
            case n.Qualifiers():
                return self._qualifiers(node)
            case n.FunctionProto():
                return _renamed(node, self.functions)
            case n.TypeSpec() if node.name.startswith("gl_"):
                return replace(node, name=self.fixed.struct(node.name))
            case n.Declarator() if original not in self.tree.facts.declared:  # a field
                return _renamed(node, self.words)
            case n.Declarator() | n.Param() | n.TypeSpec() | n.StructDef():
                return _renamed(node, self.variables)
        return node

    def _of_today(self, block: n.BlockDecl) -> n.BlockDecl:
        """Without members that are declared here, under their new names."""
        if block.name != BUILTIN_BLOCK:
            return block
        parts = (
            replace(field, declarators=(variable,))
            for field in block.fields
            for variable in field.declarators
            if variable.name not in self.fixed.names
        )
        return replace(block, fields=tuple(parts))

    def _qualifiers(self, node: n.Qualifiers) -> n.Qualifiers:
        if not node.has("attribute", "varying"):
            return node
        varying = "out" if self.tree.stage == "vertex" else "in"
        new = {"attribute": "in", "varying": varying}
        dropped = "invariant" if self.drops_invariant_inputs else ""
        words = (new.get(word, word) for word in node.words if word != dropped)
        return replace(node, words=tuple(words))

    def _directives(self) -> Iterator[n.Directive]:
        """Without extensions that are part of the new version."""
        es = self.target[1] == "es"
        for directive in self.tree.module.directives:
            words = directive.text.removeprefix("#").replace(":", " ").split()
            if self.raises and words[:1] == ["extension"] and len(words) > 1:
                if words[1] in (_CORE_ES if es else _CORE):
                    continue
                if es and words[1] in _RENAMED:
                    directive = replace(
                        directive, text=directive.text.replace(words[1], _RENAMED[words[1]])
                    )
            yield directive


def _renamed(node: N, names: Mapping[str, str]) -> N:
    bare: Any = node
    return replace(bare, name=names[bare.name]) if bare.name in names else node


def _structs(module: n.Module) -> Iterator[str]:
    return (node.name for node in walk(module) if isinstance(node, n.StructDef))


def _declared(module: n.Module) -> set[str]:
    """Names of variables, types and fields."""
    nodes = list(walk(module))
    named = n.Declarator | n.Param | n.StructDef | n.BlockDecl
    names = {node.name for node in nodes if isinstance(node, named)}
    names |= {node.instance for node in nodes if isinstance(node, n.BlockDecl)}
    return {name for name in names if name}
