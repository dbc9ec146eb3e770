"""From a tree to GLSL text.

``print_module(parse(source))`` is the shader again, laid out afresh: four spaces of indent, one
statement a line, the kept directives first. A comment stands on a line of its own before what it
belongs to, or at the end of its last line. Printed text, parsed, is printed the same.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from shadercache.ast import nodes as n
from shadercache.ast.memo import Memo
from shadercache.ast.walk import EXPRESSIONS
from shadercache.emit.print_expressions import (
    print_dims,
    print_expression,
    print_layout_item,
    print_qualifiers,
)
from shadercache.emit.variant_comments import Comments
from shadercache.front.preprocess import written_lines
from shadercache.lang.words import ASSIGN
from shadercache.source import NOWHERE

_INDENT = "    "
_NONE = Comments()
_EXPRESSIONS = frozenset(EXPRESSIONS)
_HOLDERS = (n.Block, n.If, n.For, n.While, n.DoWhile, n.Switch, n.FunctionDef, n.BlockDecl)
"""Nodes that hold statements or fields; comments in them belong to these."""


@dataclass(slots=True)
class _Output:
    """The lines that are printed, and the comments that are left for those to come."""

    lines: list[str] = field(default_factory=list)
    comments: Comments = field(default_factory=Comments)

    def add_comments(self, comments: list[str], indent: str) -> None:
        self.lines += [indent + text for text in comments]


def print_module(module: n.Module, memo: Memo | None = None) -> str:
    """The text of a whole shader, ending in a newline.

    What a declaration looks like is kept in ``memo`` for other programs that have it.
    """
    memo = Memo() if memo is None else memo
    lines = [_version(module), *written_lines(module)]
    comments = Comments(module.comments)
    header = comments.before(module.span.start)
    if header:
        lines += ["", *header]
    apart = True
    for decl in module.decls:
        printed = _declaration(decl, comments, memo)
        if apart or len(printed) > 1:
            lines.append("")
        lines += printed
        apart = printed[-1].startswith("}")
    footer = comments.before(module.span.end)
    if footer:
        lines += ["", *footer]
    return "\n".join(lines) + "\n"


def _declaration(decl: n.Node, comments: Comments, memo: Memo) -> list[str]:
    """The lines of a declaration at global level."""
    kept: dict[n.Node, tuple[list[str], frozenset[int]]] = memo.table("printed declarations")
    if decl not in kept:
        every = comments.anew()
        kept[decl] = _lines(decl, every), every.taken
    lines, taken = kept[decl]
    # Another declaration may have printed its comments: a clone has those of what it is made of.
    return lines if comments.take_all(taken) else _lines(decl, comments)


def _lines(decl: n.Node, comments: Comments) -> list[str]:
    out = _Output(comments=comments)
    _print_lines(decl, "", out)
    return out.lines


def _version(module: n.Module) -> str:
    """The ``#version`` line; 100 is a version of GLSL ES and must not say so."""
    profile = module.profile if module.version >= 150 else None
    return f"#version {module.version} {profile}" if profile else f"#version {module.version}"


def print_node(node: n.Node) -> str:
    """The text of any node, without a newline at its end unless it is a module."""
    if type(node) in _EXPRESSIONS:
        return print_expression(node)
    match node:
        case n.Module():
            return print_module(node)
        case n.Qualifiers():
            return print_qualifiers(node).rstrip()
        case n.TypeSpec():
            return _type(node, "", _NONE)
        case n.Declarator():
            return _declarator(node)
        case n.Param():
            return _param(node)
        case n.LayoutItem():
            return print_layout_item(node)
        case n.StructDef():
            return _struct(node, "", _NONE)
        case n.Directive():
            return node.text
    out = _Output()
    _print_lines(node, "", out)
    return "\n".join(out.lines)


def _type(node: n.TypeSpec, indent: str, comments: Comments) -> str:
    name = node.name if node.struct is None else _struct(node.struct, indent, comments)
    return name + print_dims(node.dims)


