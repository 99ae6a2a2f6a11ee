# `make demo` and `make test` do everything on a fresh Debian 12 machine, packages included.
.PHONY: setup build demo test bench bench-solve bench-seams bench-inflate dress-seams robustness matched accuracy accuracy-check guide docs field sanitize races same-bytes \
	install format check tidy clean
PRESET ?= release
JOBS ?= $(shell nproc)
PREFIX ?= /usr/local
SANITIZE_WITHOUT ?= none

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

# The tests, with the library under AddressSanitizer and UndefinedBehaviorSanitizer. SANITIZE_WITHOUT=commands leaves out the
# suites that run the program.
sanitize: build/.setup
	cmake --preset $(PRESET) -Wno-dev
	cmake --build build/release -j $(JOBS) --target sanitized
	ctest --test-dir build/release -C sanitized -L sanitized -LE "$(SANITIZE_WITHOUT)" -j $(JOBS) --output-on-failure

# The tests of several threads, with the library under ThreadSanitizer.
races: build/.setup
	cmake --preset $(PRESET) -Wno-dev
	cmake --build build/release -j $(JOBS) --target races
	ctest --test-dir build/release -C races -L races --output-on-failure

# Compares the outputs of this build with those of a build by clang without optimisation, byte for byte.
same-bytes: build/.setup
	cmake --preset $(PRESET) -Wno-dev
	cmake --build build/release -j $(JOBS) --target ripstop-program
	cmake --preset clang -Wno-dev
	cmake --build build/clang -j $(JOBS) --target ripstop-program
	python3 tests/anywhere/compare.py build/release/ripstop build/clang/ripstop . ../shared/data

check:
	scripts/check_format.sh
	python3 scripts/check_rooms.py src/ripstop
	python3 scripts/check_names.py src/ripstop
	python3 scripts/check_headers.py .
	python3 scripts/docs/check_links.py --sources .

# Runs clang-tidy on the sources that differ from a commit: make tidy SINCE=HEAD~3
tidy: build/.setup
	scripts/check_tidy.sh $(SINCE)

format:
	scripts/check_format.sh --fix

clean:
	rm -rf build demo
