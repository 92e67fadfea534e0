"""Prints what a 512x512 JPEG frame over loopback costs beyond its render: .venv/bin/python tests/measure/loopback.py

A benchmark, not a test: other programs' load counts. It reads over a plain socket, so that no client's work does."""

import http.client
import json
import re
import statistics
import sys
import time
from urllib.parse import urlsplit

from raywalk import Client, LocalDaemon
from raywalk.follow import built

FRAMES = 200
TIMING = re.compile(r"(\w+);dur=([\d.]+)")


def main(scene: str) -> None:
    with LocalDaemon() as daemon, Client(daemon.base_url) as client:
        client.load_scene(scene)
        built(client, scene, "embree")
        connection = http.client.HTTPConnection("127.0.0.1", urlsplit(daemon.base_url).port)
        request = {"scene": scene, "structure": "embree", "traversal": "intersect", "width": 512, "height": 512}
        beyond, encode = [], []
        for frame in range(FRAMES):
            body = json.dumps(request | {"camera": {"frame": frame, "of": FRAMES}})
            begin = time.perf_counter()
            connection.request("POST", "/v1/frames", body, {"Content-Type": "application/json"})
            answer = connection.getresponse()
            answer.read()
            total_ms = (time.perf_counter() - begin) * 1e3
            timing = {name: float(ms) for name, ms in TIMING.findall(answer.headers["Server-Timing"])}
            beyond.append(total_ms - timing["trace"])
            encode.append(timing["encode"])
    low, high = (sorted(beyond)[round(FRAMES * part)] for part in (0.05, 0.95))
    print(f"{scene}: {FRAMES} frames of 512x512 as JPEG over loopback, each beyond its render:")
    print(f"median {statistics.median(beyond):.2f} ms (5 % {low:.2f}, 95 % {high:.2f}; goal at most 3 ms), ", end="")
    print(f"of it encoding {statistics.median(encode):.2f} ms")


if __name__ == "__main__":
    main(*(sys.argv[1:] or ["bunny"]))
