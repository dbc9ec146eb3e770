"""The root of the command line: find the subcommand, run it, turn failures into diagnostics.

A subcommand is a module of this package with a function ``command``, named in ``COMMANDS``. Only
the modules of the commands in question are imported, and a module imports numpy, moderngl and the
like inside its functions: ``--version`` and ``nodes`` start in a fraction of the time that way.

Exit status: 0 well, 1 input rejected or a law broken, 2 wrong usage or a file that cannot be
written, 3 no usable OpenGL, 130 interrupted, 141 the reader of the output went away.
"""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Iterable, Sequence
from contextlib import suppress
from importlib import import_module
from itertools import islice
from typing import Annotated, Literal

import typer

from shadercache import __version__
from shadercache.cli.options import expanded
from shadercache.diagnostics import Diagnostic, DiagnosticError, UsageError, usage_error

COMMANDS = {
    "check": "check",
    "nodes": "list_nodes",
    "rewrite": "rewrite",
    "verify": "verify",
    "run": "run",
    "bench": "bench",
    "sweep": "sweep",
    "report": "report",
    "tune": "tune",
    "demo": "demo",
    "scene": "write_scene",
    "assets": "assets",
    "doctor": "doctor",
}
"""The subcommands, in the order of the help text, and their modules."""

HIDDEN = frozenset({"demo"})
"""Subcommands that the help text leaves out."""


class Reporter:
    """Writes diagnostics to stderr: as text, or as one JSON object per line."""

    json = False

    def show(self, diagnostics: Iterable[Diagnostic]) -> None:
        """Write the diagnostics in the order given."""
        for diagnostic in diagnostics:
            text = json.dumps(diagnostic.to_json()) if self.json else diagnostic.render()
            print(text, file=sys.stderr)

    def fail(self, error: DiagnosticError) -> int:
        """Write the diagnostics of ``error`` and return its exit status."""
        self.show(error.diagnostics)
        return error.exit_code


def run() -> None:
    """Entry point of the console script."""
    if sys.stdout is None:  # started with its output closed (">&-")
        sys.stdout = open(os.devnull, "w", encoding="utf-8")  # noqa: SIM115
    if hasattr(sys.stdout, "reconfigure"):
        # A name that the terminal's encoding lacks must not end in a traceback.
        sys.stdout.reconfigure(errors="backslashreplace")
    sys.exit(main(sys.argv[1:]))


def main(argv: Sequence[str]) -> int:
    """Run one command line and return the exit status; never raises for a user's mistake."""
    reporter = Reporter()
    args = _hoist_diagnostics(argv) or ["--help"]
    try:
        app = _build(args, reporter)
        # Not standalone: typer would print errors in its own form and end the process.
        status = app(args, prog_name="shadercache", standalone_mode=False)
        # Here, so that a reader who went away shows in the status and not at the interpreter's end.
        sys.stdout.flush()
        return status if isinstance(status, int) else 0  # a command returns None if all is well
    except DiagnosticError as error:
        return reporter.fail(error)
    except typer.TyperException as error:
        return reporter.fail(_explain_usage(error))
    except (KeyboardInterrupt, typer.Abort):
        return 130
    except (BrokenPipeError, SystemExit):
        # typer turns a broken pipe into SystemExit; nothing else here raises it.
        _forget_output()
        return 141
    except OSError as error:
        _forget_output()
        reason = error.strerror or str(error) or type(error).__name__
        place = f"{error.filename}: " if error.filename else ""
        return reporter.fail(usage_error("SC004", f"{place}{reason}"))
    except UnicodeDecodeError as error:
        return reporter.fail(usage_error("SC001", f"a file is not UTF-8 text: {error}"))


def _build(args: Sequence[str], reporter: Reporter) -> typer.Typer:
    """The typer application with the commands that ``args`` may mean (all, if it names none)."""
    app = typer.Typer(
        add_completion=False,
        rich_markup_mode=None,
        pretty_exceptions_enable=False,
        context_settings={"max_content_width": 100},
    )

    @app.callback(help="Cache an intermediate value of a GLSL shader from frame to frame.")
    def root(
        context: typer.Context,
        version: Annotated[
            bool,
            typer.Option(
                "--version", callback=_print_version, is_eager=True, help="Print the version."
            ),
        ] = False,
        diagnostics: Annotated[
            Literal["text", "json"],
            typer.Option(help="How errors are written; may stand behind the command as well."),
        ] = "text",
    ) -> None:
        reporter.json = diagnostics == "json"
        context.obj = reporter

    # A file may have the name of a command; then one more module is imported, and nothing else.
    for name in [name for name in COMMANDS if name in args] or COMMANDS:
        module = import_module(f"shadercache.cli.{COMMANDS[name]}")
        app.command(name, hidden=name in HIDDEN)(expanded(module.command))
    return app


def _print_version(wanted: bool) -> None:
    if wanted:
        print(f"shadercache {__version__}")
        raise typer.Exit


def _hoist_diagnostics(argv: Iterable[str]) -> list[str]:
    """Move ``--diagnostics`` to the front, where it is declared once for all commands."""
    front: list[str] = []
    rest: list[str] = []
    arguments = iter(argv)
    for argument in arguments:
        if argument == "--":
            rest += [argument, *arguments]
        elif argument == "--diagnostics":
            front += [argument, *islice(arguments, 1)]
        elif argument.startswith("--diagnostics="):
            front.append(argument)
        else:
            rest.append(argument)
    return front + rest


def _explain_usage(error: typer.TyperException) -> UsageError:
    """A command line that typer rejects, as SC003 with the way to the help text."""
    context = getattr(error, "ctx", None)
    command = context.command_path if context else "shadercache"
    message = error.format_message().rstrip(".")
    message = message[:1].lower() + message[1:]
    return usage_error("SC003", message, hint=f"'{command} --help' lists what there is")


def _forget_output() -> None:
    """Drop what stdout still holds, so that the interpreter's last flush does not fail again."""
    with suppress(OSError, ValueError), open(os.devnull, "wb") as nothing:
        os.dup2(nothing.fileno(), sys.stdout.fileno())
