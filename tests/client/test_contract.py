"""The contract, its generated models and its examples agree."""

import json
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
import yaml
from jsonschema import Draft202012Validator
from jsonschema.exceptions import ValidationError as SchemaError
from pydantic import TypeAdapter, ValidationError
from raywalk import models
from raywalk.client import Client

ROOT = Path(__file__).resolve().parents[2]
CONTRACT = yaml.safe_load((ROOT / "proto/openapi.yaml").read_text())
EXAMPLES = sorted((ROOT / "proto/examples").glob("*.json"))
GOOD = [path for path in EXAMPLES if ".good." in path.name]
BAD = [path for path in EXAMPLES if ".bad." in path.name]
MODELS_CANNOT_SAY = {"BenchmarkSpec.bad.mode-twice.json", "AccuracySpec.bad.class-twice.json"}  # uniqueItems


def names(paths: list[Path]) -> dict:
    return {"argvalues": paths, "ids": [path.stem for path in paths]}


def validator(path: Path) -> Draft202012Validator:
    name = path.name.split(".")[0]
    assert name in CONTRACT["components"]["schemas"]
    return Draft202012Validator({"$ref": f"#/components/schemas/{name}", "components": CONTRACT["components"]})


def pointers(errors: Iterator[SchemaError]) -> Iterator[str]:
    for error in errors:
        place = "".join(f"/{step}" for step in error.absolute_path)
        if error.validator == "additionalProperties":
            known = error.schema.get("properties", {})
            yield from (f"{place}/{name}" for name in error.instance if name not in known)
        elif error.context:
            yield from pointers(iter(error.context))
        else:
            yield place


def model(path: Path) -> TypeAdapter | None:
    """The model of the example's schema; schemas without a class of their own have none."""
    found = getattr(models, path.name.split(".")[0], None)
    return TypeAdapter(found) if found else None


@pytest.mark.parametrize("path", **names(GOOD))
def test_good_example(path: Path) -> None:
    validator(path).validate(json.loads(path.read_text()))
    if adapter := model(path):
        adapter.validate_json(path.read_text(), strict=True)


@pytest.mark.parametrize("path", **names(BAD))
def test_bad_example(path: Path) -> None:
    example = json.loads(path.read_text())
    assert set(example) == {"pointer", "instance"}
    assert example["pointer"] in set(pointers(validator(path).iter_errors(example["instance"])))
    adapter = model(path)
    if adapter and path.name not in MODELS_CANNOT_SAY:
        with pytest.raises(ValidationError):
            adapter.validate_json(json.dumps(example["instance"]), strict=True)


def test_every_request_schema_has_good_and_bad_examples() -> None:
    bodies = (
        content["schema"]["$ref"].rsplit("/", 1)[1]
        for path in CONTRACT["paths"].values()
        for operation in path.values()
        if isinstance(operation, dict)
        for media, content in operation.get("requestBody", {}).get("content", {}).items()
        if media == "application/json"
    )
    for name in bodies:
        for kind in GOOD, BAD:
            assert any(path.name.startswith(f"{name}.") for path in kind), name


def test_models_are_current() -> None:
    check = subprocess.run([sys.executable, ROOT / "proto/generate", "--check"], capture_output=True, text=True)
    assert check.returncode == 0, check.stderr


def test_every_operation_has_a_method() -> None:
    operations = {
        operation["operationId"]
        for path in CONTRACT["paths"].values()
        for method, operation in path.items()
        if method in ("get", "put", "post", "delete")
    }
    assert {name for name in operations if not callable(getattr(Client, name, None))} == set()


def test_operations_have_prose() -> None:
    for path in CONTRACT["paths"].values():
        for method, operation in path.items():
            if method != "parameters":
                assert operation["summary"].endswith(".")
