"""Reports in a real browser without a screen: whole on wide and narrow screens and on paper, formulas drawn."""

from __future__ import annotations

import base64
import re
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from support.model_states import model

pytest.importorskip("selenium", reason='needs selenium: pip install ".[browser]"')
from support.browser import start

from symscrew.reporting.blocks import Document, write_document
from symscrew.reporting.sections import document

pytestmark = pytest.mark.slow
NAMES = ("ur5", "three_ups_upu_s")  # an open chain; limbs with loops and wide tables
PAPER = round(178 / 25.4 * 96)  # px of A4 between the margins of style.css


@pytest.fixture(scope="session")  # tests of one mechanism stand together, not those of one file
def driver(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Any]:
    made = start(tmp_path_factory.mktemp("profile"))
    yield made
    made.quit()


@pytest.fixture(scope="session")
def reports(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], tuple[Document, Path]]:
    folder, known = tmp_path_factory.mktemp("reports"), dict[str, tuple[Document, Path]]()

    def report(name: str) -> tuple[Document, Path]:
        if name not in known:
            made = document(model(name))
            known[name] = made, write_document(made, folder / f"{name}.html")[0]
        return known[name]

    return report


def width(driver: Any, pixels: int) -> None:
    size = {"width": pixels, "height": 900, "deviceScaleFactor": 1, "mobile": False}
    driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", size)


@pytest.mark.parametrize("name", NAMES)
def test_report_is_whole_on_screen(driver, reports, name: str) -> None:
    made, file = reports(name)
    driver.get(file.as_uri())
    assert driver.execute_script("return performance.getEntriesByType('resource').length") == 0
    assert [entry for entry in driver.get_log("browser") if entry["level"] == "SEVERE"] == []
    titles = driver.execute_script(
        "return Array.from(document.querySelectorAll('h1, h2, h3')).filter((x) => x.offsetHeight > 0)"
        ".map((x) => x.textContent)"
    )
    assert titles == [made.title, *(section.title for section in made.sections)]
    for pixels in (1200, 760, 390):
        width(driver, pixels)
        assert driver.execute_script("return document.documentElement.scrollWidth") <= pixels
    pictures = driver.execute_script(
        "return Array.from(document.querySelectorAll('figure > svg, figure > img')).map((x) => {"
        " const b = x.getBoundingClientRect(); return [b.width, b.height, x.complete ?? true, x.naturalWidth ?? 1] })"
    )
    assert len(pictures) == sum(type(b).__name__ == "Picture" for s in made.sections for b in s.blocks)
    assert all(wide > 100 and high > 50 and complete and pixels for wide, high, complete, pixels in pictures)


@pytest.mark.parametrize("name", NAMES)
def test_formulas_are_drawn(driver, reports, name: str) -> None:
    driver.get(reports(name)[1].as_uri())
    width(driver, 1200)
    sizes = driver.execute_script(
        "return Array.from(document.querySelectorAll('math')).map((x) => { const b = x.getBoundingClientRect();"
        " return [b.width, b.height] })"
    )
    assert len(sizes) > 10 and all(wide > 3 and high > 3 for wide, high in sizes)
    text = driver.execute_script("return document.body.innerText")
    assert not re.search(r"\\[a-z]+|\$|\^\{", text)
    fractions = driver.execute_script("return Array.from(document.querySelectorAll('mfrac'), (x) => x.offsetHeight)")
    line = driver.execute_script("return parseFloat(getComputedStyle(document.body).fontSize)")
    assert all(high is None or high > line for high in fractions)


@pytest.mark.parametrize("name", NAMES)
def test_report_fits_the_paper(driver, reports, name: str) -> None:
    """In print no line is wider than the page, or the browser would shrink all of it."""
    driver.get(reports(name)[1].as_uri())
    driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": "print"})
    width(driver, PAPER)
    try:
        assert driver.execute_script("return document.documentElement.scrollWidth") <= PAPER
        cut = driver.execute_script(
            "return Array.from(document.querySelectorAll('table, li, p, figure, math')).filter((x) =>"
            " x.getBoundingClientRect().right > innerWidth + 0.5).map((x) => x.outerHTML.slice(0, 200))"
        )
        assert cut == []
        page = driver.execute_script("return 297 / 25.4 * 96 - 2 * 18 / 25.4 * 96")
        tall = driver.execute_script(
            "return Array.from(document.querySelectorAll('.whole, figure'), (x) => x.offsetHeight)"
        )
        assert max(tall) < page  # what is to stay on one page fits on one
    finally:
        driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": ""})
    printed = driver.execute_cdp_cmd("Page.printToPDF", {"preferCSSPageSize": True})
    sheets = re.findall(rb"/Type\s*/Page\b", base64.b64decode(printed["data"]))
    assert 3 <= len(sheets) <= 13  # the seed's, with every condition of its limbs
