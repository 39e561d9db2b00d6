"""What a notebook shows of a mechanism, in a real browser: the page works in its frame and reaches nothing outside."""

from __future__ import annotations

import time
from pathlib import Path

import pytest
from support.model_states import model

pytest.importorskip("selenium")
from support.browser import start

from symscrew.display import Page
from symscrew.paper_formulas import paper_formulas


def test_the_page_works_in_the_frame_of_a_cell(tmp_path: Path) -> None:
    four_bar = model("four_bar")
    cells = [Page(four_bar)._repr_html_(), four_bar._repr_html_(), four_bar.mechanism._repr_html_()]
    file = tmp_path / "cells.html"
    file.write_text(f"<!doctype html><html><body><p id='secret'>here</p>{''.join(cells)}</body></html>")
    driver = start(tmp_path / "profile")
    try:
        driver.get(file.as_uri())
        assert len(driver.find_elements("css selector", "table.symscrew")) == 2
        driver.switch_to.frame(driver.find_element("css selector", "iframe"))
        end = time.monotonic() + 60
        while driver.execute_script("return document.documentElement.dataset.ready") != "yes":
            assert time.monotonic() < end, "the page did not start in its frame"
            time.sleep(0.05)
        assert "four_bar" in driver.find_element("css selector", "h1").text
        reached = driver.execute_script(
            "try { return parent.document.body.textContent; } catch (e) { return 'denied'; }"
        )
        assert reached == "denied"
        assert driver.execute_script("return performance.getEntriesByType('resource').length") == 0
    finally:
        driver.quit()
    assert paper_formulas(four_bar.mechanism)._repr_latex_().count("$$") == 2
