"""The page of `symscrew view` in a real browser without a screen: clicks, keys, scrubbing, labels, narrow windows."""

from __future__ import annotations

import io
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from support.model_states import model
from support.recorded_motion import recorded

from symscrew.display import make_page, page_modes
from symscrew.display.view.motion_file import read_motion
from symscrew.display.view.page import write_made

selenium = pytest.importorskip("selenium", reason='needs selenium: pip install ".[browser]"')
from PIL import Image  # noqa: E402
from selenium import webdriver  # noqa: E402
from selenium.webdriver.common.action_chains import ActionChains  # noqa: E402
from selenium.webdriver.common.actions.wheel_input import ScrollOrigin  # noqa: E402
from selenium.webdriver.common.by import By  # noqa: E402
from selenium.webdriver.common.keys import Keys  # noqa: E402
from support.browser import start  # noqa: E402

Array = np.ndarray
LAYERS = ("screws", "constraints", "freedoms", "momentum", "reactions", "drives", "masses", "axes", "points", "joints")


class Page:
    """A page in a browser, by what a person sees and touches."""

    def __init__(self, driver: webdriver.Chrome, file: Path, size: tuple[int, int] = (1360, 860)) -> None:
        self.driver = driver
        driver.set_window_size(*size)
        driver.get(file.as_uri())
        self.wait(lambda: self.script("return document.documentElement.dataset.ready") == "yes")
        self.first = [layer for layer in LAYERS if self.find(f"#show-{layer}").is_selected()]
        for layer in {"constraints", "freedoms"} & set(self.first):  # each test says which screws it looks at
            self.toggle(layer)
        self.settle()

    def script(self, text: str, *arguments: Any) -> Any:
        return self.driver.execute_script(text, *arguments)

    def find(self, selector: str) -> Any:
        return self.driver.find_element(By.CSS_SELECTOR, selector)

    def text(self, selector: str) -> str:
        return self.find(selector).text

    def wait(self, condition: Callable[[], Any], seconds: float = 60.0) -> None:
        end = time.monotonic() + seconds
        while not condition():
            assert time.monotonic() < end, "the page did not get there"
            time.sleep(0.03)

    def settle(self) -> None:
        """Wait until two more frames have been drawn."""
        self.driver.execute_async_script("requestAnimationFrame(() => requestAnimationFrame(arguments[0]))")

    def picture(self) -> Array:
        self.script("document.activeElement.blur()")  # without the frame of what has the focus
        self.settle()
        return np.asarray(Image.open(io.BytesIO(self.find(".picture").screenshot_as_png)).convert("RGB")).astype(int)

    def value(self, row: str) -> float:
        return float(self.driver.find_element(By.XPATH, f"//th[.='{row}']/following-sibling::td[1]").text)

    def slide(self, selector: str, part: float) -> None:
        """Press on a slider at a part of its length."""
        element = self.find(selector)
        self.script("arguments[0].scrollIntoView({ block: 'nearest' })", element)
        inside = element.size["width"] - 16  # the thumb's middle stays inside
        ActionChains(self.driver).move_to_element_with_offset(
            element, round((part - 0.5) * inside), 0
        ).click().perform()
        self.settle()

    def toggle(self, layer: str) -> None:
        box = self.find(f"#show-{layer}")
        self.script("arguments[0].scrollIntoView({ block: 'nearest' })", box)
        box.click()

    def labels(self) -> list[dict[str, Any]]:
        return self.script(
            "return Array.from(document.querySelectorAll('.label')).filter((x) => !x.hidden).map((x) => {"
            " const b = x.getBoundingClientRect();"
            " return { text: x.textContent, left: b.left, right: b.right, top: b.top, bottom: b.bottom,"
            " cut: x.scrollWidth > Math.ceil(b.width) }; })"
        )


@pytest.fixture(scope="module")
def browser(tmp_path_factory: pytest.TempPathFactory) -> Iterator[webdriver.Chrome]:
    made = start(tmp_path_factory.mktemp("profile"))
    yield made
    made.quit()


