#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The page that `kreisel report` writes, used as a reader uses it: report.py PROGRAM [FOLDER...]

Without folders it runs two small experiments, whose labels hold markup. With folders it opens their reports only, and
prints size and load time of each.
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from browser import Browser, require_browser  # noqa: E402

EVIL = "</script><script>window.injected = 1</script><img src=x onerror='window.injected = 1'>"
LARGEST = 2500000

ORDERS = {
    "name": "page_orders", "kind": "convergence", "description": "Orders, " + EVIL,
    "problems": [{"name": "heavy_top", "label": EVIL}, "free_top"],
    "methods": ["rkmk/rk4", "rkmk/midpoint", "baseline/rk4_quaternion"], "formulations": ["SO3xR3", "SE3"],
    "time": {"end": 0.2, "steps": {"from": 64, "levels": 5}},
}
# A spring between two bodies, and a bushing that holds one to the ground, without joints or gravity.
SPRINGS = {"gravity": [0, 0, 0], "joints": [], "bodies": [
    {"name": "a", "mass": 1, "inertia": [0.1, 0.1, 0.1], "x": [0, 0, 0]},
    {"name": "b", "mass": 1, "inertia": [0.1, 0.1, 0.1], "x": [1, 0, 0], "omega": [0, 0, 1]}], "forces": [
        {"type": "spring", "between": ["a", "b"], "points": [[0, 0, 0], [1, 0.2, 0]], "stiffness": 2, "length": 0.5},
        {"type": "bushing", "between": ["ground", "a"], "point": [-0.2, 0, 0], "stiffness": [9, 9, 9],
         "torsional_stiffness": [9, 9, 9]}]}
MOTION = {
    "name": "page_motion", "kind": "drift",
    "problems": ["double_pendulum", "four_bar", {"name": "multibody", "label": "springs", "parameters": SPRINGS}],
    "methods": ["rkmk/rk4", "rkmk/euler"], "projections": ["none", "position_velocity"],
    "time": {"end": 4, "steps": 800}, "output": {"samples": 200},
    "figure": [
        {"kind": "heat_map", "name": "map", "metric": ["defect.position", "defect.velocity"], "x": "projection",
         "select": {"problem": "double_pendulum"}},
        {"kind": "motion", "name": "path", "instants": 3, "lever": [0, 0.3, 0],
         "select": {"problem": "double_pendulum", "method": "rkmk/rk4", "projection": "none"}}],
}


MOTION_IS_MADE = "return !document.querySelector('.motion-place') || document.documentElement.dataset.motion === 'true'"


def report_of(program, folder, config):
    """Runs a config and writes its report."""
    file = folder / (config["name"] + ".json")
    file.write_text(json.dumps(config))
    results = folder / config["name"]
    ran = subprocess.run([program, "run", file, "-o", results, "-j", "1"], capture_output=True, text=True)
    assert ran.returncode in (0, 1), ran.stderr
    return written(program, results, folder / (config["name"] + ".html"))


def written(program, results, page):
    made = subprocess.run([program, "report", results, "-o", page], capture_output=True, text=True)
    assert made.returncode in (0, 1), made.stderr
    return page


def ready(browser, page):
    """Opens a page; the seconds until it is complete, but for the motion, for which it waits then."""
    start = time.monotonic()
    browser.open(page)
    assert browser.run("return document.documentElement.dataset.ready") == "true", "the script did not come to its end"
    seconds = time.monotonic() - start
    wait_until(lambda: browser.run(MOTION_IS_MADE), "the motion is not made")
    return seconds


def check_quiet(browser, what):
    complaints = browser.complaints()
    assert not complaints, f"{what}: {complaints}"


def rows(browser):
    return browser.run("return document.querySelectorAll('#tables tbody tr').length")


def column_of(browser, title):
    """The texts of a column of the shown table."""
    return browser.run("""
        const heads = [...document.querySelectorAll('#tables thead th')];
        const at = heads.findIndex((head) => head.textContent.split(' [')[0] === arguments[0]);
        return [...document.querySelectorAll('#tables tbody tr')].map((row) => row.children[at].textContent);""", title)


