"""A report's page as a reader meets it, in headless Chromium: browse.py PAGE WIDTH [SCREENSHOT]

Uses the slider, the choices and the address, and prints what is then seen, `name value` a line.
"""
import hashlib
import json
import pathlib
import sys

from selenium import webdriver
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.chrome.service import Service

page, width = pathlib.Path(sys.argv[1]).resolve(), int(sys.argv[2])

options = webdriver.ChromeOptions()
options.binary_location = "/usr/bin/chromium"
for argument in ["--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--disable-gpu", "--force-color-profile=srgb"]:
    options.add_argument(argument)
options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
browser = webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)
browser.set_script_timeout(20)


def tell(name, value):
    print(name, value)


def script(code):
    return browser.execute_script("return " + code)


def there(selector):
    return len(browser.find_elements(By.CSS_SELECTOR, selector))


def picture():
    return hashlib.sha256(script("document.getElementById('mesh').toDataURL()").encode()).hexdigest()[:16]


def tell_mesh(moment):
    share, top = script(PAINTED)
    tell(moment + "_picture", picture())
    tell(moment + "_painted", share)
    tell(moment + "_top", top)
    tell(moment + "_step", script("document.getElementById('mesh').dataset.step"))
    tell(moment + "_load", script("document.getElementById('mesh').dataset.load"))
    tell(moment + "_field", script("document.getElementById('mesh').dataset.field"))
    tell(moment + "_run", script("document.getElementById('mesh').dataset.run"))
    tell(moment + "_state", browser.find_element(By.ID, "state").text)


# Share of the canvas that is painted, and its first painted row from the top as a share of its height.
PAINTED = """(() => {
  const c = document.createElement('canvas'), mesh = document.getElementById('mesh');
  [c.width, c.height] = [mesh.width, mesh.height];
  const pen = c.getContext('2d', {willReadFrequently: true});
  pen.drawImage(mesh, 0, 0);
  const d = pen.getImageData(0, 0, c.width, c.height).data;
  let n = 0, first = d.length;
  for (let k = 0; k < d.length; k += 4)
    if (d[k + 3] > 0 && d[k] + d[k + 1] + d[k + 2] < 750) {
      ++n;
      first = Math.min(first, k);
    }
  return [4 * n / d.length, Math.floor(first / 4 / c.width) / c.height];
})()"""

try:
    browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                            {"width": width, "height": 800, "deviceScaleFactor": 1, "mobile": width < 600})
    browser.get(page.as_uri())
    tell("title", browser.title)
    for name in ["figure svg", "figure img", "table", "canvas", "pre", ".note", "details"]:
        tell("count_" + name.replace(" ", "_"), there(name))
    tell("headings", "|".join(h.text for h in browser.find_elements(By.TAG_NAME, "h2")))
    tell("overflow", script("document.documentElement.scrollWidth - document.documentElement.clientWidth"))
    tell("viewport", script("document.documentElement.clientWidth"))
    if there("canvas"):
        tell_mesh("last")
        slider = browser.find_element(By.ID, "step")
        slider.send_keys(Keys.HOME)
        tell_mesh("first")
        slider.send_keys(Keys.ARROW_RIGHT)
        tell_mesh("second")
        slider.send_keys(Keys.END)
        tell_mesh("again")
        browser.find_element(By.ID, "edges").click()
        tell_mesh("plain")
        factor = browser.find_element(By.ID, "factor")
        tell("factor", factor.get_attribute("value"))
        factor.send_keys("0")  # ten times as much
        tell_mesh("larger")
        browser.execute_script("location.hash = 'step=1&field=stress_xx&factor=1'")
        browser.execute_async_script("setTimeout(arguments[0], 50)")
        tell_mesh("address")
        browser.execute_script("location.hash = 'run=2&step=1'")
        browser.execute_async_script("setTimeout(arguments[0], 50)")
        tell_mesh("other")
        browser.find_element(By.ID, "play").click()
        browser.execute_async_script("""
            const mesh = document.getElementById('mesh'), before = mesh.dataset.step;
            const wait = () => mesh.dataset.step === before ? setTimeout(wait, 20) : arguments[0]();
            wait();""")
        tell("playing", browser.find_element(By.ID, "play").text)
        browser.find_element(By.ID, "play").click()
        tell_mesh("played")
    if len(sys.argv) > 3:
        height = script("document.documentElement.scrollHeight")
        browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                                {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": width < 600})
        browser.save_screenshot(sys.argv[3])
    requests = [json.loads(entry["message"])["message"] for entry in browser.get_log("performance")]
    urls = {r["params"]["request"]["url"] for r in requests if r["method"] == "Network.requestWillBeSent"}
    tell("requests", "|".join(sorted(u for u in urls if not u.startswith("data:") and not u.startswith(page.as_uri()))))
    tell("console", "|".join(entry["message"] for entry in browser.get_log("browser")))
finally:
    browser.quit()
