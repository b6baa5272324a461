"""The page in headless Chromium: python browser.py FOLDER PROGRAM OUT.

Uses it as a reader would, and compares its numbers with those of the program. Whatever stands on the console, and every request beyond the files of
the page, is a fault.
"""

import functools
import http.server
import json
import re
import subprocess
import threading
import tomllib
from pathlib import Path

from playwright.sync_api import Page, expect, sync_playwright

from common import DROP, FOLDER, LONG, OUT, PROGRAM, again, download, settled, text
from handed_out import address, damaged_address, downloads, older_answers, own_scene
from tables import farthest
from typed import listed_once, mistakes, no_numbers, together, units

# Below a folder of the server, as it may stand anywhere.
PLACE = "/some/where"
# Relative to the largest number of a column: the program rounds products and sums at once where the processor can, a browser does not.
SAME = 1e-12
# The same of a body that may tilt, which turns the last digits into motion.
TILTS = 1e-11
# The same of bodies from cells, whose break points are found by searches.
MESHED = 1e-10
ROOT = Path(__file__).resolve().parents[3]


class Files(http.server.SimpleHTTPRequestHandler):
    """The files of the page, below PLACE."""

    def translate_path(self, path: str) -> str:
        return super().translate_path(path.removeprefix(PLACE))

    def log_message(self, *_: object) -> None:
        """Says nothing."""


def served() -> str:
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Files, directory=str(FOLDER)))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    return f"http://127.0.0.1:{server.server_address[1]}{PLACE}/"


def by_the_program(scene: str, folder: Path, files: dict[str, bytes] | None = None) -> Path:
    """The folder that the program writes for the same text, with files beside it."""
    folder.mkdir(parents=True, exist_ok=True)
    for name, content in (files or {}).items():
        (folder / name).write_bytes(content)
    (folder / "scene.toml").write_text(scene, encoding="utf-8")
    done = subprocess.run([PROGRAM, "run", folder / "scene.toml", "-q", "-o", folder / "out"], stdin=subprocess.DEVNULL, check=False)
    assert done.returncode == 0, f"the program ended with {done.returncode}"
    return folder / "out"


def numbers(page: Page, timed: bool = True) -> None:
    """A slider is moved: the numbers are those of the program for the text that stands there then."""
    page.locator("#field-accuracy").select_option("1e-4")
    settled(page)
    for key, presses in [("load.force", 3), ("contact.friction", 5), ("body1.geometry.shoe-block.half_angle", 2)]:
        before = text(page)
        slider = page.locator(f"[id='field-{key}']").locator("xpath=../../input[@type='range']")
        slider.focus()
        for _ in range(presses):
            page.keyboard.press("ArrowLeft")
        assert text(page) != before, f"the slider of {key} changes nothing"
        settled(page)
        moments = {phase: page.locator("#status").get_attribute(f"data-{phase}") for phase in ("check", "pressure", "coarse", "curves", "fine")}
        if timed:
            print(f"  {key}: " + ", ".join(f"{phase} after {value} ms" for phase, value in moments.items() if value))
    scene = text(page)
    assert tomllib.loads(scene)["accuracy"] == 1e-4
    assert "# A block shoe on a turning drum" in scene, "comments stay"
    assert tomllib.loads(scene)["body1"]["geometry"]["shoe-block"]["half_angle"] != "30 deg", "the angle moved"
    theirs = by_the_program(scene, OUT / "drum")
    for table in ("contact.csv", "profile.csv"):
        difference, name = farthest(download(page, table), (theirs / table).read_text(encoding="utf-8"))
        print(f"  {table}: as the program's within {difference:.1e} ({name})")
        assert difference <= SAME, table
    ours, summary = json.loads(download(page, "summary.json")), json.loads((theirs / "summary.json").read_text(encoding="utf-8"))
    assert ours["verdict"] == summary["verdict"] == page.locator("#verdict").inner_text().replace("\u2212", "-"), "another verdict"
    shown = float(page.locator("#glance div", has_text="largest pressure").locator("data").first.get_attribute("value") or "nan")
    assert abs(shown - summary["pressure"]["p_max_MPa"]) <= SAME * shown
    page.keyboard.press("Escape")


def same_elsewhere(page: Page) -> None:
    """Three other scenes have the program's digits; a punch that may tilt turns the last of them into motion."""
    for scene, table, bound in [("annular-punch", "profile.csv", SAME), ("pivoted-shoe", "contact.csv", SAME), ("translating-punch", "profile.csv", TILTS)]:
        page.locator("#scene").select_option(scene)
        settled(page)
        theirs = by_the_program(text(page), OUT / scene)
        difference, name = farthest(download(page, table), (theirs / table).read_text(encoding="utf-8"))
        page.keyboard.press("Escape")
        print(f"  {scene}, {table}: as the program's within {difference:.1e} ({name})")
        assert difference <= bound, scene