def _fields(fields: tuple[n.VarDecl, ...], end: int, indent: str, comments: Comments) -> str:
    """The fields of a struct or block, which ends at ``end``, in braces."""
    out = _Output(["{"], comments)
    for field_decl in fields:
        _print_lines(field_decl, indent + _INDENT, out)
    if comments and fields:
        out.add_comments(comments.within(fields[-1].span.end, end), indent + _INDENT)
    return "\n".join([*out.lines, indent + "}"])


def _struct(node: n.StructDef, indent: str, comments: Comments) -> str:
    name = f" {node.name}" if node.name else ""
    return f"struct{name} {_fields(node.fields, node.span.end, indent, comments)}"


def _declarator(node: n.Declarator) -> str:
    init = "" if node.init is None else f" = {print_expression(node.init, ASSIGN)}"
    return f"{node.name}{print_dims(node.dims)}{init}"


def _variables(node: n.VarDecl, indent: str, comments: Comments) -> str:
    """A declaration of variables, without the ``;``."""
    names = ", ".join(map(_declarator, node.declarators))
    text = f"{print_qualifiers(node.qualifiers)}{_type(node.type, indent, comments)}"
    return f"{text} {names}" if names else text


def _param(node: n.Param) -> str:
    name = f" {node.name}" if node.name else ""
    type_text = _type(node.type, "", _NONE)
    return f"{print_qualifiers(node.qualifiers)}{type_text}{name}{print_dims(node.dims)}"


def _proto(node: n.FunctionProto, indent: str) -> str:
    params = ", ".join(map(_param, node.params))
    type_text = _type(node.type, indent, _NONE)
    return f"{print_qualifiers(node.qualifiers)}{type_text} {node.name}({params})"


def _print_lines(node: n.Node, indent: str, out: _Output) -> None:
    """Append the lines of a statement or declaration, with its comments."""
    if not out.comments:
        _print_plain(node, indent, out)
        return
    start, end = node.span
    out.add_comments(out.comments.before(start), indent)
    if not isinstance(node, _HOLDERS) and not _defines_struct(node):
        out.add_comments(out.comments.within(start, end), indent)
    _print_plain(node, indent, out)
    behind = out.comments.behind(end)
    if behind:
        out.lines[-1] = " ".join([out.lines[-1], *behind])


def _defines_struct(node: n.Node) -> bool:
    decl = node.decl if isinstance(node, n.DeclStmt) else node
    return isinstance(decl, n.VarDecl) and decl.type.struct is not None


def _print_plain(node: n.Node, indent: str, out: _Output) -> None:
    """Append the lines of a statement or declaration."""
    lines = out.lines
    match node:
        case n.ExprStmt():
            lines.append(f"{indent}{'' if node.expr is None else print_expression(node.expr)};")
        case n.DeclStmt():
            _print_plain(node.decl, indent, out)
        case n.Block():
            lines.append(indent + "{")
            _print_inside(node, indent, out)
            lines.append(indent + "}")
        case n.If():
            _print_if(node, indent, out)
        case n.Return():
            value = "" if node.value is None else f" {print_expression(node.value)}"
            lines.append(f"{indent}return{value};")
        case n.Jump():
            lines.append(f"{indent}{node.word};")
        case n.For():
            condition = "" if node.condition is None else f" {_condition(node.condition)}"
            step = "" if node.step is None else f" {print_expression(node.step)}"
            line = f"{indent}for ({print_node(node.init)}{condition};{step})"
            _print_body(line, node.span.start, node.body, indent, out)
        case n.While():
            line = f"{indent}while ({_condition(node.condition)})"
            _print_body(line, node.span.start, node.body, indent, out)
        case n.DoWhile():
            _print_body(indent + "do", node.span.start, node.body, indent, out)
            line = _continue_line(node.body, indent, lines)
            lines.append(f"{line}while ({print_expression(node.condition)});")
        case n.Switch():
            _print_switch(node, indent, out)
        case n.Case():
            value = "default" if node.value is None else f"case {print_expression(node.value)}"
            lines.append(f"{indent}{value}:")
        case _:
            _print_declaration(node, indent, out)


