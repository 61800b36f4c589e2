# The two commands of a fresh machine: `make demo` and `make test`.

PYTHON ?= python3
PHOTO ?=
PHOTOS ?=
VENV ?= .venv
BIN := $(VENV)/bin
OUT ?= out
UPDATE ?=
LOWEST_PYTHON ?= python3.11
# Every process has one thread for matrices, and threads without work sleep: else processes wait for each other.
PYTEST = OPENBLAS_NUM_THREADS=1 OMP_WAIT_POLICY=passive $(BIN)/python -m pytest --numprocesses auto --maxprocesses 4 --dist worksteal

.PHONY: demo test pages check bench docs gallery lint dist lowest clean

$(BIN)/python:
	$(PYTHON) -m venv $(VENV)

# A stamp for each set of extras, so that nothing is installed twice.
$(VENV)/.%-installed: $(BIN)/python pyproject.toml
	$(BIN)/python -m pip install --quiet --editable ".[$*]"
	@touch $@

demo: $(VENV)/.demo-installed
	$(BIN)/python examples/demo.py --output $(OUT) $(if $(PHOTO),"$(PHOTO)")

test: $(VENV)/.test-installed
	sh .ci/install-browser
	sh .ci/install-gpu
	sh .ci/install-node-tools
	sh .ci/install-validators
	$(PYTEST) -m "not pages"

# The code of all pages, tutorials and examples, as a reader would run it.
pages: $(VENV)/.test-installed
	$(PYTEST) -m pages

# Laws of tile sets and tilings, and oracles of kernels: what to run while one works.
check: $(VENV)/.test-installed
	$(PYTEST) \
		tests/tiles tests/tilings/test_tilings.py tests/tilings/test_hashes.py tests/tilings/test_streams.py \
		tests/kernels tests/samplers/test_sampler_twins.py tests/signals/textures/test_mincut.py \
		tests/jobs tests/test_errors.py tests/test_house.py

# Ratios are compared with benchmarks/ratios.json; UPDATE=1 writes them there.
bench: $(VENV)/.bench-installed $(VENV)/.test-installed
	$(BIN)/python -m pytest benchmarks --benchmark-columns=min,median,max --benchmark-sort=name \
		$(if $(UPDATE),--update-ratios)

lint: $(VENV)/.lint-installed
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	$(BIN)/mypy tests/typing/public_face.py
	$(BIN)/pyright --pythonpath $(BIN)/python
	$(BIN)/lint-imports
	$(BIN)/python tools/check_docstrings.py

docs: $(VENV)/.docs-installed
	$(BIN)/mkdocs build --strict --quiet
	$(if $(PHOTOS),$(BIN)/python examples/gallery.py --photos "$(PHOTOS)" --output site/gallery/photographs)

# Every photograph of a folder as tile set, wide, close and by five methods, in out/gallery.
gallery: $(VENV)/.demo-installed
	$(BIN)/python examples/gallery.py $(if $(PHOTOS),--photos "$(PHOTOS)")

# The wheel and the source distribution, in dist/ once the wheel has worked in an empty environment.
dist: $(VENV)/.dist-installed
	$(BIN)/python tools/check_dist.py

# The lowest versions of the dependencies that pyproject.toml allows, in an environment of their own.
lowest:
	$(LOWEST_PYTHON) tools/lowest.py

clean:
	rm -rf $(VENV) $(OUT) dist site
