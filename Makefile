# The menu. Each entry shows the real command.

.PHONY: all build setup help demo test test-all fast asan coverage bench firmware
.PHONY: package portable bench-history nightly weekly tsan clang
.PHONY: soak formal mutants synth netlist table1 fuzz instructions qsf bitstream
.PHONY: regmap format clean configure everything
.PHONY: fuzz-programs deploy rollback deploy-jtag

all: build

# A warning of the compiler ends the build of the tests where CI builds them.
WERROR = $(if $(CI),ON,OFF)

build: configure        ## build/bin/de1sim
	@cmake --build build --target tool

help:                   ## print this menu
	@sed -n 's/^\([a-z][a-z0-9-]*\):.*## */\1\t/p' Makefile | \
	    while IFS=$$(printf '\t') read -r name what; do \
	        printf '%-16s %s\n' "$$name" "$$what"; done

setup:                  ## [FOR="tool firmware test"] install the Debian packages that are missing
	@.ci/setup $(FOR)

configure:
	@.ci/configure
everything:
	@.ci/configure FIRMWARE TESTS TEST_ALL BOARD WERROR=$(WERROR)

qsf:                    ## write the Quartus project again from the top module's ports and board.tsv
	@/usr/bin/python3 -B rtl/board/de1_soc/gen_qsf.py > build/de1_soc.qsf
	@mv build/de1_soc.qsf rtl/board/de1_soc/de1_soc.qsf

bitstream:              ## with Quartus: build/bitstream/de1_soc.rbf and de1_soc_jtag.rbf
	@rtl/board/de1_soc/bitstream.sh

deploy:                 ## BOARD=user@host [RBF=file] [DRY_RUN=1]: to the board's Linux (sw/deploy)
	@sw/deploy/deploy.sh arguments
	@$(MAKE) --no-print-directory firmware
	@sw/deploy/deploy.sh deploy

rollback:               ## BOARD=user@host [DRY_RUN=1]: the version before
	@sw/deploy/deploy.sh rollback

deploy-jtag:            ## [RBF=file] [DRY_RUN=1]: the bitstream over USB, with openFPGALoader
	@sw/deploy/jtag.sh

firmware:               ## what the board runs -> build/firmware/, and its overlays -> build/deploy/
	@.ci/configure FIRMWARE BOARD
	@cmake --build build --target firmware

demo:                   ## ten seconds of the demo -> out/, packages first
	@.ci/setup tool firmware
	@.ci/configure FIRMWARE
	@cmake --build build --target de1sim firmware_bare
	build/bin/de1sim run tb/system/demo.yaml --cpu arm --elf build/firmware/collide.elf --out out \
	    --html out/report.html
	@echo
	@echo "  out/frames/*.png              what the monitor showed (any image viewer)"
	@echo "  out/audio.wav                 what the line-out played (any audio player)"
	@echo "  out/report.json, junit.xml    what was counted and expected"
	@echo "  out/report.html               all of it on one page (any browser)"
	@echo
	@echo "  build/bin/de1sim live build/firmware/collide.elf    to play with it in a browser"

package:                ## build/package/de1sim_*.deb
	@.ci/configure FIRMWARE
	@cmake --build build --target deb

portable:               ## build/package/de1sim-*-linux-*.tar.xz, for every Linux
	@.ci/configure FIRMWARE
	@cmake --build build --target tool examples
	@sim/package/portable.sh build

test:                   ## the tests of every push, packages first
	@.ci/setup tool firmware board test
	@.ci/configure FIRMWARE TESTS BOARD WERROR=$(WERROR)
	@cmake --build build
	@.ci/test test

test-all:               ## every test, packages first: before a release, and each night
	@.ci/setup tool firmware board test
	@$(MAKE) --no-print-directory everything
	@cmake --build build
	@.ci/test test-all

fast: everything        ## every test but the whole-system ones
	@cmake --build build
	@.ci/test fast

# Tests of what has threads, or starts what has them.
THREADS = FrameWriter Wav CommandLineRun[.]Writes Scenario[.]one_key FailingRun[.]Interrupted \
    BrokenRun[.].*Report Of/Video[.]Lasts.*mp4 Gdb Suite[.]of_ Live[.](live|waves)
