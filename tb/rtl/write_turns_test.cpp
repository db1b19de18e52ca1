// write_turns_test.cpp - whose write goes to which memory, and that nothing of it is changed
#include <cstdint>

#include "Vwrite_turns.h"
#include "tb/support/register_bus.h"

namespace {

class WriteTurns : public tb::RegisterBus<Vwrite_turns> {
protected:
    static constexpr std::uint32_t CAMERA = 0xc0ffee42, PROCESSOR = 0x12345678;
    static constexpr std::uint32_t CAMERA_INDEX = 0xa5c3b7, INDEX = 0x5a3c49;

    void SetUp() override {
        dut.onchip_busy_i = dut.onchip_we_i = dut.req_i = dut.we_i = dut.sdram_take_i = 0;
        dut.video_onchip_i = dut.video_sdram_i = 0;
        dut.onchip_windex_i = INDEX & 0xffff;
        dut.onchip_wdata_i = dut.wdata_i = PROCESSOR;
        dut.index_i = INDEX;
        dut.wstrb_i = 0x6;
        dut.video_index_i = CAMERA_INDEX;
        dut.video_wdata_i = CAMERA;
        dut.rst_i = 1;
        clock(4);
        dut.rst_i = 0;
        clock();
    }
    void is_the_processors_in_the_sdram() {
        EXPECT_EQ(dut.sdram_req_o, 1);
        EXPECT_EQ(dut.sdram_index_o, INDEX);
        EXPECT_EQ(dut.sdram_wdata_o, PROCESSOR);
        EXPECT_EQ(dut.sdram_wstrb_o, 0x6);
    }
    void is_the_cameras_in_the_sdram() {
        EXPECT_EQ(dut.sdram_req_o, 1);
        EXPECT_EQ(dut.sdram_we_o, 1);
        EXPECT_EQ(dut.sdram_index_o, CAMERA_INDEX);
        EXPECT_EQ(dut.sdram_wdata_o, CAMERA);
        EXPECT_EQ(dut.sdram_wstrb_o, 0xf);
    }
};

TEST_F(WriteTurns, GivesTheOnChipMemoryToTheProcessorFirst) {
    dut.video_onchip_i = 1;
    dut.onchip_we_i = 0x9;
    dut.onchip_busy_i = 1;
    dut.eval();
    EXPECT_EQ(dut.onchip_we_o, 0x9);
    EXPECT_EQ(dut.onchip_windex_o, INDEX & 0xffff);
    EXPECT_EQ(dut.onchip_wdata_o, PROCESSOR);
    EXPECT_EQ(dut.video_onchip_take_o, 0);
}

TEST_F(WriteTurns, WritesTheCamerasWholeWordToTheOnChipMemory) {
    dut.video_onchip_i = 1;
    dut.eval();
    EXPECT_EQ(dut.onchip_we_o, 0xf);
    EXPECT_EQ(dut.onchip_windex_o, CAMERA_INDEX & 0xffff);
    EXPECT_EQ(dut.onchip_wdata_o, CAMERA);
    EXPECT_EQ(dut.video_onchip_take_o, 1);
    EXPECT_EQ(dut.awake_o, 1);
}

TEST_F(WriteTurns, WaitsWithTheCamerasWordWhileCharactersAreWritten) {
    dut.video_onchip_i = 1;
    dut.onchip_busy_i = 1;  // without a strobe for the memory itself
    dut.eval();
    EXPECT_EQ(dut.onchip_we_o, 0);
    EXPECT_EQ(dut.video_onchip_take_o, 0);
}

TEST_F(WriteTurns, GivesTheSdramToTheCameraFirst) {
    dut.req_i = dut.we_i = dut.video_sdram_i = dut.sdram_take_i = 1;
    dut.eval();
    is_the_cameras_in_the_sdram();
    EXPECT_EQ(dut.video_sdram_take_o, 1);
    EXPECT_EQ(dut.take_o, 0);
    clock();
    dut.video_sdram_i = 0;
    dut.eval();
    is_the_processors_in_the_sdram();
    EXPECT_EQ(dut.sdram_we_o, 1);
    EXPECT_EQ(dut.take_o, 1);
    EXPECT_EQ(dut.video_sdram_take_o, 0);
}

TEST_F(WriteTurns, KeepsAProcessorsRequestThatTheSdramHasSeen) {
    dut.req_i = 1;  // a read
    dut.eval();
    is_the_processors_in_the_sdram();
    EXPECT_EQ(dut.sdram_we_o, 0);
    clock();
    dut.video_sdram_i = 1;
    for (int wait = 0; wait < 3; ++wait) {
        dut.eval();
        is_the_processors_in_the_sdram();
        EXPECT_EQ(dut.awake_o, 1);
        clock();
    }
    dut.sdram_take_i = 1;
    dut.eval();
    EXPECT_EQ(dut.take_o, 1);
    EXPECT_EQ(dut.video_sdram_take_o, 0);
    clock();
    dut.eval();
    is_the_cameras_in_the_sdram();
    EXPECT_EQ(dut.video_sdram_take_o, 1);
}

TEST_F(WriteTurns, AsksForNothingOnItsOwn) {
    EXPECT_EQ(dut.onchip_we_o, 0);
    EXPECT_EQ(dut.sdram_req_o, 0);
    EXPECT_EQ(dut.awake_o, 0);
}

}  // namespace
