#!/usr/bin/env python3
# Copyright (c) 2026 The Hex_mesh_optimization authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""A picture of the top of a page of --report: picture.py PAGE PICTURE.png

Needs Pillow (Debian: python3-pil). That of the manual, doc/Hex_mesh_optimization/fig/report.png, is of

    generate_hex_mesh plate_with_hole tangled.mesh --refine 7 --corrupt scramble --amount .6
    optimize_hex_mesh tangled.mesh repaired.mesh --report page.html"""

import io
import sys

from PIL import Image

from browser import opened

page, picture = sys.argv[1:]
with opened(page, width=1200, height=975) as driver:
    image = Image.open(io.BytesIO(driver.get_screenshot_as_png())).convert("RGB")
# a palette makes it a third as large
image.quantize(256, dither=Image.Dither.NONE).save(picture, optimize=True)
