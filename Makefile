# The front door. CMakePresets.json holds the builds themselves.
.PHONY: run test bench build deps clean
.DEFAULT_GOAL := build

stylet := build/release/bin/stylet
fig10a := fig10a_l150 fig10a_l200 fig10a_l300

# Fig. 10(a) of the paper: three needles, their summaries, and one picture.
run: build
	$(stylet) run $(fig10a:%=scenes/paper/%.yaml) --out out
	$(stylet) plot $(fig10a:%=out/%.csv) --x travel --out out/fig10a

test: build
	ctest --preset release

bench: build
	build/release/bin/stylet_bench

build: deps
	cmake --preset release
	cmake --build --preset release

# Installs what is missing through apt-get.
deps:
	@.ci/deps

clean:
	rm -rf build out
