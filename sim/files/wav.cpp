// wav.cpp - WAV by libsndfile
#include "sim/files/wav.h"

#include <fmt/format.h>
#include <sndfile.h>

#include <cerrno>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "sim/files/whole_file.h"

namespace sim {

namespace {

constexpr std::size_t BLOCK_VALUES = 2 * 4096;
constexpr std::size_t MAX_WAITING_VALUES = 2 * 65536;
constexpr int MAX_RATE_HZ = 384000;

}  // namespace

struct WavWriter::Part {
    Part(const std::filesystem::path& path, int rate_hz) : file(path) {
        SF_INFO info{};
        info.samplerate = rate_hz;
        info.channels = 2;
        info.format = SF_FORMAT_WAV | SF_FORMAT_PCM_16;
        errno = 0;
        sound = sf_open_fd(file.descriptor(), SFM_WRITE, &info, 0);  // writes a first header
        if (!sound && errno) throw IoError(path, "create", errno);
        if (!sound) throw IoError(path, std::string("cannot create: ") + sf_strerror(nullptr));
        block.reserve(BLOCK_VALUES);
    }
    ~Part() {
        if (sound) sf_close(sound);
    }

    void write(std::int16_t left, std::int16_t right) {
        block.push_back(left);
        block.push_back(right);
        if (block.size() == BLOCK_VALUES) flush();
    }

    void flush() {
        const auto count = static_cast<sf_count_t>(block.size());
        errno = 0;
        if (sf_write_short(sound, block.data(), count) != count) throw full(errno);
        block.clear();
    }

    void commit() {
        flush();
        errno = 0;
        if (sf_close(std::exchange(sound, nullptr)) != 0) throw full(errno);
        file.commit();
    }

    IoError full(int reason) const {
        return IoError(file.path(), "write", reason ? reason : ENOSPC);
    }

    WholeFile file;
    SNDFILE* sound = nullptr;
    std::vector<std::int16_t> block;  // left, right
};

WavWriter::WavWriter(std::filesystem::path folder) : folder_(std::move(folder)) {}

WavWriter::~WavWriter() = default;

void WavWriter::push(std::int16_t left, std::int16_t right) {
    if (part_) return part_->write(left, right);
    if (waiting_.empty() && left == 0 && right == 0) {
        ++silence_;
        return;
    }
    if (rate_hz_) {
        open_part();
        return part_->write(left, right);
    }
    if (waiting_.size() == MAX_WAITING_VALUES)
        throw std::logic_error("WavWriter: 65536 samples of sound and no sample rate");
    waiting_.insert(waiting_.end(), {left, right});
}

void WavWriter::rate_changed(double hz) {
    if (!(hz >= 1 && hz <= MAX_RATE_HZ))
        throw std::invalid_argument(fmt::format("a sample rate of {} Hz", hz));
    const int rate_hz = static_cast<int>(std::lround(hz));
    if (rate_hz == rate_hz_) return;
    if (part_) close_part();
    if (rate_hz_)
        silence_ = static_cast<std::uint64_t>(
            std::llround(static_cast<double>(silence_) * rate_hz / rate_hz_));
    rate_hz_ = rate_hz;
    if (waiting_.empty()) return;
    open_part();
    for (std::size_t i = 0; i < waiting_.size(); i += 2) part_->write(waiting_[i], waiting_[i + 1]);
    waiting_.clear();
}

std::vector<std::filesystem::path> WavWriter::close() {
    if (!part_ && rate_hz_ && silence_) open_part();
    if (part_) close_part();
    return files_;
}

void WavWriter::open_part() {
    const std::size_t number = files_.size() + 1;
    const std::string name = number == 1 ? "audio.wav" : fmt::format("audio-{}.wav", number);
    part_ = std::make_unique<Part>(folder_ / name, rate_hz_);
    for (; silence_ > 0; --silence_) part_->write(0, 0);
}

void WavWriter::close_part() {
    part_->commit();
    files_.push_back(part_->file.path());
    part_.reset();
}

}  // namespace sim
