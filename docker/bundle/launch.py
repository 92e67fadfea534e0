"""Starts the client, or says what it lacks: requirements.txt beside this file is the one list of packages."""

import re
import shlex
import sys
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

OLDEST_PYTHON = (3, 11)
REQUIREMENTS = Path(__file__).resolve().with_name("requirements.txt")
BUNDLE = REQUIREMENTS.parents[1]


def is_installed(name: str) -> bool:
    try:
        version(name)
    except PackageNotFoundError:
        return False
    return True


def missing_packages() -> list[str]:
    lines = REQUIREMENTS.read_text(encoding="utf-8").split()
    names = [re.split(r"[<>=!~;\[ ]", line)[0] for line in lines]
    return [name for name in names if not is_installed(name)]


def advice(missing: list[str]) -> str:
    venv, requirements = shlex.quote(str(BUNDLE / ".venv")), shlex.quote(str(REQUIREMENTS))
    return f"""raywalk: this Python ({sys.executable}) has no {", ".join(missing)}.
Install what the client needs beside it:
  python3 -m venv {venv}
  {venv}/bin/pip install --requirement {requirements}
or name a Python that has it in RAYWALK_PYTHON, or add its packages to PYTHONPATH."""


def main() -> None:
    if sys.version_info < OLDEST_PYTHON:
        sys.exit("raywalk: Python {}.{} or newer is needed; RAYWALK_PYTHON may name it".format(*OLDEST_PYTHON))
    if missing := missing_packages():
        sys.exit(advice(missing))
    from raywalk.cli import main as raywalk

    sys.argv[0] = "raywalk"
    raywalk()


if __name__ == "__main__":
    main()
