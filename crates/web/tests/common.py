"""What the parts of the test of the page have in common."""

import sys
from pathlib import Path

from playwright.sync_api import Page, expect

FOLDER, PROGRAM, OUT = (Path(word).resolve() for word in sys.argv[1:4])
LONG = 60_000
# A file dropped onto the page: name and text.
DROP = """([name, text]) => {
  const dataTransfer = new DataTransfer();
  dataTransfer.items.add(new File([text], name));
  document.body.dispatchEvent(new DragEvent("drop", { dataTransfer, bubbles: true, cancelable: true }));
}"""


def settled(page: Page) -> None:
    """Waits until the answer to the last change is whole."""
    expect(page.locator("#status")).to_have_attribute("data-state", "done", timeout=LONG)


def text(page: Page) -> str:
    return page.locator("#text").input_value()


def download(page: Page, name: str) -> str:
    menu = page.locator("#downloads")
    if menu.get_attribute("open") is None:
        menu.locator("summary").click()
    with page.expect_download() as waited:
        menu.get_by_role("button", name=name, exact=True).click()
    return Path(waited.value.path()).read_text(encoding="utf-8")


def again(page: Page) -> None:
    """Back to the scene that the next parts use."""
    page.locator("#scene").select_option("drum-brake-block")
    settled(page)