def put(browser, selector, value):
    browser.run("""const node = document.querySelector(arguments[0]);
        node.value = arguments[1];
        node.dispatchEvent(new Event(node.tagName === 'SELECT' ? 'change' : 'input'));""", selector, value)


def check_table(browser):
    everything = rows(browser)
    assert everything == 60, everything
    put(browser, "#tables input[type=search]", "method:rkmk/rk4 steps>100")
    kept = rows(browser)
    assert kept == 16, kept  # of two problems in two formulations, four counts of steps
    put(browser, "#tables input[type=search]", "")
    head = "[...document.querySelectorAll('#tables thead button')].find((one) => one.textContent.startsWith('h '))"
    for direction in ("ascending", "descending"):
        browser.run(f"{head}.click()")
        shown = [float(text) for text in column_of(browser, "h")]
        assert shown == sorted(shown, reverse=direction == "descending"), direction
        assert browser.run(f"return {head}.parentNode.getAttribute('aria-sort')") == direction
        assert browser.run(f"return document.activeElement === {head}"), "sorting loses the focus"
    browser.run("document.querySelector('#tables .bar input[type=checkbox]').click()")
    data = browser.run("return JSON.parse(document.getElementById('data').textContent).tables[0].columns")
    exact = next(one for one in data if one["title"].startswith("error.position"))["numbers"]
    shown = [float(text) for text in column_of(browser, "error.position") if text]
    assert sorted(shown) == sorted(float(value) for value in exact if value is not None), "digits are lost"


def check_figure(browser):
    count = "return document.querySelectorAll('.figure .curve path[d^=M]').length"
    before = browser.run(count)
    browser.run("document.querySelector('.figure .legend button').click()")
    assert browser.run(count) < before, "the legend does not hide a curve"
    browser.run("document.querySelector('.figure .legend button').click()")
    assert browser.run(count) == before
    ticks = "return [...document.querySelectorAll('.figure svg')].map((one) => one.textContent).join()"
    logarithmic = browser.run(ticks)
    browser.run("document.querySelector('.figure [aria-label=\"Scale of the y axis\"] button').click()")
    assert browser.run(ticks) != logarithmic, "a linear axis looks like a logarithmic one"
    assert browser.run("return document.querySelectorAll('.figure .mark.fitted').length") > 0, "no window is shown"
    browser.run("""const svg = document.querySelector('.figure .plot > svg'); svg.focus();
        svg.dispatchEvent(new KeyboardEvent('keydown', {key: 'ArrowRight'}));""")
    tip = browser.run("return document.querySelector('.figure .tip:not([hidden])').textContent")
    assert "h [s] = " in tip, tip


def check_labels(browser):
    assert browser.run("return window.injected") is None, "a label was run"
    assert browser.run("return document.querySelectorAll('#report img, #report script').length") == 0
    assert EVIL in browser.run("return document.getElementById('report').textContent"), "the label is not shown"


def pixels(browser):
    """How many pixels of the canvas differ from its corner, and a sum of all."""
    return browser.run("""
        const canvas = document.querySelector('#motion canvas'), copy = document.createElement('canvas');
        copy.width = canvas.width; copy.height = canvas.height;
        const context = copy.getContext('2d');
        context.drawImage(canvas, 0, 0);
        const data = context.getImageData(0, 0, copy.width, copy.height).data;
        let count = 0, sum = 0;
        for (let i = 0; i < data.length; i += 4) {
            if (data[i] !== data[0] || data[i + 1] !== data[1] || data[i + 2] !== data[2]) count++;
            sum = (sum * 31 + data[i] + 7 * data[i + 1] + 13 * data[i + 2]) % 1000000007;
        }
        return [count, sum];""")


def wait_until(holds, complaint, most=60):
    """Software rendering on a loaded machine takes its time."""
    end = time.monotonic() + most
    while not holds():
        assert time.monotonic() < end, complaint
        time.sleep(0.1)


def clock(browser):
    return float(browser.run("return document.querySelector('#motion .clock').textContent").split()[2])


