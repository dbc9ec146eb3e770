"""From a tree to GLSL text.

``print_module(parse(source))`` is the shader again, laid out afresh: four spaces of indent, one
statement a line, blank lines around what takes several, the kept directives first. Parentheses
come from the precedence table, never from the tree; literals keep their spelling. Printing what
was parsed from printed text changes nothing.

Expressions are printed with an explicit stack, so the length of an operator chain has no limit.
"""

from __future__ import annotations

from shadercache.ast.nodes import (
    Assign,
    Binary,
    Block,
    BlockDecl,
    Call,
    Case,
    Comma,
    Conditional,
    Construct,
    Declarator,
    DeclStmt,
    Dims,
    Directive,
    DoWhile,
    ExprStmt,
    For,
    FunctionDef,
    FunctionProto,
    If,
    Index,
    Jump,
    LayoutItem,
    Length,
    Literal,
    Member,
    Module,
    Name,
    Node,
    Param,
    Postfix,
    PrecisionDecl,
    QualifierDecl,
    Qualifiers,
    Return,
    Stmt,
    StructDef,
    Switch,
    TypeSpec,
    Unary,
    VarDecl,
    While,
)
from shadercache.ast.walk import EXPRESSIONS
from shadercache.lang.words import (
    ASSIGN,
    COMMA,
    CONDITIONAL,
    POSTFIX,
    PRECEDENCE,
    PRIMARY,
    QUALIFIER_ORDER,
    UNARY,
)

_INDENT = "    "
_EXPRESSIONS = frozenset(EXPRESSIONS)


def print_module(module: Module) -> str:
    """The text of a whole shader, ending in a newline."""
    version = f"#version {module.version}" + (f" {module.profile}" if module.profile else "")
    lines = [version, *(directive.text for directive in module.directives)]
    apart = True
    for decl in module.decls:
        printed: list[str] = []
        _print_lines(decl, "", printed)
        if apart or len(printed) > 1:
            lines.append("")
        lines += printed
        apart = len(printed) > 1
    return "\n".join(lines) + "\n"


def print_node(node: Node) -> str:
    """The text of any node, without a newline at its end unless it is a module."""
    if type(node) in _EXPRESSIONS:
        return _expression(node)
    match node:
        case Module():
            return print_module(node)
        case Qualifiers():
            return _qualifiers(node).rstrip()
        case TypeSpec():
            return _type(node, "")
        case Declarator():
            return _declarator(node)
        case Param():
            return _param(node)
        case LayoutItem():
            return _layout_item(node)
        case StructDef():
            return _struct(node, "")
        case Directive():
            return node.text
    lines: list[str] = []
    _print_lines(node, "", lines)
    return "\n".join(lines)


# --- expressions ----------------------------------------------------------------------------------


def _expression(node: Node, least: int = COMMA) -> str:
    """The text of an expression, in parentheses where it binds looser than ``least``."""
    out: list[str] = []
    stack: list[str | tuple[Node, int]] = [(node, least)]
    while stack:
        item = stack.pop()
        if isinstance(item, str):
            out.append(item)
            continue
        node, least = item
        if isinstance(node, Name):
            out.append(node.name)
            continue
        precedence, parts = _parts(node)
        if precedence < least:
            out.append("(")
            stack.append(")")
        stack += parts[::-1]
    return "".join(out)


_Parts = list["str | tuple[Node, int]"]


