"""What the page hands out: files, and the address that holds a scene."""

import json
import random
import re
from pathlib import Path

from playwright.sync_api import Page, expect

from common import DROP, LONG, again, download, settled, text


def downloads(page: Page) -> None:
    """Each file is what its name says."""
    assert download(page, "drum-brake-block.toml") == text(page)
    drawn = download(page, "profile.dxf").split()
    assert "SPLINE" in drawn and drawn[-1] == "EOF"
    assert download(page, "plots/scene.svg").startswith("<svg")
    assert "<!doctype html>" in download(page, "report.html").lower()
    page.keyboard.press("Escape")
    expect(page.locator("#downloads")).not_to_have_attribute("open", "")


def own_scene(page: Page) -> None:
    """A scene that is dropped has the name of its file: to choose, in the address, in what is handed out; back to it goes Reset."""
    dropped = text(page).replace('force = "10 kN"', 'force = "9 kN"')
    assert dropped != text(page)
    page.evaluate(DROP, ["my-shoe.TOML", dropped])
    expect(page.locator("#scene option:checked")).to_have_text("my-shoe (your file)")
    expect(page.locator("#kept")).to_be_empty()
    settled(page)
    assert text(page) == dropped
    assert json.loads(download(page, "summary.json"))["scene"] == "my-shoe"
    with page.expect_download() as waited:
        page.locator("#files button").get_by_text("report.html", exact=True).click()
    assert waited.value.suggested_filename == "my-shoe-report.html"
    assert download(page, "my-shoe.toml") == dropped
    page.keyboard.press("Escape")
    expect(page.locator("#reset")).to_be_disabled()
    page.locator("#text").fill(dropped.replace("9 kN", "8 kN"))
    settled(page)
    page.locator("#reset").click()
    settled(page)
    assert text(page) == dropped
    expect(page).to_have_url(re.compile("scene=my-shoe&toml="))
    other = page.context.new_page()
    other.goto(page.url)
    settled(other)
    expect(other.locator("#scene option:checked")).to_have_text("my-shoe (your file)")
    assert text(other) == dropped
    other.close()
    again(page)
    assert text(page) != dropped
    page.locator("#scene").select_option("")
    settled(page)
    assert text(page) == dropped
    # A name of ours is that of the file all the same.
    page.evaluate(DROP, ["annular-punch.toml", dropped])
    settled(page)
    page.locator("#text").fill(dropped.replace("9 kN", "8 kN"))
    settled(page)
    page.locator("#reset").click()
    settled(page)
    assert text(page) == dropped
    again(page)


# Another scene, and the menu opened at once: the names of its files then.
AT_ONCE = """async () => {
  const [scene, menu] = [document.getElementById("scene"), document.getElementById("downloads")];
  scene.value = "drum-brake-hot";
  scene.dispatchEvent(new Event("change"));
  menu.open = true;
  await new Promise(done => setTimeout(done, 50));
  return [document.getElementById("status").dataset.state, ...[...menu.querySelectorAll("button")].map(button => button.textContent)];
}"""


def older_answers(page: Page) -> None:
    """No file of an older answer is handed out; the menu follows while it is open."""
    names = page.locator("#files button")
    assert page.evaluate(AT_ONCE) == ["busy", "drum-brake-hot.toml"], "files of an older answer"
    settled(page)
    good = text(page)
    with page.expect_download() as waited:
        names.get_by_text("summary.json", exact=True).click()
    assert waited.value.suggested_filename == "drum-brake-hot-summary.json"
    assert json.loads(Path(waited.value.path()).read_text(encoding="utf-8"))["scene"] == "drum-brake-hot"
    for wrong in ("title = 3", "title = ["):
        page.locator("#text").fill(wrong)
        expect(page.locator("#fault")).to_be_visible(timeout=LONG)
        expect(names).to_have_text(["drum-brake-hot.toml"])
        assert download(page, "drum-brake-hot.toml") == wrong
        page.locator("#text").fill(good)
        settled(page)
        expect(names.get_by_text("report.html", exact=True)).to_be_visible()
    page.keyboard.press("Escape")
    page.locator("#downloads summary").press("Escape")
    again(page)


def address(page: Page) -> None:
    """The address of a page opens the same scene elsewhere."""
    expect(page).to_have_url(re.compile("toml="))
    other = page.context.new_page()
    other.goto(page.url)
    settled(other)
    assert text(other) == text(page)
    other.close()


def damaged_address(page: Page) -> None:
    """An address without its whole text says so, and stays; one of a large text holds it."""
    other = page.context.new_page()
    base = page.url.split("#")[0]
    other.goto(f"{base}#scene=annular-punch&toml=AAAA")
    settled(other)
    expect(other.locator("#status")).to_contain_text("damaged")
    other.wait_for_timeout(500)
    assert other.url.endswith("toml=AAAA")
    noise = random.Random(1)
    large = text(other) + "".join(f"# {noise.randbytes(60).hex()}\n" for _ in range(3500))
    # Typing as much takes Chromium minutes.
    other.locator("#text").evaluate("(area, large) => { area.value = large; area.dispatchEvent(new Event('input')); }", large)
    expect(other).to_have_url(re.compile("toml=.{200000}"), timeout=LONG)
    settled(other)
    expect(other.locator("#status")).not_to_contain_text("damaged")
    other.reload()
    settled(other)
    same = text(other) == large
    assert same, "another text than the address had"
    other.close()
