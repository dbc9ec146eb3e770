"""Is a module GLSL? All that the inference cannot do without, and the rules that only reject.

What each of the codes SC2xx is about stands in docs/DIAGNOSTICS.md.
"""

from __future__ import annotations

from shadercache.ast import nodes as n
from shadercache.ast.large import without_collector
from shadercache.sema.facts import Facts, Stage
from shadercache.sema.infer import facts_of, infer_tables
from shadercache.sema.inference_context import Tables
from shadercache.source import Source
from shadercache.valid import declaration_rules as declarations
from shadercache.valid import expression_rules as expressions
from shadercache.valid import function_rules as functions
from shadercache.valid import name_rules as names
from shadercache.valid import vulkan_rules
from shadercache.valid.layouts import layouts
from shadercache.valid.statement_rules import statements
from shadercache.valid.suspect import Rule, Suspect

# Reports are sorted by place in the end, so the order of the rules says nothing.
RULES: tuple[tuple[type[n.Node], Rule], ...] = (
    (n.Module, names.given_names),
    (n.Module, names.redeclared),
    (n.StructDef, declarations.struct),
    (n.Module, declarations.variables),
    (n.BlockDecl, declarations.block),
    (n.QualifierDecl, declarations.qualifiers_alone),
    (n.Module, layouts),
    (n.PrecisionDecl, declarations.default_precision),
    (n.Module, declarations.precisions),
    (n.Module, functions.function_heads),
    (n.FunctionDef, statements),
    (n.Assign, expressions.assigned),
    (n.Unary, expressions.stepped),
    (n.Postfix, expressions.stepped),
    (n.Call, expressions.arguments),
    (n.Module, vulkan_rules.vulkan),
    (n.Call, vulkan_rules.combined),
    (n.Index, expressions.index),
    (n.Module, functions.definitions),
    (n.Module, functions.recursion),
)
"""The nodes of a class, and what is asked of each."""


def validate(
    module: n.Module,
    source: Source,
    stage: Stage = "fragment",
    *,
    needs_main: bool = False,
    tables: Tables | None = None,
) -> Facts:
    """The facts of ``module``, which was parsed from ``source``, if it is right.

    A module without ``main`` may be a part of a program: it is warned of, unless ``needs_main``.
    Raises :class:`InputError` with every mistake found (SC2xx), in source order.
    """
    with without_collector():
        inferred = infer_tables(module, source, stage, tables)
        suspect = Suspect(module, inferred.language, inferred.tables, inferred.constants)
        findings = [
            finding
            for kind, rule in RULES
            for node in suspect.nodes(kind)
            for finding in rule(node, suspect)
        ]
        for code, message, node, hint, doubtful in (
            *findings,
            *functions.entry_point(suspect, needs_main),
        ):
            report = inferred.problems.warn if doubtful else inferred.problems.error
            report(code, message, node, hint)
        return facts_of(module, inferred)
