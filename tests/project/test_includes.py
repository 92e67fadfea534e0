"""The include rule holds, and its checker finds what breaks it."""

from pathlib import Path

import pytest

from tests.project.include_rule import violations
from tests.project.sources import ROOT

GOOD = {
    "kernels/platform.h": "#ifndef GPU\n#include <cmath>\n#endif\n",
    "kernels/vec.h": '#include "kernels/platform.h"\n',
    "kernels/scene_view.h": '#include "kernels/vec.h"\n',
    "kernels/query.h": '#include "kernels/scene_view.h"\n',
    "kernels/accel/kind.h": "// Host only.\n#include <string>\n",
    "kernels/accel/grid/dda.h": '#include "kernels/accel/kind.h"\n#include "kernels/query.h"\n',
    "kernels/accel/bvh/pair.h": "",
    "kernels/accel/kinds.cpp": '#include "kernels/accel/grid/dda.h"\n',
    "kernels/shade/phong.h": '#include "kernels/query.h"\n',
    "kernels/entry_cpu.cpp": '#include <vector>\n#include "kernels/accel/grid/dda.h"\n',
    "server/main.cpp": '#include <CLI/CLI.hpp>\n#include "server/api/frames.h"\n',
    "server/api/frames.h": '#include <nlohmann/json.hpp>\n#include "server/http/server.h"\n',
    "server/http/server.h": '#include "server/catalog/catalog.h"\n',
    "server/catalog/catalog.h": '#include "server/device/device.h"\n',
    "server/device/device.h": '#include "kernels/query.h"\n',
    "server/accuracy/rate.h": "",
    "server/accuracy/oracle/exact.h": '#include <gmpxx.h>\n#include "kernels/query.h"\n',
    "server/bench/errors.h": '#include "server/accuracy/rate.h"\n',
    "server/scene/scene.h": "",
    "tests/kernels/grid.cpp": '#include "kernels/shade/phong.h"\n#include "server/scene/scene.h"\n',
}

BAD = [
    ("kernels/platform.h", '#include "kernels/vec.h"', "platform may not include math"),
    ("kernels/vec.h", '#include "kernels/query.h"', "math may not include query"),
    ("kernels/vec.h", "#include <cmath>", "GPU shares"),
    ("kernels/accel/grid/dda.h", '#include "kernels/accel/bvh/pair.h"', "accel/grid may not include accel/bvh"),
    ("kernels/accel/grid/dda.h", '#include "kernels/shade/phong.h"', "accel/grid may not include shade"),
    ("kernels/accel/kind.h", '#include "kernels/accel/grid/dda.h"', "accel may not include accel/grid"),
    ("kernels/accel/kinds.cpp", '#include "kernels/shade/phong.h"', "accel-tables may not include shade"),
    ("kernels/shade/phong.h", '#include "kernels/accel/kind.h"', "shade may not include accel"),
    ("kernels/entry_cpu.cpp", '#include "server/scene/scene.h"', "top may not include server/scene"),
    ("server/device/device.h", '#include "server/catalog/catalog.h"', "server/device may not include server/catalog"),
    ("server/device/device.h", '#include "server/scene/scene.h"', "server/device may not include server/scene"),
    ("server/http/server.h", '#include "server/api/frames.h"', "server/http may not include server/api"),
    ("server/catalog/catalog.h", "#include <nlohmann/json.hpp>", "is for server/api, server/http"),
    ("server/scene/scene.h", "#include <OpenImageIO/imageio.h>", "server/image only"),
    ("server/device/device.h", "#include <cuda.h>", "server/device/cuda only"),
    ("server/catalog/catalog.h", "#include <gmpxx.h>", "server/accuracy/oracle only"),
    ("server/device/device.h", '#include "server/accuracy/rate.h"', "server/device may not include server/accuracy"),
    ("server/api/frames.h", '#include "tests/kernels/grid.cpp"', "server/api may not include tests"),
    ("server/api/frames.h", '#include "server.h"', "not written from the root"),
    ("server/api/frames.h", '#include "server/http/gone.h"', "does not exist"),
    ("server/extras/new.h", "", "no place in the architecture"),
]


def write_tree(root: Path, files: dict[str, str]) -> None:
    for name, text in files.items():
        (root / name).parent.mkdir(parents=True, exist_ok=True)
        (root / name).write_text(text)


def test_the_project_keeps_the_include_rule():
    assert violations(ROOT) == []


def test_a_good_tree_passes(tmp_path):
    write_tree(tmp_path, GOOD)
    assert violations(tmp_path) == []


@pytest.mark.parametrize(("file", "line", "expected"), BAD)
def test_each_broken_arrow_is_found(tmp_path, file, line, expected):
    write_tree(tmp_path, GOOD | {file: GOOD.get(file, "") + line + "\n"})
    found = violations(tmp_path)
    assert len(found) == 1
    assert found[0].startswith(file)
    assert expected in found[0]
