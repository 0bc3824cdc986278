#!/usr/bin/env python3
"""Opens a page of gapcheck --html in Chromium and compares it with what it promises.

usage: html_chromium.py PAGE [--whole | --large]    exit code 0: good, 1: not, 77: Chromium is not installed

--whole: its layout at three sizes and its links too, which hardly depend on the deck.
"""

import json
import math
import sys

from chromium import Browser, colors, program

SELECTED = "[...document.querySelectorAll('#findings tr[aria-selected=true]')].map(r => Number(r.dataset.finding))"
SHOWN = "[...document.querySelectorAll('#findings tr.choice')].map(r => Number(r.dataset.finding))"
failures = []


def check(good, what):
    if not good:
        failures.append(what)
        print("failed:", what)


def row(browser, number):
    return f"#findings tr.choice[aria-rowindex='{number + 2}']"


def check_start(browser):
    """The page opens on the verdict and the worst finding: rows begin with the errors, with rule and message."""
    data = json.loads(browser.value("document.getElementById('data').textContent"))
    findings = data["findings"]
    severities = browser.value("[...document.querySelectorAll('#findings tr.choice')]"
                               ".filter(r => !r.textContent.includes('ignored')).map(r => r.children[0].textContent)")
    order = ["error", "warning", "note"]
    check(severities == sorted(severities, key=order.index), f"errors come first: {severities}")
    chosen = browser.value(SELECTED)
    check(len(chosen) == 1, "a finding is selected from the beginning")
    ranks = [(data["texts"][state] == "ignored", -severity)
             for state, severity in zip(findings["state"], findings["severity"])]
    check(ranks[chosen[0]] == min(ranks), "it is one of the worst")
    caption = browser.value("document.getElementById('caption').textContent")
    first = browser.value("[...document.querySelector('#findings tr[aria-selected=true]').children].map(c => c.textContent)")
    for word in (data["texts"][findings["rule"][chosen[0]]], data["texts"][findings["message"][chosen[0]]]):
        check(word in caption, f"the caption says {word}")
        check(any(word in cell for cell in first), f"its row says {word}")


def check_layout(path):
    """At each size the verdict and the whole picture are on the first screen, and the picture is half of it."""
    with Browser() as browser:
        for width, height, dark in ((1280, 900, False), (700, 900, True), (1920, 1000, False)):
            browser.resize(width, height, dark)
            browser.open("about:blank")
            browser.open(path)
            boxes = browser.value("['#verdict', '.picture', '#view', '#findings'].map(s => "
                                  "{ const b = document.querySelector(s).getBoundingClientRect(); "
                                  "return [b.left, b.top, b.right, b.bottom]; })")
            size = f"{width} x {height}"
            for left, top, right, bottom in boxes:
                check(left >= 0 and top >= 0 and right <= width and bottom <= height, f"nothing is cut off at {size}")
            card, view = boxes[1], boxes[2]
            area = (card[2] - card[0]) * (card[3] - card[1]) / (width * height)
            check(area >= 0.47, f"the picture has half of the page at {size}: {area:.2f}")
            check(view[3] - view[1] > 0.35 * height, f"the picture is high enough at {size}: {view}")
            check(browser.value("document.documentElement.scrollWidth <= innerWidth"), f"{size} is wide enough")


def check_tables(browser):
    data = json.loads(browser.value("document.getElementById('data').textContent"))
    verdict = browser.value("document.getElementById('verdict').textContent").replace(",", "")
    counts = list(data["totals"].values())
    check(all(str(count) in verdict for count in counts) or sum(counts) == 0, "the verdict counts")
    rows = browser.value("document.querySelectorAll('#contacts tbody tr').length")
    check(rows == min(1000, len(data["contacts"])), "contacts are listed")
    if data["shown"] == 0:
        return False
    check(len(browser.value(SHOWN)) > 0, "findings are listed")
    return True


def check_sorting_and_filters(browser):
    count = "Number(document.getElementById('count').textContent.split(' ')[0].replaceAll(',', ''))"
    depths = "[...document.querySelectorAll('#findings tr.choice')].map(r => Number(r.children[2].textContent))"
    before = browser.value(count)
    browser.click("#findings th:nth-child(3) button")
    first = browser.value(depths)
    check(first == sorted(first, reverse=True), "a press on the heading sorts by depth, deepest first")
    browser.click("#findings th:nth-child(3) button")
    second = browser.value(depths)
    check(second == sorted(second), "a second press turns the order round")
    browser.click("#findings th:nth-child(3) button")
    browser.value("(() => { const f = document.querySelector('#filters input'); f.value = 'no such text'; "
                  "f.dispatchEvent(new Event('input', {bubbles: true})); })()")
    check(browser.value(count) == 0 and browser.value(SHOWN) == [], "a text that is nowhere leaves nothing")
    browser.click("#filters button")
    check(browser.value(count) == before, "the button shows everything again")
    if browser.value("document.querySelectorAll('#histogram svg rect[role]').length") > 0:
        browser.click("#histogram svg rect[role]")
        check(0 < browser.value(count) <= before, "a bar of the histogram filters")
        browser.click("#filters button")
    if browser.value("document.querySelectorAll('#matrix button').length") > 0:
        browser.click("#matrix button")
        check(0 < browser.value(count) <= before, "a cell of the matrix filters")
        browser.click("#filters button")