def _parts(node: Node) -> tuple[int, _Parts]:
    """How tight an expression binds, and its text with the operands left to print.

    Each operand goes with the least precedence that stands there without parentheses.
    """
    match node:
        case Binary(op=op, left=left, right=right):
            own = PRECEDENCE[op]
            return own, [(left, own), f" {op} ", (right, own + 1)]
        case Name(name=name):
            return PRIMARY, [name]
        case Literal(text=text):
            # `1.x` and `-1[0]` are other tokens or another tree, hence not PRIMARY.
            return UNARY, [text]
        case Member(object=inner, name=name):
            return POSTFIX, [(inner, POSTFIX), f".{name}"]
        case Call(name=name, args=args):
            return PRIMARY, [f"{name}(", *_arguments(args)]
        case Construct(type=type_spec, args=args):
            return PRIMARY, [f"{_type(type_spec, '')}(", *_arguments(args)]
        case Index(object=inner, index=index):
            return POSTFIX, [(inner, POSTFIX), "[", (index, COMMA), "]"]
        case Unary(op=op, operand=operand):
            return UNARY, [op + _gap(op, operand), (operand, UNARY)]
        case Assign(op=op, target=target, value=value):
            return ASSIGN, [(target, UNARY), f" {op} ", (value, ASSIGN)]
        case Conditional(condition=condition, then=then, other=other):
            above = CONDITIONAL + 1
            parts: _Parts = [(condition, above), " ? ", (then, CONDITIONAL)]
            return CONDITIONAL, [*parts, " : ", (other, CONDITIONAL)]
        case Postfix(op=op, operand=operand):
            return POSTFIX, [(operand, POSTFIX), op]
        case Length(object=inner):
            return POSTFIX, [(inner, POSTFIX), ".length()"]
        case Comma(left=left, right=right):
            return COMMA, [(left, COMMA), ", ", (right, ASSIGN)]
    raise TypeError(f"{type(node).__name__} is not an expression")


def _arguments(args: tuple[Node, ...]) -> _Parts:
    parts: _Parts = []
    for arg in args:
        parts += [(arg, ASSIGN), ", "]
    parts[-1:] = [")"]
    return parts


def _gap(op: str, operand: Node) -> str:
    """A blank where the operator would run into a sign that the operand begins with."""
    if isinstance(operand, Unary):
        begin = operand.op
    else:
        begin = operand.text if isinstance(operand, Literal) else ""
    return " " if begin[:1] == op[0] else ""


# --- types and declarations -----------------------------------------------------------------------


def _dims(dims: Dims) -> str:
    return "".join("[]" if size is None else f"[{_expression(size, ASSIGN)}]" for size in dims)


def _layout_item(node: LayoutItem) -> str:
    return node.name if node.value is None else f"{node.name} = {_expression(node.value, ASSIGN)}"


def _qualifiers(node: Qualifiers) -> str:
    """The qualifiers, each with a blank after it: the layout, then the words.

    The words are put in the order that every version takes, whatever order a pass left them in.
    """
    words = sorted(node.words, key=QUALIFIER_ORDER.__getitem__)
    text = "".join(f"{word} " for word in words)
    if node.layout is None:
        return text
    return f"layout({', '.join(map(_layout_item, node.layout))}) {text}"


def _type(node: TypeSpec, indent: str) -> str:
    name = node.name if node.struct is None else _struct(node.struct, indent)
    return name + _dims(node.dims)


def _fields(fields: tuple[VarDecl, ...], indent: str) -> str:
    lines: list[str] = []
    for field in fields:
        _print_lines(field, indent + _INDENT, lines)
    return "\n".join(["{", *lines, indent + "}"])


def _struct(node: StructDef, indent: str) -> str:
    name = f" {node.name}" if node.name else ""
    return f"struct{name} {_fields(node.fields, indent)}"


def _declarator(node: Declarator) -> str:
    init = "" if node.init is None else f" = {_expression(node.init, ASSIGN)}"
    return f"{node.name}{_dims(node.dims)}{init}"


def _variables(node: VarDecl, indent: str) -> str:
    """A declaration of variables, without the ``;``."""
    names = ", ".join(map(_declarator, node.declarators))
    text = f"{_qualifiers(node.qualifiers)}{_type(node.type, indent)}"
    return f"{text} {names}" if names else text


def _param(node: Param) -> str:
    name = f" {node.name}" if node.name else ""
    return f"{_qualifiers(node.qualifiers)}{_type(node.type, '')}{name}{_dims(node.dims)}"


def _proto(node: FunctionProto, indent: str) -> str:
    params = ", ".join(map(_param, node.params))
    return f"{_qualifiers(node.qualifiers)}{_type(node.type, indent)} {node.name}({params})"


def _block(node: BlockDecl, indent: str) -> str:
    instance = f" {node.instance}{_dims(node.dims)}" if node.instance else ""
    fields = _fields(node.fields, indent)
    return f"{_qualifiers(node.qualifiers)}{node.name} {fields}{instance};"


def _qualifier_decl(node: QualifierDecl) -> str:
    return f"{_qualifiers(node.qualifiers)}{', '.join(node.names)}".rstrip() + ";"


# --- statements -----------------------------------------------------------------------------------


