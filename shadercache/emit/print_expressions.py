"""From an expression, an array size or a qualifier to GLSL text.

Parentheses come from the precedence table, never from the tree, and literals keep their spelling.
"""

from __future__ import annotations

from shadercache.ast import nodes as n
from shadercache.lang.words import (
    ASSIGN,
    COMMA,
    CONDITIONAL,
    MEMORY_QUALIFIERS,
    POSTFIX,
    PRECEDENCE,
    PRIMARY,
    QUALIFIER_ORDER,
    UNARY,
)


def print_expression(node: n.Node, least: int = COMMA) -> str:
    """The text of an expression, in parentheses where it binds looser than ``least``."""
    # An explicit stack: a chain of operators may be longer than Python's recursion goes.
    out: list[str] = []
    stack: list[str | tuple[n.Node, int]] = [(node, least)]
    while stack:
        part = stack.pop()
        if isinstance(part, str):
            out.append(part)
            continue
        node, least = part
        if isinstance(node, n.Name):
            out.append(node.name)
            continue
        precedence, parts = _parts(node)
        if precedence < least:
            out.append("(")
            stack.append(")")
        stack += parts[::-1]
    return "".join(out)


_Parts = list["str | tuple[n.Node, int]"]


def _parts(node: n.Node) -> tuple[int, _Parts]:
    """How tight an expression binds, and its text with the operands left to print.

    Each operand goes with the least precedence that stands there without parentheses.
    """
    match node:
        case n.Binary(op=op, left=left, right=right):
            own = PRECEDENCE[op]
            # Operators group from the left: the same one on the right needs parentheses.
            return own, [(left, own), f" {op} ", (right, own + 1)]
        case n.Name(name=name):
            return PRIMARY, [name]
        case n.Literal(text=text):
            # `1.x` and `-1[0]` are other tokens or another tree, hence not PRIMARY.
            return UNARY, [text]
        case n.Member(object=inner, name=name):
            return POSTFIX, [(inner, POSTFIX), f".{name}"]
        case n.Call(name=name, args=args):
            return PRIMARY, [f"{name}(", *_arguments(args)]
        case n.Construct(type=type_spec, args=args):
            return PRIMARY, [type_spec.name, *_sizes(type_spec.dims), "(", *_arguments(args)]
        case n.Index(object=inner, index=index):
            return POSTFIX, [(inner, POSTFIX), "[", (index, COMMA), "]"]
        case n.Unary(op=op, operand=operand):
            return UNARY, [op + _gap(op, operand), (operand, UNARY)]
        case n.Assign(op=op, target=target, value=value):
            return ASSIGN, [(target, UNARY), f" {op} ", (value, ASSIGN)]
        case n.Conditional(condition=condition, then=then, other=other):
            above = CONDITIONAL + 1
            parts: _Parts = [(condition, above), " ? ", (then, CONDITIONAL)]
            return CONDITIONAL, [*parts, " : ", (other, CONDITIONAL)]
        case n.Postfix(op=op, operand=operand):
            return POSTFIX, [(operand, POSTFIX), op]
        case n.Length(object=inner):
            return POSTFIX, [(inner, POSTFIX), ".length()"]
        case n.InitList(items=items):
            return ASSIGN, ["{", *_arguments(items, "}")]
        case n.Comma(left=left, right=right):
            return COMMA, [(left, COMMA), ", ", (right, ASSIGN)]
    raise TypeError(f"{type(node).__name__} is not an expression")


def _arguments(args: tuple[n.Node, ...], closing: str = ")") -> _Parts:
    parts: _Parts = []
    for arg in args:
        parts += [(arg, ASSIGN), ", "]
    # In the place of the last comma; where there is no argument the slice is empty.
    parts[-1:] = [closing]
    return parts


def _sizes(dims: n.Dims) -> _Parts:
    parts: _Parts = []
    for size in dims:
        parts += ["[]"] if size is None else ["[", (size, ASSIGN), "]"]
    return parts


def _gap(op: str, operand: n.Node) -> str:
    """A blank where the operator would run into a sign that the operand begins with."""
    if isinstance(operand, n.Unary):
        begin = operand.op
    else:
        begin = operand.text if isinstance(operand, n.Literal) else ""
    return " " if begin[:1] == op[0] else ""


def print_dims(dims: n.Dims) -> str:
    """The text of array sizes: ``[2][]``."""
    return "".join("[]" if size is None else f"[{print_expression(size, ASSIGN)}]" for size in dims)


def print_layout_item(node: n.LayoutItem) -> str:
    """``name`` or ``name = value``."""
    if node.value is None:
        return node.name
    return f"{node.name} = {print_expression(node.value, ASSIGN)}"


def print_qualifiers(node: n.Qualifiers, block: bool = False) -> str:
    """The qualifiers of a variable or ``block``, a blank behind each: the layout, the words."""
    # Before GLSL 4.20 the order of qualifiers is fixed, and passes put words anywhere.
    ranked = [word for word in node.words if block or word not in MEMORY_QUALIFIERS]
    ranks = [QUALIFIER_ORDER[word] for word in ranked]
    ordered = ranks == sorted(ranks)
    words = node.words if ordered else sorted(node.words, key=QUALIFIER_ORDER.__getitem__)
    text = "".join(f"{word} " for word in words)
    if node.layout is None:
        return text
    return f"layout({', '.join(map(print_layout_item, node.layout))}) {text}"
