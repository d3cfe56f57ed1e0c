"""A page as a reader meets it, in headless Chromium: browse.py PAGE WIDTH [SCREENSHOT]

Moves the slider through its keys and the choices through their events, and prints what it sees, a `name value` a line. Exits with
1 and says what is missing where the browser or its driver is not there.
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


def tell(name, value):
    print(name, value)


def script(code):
    return browser.execute_script("return " + code)


def there(selector):
    return len(browser.find_elements(By.CSS_SELECTOR, selector))


def picture():
    return hashlib.sha256(script("document.getElementById('mesh').toDataURL()").encode()).hexdigest()[:16]


def tell_mesh(moment):
    tell(moment + "_picture", picture())
    tell(moment + "_step", script("document.getElementById('mesh').dataset.step"))
    tell(moment + "_load", script("document.getElementById('mesh').dataset.load"))
    tell(moment + "_field", script("document.getElementById('mesh').dataset.field"))
    tell(moment + "_run", script("document.getElementById('mesh').dataset.run"))
    tell(moment + "_state", browser.find_element(By.ID, "state").text)


# Colours of the canvas that are neither white nor transparent, as a share of it.
PAINTED = """(() => {
  const c = document.getElementById('mesh'), d = c.getContext('2d').getImageData(0, 0, c.width, c.height).data;
  let n = 0;
  for (let k = 0; k < d.length; k += 4) n += d[k + 3] > 0 && d[k] + d[k + 1] + d[k + 2] < 750;
  return 4 * n / d.length;
})()"""

try:
    browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                            {"width": width, "height": 800, "deviceScaleFactor": 1, "mobile": width < 600})
    browser.get(page.as_uri())
    for name in ["figure svg", "figure img", "table", "canvas", "pre", ".note", "details"]:
        tell("count_" + name.replace(" ", "_"), there(name))
    tell("headings", "|".join(h.text for h in browser.find_elements(By.TAG_NAME, "h2")))
    tell("overflow", script("document.documentElement.scrollWidth - document.documentElement.clientWidth"))
    tell("viewport", script("document.documentElement.clientWidth"))
    if there("canvas"):
        tell("painted", script(PAINTED))
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
        browser.execute_script("location.hash = 'step=1&field=stress_xx'")
        browser.execute_async_script("setTimeout(arguments[0], 50)")
        tell_mesh("address")
        browser.execute_script("location.hash = 'run=2'")
        browser.execute_async_script("setTimeout(arguments[0], 50)")
        tell_mesh("other")
        browser.find_element(By.ID, "play").click()
        browser.execute_async_script("setTimeout(arguments[0], 1000)")
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