def _print_lines(node: Node, indent: str, lines: list[str]) -> None:
    """Append the lines of a statement or declaration."""
    match node:
        case ExprStmt():
            lines.append(f"{indent}{'' if node.expr is None else _expression(node.expr)};")
        case DeclStmt():
            _print_lines(node.decl, indent, lines)
        case VarDecl():
            lines += f"{indent}{_variables(node, indent)};".split("\n")
        case Block():
            lines.append(indent + "{")
            _print_all(node.body, indent + _INDENT, lines)
            lines.append(indent + "}")
        case If():
            _print_if(node, indent, lines)
        case Return():
            value = "" if node.value is None else f" {_expression(node.value)}"
            lines.append(f"{indent}return{value};")
        case Jump():
            lines.append(f"{indent}{node.word};")
        case For():
            _print_body(indent + _for_head(node), node.body, indent, lines)
        case While():
            line = f"{indent}while ({_condition(node.condition)})"
            _print_body(line, node.body, indent, lines)
        case DoWhile():
            _print_body(indent + "do", node.body, indent, lines)
            line = _continue_line(node.body, indent, lines)
            lines.append(f"{line}while ({_expression(node.condition)});")
        case Switch():
            _print_switch(node, indent, lines)
        case FunctionDef():
            _print_body(indent + _proto(node.proto, indent), node.body, indent, lines)
        case FunctionProto():
            lines.append(f"{indent}{_proto(node, indent)};")
        case BlockDecl():
            lines += f"{indent}{_block(node, indent)}".split("\n")
        case PrecisionDecl():
            lines.append(f"{indent}precision {node.precision} {_type(node.type, indent)};")
        case QualifierDecl():
            lines.append(indent + _qualifier_decl(node))
        case Case():
            value = "default" if node.value is None else f"case {_expression(node.value)}"
            lines.append(f"{indent}{value}:")
        case _:
            raise TypeError(f"{type(node).__name__} cannot be printed")


def _print_all(nodes: tuple[Node, ...], indent: str, lines: list[str]) -> None:
    for node in nodes:
        _print_lines(node, indent, lines)


def _print_body(line: str, body: Node, indent: str, lines: list[str]) -> None:
    """A statement that holds another: a block begins on its line, anything else on the next."""
    if isinstance(body, Block):
        lines.append(line + " {")
        _print_all(body.body, indent + _INDENT, lines)
        lines.append(indent + "}")
    else:
        lines.append(line)
        _print_lines(body, indent + _INDENT, lines)


def _continue_line(body: Node, indent: str, lines: list[str]) -> str:
    """What a line begins with after the body of a statement: its brace where it has one."""
    return lines.pop() + " " if isinstance(body, Block) else indent


def _print_if(node: If, indent: str, lines: list[str]) -> None:
    """``if`` with all its ``else if``; these are printed in a loop, for a chain may be long."""
    line = f"{indent}if ({_expression(node.condition)})"
    while True:
        then: Stmt = node.then
        if node.other is not None and _ends_in_open_if(then):
            then = Block(then.span, (then,))  # Else the `else` would belong to the inner `if`.
        _print_body(line, then, indent, lines)
        if node.other is None:
            return
        line = _continue_line(then, indent, lines) + "else"
        if not isinstance(node.other, If):
            _print_body(line, node.other, indent, lines)
            return
        node = node.other
        line += f" if ({_expression(node.condition)})"


def _ends_in_open_if(node: Node) -> bool:
    """Would an ``else`` after this statement belong to an ``if`` inside it?"""
    while isinstance(node, If | For | While):
        if not isinstance(node, If):
            node = node.body
        elif node.other is None:
            return True
        else:
            node = node.other
    return False


def _condition(node: Node) -> str:
    return _variables(node, "") if isinstance(node, VarDecl) else _expression(node)


def _for_head(node: For) -> str:
    init = print_node(node.init)
    condition = "" if node.condition is None else f" {_condition(node.condition)}"
    step = "" if node.step is None else f" {_expression(node.step)}"
    return f"for ({init}{condition};{step})"


def _print_switch(node: Switch, indent: str, lines: list[str]) -> None:
    lines.append(f"{indent}switch ({_expression(node.selector)}) {{")
    for statement in node.body:
        inner = _INDENT if isinstance(statement, Case) else 2 * _INDENT
        _print_lines(statement, indent + inner, lines)
    lines.append(indent + "}")