def files_of_the_reader(page: Page) -> None:
    """A mesh and a measured profile that the scene names are chosen or dropped, and compute as beside the program; a file that is not there is told."""
    mesh = (ROOT / "data/meshes/lining.msh").read_bytes()
    scene = (ROOT / "data/meshes/lining.toml").read_text(encoding="utf-8").replace("accuracy = 1e-5", "accuracy = 1e-2")
    page.locator("#text").fill(scene)
    expect(page.locator("#fault")).to_contain_text("lining.msh", timeout=LONG)
    expect(page.locator("#fault")).to_contain_text(f"line {next(n for n, line in enumerate(scene.splitlines(), 1) if line.startswith('file'))}, column")
    page.locator("#choice").set_input_files({"name": "lining.msh", "mimeType": "", "buffer": mesh})
    expect(page.locator("#kept")).to_contain_text("lining.msh")
    settled(page)
    theirs = by_the_program(scene, OUT / "lining", {"lining.msh": mesh})
    difference, name = farthest(download(page, "profile.csv"), (theirs / "profile.csv").read_text(encoding="utf-8"))
    page.keyboard.press("Escape")
    print(f"  a mesh: as the program's within {difference:.1e} ({name})")
    assert difference <= MESHED
    page.locator("#choice").set_input_files({"name": "lining.msh", "mimeType": "", "buffer": mesh[: len(mesh) // 2]})
    expect(page.locator("#fault")).to_contain_text("line", timeout=LONG)
    page.get_by_role("button", name="take lining.msh away").click()
    expect(page.locator("#fault")).to_contain_text("has no file", timeout=LONG)
    page.locator("#scene").select_option("translating-punch")
    gap = "s_mm;gap_um\n-30;2,1\n-20;0,9\n-10;0,2\n0;0\n10;0,3\n20;1,0\n30;2,0\n"
    measured = text(page).replace("gap = 0", 'gap = "profile.csv"').replace('["pressure", "shape"]', '["contact"]').replace("accuracy = 1e-6", "accuracy = 1e-2")
    page.locator("#text").fill(measured)
    expect(page.locator("#fault")).to_contain_text("profile.csv", timeout=LONG)
    page.evaluate(DROP, ["profile.csv", gap])
    settled(page)
    assert page.locator("#fault").is_hidden()
    expect(page.locator("#verdict")).to_contain_text("The bodies touch")
    page.reload()
    settled(page)
    expect(page.locator("#kept")).to_contain_text("profile.csv")
    page.get_by_role("button", name="take profile.csv away").click()
    page.locator("#scene").select_option("drum-brake-block")
    settled(page)


def compare(page: Page) -> None:
    """A pinned answer stays beside the next one."""
    page.locator("#pin").click()
    page.locator("[id='field-wear.b.0'], [id='field-wear.b']").first.fill("1")
    page.keyboard.press("Enter")
    settled(page)
    expect(page.locator("#pinned")).to_contain_text("wear.b 0.5 \u2192 1")
    expect(page.locator("#glance .change").first).to_contain_text("%")
    expect(page.locator("figure[data-chart=pressure] .u-legend")).to_contain_text("pinned")
    page.screenshot(path=OUT / "pinned.png", full_page=True)
    page.locator("#pin").click()
    expect(page.locator("#pinned")).to_be_hidden()


def in_time(page: Page) -> None:
    """A run in time plays."""
    page.locator("#scene").select_option("punch-wear")
    page.locator("#field-accuracy").select_option("1e-2")
    settled(page)
    expect(page.locator("#run-part")).to_be_visible()
    before = page.locator("#moment").inner_text()
    page.locator("#play").click()
    expect(page.locator("#play")).to_have_text("Pause")
    expect(page.locator("#moment")).not_to_have_text(before)
    page.screenshot(path=OUT / "in-time.png", full_page=True)
    page.locator("#play").click()
    page.locator("#step").focus()
    page.keyboard.press("End")
    assert page.locator("#moment").inner_text() == before


NAMELESS = """() => [...document.querySelectorAll("input, select, textarea, button, summary, [role=img]")].filter(node => {
  const words = node.getAttribute("aria-label") || [...(node.labels ?? [])].map(label => label.textContent).join("") ||
    (["BUTTON", "SUMMARY"].includes(node.tagName) ? node.textContent : "");
  return !words.trim();
}).map(node => node.outerHTML.slice(0, 120))"""

# Headings that leave out a level, places to go to by keyboard that leave the order of the page, and names that two elements have.
DISORDERED = """() => {
  const levels = [...document.querySelectorAll("h1, h2, h3, h4")].map(node => Number(node.localName[1]));
  const skipped = levels.filter((level, place) => level > (levels[place - 1] ?? 0) + 1).map(level => `a heading of level ${level}`);
  const moved = [...document.querySelectorAll("[tabindex]")].filter(node => node.tabIndex > 0).map(node => node.id);
  const ids = [...document.querySelectorAll("[id]")].map(node => node.id);
  const parts = ["main", "header", "footer", "h1"].filter(name => document.querySelectorAll(name).length !== 1);
  return [...skipped, ...moved, ...ids.filter((id, place) => ids.indexOf(id) < place), ...parts];
}"""

# Contrast of text with what is behind it, by the rule of WCAG 2: at least 4.5.
PALE = """() => {
  const numbers = words => words.match(/[\\d.]+/g).map(Number);
  const light = ([r, g, b]) => [r, g, b].map(c => c / 255).map(c => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4)).reduce((sum, c, i) => sum + c * [0.2126, 0.7152, 0.0722][i], 0);
  const behind = node => { for (; node; node = node.parentElement) { const c = numbers(getComputedStyle(node).backgroundColor); if (c.length < 4 || c[3] > 0.99) return c; } return [255, 255, 255]; };
  const pale = [];
  for (const node of document.querySelectorAll("body *")) {
    const own = [...node.childNodes].some(child => child.nodeType === 3 && child.textContent.trim());
    if (!own || node.closest("svg, noscript, :disabled, .skip, [inert], option, optgroup") || !node.getClientRects().length) continue;
    const [a, b] = [light(numbers(getComputedStyle(node).color)), light(behind(node))];
    const contrast = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
    if (contrast < 4.5) pale.push(`${contrast.toFixed(2)}: ${node.outerHTML.slice(0, 100)}`);
  }
  return pale;
}"""


def looks(page: Page) -> None:
    """Names for screen readers, contrast, and pictures, light and dark, wide and narrow."""
    page.locator("#scene").select_option("drum-brake-block")
    settled(page)
    assert page.evaluate(NAMELESS) == [], page.evaluate(NAMELESS)
    assert page.evaluate(DISORDERED) == [], page.evaluate(DISORDERED)
    for motion, seconds in (("reduce", "0s"), ("no-preference", "0.15s")):
        page.emulate_media(reduced_motion=motion)
        assert page.locator("#verdict").evaluate("node => getComputedStyle(node).transitionDuration") == seconds, motion
    for scheme in ("light", "dark"):
        page.emulate_media(color_scheme=scheme)
        for width, height in ((1280, 900), (390, 844), (1800, 1000)):
            page.set_viewport_size({"width": width, "height": height})
            page.evaluate("scrollTo(0, 0); document.querySelector('.side').scrollTo(0, 0)")
            page.wait_for_timeout(200)
            page.screenshot(path=OUT / f"{width}-{scheme}.png", full_page=True)
            wide = page.evaluate("document.documentElement.scrollWidth - document.documentElement.clientWidth")
            assert wide <= 0, f"{wide} pixels too wide at {width}"
        assert page.evaluate(PALE) == [], page.evaluate(PALE)
    page.emulate_media(color_scheme="light")
    page.set_viewport_size({"width": 1280, "height": 900})


def by_keyboard(page: Page) -> None:
    """The first keys of a page: over the link to the result to the choice of scenes."""
    page.reload()
    settled(page)
    page.keyboard.press("Tab")
    assert page.evaluate("document.activeElement.className") == "skip"
    page.keyboard.press("Tab")
    assert page.evaluate("document.activeElement.id") == "scene"
    page.keyboard.press("ArrowDown")
    settled(page)
    assert "drum-brake-ring" in page.evaluate("document.getElementById('scene').value")


def every_scene(page: Page) -> None:
    """Every scene that comes with the program is read and shown."""
    for name in page.evaluate("[...document.querySelectorAll('#scene option')].map(option => option.value)"):
        page.locator("#scene").select_option(name)
        page.wait_for_selector("#drawing svg", timeout=LONG)
        expect(page.locator("#status")).to_have_attribute("data-check", re.compile("."), timeout=LONG)
        assert page.locator("#fault").is_hidden(), name


def main() -> None:
    base = served()
    console: list[str] = []
    requests: list[str] = []
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path="/usr/bin/chromium", args=["--no-sandbox"])
        context = browser.new_context(viewport={"width": 1280, "height": 900}, accept_downloads=True)
        context.on("request", lambda request: requests.append(request.url))
        context.on("console", lambda message: console.append(message.text))
        context.on("weberror", lambda error: console.append(str(error.error)))
        page = context.new_page()
        page.goto(base)
        settled(page)
        for part in (numbers, same_elsewhere, again, files_of_the_reader, downloads, own_scene, older_answers, mistakes, units, no_numbers, listed_once, together, compare, address, damaged_address, in_time, looks, by_keyboard, every_scene):
            print(part.__name__, flush=True)
            part(page)
        browser.close()
    strange = [url for url in requests if not (url.startswith(base) or re.match(r"blob:http://127\.0\.0\.1", url))]
    assert not strange, f"requests beyond the page: {strange}"
    assert not console, f"on the console: {console}"
    print(f"{len(set(requests))} files asked for, nothing on the console")


main()