def check_states(browser):
    """The column and the filter of states are there if and only if there is a baseline or something is ignored."""
    data = json.loads(browser.value("document.getElementById('data').textContent"))
    heads = browser.value("[...document.querySelectorAll('#findings th')].map(h => h.textContent)")
    there = data["baseline"] != "" or data["ignored"] > 0
    check(("state" in heads) == there, f"a column of states where there are any: {heads}")
    choice = "[...document.querySelectorAll('#filters select')].find(s => s.ariaLabel === 'State')"
    check(browser.value(f"{choice} !== undefined") == there, "a filter of states where there are any")
    if not there:
        return
    verdict = browser.value("document.getElementById('verdict').textContent").replace(",", "")
    check(data["ignored"] == 0 or f"{data['ignored']} ignored" in verdict, "the verdict says how many are ignored")
    check(data["baseline"].replace(",", "") in verdict, "the verdict counts against the baseline")
    column = heads.index("state")
    states = [data["texts"][text] for text in data["findings"]["state"]]
    for state in sorted(set(states)):
        browser.value(f"(() => {{ const s = {choice}; s.value = '{state}'; "
                      "s.dispatchEvent(new Event('input', {bubbles: true})); })()")
        count = browser.value("Number(document.getElementById('count').textContent.split(' ')[0].replaceAll(',', ''))")
        check(count == states.count(state), f"the filter leaves what is {state}")
        shown = browser.value("[...document.querySelectorAll('#findings tr.choice')]"
                              f".map(r => r.children[{column}].textContent)")
        check(shown and set(shown) == {state}, f"rows that are {state} say so")
    if "ignored" in states:
        browser.value(f"(() => {{ const s = {choice}; s.value = 'ignored'; "
                      "s.dispatchEvent(new Event('input', {bubbles: true})); })()")
        browser.click(row(browser, 0))
        detail = browser.value("document.getElementById('detail').textContent")
        check("left out by" in detail, f"the details say what leaves it out: {detail}")
    browser.click("#filters button")


def check_keyboard(browser):
    browser.click(row(browser, 0))
    first = browser.value(SELECTED)
    check(len(first) == 1, "a press on a row selects it")
    check(browser.value("document.getElementById('detail').textContent.length") > 10, "its details are shown")
    browser.value("document.getElementById('findings').focus()")
    browser.press("ArrowDown")
    second = browser.value(SELECTED)
    check(len(second) == 1 and (second != first or len(browser.value(SHOWN)) == 1), "the arrow keys move the selection")


def placed_rows(browser):
    """Numbers of the rows whose findings have a place in the picture, of the first ones."""
    return browser.value(
        "(() => { const p = JSON.parse(document.getElementById('data').textContent).picture.positions;"
        "const b = Uint8Array.from(atob(p), c => c.charCodeAt(0)); const x = new Float32Array(b.buffer);"
        "return [...document.querySelectorAll('#findings tr.choice')].map((r, n) => [n, Number(r.dataset.finding)])"
        ".filter(([n, i]) => !Number.isNaN(x[3 * i])).map(([n]) => n); })()")


def data_set(browser, name):
    """What the picture says of itself: the numbers of an attribute of its canvas."""
    return [int(number) for number in browser.value(f"document.getElementById('canvas').dataset.{name} ?? ''").split()]


def change(browser, label, value):
    browser.value(f"(() => {{ const s = [...document.querySelectorAll('#tools select, #tools input')]"
                  f".find(s => s.ariaLabel === '{label}'); s.value = '{value}';"
                  "s.dispatchEvent(new Event(s.type === 'range' ? 'input' : 'change')); })()")


