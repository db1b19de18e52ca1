// registers.cpp - registers that keep what is written, or say what the documents promise
#include "hal/system_id.h"
#include "regmap.h"
#include "selftest/checks.h"

namespace selftest {

namespace {

// Every bit of `mask` keeps both values, every other reads 0.  Leaves 0.
Finding reads_back(Bench& bench, std::uint32_t address, std::uint32_t mask) {
    Finding finding;
    for (const std::uint32_t pattern : {0xFFFFFFFFu, 0xAAAAAAAAu, 0x55555555u, 0u}) {
        bench.io.write(address, pattern);
        finding = equal(address, bench.io.read(address), pattern & mask);
        if (!finding.met) break;
    }
    bench.io.write(address, 0);
    return finding.met ? equal(address, mask, mask) : finding;
}

}  // namespace

Finding system_id(Bench& bench) {
    if (hal::system_id_matches(bench.io)) return met("DE1S");
    const Finding id =
        equal(regmap::SYSID_ID, bench.io.read(regmap::SYSID_ID), regmap::SYSID_ID_RESET);
    if (!id.met) return id;
    return equal(regmap::SYSID_HASH, bench.io.read(regmap::SYSID_HASH), regmap::REGMAP_HASH);
}

Finding ledr(Bench& bench) { return reads_back(bench, regmap::LEDR_DATA, 0x3FF); }
Finding hex3_0(Bench& bench) { return reads_back(bench, regmap::HEX3_0_DATA, 0x7F7F7F7F); }
Finding hex5_4(Bench& bench) { return reads_back(bench, regmap::HEX5_4_DATA, 0x7F7F); }
Finding key_mask(Bench& bench) { return reads_back(bench, regmap::KEY_MASK, 0xF); }
Finding jp2_mask(Bench& bench) { return reads_back(bench, regmap::JP2_MASK, 0xFFFFFFFF); }

Finding unused_bits(Bench& bench) {
    const Finding sw = equal(regmap::SW_DATA, bench.io.read(regmap::SW_DATA) & ~0x3FFu, 0);
    return sw.met ? equal(regmap::KEY_DATA, bench.io.read(regmap::KEY_DATA) & ~0xFu, 0) : sw;
}

Finding resolution(Bench& bench) {
    return equal(regmap::PIXEL_RESOLUTION, bench.io.read(regmap::PIXEL_RESOLUTION), 0x00F00140);
}

Finding codec(Bench& bench) {
    const std::uint32_t begin = bench.cpu.micros();
    std::uint32_t status = 0;
    while (!(status & (regmap::CODEC_STATUS_READY_MASK | regmap::CODEC_STATUS_ERROR_MASK)) &&
           bench.cpu.micros() - begin < 100'000) {
        bench.cpu.idle();
        status = bench.io.read(regmap::CODEC_STATUS);
    }
    return equal(regmap::CODEC_STATUS, status & 3, regmap::CODEC_STATUS_READY_MASK);
}

}  // namespace selftest
