"""The driver without a device: daemons on it do everything but compute."""

from pathlib import Path

import pytest

from tests.api.conftest import find_daemon


@pytest.fixture
def fake_driver() -> Path:
    library = find_daemon().parents[1] / "tests/libfake_cuda.so"
    if not library.is_file():
        pytest.skip(f"{library} is not built")
    return library
