"""Is a module GLSL? All that the inference cannot do without, and the rules that only reject.

The codes of its diagnostics:

=====  ============================================================================================
SC201  a name that is not declared (with the nearest known one as a hint)
SC202  a name that is declared twice in a scope, a function that is defined twice
SC203  a reserved name
SC204  a name of another sort than the place needs: a type, a variable, a function; misplaced void
SC205  an operator that does not apply to its operands
SC206  a call that no overload fits (with the candidates)
SC207  a call with a wrong number of arguments
SC208  an ambiguous call
SC209  a target of an assignment, or an out argument, that cannot be written
SC210  a value that does not convert to the type it is assigned to
SC211  a wrong or missing return value
SC212  a condition that is not bool
SC213  a field, swizzle or length() that does not exist
SC214  an index of a wrong type or out of range, or something without elements
SC215  a wrong array size
SC216  recursion
SC217  no main (a warning, unless one is needed), or a wrong one
SC218  discard, break or continue where there can be none
SC219  wrong arguments of a constructor
SC220  a wrong switch
SC221  a qualifier, or a kind of variable, that the place or the type does not allow
SC222  an initialiser that has to be constant
SC223  a wrong layout
SC224  declarations of a function that disagree, or a wrong result type
SC225  arrays of arrays in a version without them
SC226  an argument that has to be constant
SC227  an integer that needs more than 32 bits
SC228  a float, integer or sampler that has no precision (GLSL ES)
SC290  warning: the drivers disagree about a call of an overloaded built-in function
SC291  warning: a function that is called but not defined
SC292  warning: a name with two underscores
=====  ============================================================================================
"""

from __future__ import annotations

from collections.abc import Callable

from shadercache.ast.large import without_collector
from shadercache.ast.nodes import Module
from shadercache.sema.facts import Facts, Stage
from shadercache.sema.infer import infer_tables
from shadercache.sema.inference_context import Tables
from shadercache.source import Source
from shadercache.valid.assignments import check_assignments
from shadercache.valid.call_arguments import check_call_arguments
from shadercache.valid.control_flow import check_control_flow
from shadercache.valid.default_precisions import check_default_precisions
from shadercache.valid.function_heads import check_definitions, check_function_heads, check_main
from shadercache.valid.indices import check_indices
from shadercache.valid.interface_blocks import check_blocks
from shadercache.valid.layouts import check_layouts
from shadercache.valid.recursion import check_recursion
from shadercache.valid.redeclared import check_redeclared
from shadercache.valid.reserved_names import check_names
from shadercache.valid.suspect import Suspect
from shadercache.valid.variable_storage import (
    check_qualifier_declarations,
    check_structs,
    check_variables,
)

RULES: tuple[Callable[[Suspect], None], ...] = (
    check_names,
    check_redeclared,
    check_structs,
    check_variables,
    check_blocks,
    check_qualifier_declarations,
    check_layouts,
    check_default_precisions,
    check_function_heads,
    check_control_flow,
    check_assignments,
    check_indices,
    check_call_arguments,
    check_definitions,
    check_recursion,
)
"""What is asked of every module; each rule reports to the problems of its suspect."""


def validate(
    module: Module,
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
        suspect = Suspect(
            module, inferred.language, inferred.tables, inferred.constants, inferred.problems
        )
        for rule in RULES:
            rule(suspect)
        check_main(suspect, needed=needs_main)
        return inferred.facts()