def _print_declaration(node: n.Node, indent: str, out: _Output) -> None:
    match node:
        case n.VarDecl():
            out.lines += f"{indent}{_variables(node, indent, out.comments)};".split("\n")
        case n.FunctionDef():
            line = indent + _proto(node.proto, indent)
            _print_body(line, node.span.start, node.body, indent, out)
        case n.FunctionProto():
            out.lines.append(f"{indent}{_proto(node, indent)};")
        case n.BlockDecl():
            instance = f" {node.instance}{print_dims(node.dims)}" if node.instance else ""
            fields = _fields(node.fields, node.span.end, indent, out.comments)
            words = print_qualifiers(node.qualifiers, block=True)
            out.lines += f"{indent}{words}{node.name} {fields}{instance};".split("\n")
        case n.PrecisionDecl():
            type_text = _type(node.type, indent, out.comments)
            out.lines.append(f"{indent}precision {node.precision} {type_text};")
        case n.QualifierDecl():
            names = ", ".join(node.names)
            out.lines.append(f"{indent}{print_qualifiers(node.qualifiers)}{names}".rstrip() + ";")
        case _:
            raise TypeError(f"{type(node).__name__} cannot be printed")


def _print_inside(block: n.Block, indent: str, out: _Output) -> None:
    """The statements of a block, and the comments before its closing brace."""
    for node in block.body:
        _print_lines(node, indent + _INDENT, out)
    if out.comments:
        # They are anchored to that brace, which is the last character of the block.
        out.add_comments(out.comments.before(block.span.end - 1), indent + _INDENT)


def _print_body(line: str, start: int, body: n.Node, indent: str, out: _Output) -> None:
    """A statement that holds another: a block begins on its line, anything else on the next.

    The comments between ``start``, where the statement begins, and its body come first in the body.
    """
    is_block = isinstance(body, n.Block)
    out.lines.append(line + " {" if is_block else line)
    # From nowhere to the body would be all the comments so far.
    if out.comments and start != NOWHERE.start:
        out.add_comments(out.comments.within(start, body.span.start), indent + _INDENT)
    if isinstance(body, n.Block):
        _print_inside(body, indent, out)
        out.lines.append(indent + "}")
    else:
        _print_lines(body, indent + _INDENT, out)


def _continue_line(body: n.Node, indent: str, lines: list[str]) -> str:
    """What a line begins with after the body of a statement: its brace where it has one."""
    return lines.pop() + " " if isinstance(body, n.Block) else indent


def _print_if(node: n.If, indent: str, out: _Output) -> None:
    """``if`` with all its ``else if``; these are printed in a loop, for a chain may be long."""
    line = f"{indent}if ({print_expression(node.condition)})"
    start = node.span.start
    while True:
        then: n.Stmt = node.then
        if node.other is not None and _ends_in_open_if(then):
            then = n.Block(then.span, (then,))  # Else the `else` would belong to the inner `if`.
        _print_body(line, start, then, indent, out)
        if node.other is None:
            return
        line = _continue_line(then, indent, out.lines) + "else"
        start = then.span.end
        if not isinstance(node.other, n.If):
            _print_body(line, start, node.other, indent, out)
            return
        node = node.other
        line += f" if ({print_expression(node.condition)})"


def _ends_in_open_if(node: n.Node) -> bool:
    """Would an ``else`` after this statement belong to an ``if`` inside it?"""
    while isinstance(node, n.If | n.For | n.While):
        if not isinstance(node, n.If):
            node = node.body
        elif node.other is None:
            return True
        else:
            node = node.other
    return False


def _condition(node: n.Node) -> str:
    return _variables(node, "", _NONE) if isinstance(node, n.VarDecl) else print_expression(node)


def _print_switch(node: n.Switch, indent: str, out: _Output) -> None:
    out.lines.append(f"{indent}switch ({print_expression(node.selector)}) {{")
    for statement in node.body:
        inner = _INDENT if isinstance(statement, n.Case) else 2 * _INDENT
        _print_lines(statement, indent + inner, out)
    if out.comments:
        out.add_comments(out.comments.before(node.span.end - 1), indent + 2 * _INDENT)
    out.lines.append(indent + "}")
