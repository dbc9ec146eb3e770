"""Of every case the manifest follows its schema and lists all that its programs declare."""

from __future__ import annotations

import json

import pytest
from jsonschema import Draft202012Validator
from manifests import SCHEMA, plain

from shadercache.analysis.input_reads import input_kinds
from shadercache.diagnostics import InputError
from tests.cases.cases import NAMES, analysed
from tests.configured import rewritten


@pytest.mark.parametrize("name", NAMES)
def test_what_is_declared_and_depended_on_is_listed(name: str) -> None:
    try:
        analysis = analysed(name)
    except InputError:
        return
    legal = [node for node in analysis.nodes if node.legal]
    if not legal:
        return
    node = max(legal, key=lambda node: len(node.inputs))
    manifest = plain(rewritten(analysis, node, unprofitable=True).manifest)
    Draft202012Validator(json.loads(SCHEMA.read_text(encoding="utf-8"))).validate(manifest)
    given = {item["name"] for item in manifest["inputs"]}
    known = given | {item["name"] for item in manifest["uniforms"]}
    passes = [item for variant in manifest["variants"] for item in variant["passes"]]
    for item in (*passes, manifest["original"], manifest["payload"], manifest["debug"]):
        assert known.issuperset((*item["uniforms"], *item["attributes"]))
    for item in manifest["depends_on"]:
        assert item["name"] in given or item["kind"] == "built-in"
    if node.inputs & input_kinds(analysis.program.module, analysis.program.facts).keys():
        assert manifest["depends_on"]
