"""The built-in variables and constants of every version, profile and stage, against glslang's."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from lang.glslang_tables import variables
from lang.test_builtin_tables import TABLES, needs_glslang

from shadercache.lang.builtins import variable, variable_names

# Of other stages and of extensions; the constants of images, which glslang has from 1.30 on, and
# those of the compatibility profile, which it keeps; the blocks whose members are ours one by one.
LEFT_OUT = re.compile(
    r"gl_\w*(Ray|Semantics|Scope|Mesh|Task|HitKind|Subgroup|CooperativeMatrix)\w*|gl_\w+(NV|EXT)"
    r"|gl_Matrix(Use|Operands)\w+"
    r"|gl_Max\w*(Image|CombinedShaderOutputResources)\w*|gl_PerVertex|gl_PerFragment"
    r"|gl_Max(Lights|ClipPlanes|TextureUnits|TextureCoords)"
)
# Members of gl_PerVertex and gl_PerFragment.
ADDED = re.compile(
    r"gl_(Position|PointSize|Clip(Distance|Vertex)|CullDistance|TexCoord|FogFragCoord"
    r"|(Front|Back)?(Secondary)?Color)"
)


@needs_glslang
@pytest.mark.parametrize(("version", "profile", "stage"), TABLES)
def test_7_variables_are_those_of_glslang(
    version: int, profile: str | None, stage: str, tmp_path: Path
) -> None:
    head = str(version) if profile is None or version == 100 else f"{version} {profile}"
    theirs = variables(head, stage, tmp_path)
    ours = {name for name in variable_names() if variable(name, stage, version, profile)}
    assert not [name for name in theirs - ours if not LEFT_OUT.fullmatch(name)]
    assert not [name for name in ours - theirs if not ADDED.fullmatch(name)]
    assert len(ours & theirs) > 10