def check_selection(browser):
    """A finding of two shells: its node, segment and elements are marked, both are coated, and the cut goes through."""
    data = json.loads(browser.value("document.getElementById('data').textContent"))
    shells = [i for i, rule in enumerate(data["findings"]["id"])
              if data["texts"][rule] in ("GC101", "GC102") and "parts" in data["picture"]]
    rows = [n for n, i in enumerate(browser.value(SHOWN)) if i in shells]
    if not rows or data["model"]["shells"] == 0:
        return
    browser.click(row(browser, rows[0]))
    segment, element, tracked = data_set(browser, "marked")
    check(segment == 1 and element >= 1 and tracked >= 1, "segment, element and the node's elements are marked")
    check(min(data_set(browser, "coats")) >= 1, "both sides have their thickness")
    middle = data_set(browser, "cut")[0]
    check(middle > 0, "the cut goes through both")
    before = browser.picture("#canvas")
    change(browser, "Place of the cut", "0.8")
    browser.settle()
    check(browser.picture("#canvas") != before, "the slider moves the cut")
    change(browser, "Cut", "")
    browser.settle()
    check(data_set(browser, "cut") == [0], "without a cut nothing is cut")
    change(browser, "Cut", "across")
    faces = data_set(browser, "faces")[0]
    isolate = "[...document.querySelectorAll('#tools label')].find(l => l.textContent === 'its parts only')"
    browser.value(f"{isolate}.querySelector('input').click()")
    sizes = {part["id"]: part["faces"] for part in data["picture"]["parts"]}
    chosen = browser.value(SELECTED)[0]
    own = {data["findings"][column][chosen] for column in ("part", "element_part")}
    alone = data_set(browser, "faces")[0]
    check(alone == sum(sizes[part] for part in own), f"its parts are alone: {alone} of {faces} faces")
    browser.value(f"{isolate}.querySelector('input').click()")
    check(data_set(browser, "faces")[0] == faces, "the others come back")
    browser.settle()
    for part in ("axes", "scale", "legend"):
        check(browser.value(f"document.getElementById('{part}').getBoundingClientRect().width") > 20, f"{part} is there")
    check(float(browser.value("document.querySelector('#scale span').textContent")) > 0, "the scale has a length")


def check_moves(browser):
    """Where nodes move, the picture shows the mesh before, after, and as it was again."""
    data = json.loads(browser.value("document.getElementById('data').textContent"))
    there = bool(data["picture"].get("moved_points"))
    labels = browser.value("[...document.querySelectorAll('#tools select')].map(s => s.ariaLabel)")
    check(("Nodes" in labels) == there, f"a choice of before and after where nodes move: {labels}")
    if not there:
        return
    check(data["moves"] in browser.value("document.getElementById('model').textContent"), "the page says what moves")
    browser.click("#tools button:nth-of-type(1)")
    pictures = []
    for choice in ("0", "10", "0"):
        change(browser, "Nodes", choice)
        pictures.append(browser.steady_picture("#canvas"))
    check(pictures[1] != pictures[0], "after the moves the picture is another one")
    check(pictures[2] == pictures[0], "and before them it is the first one again")


def check_elements(browser):
    """A finding of an element whose position is not known is shown where its element is."""
    data = json.loads(browser.value("document.getElementById('data').textContent"))
    for i, element in enumerate(data["findings"]["element"]):
        if element != 0 and data["picture"].get("parts"):
            browser.value(f"location.hash = '#f{data['findings']['number'][i]}'")
            browser.settle()
            check(not browser.value("document.getElementById('label').hidden"), f"element {element} is shown")
            check(data_set(browser, "marked")[1] > 0, f"element {element} is marked")
            return


def check_links(browser, path):
    """The address follows the selection, leads to it when the page opens, and moves it when it changes."""
    data = json.loads(browser.value("document.getElementById('data').textContent"))
    browser.click(row(browser, 0))
    chosen = browser.value(SELECTED)[0]
    number = data["findings"]["number"][chosen]
    check(browser.value("location.hash") == f"#f{number}", "the address is that of the selected finding")
    last = len(data["findings"]["number"]) - 1
    browser.value(f"location.hash = '#f{data['findings']['number'][last]}'")
    check(browser.becomes(f"{SELECTED}.includes({last})"), "a new address selects its finding")
    browser.open("about:blank")
    browser.open(f"{path}#f{data['findings']['number'][last]}")
    check(last in browser.value(SELECTED), "the page opens on the finding of its address")
    browser.open("about:blank")
    browser.open(path)
    check(browser.value("location.hash") == "", "the address stays as it is where nobody selected")


