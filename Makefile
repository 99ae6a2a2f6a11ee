# `make demo` and `make test` do everything on a fresh Debian 12 machine, packages included.
.PHONY: setup build demo test bench bench-solve bench-seams bench-inflate dress-seams robustness matched accuracy accuracy-check guide docs field sanitize \
	install format check tidy clean
PRESET ?= release
JOBS ?= $(shell nproc)
PREFIX ?= /usr/local

build: build/.setup
	cmake --preset $(PRESET) -Wno-dev
	cmake --build build/release -j $(JOBS)

demo: build/.setup
	cmake --preset $(PRESET) -Wno-dev
	cmake --build build/release -j $(JOBS) --target ripstop-programs
	scripts/demo.sh

test: build
	ctest --test-dir build/release -j $(JOBS) --output-on-failure

bench: build
	build/release/ripstop-bench

bench-solve: build
	build/release/ripstop-bench-solve $(SOLVE)

bench-seams: build
	build/release/ripstop-bench-seams

bench-inflate: build
	build/release/ripstop-bench-inflate $(TABLES)

dress-seams: build
	build/release/ripstop-dress-seams

robustness: build
	build/release/ripstop-robustness

matched: build
	build/release/ripstop-matched

accuracy: build
	build/release/ripstop-accuracy $(METHODS)

accuracy-check: build
	build/release/ripstop-accuracy --check docs/accuracy.md

# docs/guide.md anew, with what the program prints now, and build/guide/guide.html with the pictures in it.
guide: build
	node scripts/guide/make.mjs build/release/ripstop build/guide

# build/docs: one site of guide, methods, formats, decisions and public headers, every link checked. Builds the program only
# where nobody took the pictures of the guide yet.
docs: $(if $(wildcard build/guide/pictures/*.png build/release/guide/pictures/*.png),build/.setup,build)
	python3 scripts/docs/make.py build/release/ripstop

# Thousands of made envelopes through check, flatten and cut lines; some minutes. FIELD=sleeve: those with that word alone.
field: build/.setup
	cmake --preset $(PRESET) -Wno-dev
	cmake --build build/release -j $(JOBS) --target ripstop-field
	build/release/tests/ripstop-field $(FIELD)

# As `make install PREFIX=$HOME/ripstop`; the folder may be moved afterwards.
install: build
	cmake --install build/release --prefix $(PREFIX)

setup:
	scripts/setup.sh
	mkdir -p build && touch build/.setup

build/.setup: scripts/setup.sh scripts/packages.txt apps/rhino/package-lock.json apps/report/package-lock.json tests/dxf/package-lock.json
	$(MAKE) setup

sanitize: build/.setup
	cmake --preset asan -Wno-dev
	cmake --build build/asan -j $(JOBS)
	ctest --test-dir build/asan -j $(JOBS) --output-on-failure --timeout 900

check:
	scripts/check_format.sh
	python3 scripts/check_rooms.py src/ripstop
	python3 scripts/check_names.py src/ripstop
	python3 scripts/check_headers.py .
	python3 scripts/docs/check_links.py --sources .

# The sources that differ from a commit, by clang-tidy: make tidy SINCE=HEAD~3
tidy: build/.setup
	scripts/check_tidy.sh $(SINCE)

format:
	scripts/check_format.sh --fix

clean:
	rm -rf build demo