def extent(browser):
    """Over which parts of the width and of the height of the left pane something moves, [[low, high], [low, high]]."""
    return browser.run("""
        const canvas = document.querySelector('#motion canvas'), [width, height] = [300, 215];
        const context = Object.assign(document.createElement('canvas'), {width, height})
            .getContext('2d', {willReadFrequently: true});
        const clock = document.querySelector('#motion input[type=range]'), at = [[1, 0], [1, 0]];
        for (let time = 0; time < clock.max; time += clock.max / 16) {
            clock.value = time;
            clock.dispatchEvent(new Event('input'));
            context.drawImage(canvas, 0, 0, canvas.width / 2, canvas.height, 0, 0, width, height);
            const {data} = context.getImageData(0, 0, width, height);
            for (let i = 0; i < data.length; i += 4) {
                const colours = [data[i], data[i + 1], data[i + 2]];
                if (Math.max(...colours) - Math.min(...colours) < 30) continue;  // page, floor and joints are grey
                [(i / 4) % width / width, Math.floor(i / 4 / width) / height].forEach((part, k) => {
                    at[k] = [Math.min(at[k][0], part), Math.max(at[k][1], part)];
                });
            }
        }
        return at;""")


def check_filled(browser):
    """A motion is in sight as a whole and fills the picture; the rest of the page came before it."""
    for view in ("front", "view"):
        browser.run("""[...document.querySelectorAll('#motion [aria-label="View"] button')]
            .find((one) => one.textContent === arguments[0]).click()""", view)
        parts = extent(browser)
        assert all(low > 0.03 and high < 0.97 for low, high in parts), f"{view}: the motion leaves the picture, {parts}"
        assert max(high - low for low, high in parts) > 0.7, f"{view}: the motion fills little of the picture, {parts}"
    browser.driver.set_window_size(640, 1400)
    parts = extent(browser)
    browser.driver.set_window_size(1280, 1400)
    assert all(low > 0.03 and high < 0.97 for low, high in parts), f"a narrow page cuts the motion, {parts}"
    seen, made = browser.run("""return [performance.getEntriesByName('first-contentful-paint'),
        performance.getEntriesByName('motion')].map((list) => list[0].startTime)""")
    assert seen < made, f"the page is seen {seen} ms after its start, the motion is begun after {made} ms"


def check_motion(browser):
    # It is first painted when the page is laid out, which may be after its script has come to its end.
    wait_until(lambda: pixels(browser)[0] > 3000, "the picture is blank")
    at_start = pixels(browser)[1]
    put(browser, "#motion input[type=range]", "1.5")
    assert abs(clock(browser) - 1.5) < 1e-3
    later = pixels(browser)[1]
    assert later != at_start, "scrubbing does not move the picture"
    browser.run("document.querySelector('#motion .play').click()")
    wait_until(lambda: clock(browser) > 1.6, "it does not play")
    browser.run("document.querySelector('#motion .play').click()")
    played = clock(browser)
    time.sleep(0.5)
    assert clock(browser) == played, "it does not pause"
    assert pixels(browser)[1] != later
    paths = browser.run("return document.querySelectorAll('.distance .curve path[d^=M]').length")
    assert paths == 1, "no distance is drawn"
    browser.run("""document.querySelector('#motion canvas').dispatchEvent(
        new KeyboardEvent('keydown', {key: 'ArrowLeft', cancelable: true}))""")
    assert pixels(browser)[1] != later, "the view does not turn"


