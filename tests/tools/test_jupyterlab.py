"""What a notebook shows, in a real JupyterLab: tables, typeset formulas, pictures, and the page in 3-D in its frame."""

from __future__ import annotations

import json
import os
import socket
import subprocess
import sys
import time
import urllib.request
from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip("selenium")
if find_spec("jupyterlab") is None:  # importing it takes seconds, in every process that collects tests
    pytest.skip("needs JupyterLab: pip install 'symscrew[notebook]'", allow_module_level=True)
from support.browser import start

CELLS = {
    "mechanism": 'import symscrew\nfour_bar = symscrew.load_catalogue("four_bar")\nfour_bar',
    "model": "model = symscrew.derive(four_bar)\nmodel",
    "page": "symscrew.view(model)",
    "paper": "symscrew.formulas(four_bar)",
    "quantity": 'symscrew.Quantities(four_bar).joint_screws("B")',
    "mobility": "symscrew.analyse_mobility(four_bar)",
    "place": 'symscrew.assemble(model, {"A": 0.3})',
    "picture": "symscrew.draw(four_bar)",
}
RUN = """
const done = arguments[arguments.length - 1];
(async () => {
  const app = window.jupyterapp;
  await app.restored;
  const panel = await app.commands.execute('docmanager:open', {path: 'cells.ipynb'});
  await panel.context.ready;
  await panel.sessionContext.ready;
  await app.commands.execute('notebook:run-all-cells');
  return panel.content.widgets.map(cell => cell.model.executionCount);
})().then(done, error => done(String(error)));
"""
OUTPUTS = "return [...document.querySelectorAll('.jp-CodeCell')].map(cell => cell.querySelector('.jp-OutputArea'))"


def waited(what: str, ready: Any, seconds: float = 90) -> None:
    end = time.monotonic() + seconds
    while not ready():
        assert time.monotonic() < end, what
        time.sleep(0.1)


@pytest.fixture
def server(tmp_path: Path) -> Iterator[str]:
    """The address of a JupyterLab whose folder holds the cells, all of them drawn, with nothing of this user's."""
    cells = [
        {"cell_type": "code", "id": name, "metadata": {}, "source": code, "outputs": [], "execution_count": None}
        for name, code in CELLS.items()
    ]
    kernel = {"display_name": "Python 3", "language": "python", "name": "python3"}
    folder, settings = tmp_path / "work", tmp_path / "settings" / "@jupyterlab" / "notebook-extension"
    folder.mkdir()
    settings.mkdir(parents=True)
    (settings / "tracker.jupyterlab-settings").write_text('{"windowingMode": "none"}')
    content = {"cells": cells, "metadata": {"kernelspec": kernel}, "nbformat": 4, "nbformat_minor": 5}
    (folder / "cells.ipynb").write_text(json.dumps(content))
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    own = {f"JUPYTER_{name}_DIR": str(tmp_path / name.lower()) for name in ("CONFIG", "DATA", "RUNTIME")}
    environment = (
        os.environ | own | {"JUPYTERLAB_SETTINGS_DIR": str(tmp_path / "settings"), "IPYTHONDIR": str(tmp_path)}
    )
    command = [
        sys.executable, "-m", "jupyterlab", "--no-browser", "--allow-root", f"--port={port}",
        "--ServerApp.port_retries=0", "--IdentityProvider.token=secret",
        f"--ServerApp.root_dir={folder}", "--LabApp.expose_app_in_browser=True",
        "--LabApp.check_for_updates_class=jupyterlab.NeverCheckForUpdate", "--LabApp.news_url=None",
    ]  # fmt: skip
    with (tmp_path / "log").open("w") as log:
        running = subprocess.Popen(command, env=environment, stdout=log, stderr=subprocess.STDOUT)
    try:

        def answers() -> bool:
            assert running.poll() is None, (tmp_path / "log").read_text()[-2000:]
            try:
                return urllib.request.urlopen(f"http://127.0.0.1:{port}/api?token=secret", timeout=5).status == 200
            except OSError:
                return False

        waited("JupyterLab did not start", answers)
        yield f"http://127.0.0.1:{port}/lab/tree/cells.ipynb?token=secret"
    finally:
        running.terminate()
        running.wait(20)


def test_a_notebook_shows_what_it_is_handed(server: str, tmp_path: Path) -> None:
    driver = start(tmp_path / "profile")
    try:
        driver.set_window_size(1360, 900)
        driver.set_script_timeout(180)
        driver.get(server)
        waited("JupyterLab was not shown", lambda: driver.execute_script("return !!window.jupyterapp"))
        assert driver.execute_async_script(RUN) == list(range(1, len(CELLS) + 1))
        found = dict(zip(CELLS, driver.execute_script(OUTPUTS), strict=True))
        waited("formulas were not typeset", lambda: _count(found["paper"], "mjx-container") > 20)
        waited("a formula was not typeset", lambda: _count(found["quantity"], "mjx-container") == 1)
        assert not driver.find_elements("css selector", "[data-mjx-error], mjx-merror"), "a formula was not understood"
        assert not driver.find_elements(
            "css selector", ".jp-OutputArea [data-mime-type*=error], [data-mime-type*=stderr]"
        )
        assert _count(found["paper"], "h4") >= 3, "a heading for every part"
        for name, rows in {"mechanism": 3, "model": 20, "place": 3}.items():
            assert _count(found[name], "table.symscrew tbody tr") >= rows, name
        assert "mobility 1" in found["mobility"].text
        assert _count(found["picture"], "img, svg, iframe")
        for name, output in found.items():
            assert output.size["height"] > 20 and output.size["width"] > 400, name
        driver.execute_script("arguments[0].scrollIntoView()", found["page"])
        driver.save_screenshot(str(tmp_path / "page.png"))
        driver.execute_script("arguments[0].scrollIntoView()", found["paper"])
        driver.save_screenshot(str(tmp_path / "paper.png"))
        _page(driver, found["page"])
    finally:
        driver.quit()


def _count(output: Any, selector: str) -> int:
    return len(output.find_elements("css selector", selector))


def _page(driver: Any, output: Any) -> None:
    """The page starts in its frame, and can reach neither the notebook nor the network."""
    driver.switch_to.frame(output.find_element("css selector", "iframe"))
    ready = "return document.documentElement.dataset.ready === 'yes'"
    waited("the page did not start in its frame", lambda: driver.execute_script(ready))
    assert "four_bar" in driver.find_element("css selector", "h1").text
    reach = "try { return parent.document.body.textContent; } catch (e) { return 'denied'; }"
    assert driver.execute_script(reach) == "denied"
    assert driver.execute_script("return performance.getEntriesByType('resource').length") == 0
