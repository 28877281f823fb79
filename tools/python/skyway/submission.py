"""Folders for an authority that somebody else made."""

from __future__ import annotations

import json
from typing import Any

from . import _skyway
from .arguments import File, file, whole


def check_submission(folder: File, *, threads: int = 0) -> dict[str, Any]:
    """The report of `skyway-check FOLDER`: every file, flight and claim of the folder is proved anew, and nothing in it is believed.

    Keys: "ok" and "manifest" (its SHA-256); if it is not refused "flights", "files" and "not_verified" (what nobody looked at), else "file" and
    "reason".
    """
    report: dict[str, Any] = json.loads(_skyway.check_submission(file("folder", folder), threads=whole("threads", threads)))
    return report
