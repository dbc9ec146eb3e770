"""The compiler behind the front end, on a shader that the front end took."""

from __future__ import annotations

from dataclasses import replace

from shadercache.analysis.candidates import Candidate
from shadercache.ast.nodes import BlockDecl, Module, Qualifiers, StructDef, VarDecl
from shadercache.caching.configuration import Configuration
from shadercache.compiler import Analysis, analyse
from shadercache.diagnostics import InputError
from shadercache.emit.printer import print_module, print_node
from shadercache.front.read_options import ReadOptions
from shadercache.source import Source
from shadercache.valid.read import read
from tests.configured import configured, rewritten


def compile_behind(fragment: Source, module: Module, options: ReadOptions) -> str:
    """Find the nodes and rewrite two, with a vertex shader that fits; what went wrong, if at all.

    A shader or node that the compiler refuses is no mistake. What it writes has to be GLSL.
    """
    vertex = Source("stress.vert", plain_vertex(module))
    try:
        analysis = analyse(fragment, vertex, options)
    except InputError:
        return ""
    fit = [node for node in analysis.nodes if node.offered or _merely_cheap(node)]
    if not fit:
        return ""
    first = _rewrite(analysis, fit[0], configured(mode="plain"))
    return first or _rewrite(analysis, fit[-1], configured(mode="proof"))


def _merely_cheap(node: Candidate) -> bool:
    return node.refusal is not None and node.refusal.unprofitable


def _rewrite(analysis: Analysis, node: Candidate, options: Configuration) -> str:
    try:
        files = rewritten(analysis, node, options, unprofitable=True).files
    except InputError:
        return ""
    for name, text in files.items():
        source = Source(name, text)
        try:
            read(source, "vertex" if name.endswith(".vert") else "fragment")
        except InputError as error:
            first = error.diagnostics[0].render()
            return f"rewriting '{node.text[:60]}' ({options.mode}) yields a wrong {name}: {first}"
    return ""


def plain_vertex(module: Module) -> str:
    """A vertex shader that gives a fragment shader the inputs that it declares."""
    old = module.version < (300 if module.profile == "es" else 130)
    out = "varying" if old else "out"
    texts = []
    for decl in module.decls:
        match decl:
            case VarDecl(qualifiers=qualifiers) | BlockDecl(qualifiers=qualifiers) if (
                qualifiers.has("in", "varying")
            ):
                texts.append(print_node(replace(decl, qualifiers=_outgoing(qualifiers, out))))
            case StructDef() | VarDecl(declarators=()):
                texts.append(print_node(decl))
            case VarDecl(qualifiers=qualifiers) if qualifiers.has("const"):
                texts.append(print_node(decl))
    given = "attribute" if old else "in"
    main = f"{given} vec4 a_position;\nuniform mat4 u_mvp;\n"
    main += "void main() { gl_Position = u_mvp * a_position; }\n"
    head = print_module(replace(module, decls=(), comments=()))
    return "\n".join([head, *texts, main])


def _outgoing(qualifiers: Qualifiers, out: str) -> Qualifiers:
    words = tuple(out if word in ("in", "varying") else word for word in qualifiers.words)
    return replace(qualifiers, words=words)
