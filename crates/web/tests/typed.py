"""What a reader types into the text and the form, and what is told of it."""

import re
import tomllib

from playwright.sync_api import Page, expect

from common import LONG, OUT, again, settled, text


def mistakes(page: Page) -> None:
    """A slip is told at its line, what stood before stays, and goes on when it is mended."""
    good = text(page)
    page.locator("#text").fill(good.replace("friction =", "frction ="))
    expect(page.locator("#fault")).to_contain_text("did you mean `friction`", timeout=LONG)
    line = next(number for number, words in enumerate(good.splitlines(), 1) if "friction =" in words and not words.startswith("#"))
    expect(page.locator("#fault")).to_contain_text(f"line {line}, column")
    expect(page.locator("#mark")).to_be_attached()
    page.locator("#fault button").click()
    assert page.evaluate("document.getSelection().toString()") == "frction", "the place is not where the slip is"
    assert page.locator("#mark").is_visible()
    page.screenshot(path=OUT / "mistake.png")
    page.locator("#text").fill(good.replace("tasks = [", "tasks = [["))
    expect(page.locator("#fault")).to_contain_text("this is not TOML", timeout=LONG)
    page.locator("#text").fill(good)
    expect(page.locator("#fault")).to_be_hidden(timeout=LONG)
    settled(page)


def units(page: Page) -> None:
    """What is typed stays as it was typed; another unit is the same load."""
    force = page.locator("[id='field-load.force']")
    force.fill("8 kN")
    force.press("Enter")
    settled(page)
    assert tomllib.loads(text(page))["load"]["force"] == "8 kN"
    page.get_by_label("unit of force").select_option("N")
    settled(page)
    assert tomllib.loads(text(page))["load"]["force"] == "8000 N"
    force.fill("8 kg")
    force.press("Enter")
    expect(page.locator("#fault")).to_contain_text("wrong unit", timeout=LONG)
    force.fill("9")
    force.press("Enter")
    page.get_by_label("unit of force").select_option("kN")
    expect(page.locator("#fault")).to_be_hidden(timeout=LONG)
    settled(page)
    page.locator("[id='field-body1.material']").select_option("bronze" if page.locator("[id='field-body1.material'] option[value=bronze]").count() else "steel")
    settled(page)
    assert isinstance(tomllib.loads(text(page))["body1"]["material"], str)
    page.locator("[id='field-optimum.functional']").select_option("uniform")
    settled(page)
    expect(page.locator("#verdict")).to_contain_text("Machine this shape")
    # What stands behind its note comes from a file beside the module.
    expect(page.locator("#notes details[data-code=not-steady]")).to_contain_text("What to do")


def no_numbers(page: Page) -> None:
    """What is no number is told at its field and changes nothing; what is one is written as TOML has it."""
    again(page)
    before = text(page)
    for key in ("contact.friction", "load.force", "body1.geometry.shoe-block.radius"):
        field, note = page.locator(f"[id='field-{key}']"), page.locator(f"[id='field-{key}-with']")
        good = field.input_value()
        for typed, says in (("5.", "no number: write 5;"), ("05", "no number: write 5;"), ("0,3", "no comma"), ("1e400", "too large"), ("", "no number"), ("five", "no number")):
            field.fill(typed)
            field.press("Enter")
            expect(field).to_have_attribute("aria-invalid", "true")
            expect(note).to_contain_text(says)
            expect(note).to_contain_text(f"the scene keeps {good}")
            assert text(page) == before, typed
        field.fill(good)
        field.press("Enter")
        expect(field).to_have_attribute("aria-invalid", "false")
        expect(note).not_to_contain_text("keeps")
        assert text(page) == before
    friction = page.locator("[id='field-contact.friction']")
    friction.fill("+.3")
    friction.press("Enter")
    expect(friction).to_have_value("0.3")
    settled(page)
    assert tomllib.loads(text(page))["contact"]["friction"] == 0.3


def listed_once(page: Page) -> None:
    """A word that a list has not is there once, however often the scene changes; a title with a colon stays out of the charts."""
    other = re.sub(r"(?m)^accuracy = \S+", "accuracy = 5e-3", text(page))
    page.locator("#text").fill(re.sub(r'(?m)^title = ".*"', 'title = "Brake: variant B"', other).replace("10000", '"1e7 mN"').replace('"10 kN"', '"1e7 mN"'))
    expect(page.locator("#field-accuracy")).to_have_value("5e-3")
    settled(page)
    for friction in ("0.21", "0.22", "0.23"):
        page.locator("[id='field-contact.friction']").fill(friction)
        page.keyboard.press("Enter")
        settled(page)
    assert page.locator("#form select").evaluate_all(DOUBLED) == []
    assert page.locator("#field-accuracy option[value='5e-3']").count() == page.locator("[aria-label='unit of force'] option[value=mN]").count() == 1
    expect(page.locator("figure[data-chart=pressure] figcaption")).to_have_text("contact pressure")


# Words that a list has twice.
DOUBLED = "all => all.flatMap(one => [...one.options].map(({ value }) => value).filter((value, place, values) => values.indexOf(value) < place))"


def together(page: Page) -> None:
    """The radius of shoe and drum is one number."""
    page.locator("#scene").select_option("drum-brake-block")
    settled(page)
    radius = page.locator("[id='field-body1.geometry.shoe-block.radius']")
    radius.fill("210")
    radius.press("Enter")
    settled(page)
    scene = tomllib.loads(text(page))
    assert scene["body1"]["geometry"]["shoe-block"]["radius"] == scene["body2"]["geometry"]["ring"]["outer"] == 210
