#include "app/app.h"

#include "app/draw.h"
#include "app/present.h"
#include "app/sound.h"
#include "app/world.h"
#include "hal/audio_out.h"
#include "hal/display.h"
#include "hal/keypad.h"
#include "hal/panel.h"
#include "hal/system_id.h"

namespace app {

namespace {

constexpr unsigned FIFO = 128;
constexpr unsigned FRAME_IDLES = 1000;  // several frames, if idle() is as short as 50 us

void feed(Mixer& mixer, hal::AudioOut& audio, unsigned rate_hz) {
    StereoSample samples[FIFO];
    const unsigned space = audio.space();
    const unsigned count = space < FIFO ? space : FIFO;
    mixer.mix(samples, count, rate_hz);
    for (unsigned i = 0; i < count; ++i) audio.push(samples[i].left, samples[i].right);
}

class Program {
public:
    Program(hal::Mmio& io, hal::Cpu& cpu)
        : cpu_{cpu},
          panel_{io},
          keypad_{io},
          display_{io},
          audio_{io},
          rate_hz_{audio_.rate_hz()},
          world_{1 + panel_.switches()} {}

    void frame() {
        const std::uint32_t begin = cpu_.micros();
        char keys[16];
        unsigned count = 0;
        while (count < sizeof keys)
            if (const char key = keypad_.pressed())
                keys[count++] = key;
            else
                break;
        step(world_, {{keys, count}});
        feed(mixer_, audio_, rate_hz_);
        draw(world_, {tick_us_}, canvas_);
        presenter_.present(canvas_, display_);
        feed(mixer_, audio_, rate_hz_);
        sound_collisions(world_, mixer_);
        panel_.number(world_.count);
        panel_.leds(world_.pairs.size() < 1023 ? static_cast<std::uint32_t>(world_.pairs.size())
                                               : 1023);
        tick_us_ = cpu_.micros() - begin;

        display_.swap();
        for (unsigned i = 0; i < FRAME_IDLES && !display_.swapped(); ++i) {
            cpu_.idle();
            feed(mixer_, audio_, rate_hz_);
        }
    }

private:
    hal::Cpu& cpu_;
    hal::Panel panel_;
    hal::Keypad keypad_;
    hal::Display display_;
    hal::AudioOut audio_;
    const unsigned rate_hz_;
    World world_;
    Mixer mixer_;
    gfx::Canvas canvas_;
    Presenter presenter_;
    std::uint32_t tick_us_ = 0;
};

}  // namespace

void run(hal::Mmio& io, hal::Cpu& cpu) {
    if (!hal::system_id_matches(io)) {
        cpu.print("system ID: this bitstream has another register map\n");
        return;
    }
    Program program{io, cpu};
    cpu.print("ready\n");
    for (;;) program.frame();
}

}  // namespace app
