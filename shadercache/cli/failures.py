"""Show diagnostics, and say in the same form what typer and the operating system complain of."""

from __future__ import annotations

import json
import sys
from collections.abc import Iterable

import typer

from shadercache.diagnostics import Diagnostic, DiagnosticError, UsageError, usage_error


class Reporter:
    """Writes diagnostics to stderr: as text, or as one JSON object per line."""

    def __init__(self) -> None:
        self.json = False

    def show(self, diagnostics: Iterable[Diagnostic]) -> None:
        """Write the diagnostics in the order given."""
        for item in diagnostics:
            text = json.dumps(item.to_json()) if self.json else item.render()
            print(text, file=sys.stderr)

    def fail(self, error: DiagnosticError) -> int:
        """Write the diagnostics of ``error`` and return its exit status."""
        self.show(error.diagnostics)
        return error.exit_code


def explain_usage(error: typer.TyperException) -> UsageError:
    """A command line that typer rejects, as SC003 with the way to the help text."""
    context = getattr(error, "ctx", None)
    command = context.command_path if context else "shadercache"
    message = error.format_message().rstrip(".")
    message = message[:1].lower() + message[1:]
    return usage_error("SC003", message, hint=f"'{command} --help' lists what there is")


def explain_os_error(error: OSError) -> UsageError:
    """What the operating system refused, as SC004 with the file it is about."""
    reason = error.strerror or str(error) or type(error).__name__
    place = f"{error.filename}: " if error.filename else ""
    return usage_error("SC004", f"{place}{reason}")