def check_forces(browser):
    """Forces are drawn on request, by the keyboard too, each kind in its colour; what they mean and their scale are
    said."""
    from selenium.webdriver.common.keys import Keys
    boxes = {label.text.strip(): label.find_element("css selector", "input")
             for label in browser.driver.find_elements("css selector", "#motion .bar label")
             if label.text.strip() in ("forces of joints", "springs, dampers, attractions", "applied forces")}
    assert len(boxes) == 3, boxes
    assert not any(box.is_selected() for box in boxes.values()), "forces are shown unasked"
    put(browser, "#motion input[type=range]", "0.5")
    said = "return document.querySelector('#motion .forces:not([hidden])')?.textContent || ''"
    assert browser.run(said) == ""
    seen = [pixels(browser)[1]]
    for name, meaning in (("forces of joints", "reaction of a joint"), ("applied forces", "weight or load")):
        boxes[name].send_keys(Keys.SPACE)
        assert boxes[name].is_selected(), f"the space bar does not switch {name}"
        seen.append(pixels(browser)[1])
        text = browser.run(said)
        assert meaning in text and "An arrow of " in text and " N" in text, text
    assert len(set(seen)) == 3, "switching forces does not change the picture"
    scale = browser.run(said)
    put(browser, "#motion [aria-label='Length of arrows']", "5")
    assert pixels(browser)[1] != seen[-1] and browser.run(said) != scale, "arrows do not become longer"
    put(browser, "#motion [aria-label='Length of arrows']", "1")
    assert pixels(browser)[1] == seen[-1] and browser.run(said) == scale
    check_springs(browser, boxes["springs, dampers, attractions"], seen[-1])
    for box in filter(lambda one: one.is_selected(), boxes.values()):
        box.send_keys(Keys.SPACE)
    assert pixels(browser)[1] == seen[0], "forces stay when they are switched off"
    assert browser.run(said) == ""


def choose_left(browser, pattern):
    browser.run("""const left = document.querySelector('#motion select');
        left.value = [...left.options].findIndex((one) => new RegExp(arguments[0]).test(one.textContent));
        left.dispatchEvent(new Event('change'));""", pattern)


def check_springs(browser, box, without):
    """Arrows of forces between bodies stand where there are any; of a pendulum there are none."""
    said = "return document.querySelector('#motion .forces:not([hidden])').textContent"
    box.click()
    assert pixels(browser)[1] == without and "spring" not in browser.run(said), browser.run(said)
    choose_left(browser, "springs.*rk4")
    shown, text = pixels(browser)[1], browser.run(said)
    assert "spring, damper, bushing or attraction, on both bodies" in text, text
    box.click()
    assert pixels(browser)[1] != shown, "forces of springs are not drawn"
    assert "spring" not in browser.run(said)
    choose_left(browser, "double_pendulum.*rk4")


def check_places(browser):
    """Heat maps are tables with a colour for each value, figures in space turn by the arrow keys."""
    maps = browser.run("""
        return [...document.querySelectorAll('table.heat')].map((table) => [
            table.caption.textContent, [...table.querySelectorAll('tbody th')].map((head) => head.textContent),
            [...table.querySelectorAll('td')].map((place) => [place.title, place.style.backgroundColor])]);""")
    assert len(maps) == 2, maps
    for caption, methods, places in maps:
        assert caption and sorted(methods) == ["rkmk/euler", "rkmk/rk4"], (caption, methods)
        values = [float(value) for value, _ in places]
        assert len(values) == 4 and len({colour for _, colour in places}) == len(set(values)), places
    outline = "return document.querySelector('.space svg').innerHTML"
    before = browser.run(outline)
    assert before.count('class="track"') >= 200 and before.count('class="outline"') > 3, len(before)
    browser.run("""document.querySelector('.space svg').dispatchEvent(
        new KeyboardEvent('keydown', {key: 'ArrowLeft', cancelable: true}))""")
    assert browser.run(outline) != before, "the arrow keys do not turn the picture"


def check_stopped(browser):
    """A cell that failed says when and why."""
    choose_left(browser, "four_bar.*rk4.*no projection")
    put(browser, "#motion input[type=range]", "4")
    said = browser.run("return document.querySelector('#motion .stop').textContent")
    assert said.startswith("stopped at t = ") and "singular_kkt" in said, said