@pytest.fixture
def driver(browser: webdriver.Chrome) -> Iterator[webdriver.Chrome]:
    """Whatever a test does in its page: nothing is asked of a network, and the browser has nothing to complain of."""
    browser.get_log("browser")  # of the test before, which may have failed
    yield browser
    assert browser.execute_script("return performance.getEntriesByType('resource').length") == 0
    assert [entry for entry in browser.get_log("browser") if entry["level"] == "SEVERE"] == []
    assert not browser.find_element(By.CSS_SELECTOR, "#trouble").is_displayed()


@pytest.fixture(scope="module")
def files(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], Path]:
    folder = tmp_path_factory.mktemp("pages")

    def file(name: str) -> Path:
        path = folder / f"{name}.html"
        if not path.exists():
            if name == "limited":
                write_made(make_page(model("delta"), limits={"arm1_R": (-0.4, 0.5)}), path)
            elif name == "run":
                np.savez(folder / "run.npz", **recorded())
                write_made(make_page(model("three_ups_upu_s"), read_motion(folder / "run.npz")), path)
            elif name == "modes":
                found = model("four_bar")
                write_made(make_page(found, modes=page_modes(found)), path)
            else:
                write_made(make_page(model(name)), path)
        return path

    return file


def differing(a: Array, b: Array) -> int:
    """How many pixels of two pictures differ visibly."""
    return int((np.abs(a - b).max(axis=2) > 24).sum())


def test_screws_explain_the_mechanism_from_the_first_moment(driver, files) -> None:
    page = Page(driver, files("three_ups_upu_s"))
    assert page.first == ["constraints", "freedoms", "axes", "points"]
    page.toggle("constraints")
    page.settle()
    assert page.find("#listing").get_attribute("open") is not None
    assert "force along (0, 1, 0) through (0.4, 0, 0)" in page.text("#listing")


def test_opens_without_errors_or_requests(driver, files) -> None:
    """Mechanisms that no other test here opens, and all of them in one browser."""
    for name in ("ur5", "planar_3rrr"):
        page = Page(driver, files(name))
        assert page.picture().std() > 8, name
        assert page.script("return performance.getEntriesByType('resource').length") == 0, name


def test_play_pause_and_scrub_a_recorded_motion(driver, files) -> None:
    page, arrays = Page(driver, files("run")), recorded()
    before = page.picture()
    page.find("#play").click()
    assert page.find("#play").accessible_name == "Pause"
    page.wait(lambda: float(page.text("#clock").split()[0]) > 0.3)
    page.find("#play").click()
    stopped = page.text("#clock")
    assert differing(before, page.picture()) > 500
    time.sleep(0.3)
    assert page.text("#clock") == stopped and page.find("#play").accessible_name == "Play"
    for part in (0.75, 0.25):
        page.slide("#time", part)
        now = float(page.find("#time").get_attribute("value"))
        assert abs(now - 2.0 * part) < 0.05 and page.text("#clock").startswith(f"{now:.2f} / 2.00")
        for k, label in enumerate(arrays["u_labels"]):
            expected = np.interp(now, arrays["t"], arrays["u"][:, k])
            assert abs(page.value(f"drive {label}") - expected) < 1e-3 * np.abs(arrays["u"]).max()
    page.find("#play").click()  # runs on from here and stops at the end
    page.find("#speed").send_keys("4")
    page.wait(lambda: page.find("#play").accessible_name == "Play")
    assert page.text("#clock") == "2.00 / 2.00 s"


def test_slider_solves_the_loops_in_the_page(driver, files) -> None:
    page, found = Page(driver, files("three_ups_upu_s")), model("three_ups_upu_s")
    before = page.picture()
    page.slide("#y1", 0.6)
    assert differing(before, page.picture()) > 2000
    angle = float(page.find("#y1").get_attribute("value"))
    assert page.text("output[for=y1]") == f"{np.degrees(angle):.1f}°" and angle > 0.1
    (q,), status = found("assemble", np.array([0.0, np.sin(angle / 2)]), found.system.reference)
    (energy,), _ = found("energy", q, np.zeros(15))
    assert status == 0 and abs(page.value("potential energy") - energy[1]) < 1e-3 * energy[1]
    (u, _), _ = found("joint_reactions", q, np.zeros(15), np.zeros(15))
    assert abs(page.value("drive limb3_P") - u[2]) < 1e-3 * np.abs(u).max()
    assert page.value("opening of the loops") < 1e-12
    page.find("#y1").send_keys(Keys.ARROW_LEFT)
    assert float(page.find("#y1").get_attribute("value")) < angle


