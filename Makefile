# The front door. CMakePresets.json holds the builds themselves.
.PHONY: run needles buckling tissue studies test bench bench-tissue build deps clean
.DEFAULT_GOAL := build

stylet := build/release/bin/stylet
fig10a := fig10a_l150 fig10a_l200 fig10a_l300

# Fig. 10(a) of the paper: three needles, their summaries, and one picture.
run: build
	$(stylet) run $(fig10a:%=scenes/paper/%.yaml) --out out
	$(stylet) plot $(fig10a:%=out/%.csv) --x travel --out out/fig10a

# The same three with a needle that needs no formula, and both needles on one picture.
needles: run
	$(foreach l,150 200 300,$(stylet) run scenes/paper/fig10a_l$(l).yaml --set needle.type=rod --set 'title=L = $(l) mm, rod' --out out/rod &&) true
	$(stylet) plot $(foreach l,150 200 300,out/fig10a_l$(l).csv out/rod/fig10a_l$(l).csv) --x travel --out out/fig10a_needles

# Figs. 3 and 4(b) and Tables 1 and 2 of the paper: critical loads by each model, as pictures and as one table.
buckling: build
	$(stylet) critical-load scenes/paper/fig3.yaml --vary needle.radius=0.1..1mm --plot out/fig3a
	$(stylet) critical-load scenes/paper/fig3.yaml --vary needle.length=10..200mm --points 191 --plot out/fig3b
	$(stylet) critical-load scenes/paper/fig4b.yaml --depth '50 mm' --vary 'tissue.layers[0].youngs_modulus=5..100kPa' --stiffness --plot out/fig4b
	$(stylet) critical-load scenes/paper/table*.yaml --depth '50 mm' --reference scenes/paper/tables.csv \
	  --model foundation,form=printed --model foundation,form=consistent --model winkler \
	  --model layered_explicit,terms=2 --model layered_explicit,terms=3

# The needle of 150 mm into meshes of three sizes and into the half-space: force against travel on one picture.
meshes := 6,6,3 10,10,4 16,16,6
tissue: build
	$(stylet) run scenes/paper/fig10a_l150.yaml --set 'title=half_space' --out out/tissue/half_space
	$(foreach m,$(meshes),$(stylet) run scenes/paper/fig10a_l150.yaml --set tissue.type=corotational_fem --set 'tissue.corotational_fem.cells=[$(m)]' \
	  --set 'title=corotational_fem, $(m) cells' --out out/tissue/$(m) &&) true
	$(stylet) plot out/tissue/half_space/fig10a_l150.csv $(foreach m,$(meshes),out/tissue/$(m)/fig10a_l150.csv) --x travel --out out/tissue/meshes

# What accuracy costs in time: each study leaves its page and picture in docs/studies. A quarter of an hour on a quiet machine; stopped, it
# goes on where it was. `make studies again=--again` measures everything anew.
studies: build
	$(foreach s,$(wildcard scenes/studies/*.yaml),$(stylet) study $(s) --out docs/studies $(again) &&) true

test: build
	ctest --preset release

bench: build
	build/release/bin/stylet_bench
	build/release/bin/stylet_answers_bench

# The finite-element tissue on four meshes, step by step against Newton's method: half an hour. `make bench-tissue cells=15` leaves the
# largest out.
bench-tissue: build
	build/release/bin/stylet_tissue_bench $(cells)

build: deps
	cmake --preset release
	cmake --build --preset release

# Installs what is missing through apt-get.
deps:
	@.ci/deps

clean:
	rm -rf build out
