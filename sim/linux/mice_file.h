// mice_file.h - an open /dev/input/mice or mouse0: packets of the PS/2 protocol.
//
// It has a wheel if the program asks as a PS/2 driver does (ImPS/2).  What is moved between two
// reads is one packet.
//
// Source: Linux 6.1, drivers/input/mousedev.c.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sim/linux/device.h"
#include "sim/linux/input_device.h"

namespace sim {

class MiceFile final : public LinuxDevice, public InputListener {
public:
    // Of one mouse; or of all there are, without.
    MiceFile(std::shared_ptr<InputDevice> mouse, unsigned number)
        : mouse_{std::move(mouse)}, number_{number} {}

    FileStatus status() const override;
    std::string name() const override { return "the USB mouse"; }
    unsigned can_do() const override;
    std::int64_t read(void* data, std::size_t bytes) override;
    std::int64_t write(const void* data, std::size_t bytes) override;
    void hear(const InputEvent& event) override;

private:
    bool is_gone() const { return mouse_ && !mouse_->exists(); }
    void report();
    void command(std::uint8_t byte);

    const std::shared_ptr<InputDevice> mouse_;
    const unsigned number_;
    int right_ = 0, up_ = 0, wheel_ = 0;
    std::uint8_t buttons_ = 0;
    bool moved_ = false, has_wheel_ = false;
    std::size_t asked_ = 0;
    std::vector<std::uint8_t> answer_;
};

}  // namespace sim
