# Copyright (c) 2026 The Hex_mesh_optimization authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Opens pages in Chromium without a screen and without a network."""

import contextlib
import pathlib
import shutil

from selenium import webdriver
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.support.ui import WebDriverWait


def set_size(driver, width, height):
    """Of what is seen of the page: a window has a least width, which phones are below."""
    driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                           {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False})


@contextlib.contextmanager
def opened(page, width=1200, height=900, scheme="light"):
    """The driver of a browser that shows a page of a report, drawn completely."""
    options = webdriver.ChromeOptions()
    options.binary_location = shutil.which("chromium")
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    # no sandbox: it does not start for root; drawn by the processor, the same everywhere
    for argument in ("headless=new", "no-sandbox", "disable-dev-shm-usage", "use-angle=swiftshader", "enable-unsafe-swiftshader",
                     "disable-background-networking", "host-resolver-rules=MAP * ~NOTFOUND", "hide-scrollbars",
                     "force-device-scale-factor=1"):
        options.add_argument("--" + argument)
    driver = webdriver.Chrome(service=Service(shutil.which("chromedriver")), options=options)
    try:
        driver.execute_cdp_cmd("Network.enable", {})
        driver.execute_cdp_cmd("Network.emulateNetworkConditions",
                               {"offline": True, "latency": 0, "downloadThroughput": 0, "uploadThroughput": 0})
        set_size(driver, width, height)
        driver.execute_cdp_cmd("Emulation.setEmulatedMedia",
                               {"features": [{"name": "prefers-color-scheme", "value": scheme},
                                             {"name": "prefers-reduced-motion", "value": "reduce"}]})
        driver.get(pathlib.Path(page).resolve().as_uri())
        WebDriverWait(driver, 60).until(
            lambda d: d.execute_script("return document.documentElement.dataset.isReady") == "true")
        driver.implicitly_wait(60)  # lists are filled when they are opened, soon
        yield driver
    finally:
        driver.quit()