def check_picture(browser):
    def full(what):
        counts = colors(browser.picture("#canvas", scale=0.25))
        most = max(counts.values()) / sum(counts.values())
        check(len(counts) > 20 and most < 0.995, f"{what}: {len(counts)} colours, {most:.1%} of one")

    rows = placed_rows(browser)
    start = browser.settle()
    full("the first picture is not empty")
    if not rows:
        return
    now = browser.value("[...document.querySelectorAll('#findings tr.choice')]"
                        ".findIndex(r => r.ariaSelected === 'true')")
    others = [number for number in rows[:6] if number != now]
    if others:
        browser.click(row(browser, others[0]))
        check(browser.settle(different_from=start) != start, "a press on another row moves the camera")
    check(not browser.value("document.getElementById('label').hidden"), "the node has its label")
    full("the picture of a finding is not empty")
    # Presses on the picture, from its middle outward, until one meets another node.
    first = browser.value(SELECTED)
    width, height = browser.value("[canvas.clientWidth, canvas.clientHeight]")
    if len(rows) > 1:
        browser.click("#tools button:nth-of-type(2)")
        browser.settle()
        met = False
        for ring in range(0, 30):
            directions = max(8, 5 * ring)
            for direction in range(directions):
                x, y = (14 * ring * f(2 * math.pi * direction / directions) for f in (math.cos, math.sin))
                if abs(x) > width / 2 - 3 or abs(y) > height / 2 - 3:
                    continue
                browser.click("#canvas", width / 2 + x, height / 2 + y)
                now = browser.value(SELECTED)
                met = len(now) == 1 and now != first
                if met:
                    break
            if met:
                break
        check(met, "a press on a node selects its row")
        browser.settle()
    camera = browser.settle()
    browser.value("document.querySelector('#canvas').focus()")
    browser.press("ArrowLeft")
    check(browser.settle(different_from=camera) != camera, "the arrow keys turn the picture")
    change(browser, "Length of the vectors", "100")
    full("magnified vectors")


def check_page(path, whole):
    with Browser() as browser:
        seconds = browser.open(path)
        print(f"{path}: opened in {seconds:.2f} s")
        if check_tables(browser):
            check_start(browser)
            check_keyboard(browser)
            check_sorting_and_filters(browser)
            check_states(browser)
            if browser.value("document.getElementById('canvas') !== null"):
                check_picture(browser)
                check_selection(browser)
                check_elements(browser)
                check_moves(browser)
            else:
                why = browser.value("document.getElementById('view').textContent")
                check("known" in why, f"it says why there is no picture: {why}")
            if whole:
                check_links(browser, path)
        foreign = browser.value("document.querySelectorAll('img, iframe, a').length")
        check(foreign == 0, "nothing but the page's own elements")
        check(browser.value("window.injected === undefined"), "no script of the deck has run")
        check(browser.value("document.documentElement.scrollWidth <= innerWidth"), "1280 pixels are wide enough")
        loaded = [url for url in browser.requests if not url.startswith(("file://", "data:", "about:"))]
        check(loaded == [], f"nothing is loaded: {loaded}")
        check(browser.errors == [], f"the console is free of errors: {browser.errors}")


def check_dark_without_webgl(path):
    with Browser(dark=True, webgl=False) as browser:
        browser.open(path)
        back = browser.value("getComputedStyle(document.body).backgroundColor")
        check(back == "rgb(20, 23, 27)", f"dark where the reader wants it: {back}")
        check(browser.value("document.getElementById('canvas') === null"), "no picture without WebGL")
        why = browser.value("document.getElementById('view').textContent")
        check("WebGL" in why or "known" in why, f"the page says why: {why}")
        if browser.value("JSON.parse(document.getElementById('data').textContent).shown") > 0:
            check_keyboard(browser)
            check_sorting_and_filters(browser)
        check(browser.errors == [], f"the console is free of errors without WebGL: {browser.errors}")


def check_large(path):
    """More than 40,000 faces and 2,000 findings: colours instead of markers, an outline while it turns."""
    with Browser() as browser:
        browser.open(path)
        browser.settle()
        faces, markers = data_set(browser, "faces")[0], data_set(browser, "markers")[0]
        check(faces > 40000, f"the deck is large: {faces} faces")
        check(markers < 100, f"findings are colours of the mesh, not {markers} markers")
        browser.click("#tools button:nth-of-type(2)")
        browser.settle()
        seen = colors(browser.picture("#canvas"))
        warm = sum(count for color, count in seen.items() if color[0] > 90 and color[0] > 1.3 * color[2])
        check(warm > 0.05 * sum(seen.values()), f"the depths are colours: {warm} pixels")
        browser.value("(() => { window.drawn = []; new MutationObserver(() => drawn.push(canvas.dataset.drawn))"
                      ".observe(canvas, {attributeFilter: ['data-drawn']}); canvas.focus(); })()")
        browser.press("ArrowLeft")
        browser.settle()
        drawn = browser.value("window.drawn")
        check("outline" in drawn and drawn[-1] == "all", f"it is an outline while it turns, and then all: {drawn}")
        browser.click(row(browser, 2))
        check(len(browser.value(SELECTED)) == 1, "a row can be selected")
        check(browser.errors == [], f"the console is free of errors: {browser.errors}")


def main():
    if program() is None:
        print("Chromium is not installed")
        return 77
    if "--large" in sys.argv:
        check_large(sys.argv[1])
        return 1 if failures else 0
    whole = "--whole" in sys.argv
    check_page(sys.argv[1], whole)
    if whole:
        check_layout(sys.argv[1])
    check_dark_without_webgl(sys.argv[1])
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
