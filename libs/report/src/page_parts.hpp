// The script and the style of the page, as page.js and page.css have them.
#pragma once

namespace cleft::report {

extern const char* const k_page_js;
extern const char* const k_page_css;

}  // namespace cleft::report
