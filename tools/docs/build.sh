#!/usr/bin/env bash
# Builds the documentation, to be read without a network: build/docs/html/index.html. Pages are written in Markdown (pages/), or made of
# the program's own texts and of the scenes of verification/, which are run for their pictures; below api/ is what Doxygen makes of the
# public headers. Fails where a link is dead, or where a comment of the code cites an equation that there is not.
source "$(dirname "${BASH_SOURCE[0]}")/../setup.sh"
install_missing_packages pandoc doxygen
build cleft

/usr/bin/python3 tools/docs/check_equations.py
say "writing the pages"
/usr/bin/python3 tools/docs/make_pages.py build/docs/html
say "writing the reference of the libraries"
rm -rf build/docs/html/api
doxygen tools/docs/Doxyfile
/usr/bin/python3 tools/docs/check_links.py build/docs/html
say "read build/docs/html/index.html"
