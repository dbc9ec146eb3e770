"""Interface blocks: which there are, and what they hold (GLSL 4.60 section 4.3.9): SC202, SC215,
SC221."""

from __future__ import annotations

from collections.abc import Mapping

from shadercache.ast.nodes import BlockDecl
from shadercache.sema.blocks import BUILTIN_BLOCK
from shadercache.sema.facts import Kind
from shadercache.sema.problems import ERROR
from shadercache.valid.qualifier_words import STORAGE, words_problem
from shadercache.valid.suspect import Suspect
from shadercache.valid.variable_storage import check_words

_IO_EXTENSIONS = ("GL_EXT_shader_io_blocks", "GL_OES_shader_io_blocks")
# First desktop and ES versions of the blocks of each storage, and the extensions that have them.
_SINCE: Mapping[str, tuple[int, int, *tuple[str, ...]]] = {
    "uniform": (140, 300, "GL_ARB_uniform_buffer_object"),
    "buffer": (430, 310, "GL_ARB_shader_storage_buffer_object"),
    "in": (150, 320, *_IO_EXTENSIONS),
    "out": (150, 320, *_IO_EXTENSIONS),
}
_STAGE_HAS_NONE = (("vertex", "in"), ("fragment", "out"))


def check_blocks(suspect: Suspect) -> None:
    """Every interface block, and its members."""
    for block in suspect.nodes(BlockDecl):
        storage = suspect.storage(block.qualifiers)
        check_words(block.qualifiers, False, suspect)
        _check_storage(block, storage, suspect)
        if block.name == BUILTIN_BLOCK:
            _check_redeclared(block, suspect)
        _check_members(block, storage, suspect)
        _check_sizes(block, storage, suspect)


def _check_storage(block: BlockDecl, storage: Kind, suspect: Suspect) -> None:
    stage, problems = suspect.language.stage, suspect.problems
    if storage not in _SINCE:
        message = f"the block '{block.name}' is not uniform, buffer, in or out"
        problems.error("SC221", message, block)
    elif not _is_known(storage, suspect):
        message = f"this version of GLSL has no '{storage}' blocks"
        problems.error("SC221", message, block.qualifiers)
    elif (stage, storage) in _STAGE_HAS_NONE:
        message = f"a {stage} shader has no '{storage}' blocks"
        problems.error("SC221", message, block.qualifiers)


def _is_known(storage: Kind, suspect: Suspect) -> bool:
    desktop, es, *extensions = _SINCE[storage]
    language = suspect.language
    if language.at_least(desktop, es):
        return True
    extended = storage != "buffer" or language.at_least(150, 310)
    return extended and not language.extensions.isdisjoint(extensions)


def _check_redeclared(block: BlockDecl, suspect: Suspect) -> None:
    """``out gl_PerVertex { vec4 gl_Position; };`` (4.10 section 7.1): only what is there."""
    language, problems = suspect.language, suspect.problems
    extensions = ("GL_ARB_separate_shader_objects", *_IO_EXTENSIONS)
    if not language.at_least(410, 320) and language.extensions.isdisjoint(extensions):
        problems.error("SC221", "this version of GLSL has gl_PerVertex as it is", block)
        return
    for decl in block.fields:
        for node in decl.declarators:
            if language.builtin_variable(node.name) is None:
                problems.error("SC202", f"gl_PerVertex has no member '{node.name}'", node)


def _check_members(block: BlockDecl, storage: Kind, suspect: Suspect) -> None:
    problems, fields = suspect.problems, suspect.fields(block)
    for decl in block.fields:
        for node in decl.declarators:
            kind = fields[node.name]
            if kind is not ERROR and suspect.language.only_handles(kind):
                message = f"the member '{node.name}' of a block cannot be {kind}"
                problems.error("SC221", message, node)
        other = [word for word in decl.qualifiers.words if word in STORAGE and word != storage]
        if other:
            message = f"'{other[0]}' does not apply to a member of a '{storage}' block"
            problems.error("SC221", message, decl)
        problem = words_problem(decl.qualifiers.words, suspect.language)
        if problem is not None:
            problems.error("SC221", problem, decl)
        if decl.type.struct is not None:
            problems.error("SC221", "a struct cannot be defined inside of a block", decl.type)


def _check_sizes(block: BlockDecl, storage: Kind, suspect: Suspect) -> None:
    """GLSL ES has arrays without a size only at the end of a buffer (ES 3.10 section 4.1.9)."""
    if not suspect.language.es:
        return
    nodes = [node for decl in block.fields for node in decl.declarators]
    for node in nodes[:-1] if storage == "buffer" else nodes:
        kind = suspect.fields(block)[node.name]
        if kind is not ERROR and kind.is_unsized:
            suspect.problems.error("SC215", f"'{node.name}' has no size", node)