def test_the_chooser_of_modes_goes_between_them_and_sliders_go_on_from_there(driver, files) -> None:
    page, found = Page(driver, files("modes")), model("four_bar")
    before = page.picture()
    choice = page.find("#mode")
    assert choice.accessible_name == "Assembly mode"
    choice.send_keys("-1")
    page.settle()
    assert choice.get_attribute("value") == "-1" and differing(before, page.picture()) > 1000
    q = page_modes(found)["-1"]
    (energy,), _ = found("energy", q, np.zeros(len(q)))
    assert abs(page.value("potential energy") - energy[1]) < 1e-3 * abs(energy[1])
    page.slide("#y0", 0.55)
    angle = float(page.find("#y0").get_attribute("value"))
    (near,), status = found("assemble", np.array([angle]), q)
    (energy,), _ = found("energy", near, np.zeros(len(q)))
    assert status == 0 and abs(page.value("potential energy") - energy[1]) < 1e-3 * abs(energy[1])


def test_slider_that_cannot_be_reached_says_so_and_stays(driver, files) -> None:
    page = Page(driver, files("delta"))
    page.slide("#y2", 0.0)  # stretched out downwards
    shown = [page.text(f"output[for=y{k}]") for k in range(3)]
    before = page.picture()
    page.slide("#y0", 1.0)
    complaints = [p.text for p in driver.find_elements(By.CSS_SELECTOR, ".problem") if p.is_displayed()]
    assert complaints == ["The loops cannot be closed there; the last pose stays."]
    assert [page.text(f"output[for=y{k}]") for k in range(3)] == shown and differing(before, page.picture()) == 0
    page.slide("#y2", 0.5)
    assert not [p for p in driver.find_elements(By.CSS_SELECTOR, ".problem") if p.is_displayed()]


def test_every_layer_can_be_shown_and_hidden(driver, files) -> None:
    page = Page(driver, files("run"))
    page.slide("#time", 0.4)
    with_or_without = page.picture()
    for layer in LAYERS:
        page.toggle(layer)
        assert differing(with_or_without, page.picture()) > 60, layer
        page.toggle(layer)
        assert differing(with_or_without, page.picture()) == 0, layer


@pytest.mark.parametrize("case", [("run", (1360, 860)), ("stewart_6ups", (430, 860))])
def test_labels_are_whole_and_apart(driver, files, case: tuple[str, tuple[int, int]]) -> None:
    name, size = case
    page = Page(driver, files(name), size)
    for layer in LAYERS:
        if layer not in ("points", "axes"):  # shown from the start
            page.toggle(layer)
    page.slide("#time", 0.4)
    labels, frame = page.labels(), page.find(".picture").rect
    assert len(labels) >= 5
    for k, a in enumerate(labels):
        assert not a["cut"] and a["left"] >= frame["x"] and a["right"] <= frame["x"] + frame["width"]
        assert a["top"] >= frame["y"] and a["bottom"] <= frame["y"] + frame["height"]
        for b in labels[:k]:
            apart = (
                a["right"] <= b["left"] or b["right"] <= a["left"] or a["bottom"] <= b["top"] or b["bottom"] <= a["top"]
            )
            assert apart, (a["text"], b["text"])


def test_mouse_and_keys_turn_move_and_zoom(driver, files) -> None:
    page = Page(driver, files("four_bar"))
    page.find("#show-joints").click()
    first = page.picture()
    canvas = page.find("canvas")
    actions: dict[str, Callable[[ActionChains], ActionChains]] = {
        "drag": lambda a: a.drag_and_drop_by_offset(canvas, 120, 60),
        "wheel": lambda a: a.scroll_from_origin(ScrollOrigin.from_element(canvas), 0, -300),
        "arrow": lambda a: a.send_keys(Keys.ARROW_LEFT),
        "pan": lambda a: a.key_down(Keys.SHIFT).send_keys(Keys.ARROW_UP).key_up(Keys.SHIFT),
        "plus": lambda a: a.send_keys("+"),
    }
    for name, action in actions.items():
        before = page.picture()
        page.script("arguments[0].focus()", canvas)
        action(ActionChains(driver)).perform()
        assert differing(before, page.picture()) > 500, name
    page.script("arguments[0].focus()", canvas)
    ActionChains(driver).send_keys(Keys.HOME).perform()
    assert differing(first, page.picture()) == 0
    page.driver.find_element(By.XPATH, "//button[.='Side']").click()
    assert differing(first, page.picture()) > 500


