"""Fills the folder of original scene data from a mirror folder or from the public homes."""

from raywalk.fetch.fill import fill
from raywalk.fetch.home import HomeFile, home_sources
from raywalk.fetch.mirror import MirrorArchive, mirror_sources
from raywalk.fetch.source import Outcome, Source, Watcher

__all__ = ["HomeFile", "MirrorArchive", "Outcome", "Source", "Watcher", "fill", "home_sources", "mirror_sources"]
