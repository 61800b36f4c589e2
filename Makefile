# The two commands of a fresh machine: `make demo` and `make test`.

PYTHON ?= python3
PHOTO ?=
VENV := .venv
BIN := $(VENV)/bin
OUT ?= out

.PHONY: demo test bench docs lint clean

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
	$(BIN)/python -m pytest

bench: $(VENV)/.bench-installed $(VENV)/.test-installed
	$(BIN)/python -m pytest benchmarks --benchmark-columns=min,median,max --benchmark-sort=name

lint: $(VENV)/.lint-installed
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	$(BIN)/lint-imports

docs: $(VENV)/.docs-installed
	$(BIN)/mkdocs build --strict --quiet

clean:
	rm -rf $(VENV) $(OUT) site