tsan:                   ## what has threads, with the thread sanitizer
	@.ci/setup --check tool firmware test
	@cmake --preset tsan
	@cmake --build --preset tsan
	@rm -rf build/tsan/races && mkdir build/tsan/races
	@.ci/test tsan -R "^($$(echo '$(THREADS)' | tr ' ' '|'))"; code=$$?; \
	    cat build/tsan/races/* 2>/dev/null && exit 1; exit $$code

asan:                   ## every test, with address and undefined-behaviour sanitizers
	@.ci/setup --check tool firmware board test
	@cmake --preset asan
	@cmake --build build/asan
	@.ci/test asan

clang:                  ## every test but the whole-system ones, built by clang
	@.ci/setup --check tool firmware test fuzz
	@cmake --preset clang
	@cmake --build build/clang
	@.ci/test clang

coverage:               ## of the RTL and the C++ -> build/coverage/html/index.html
	@.ci/setup --check tool firmware board test
	@cmake --preset coverage
	@cmake --build build/coverage
	@cmake --build build/coverage --target coverage

formal: everything      ## proofs with Yosys and z3 (tb/formal)
	@cmake --build build --target formal

mutants:                ## [N=330] [SEED=n] [BLOCK=vga] [ONLY=id] [RESUME=1]: who finds its faults
	@.ci/setup --check tool firmware test
	@/usr/bin/python3 -B tb/mutants/mutants.py --number $(or $(N),330) --seed $(or $(SEED),1) \
	    $(if $(BLOCK),--block $(BLOCK)) $(if $(ONLY),--only "$$ONLY") $(if $(RESUME),--resume)

synth: everything       ## what the netlist takes of the device, and the limits (tb/synth)
	@cmake --build build --target synth

netlist: everything     ## the netlist plays the demo's beginning as the Verilog does
	@cmake --build build --target netlist

bench: everything       ## how fast, beside the bare Verilated model in the same run
	@cmake --build build --target bench

bench-history: everything ## the same, kept and compared: build/bench/history.svg
	@/usr/bin/python3 -B tb/bench/history.py build/bench -- cmake --build build --target bench

table1: everything      ## the paper's experiments -> out/table1/, sw/collision/REPRODUCTION.md
	@cmake --build build --target table1

# Each target for FUZZ_SECONDS or FUZZ_RUNS; without TARGET also damaged programs and system calls.
FUZZ_SECONDS ?= 60
FUZZ_CALLS ?= 10000000
FUZZ_SEED ?= 1
fuzz:                   ## [FUZZ_SECONDS=60] [FUZZ_RUNS=n] [TARGET=png] any bytes into all readers
	@.ci/setup --check tool fuzz
	@mkdir -p build && cmake --preset fuzz > build/fuzz.log || { cat build/fuzz.log; exit 1; }
	@cmake --build --preset fuzz
	@/usr/bin/python3 -B tb/fuzz/run.py build/fuzz/bin build/fuzz/corpus tb/fuzz \
	    $(if $(FUZZ_RUNS),--runs $(FUZZ_RUNS),--seconds $(FUZZ_SECONDS)) $(TARGET)
	@$(if $(TARGET),true,$(MAKE) --no-print-directory fuzz-programs)

fuzz-programs: everything ## [FUZZ_CALLS=n] [FUZZ_SEED=n] damaged programs, Linux calls at random
	@cmake --build build --target de1sim firmware linux_programs
	@/usr/bin/python3 -B tb/fuzz/elf/mutants.py build/bin/de1sim build/damaged_programs \
	    build/firmware/collide.elf build/firmware/collide-linux
	@/usr/bin/python3 -B tb/fuzz/calls/calls.py build/bin/de1sim \
	    build/tb/programs/linux/calls_at_random build/calls --calls $(FUZZ_CALLS) \
	    --seed $(FUZZ_SEED) --limit 3600

soak: everything        ## an hour of de1sim live with a client that comes and goes (SOAK_MINUTES)
	@cmake --build build --target soak

instructions: everything ## 10^9 random ones on the processor and QEMU's [ARM_CORE_SEED=n]
	@cmake --build build --target arm_core_unicorn_test
	@ARM_CORE_INSTRUCTIONS=1000000000 build/bin/arm_core_unicorn_test --gtest_filter='Against*'


# The register map's views are printed without CMake, because its configuration runs Verilator on
# them.
regmap:                 ## write what is made of sources again: REGISTERS.md, STEPS.md and more
	@mkdir -p build
	@$(CXX) -std=c++17 -Irtl/regmap -o build/gen_regmap rtl/regmap/gen_regmap.cpp
	@build/gen_regmap vh > build/regmap.vh && mv build/regmap.vh rtl/regmap/
	@build/gen_regmap decode > build/lw_decode.vh && mv build/lw_decode.vh rtl/regmap/
	@build/gen_regmap md > build/REGISTERS.md && mv build/REGISTERS.md rtl/regmap/
	@build/gen_regmap de10 > build/DE10_LITE.md && mv build/DE10_LITE.md rtl/regmap/
	@build/gen_regmap c > build/registers.h && mv build/registers.h sw/examples/
	@$(CXX) -std=c++17 -Isw -o build/gen_font sw/gfx/gen_font.cpp sw/gfx/font.cpp sw/gfx/canvas.cpp
	@build/gen_font > build/character_font.vh && mv build/character_font.vh rtl/vga/
	@.ci/configure
	@cmake --build build --target schema_files
	@/usr/bin/python3 -B tb/lint/not_handled.py . --write

nightly:                ## what CI does each night, command by command
	@.ci/setup --check tool firmware board test fuzz
	@.ci/tier nightly

weekly:                 ## what CI does each week, likewise
	@.ci/setup --check tool firmware board test
	@.ci/tier weekly

format:                 ## lay out all C++
	@git ls-files -co --exclude-standard '*.h' '*.cpp' | xargs -d '\n' clang-format -i

clean:
	rm -rf build out
