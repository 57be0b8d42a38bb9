# SPDX-License-Identifier: GPL-3.0-or-later
"""interop.py TOOL FOLDER: rimline against other programs, file by file. Status 1 where a check failed."""

import pathlib
import sys

import reading
import writing
from tool import Tool, run_checks

tool = Tool(sys.argv[1], pathlib.Path(sys.argv[2]))
sys.exit(1 if run_checks(reading.CHECKS + writing.CHECKS, tool) > 0 else 0)