def test_warning_where_the_margin_shrinks(driver, files) -> None:
    page = Page(driver, files("sarrus"))
    chip = page.find("#margin")
    assert chip.get_attribute("data-level") == "good" and chip.text.startswith("✓")
    blue = page.picture()
    page.slide("#y0", 0.99)
    assert chip.get_attribute("data-level") != "good" and chip.text[0] in "▲✕"
    yellow = page.picture()

    def warm(picture: Array) -> int:
        return int(((picture[..., 0] > 150) & (picture[..., 2] < 80)).sum())

    def cold(picture: Array) -> int:
        return int(((picture[..., 2] > 150) & (picture[..., 0] < 90)).sum())

    assert cold(blue) > 1000 and cold(yellow) < 0.1 * cold(blue) and warm(yellow) > warm(blue)


def test_themes_differ_and_keep_the_motion(driver, files) -> None:
    page = Page(driver, files("run"))
    page.slide("#time", 0.5)
    clock, light = page.text("#clock"), page.picture()
    press = "document.querySelector('#theme').click()"  # a pointer over the button would change its frame
    page.script(press)
    dark = page.picture()
    assert light.mean() > 180 > 90 > dark.mean() and page.text("#clock") == clock
    page.script(press)
    assert differing(light, page.picture()) == 0


def test_narrow_windows_keep_everything_inside(driver, files) -> None:
    page = Page(driver, files("stewart_6ups"), (380, 900))
    for width in (380, 620, 900):
        driver.set_window_size(width, 900)
        page.settle()
        keeps_everything_inside(driver, page)


def keeps_everything_inside(driver: webdriver.Chrome, page: Page) -> None:
    inner = page.script("return innerWidth")
    assert page.script("return document.documentElement.scrollWidth") <= inner
    outside = page.script(
        "return Array.from(document.querySelectorAll('button, input, select, label, summary, output, h1, td, th'))"
        ".filter((x) => x.offsetParent && (x.getBoundingClientRect().right > innerWidth + 0.5"
        " || x.getBoundingClientRect().left < -0.5)).map((x) => x.outerHTML)"
    )
    assert outside == []
    frame = page.find(".picture").rect
    assert frame["height"] > 250 and frame["width"] > 0.55 * inner


def test_every_control_has_a_name_and_is_reached_by_tab(driver, files) -> None:
    page = Page(driver, files("three_ups_upu_s"))
    kinds = ("button", "input:not(:disabled)", "select", "summary", "canvas")
    wanted = driver.find_elements(By.CSS_SELECTOR, ", ".join(f"{kind}:not([hidden] *)" for kind in kinds))
    assert len(wanted) > 20
    assert [w.get_attribute("outerHTML") for w in wanted if not w.accessible_name] == []
    reached = set()
    for _ in range(len(wanted) + 5):
        ActionChains(driver).send_keys(Keys.TAB).perform()
        reached.add(driver.switch_to.active_element.id)
    assert {w.id for w in wanted} <= reached
    page.find("#show-drives").send_keys(Keys.SPACE)
    assert page.find("#show-drives").is_selected()


def test_limits_of_joints_are_drawn_and_kept(driver, files) -> None:
    page, found = Page(driver, files("limited")), model("delta")
    assert page.find("#show-limits").is_selected() and "arm1_R: -22.9° … 28.6°" in [x["text"] for x in page.labels()]
    page.slide("#y2", 1.0)
    y = [float(page.find(f"#y{k}").get_attribute("value")) for k in range(3)]
    (q,), status = found("assemble", np.array(y), found.system.reference)
    labels = found.programs["joint_displacements"].outputs[0].labels
    angle = found("joint_displacements", q)[0][0][labels.index("arm1_R")]
    assert status == 0 and -0.4 - 1e-6 < angle < 0.5 + 1e-6 and min(angle + 0.4, 0.5 - angle) < 0.05
    ends = [float(page.find("#y2").get_attribute(end)) for end in ("min", "max")]
    page.toggle("limits")
    page.slide("#y0", 1.0)
    page.slide("#y1", 1.0)
    complaints = [p.text for p in driver.find_elements(By.CSS_SELECTOR, ".problem") if p.is_displayed()]
    assert all("leave its limits" in text or "cannot be closed" in text for text in complaints) and ends[0] < y[2]


