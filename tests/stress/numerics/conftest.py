"""The fixture of all numerical stress tests."""

from __future__ import annotations

import pytest

from .criteria import Criteria


@pytest.fixture
def stress(request: pytest.FixtureRequest) -> Criteria:
    """What the test measures and demands."""
    return Criteria(request.node.user_properties)