def check_access(browser):
    unnamed = browser.run("""
        return [...document.querySelectorAll('button, select, input, a, canvas, [tabindex]')].filter((node) =>
            !(node.textContent.trim() || node.getAttribute('aria-label') || (node.labels && node.labels.length)))
            .map((node) => node.outerHTML.slice(0, 90));""")
    assert not unnamed, unnamed
    contrast = """
        const style = getComputedStyle(document.documentElement);
        const light = (name) => {
            const hex = style.getPropertyValue(name).trim();
            const part = [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16) / 255)
                .map((c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4));
            return 0.2126 * part[0] + 0.7152 * part[1] + 0.0722 * part[2];
        };
        const ratio = (a, b) => (Math.max(light(a), light(b)) + 0.05) / (Math.min(light(a), light(b)) + 0.05);
        return arguments[0].map(([a, b]) => [a, b, ratio(a, b)]);"""
    texts = ("--ink", "--faint", "--accent", "--bad", "--good")
    pairs = [[text, page] for text in texts for page in ("--page", "--soft")]
    pairs += [["--bad", "--bad-soft"], ["--tip-ink", "--tip"]]
    for _ in ("one theme", "the other"):
        poor = [pair for pair in browser.run(contrast, pairs) if pair[2] < 4.5]
        assert not poor, poor
        browser.run("document.querySelector('nav button').click()")
    from selenium.webdriver.common.action_chains import ActionChains
    from selenium.webdriver.common.keys import Keys
    browser.run("document.activeElement.blur()")
    reached = set()
    for _ in range(12):
        ActionChains(browser.driver).send_keys(Keys.TAB).perform()
        reached.add(browser.run("return [...document.querySelectorAll('*')].indexOf(document.activeElement)"))
        assert browser.run("return getComputedStyle(document.activeElement).outlineStyle") != "none", "focus is invisible"
    assert len(reached) > 8, reached


def check_control(browser, page):
    """What a page must not do is noticed: a script that is not ours, a request, an error."""
    text = page.read_text()
    faults = {
        "a script": text.replace("<main", "<script>window.injected = 1</script><main", 1),
        "a request": text.replace("<main", '<img src="http://127.0.0.1:9/x.png" alt=""><main', 1),
        "a changed script": text.replace("'use strict';", "'use strict';window.injected = 1;", 1),
    }
    for name, faulty in faults.items():
        assert faulty != text, name
        changed = page.with_name("control.html")
        changed.write_text(faulty)
        browser.open(changed)
        assert browser.run("return window.injected") is None, f"control: {name} was run"
        assert browser.complaints(), f"control: {name} was not noticed"


def without_webgl(page):
    with Browser("--disable-3d-apis") as browser:
        ready(browser, page)
        said = browser.run("return document.getElementById('motion').textContent")
        assert "no WebGL2" in said, said
        assert rows(browser) > 0


def check_own(program):
    with tempfile.TemporaryDirectory() as folder:
        orders = report_of(program, pathlib.Path(folder), ORDERS)
        motion = report_of(program, pathlib.Path(folder), MOTION)
        with Browser() as browser:
            ready(browser, orders)
            for check in (check_labels, check_table, check_figure, check_access):
                check(browser)
            said = browser.run("return document.getElementById('motion').textContent")
            assert '"output": {"samples": 500}' in said, said
            check_quiet(browser, "orders")
            ready(browser, motion)
            for check in (check_motion, check_filled, check_places, check_forces, check_stopped, check_access):
                check(browser)
            check_quiet(browser, "motion")
            check_control(browser, orders)
        without_webgl(motion)
    print("browser.report: plays, scrubs, filters, sorts; no error, request or violation")


def check_folders(program, folders):
    with tempfile.TemporaryDirectory() as scratch, Browser() as browser:
        for folder in map(pathlib.Path, folders):
            page = written(program, folder, pathlib.Path(scratch) / (folder.name + ".html"))
            size = page.stat().st_size
            seconds = ready(browser, page)
            check_quiet(browser, folder.name)
            print(f"{folder.name}: {size} bytes, {seconds:.2f} s")
            assert size <= LARGEST, f"{folder.name}: expected at most {LARGEST} bytes"


if __name__ == "__main__":
    require_browser()
    check_folders(sys.argv[1], sys.argv[2:]) if sys.argv[2:] else check_own(sys.argv[1])
