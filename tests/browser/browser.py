# SPDX-License-Identifier: BSD-3-Clause
"""Debian's Chromium without a screen, and what a page did in it that it must not do."""
import json
import os
import shutil
import sys

SKIPPED = 77


def require_browser():
    """Ends the test with its name where there is no browser, unless KREISEL_REQUIRE has `browser`."""
    missing = [name for name in ("chromium", "chromedriver") if shutil.which(name) is None]
    try:
        import selenium  # noqa: F401
    except ImportError:
        missing.append("python3-selenium")
    if not missing:
        return
    print("browser.report: skipped: there is no " + ", ".join(missing) + "; tools/setup browser installs it")
    sys.exit(1 if "browser" in os.environ.get("KREISEL_REQUIRE", "").split() else SKIPPED)


class Browser:
    """A browser with software rendering; a context manager."""

    def __init__(self, *flags):
        from selenium import webdriver
        from selenium.webdriver.chrome.options import Options
        from selenium.webdriver.chrome.service import Service

        options = Options()
        options.binary_location = shutil.which("chromium")
        standard = ["--headless=new", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
                    "--ignore-gpu-blocklist", "--window-size=1280,1400", "--hide-scrollbars", "--no-first-run",
                    "--disable-background-networking", "--disable-component-update"]
        for flag in [*standard, *flags]:
            options.add_argument(flag)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
        self.driver = webdriver.Chrome(options=options, service=Service(shutil.which("chromedriver")))
        self.driver.set_page_load_timeout(240)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.driver.quit()

    def open(self, file):
        self.driver.get("about:blank")
        self.driver.get_log("browser")
        self.driver.get_log("performance")
        self.driver.get("file://" + str(file))

    def run(self, script, *arguments):
        return self.driver.execute_script(script, *arguments)

    def complaints(self):
        """Errors and warnings on the console, policy violations among them, and every request but that of the page."""
        found = [entry["message"] for entry in self.driver.get_log("browser")
                 if entry["level"] in ("SEVERE", "WARNING") and "GPU stall" not in entry["message"]
                 and "GL Driver" not in entry["message"]]
        for entry in self.driver.get_log("performance"):
            message = json.loads(entry["message"])["message"]
            if message["method"] != "Network.requestWillBeSent":
                continue
            url = message["params"]["request"]["url"]
            if not url.startswith(("file:", "data:", "blob:", "about:")):
                found.append("request of " + url)
        return found