def test_a_body_is_chosen_by_a_click(driver, files) -> None:
    page = Page(driver, files("run"))
    page.slide("#time", 0.4)
    before, text = page.picture(), page.text("#body")
    assert "Click a body" in text
    c1 = next(label for label in page.labels() if label["text"] == "C1")
    canvas = page.find("canvas").rect
    x, y = c1["right"] + 40 - canvas["x"] - canvas["width"] / 2, c1["bottom"] - 4 - canvas["y"] - canvas["height"] / 2
    ActionChains(driver).move_to_element_with_offset(page.find("canvas"), round(x), round(y)).click().perform()
    page.settle()
    text = page.text("#body")
    assert differing(before, page.picture()) > 300 and "angular velocity" in text and "kg m/s" in text
    chosen = text.splitlines()[2] if text.splitlines()[1] == "" else text.splitlines()[1]
    assert chosen in {
        body["name"] for body in page.script("return JSON.parse(document.getElementById('data').textContent).bodies")
    }


def test_curves_and_the_scrubber_move_together(driver, files) -> None:
    page, arrays = Page(driver, files("run")), recorded()
    where = "return Number(document.querySelector('#plots .cursor').getAttribute('x1'))"
    page.slide("#time", 0.1)
    early = page.script(where)
    page.slide("#time", 0.9)
    assert page.script(where) > early + 150
    plot = page.find("#plots svg")
    page.script("arguments[0].scrollIntoView({ block: 'nearest' })", plot)
    ActionChains(driver).move_to_element(plot).click().perform()
    now = float(page.find("#time").get_attribute("value"))
    assert np.abs(arrays["t"] - now).min() < 1e-12 and 0.7 < now < 1.3
    assert len(driver.find_elements(By.CSS_SELECTOR, "#plots .curve")) == arrays["u"].shape[1]
    k = int(np.abs(arrays["t"] - now).argmin())  # a recorded time, and its very numbers
    for j, label in enumerate(arrays["u_labels"]):
        assert page.value(f"drive {label}") == pytest.approx(arrays["u"][k, j], rel=5e-4, abs=1e-9)


def test_an_embedded_page_is_picture_and_motion_alone(driver, files) -> None:
    driver.get("about:blank")
    driver.get(f"{files('four_bar').as_uri()}#embed")
    end = time.monotonic() + 60
    while driver.execute_script("return document.documentElement.dataset.ready") != "yes":
        assert time.monotonic() < end
    assert not driver.find_element(By.CSS_SELECTOR, "aside").is_displayed()
    assert driver.find_element(By.CSS_SELECTOR, "#play").is_displayed()


def test_a_picture_has_its_labels_and_a_film_ends_by_itself(driver, files) -> None:
    page = Page(driver, files("run"))
    page.script(
        "Records.kept = []; HTMLAnchorElement.prototype.click = function () { Records.kept.push(this.download); }"
    )
    page.find("#still").click()
    page.wait(lambda: page.script("return Records.kept") == ["three_ups_upu_s.png"])
    page.find("#speed").send_keys("4")
    page.find("#film").click()
    page.wait(lambda: page.text("#film") == "Film" and len(page.script("return Records.kept")) == 2)
    assert page.script("return Records.kept")[1].endswith((".mp4", ".webm"))


def test_says_what_is_missing_without_webgl(browser, files) -> None:
    """As a browser without it answers: no context."""
    absent = {"source": "HTMLCanvasElement.prototype.getContext = () => null"}
    added = browser.execute_cdp_cmd("Page.addScriptToEvaluateOnNewDocument", absent)
    browser.get(files("four_bar").as_uri())
    browser.execute_cdp_cmd("Page.removeScriptToEvaluateOnNewDocument", added)
    assert "WebGL" in browser.find_element(By.ID, "trouble").text
