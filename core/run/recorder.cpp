#include "core/run/recorder.h"

#include <stylet/error.h>

#include <fmt/format.h>

#include <boost/lockfree/spsc_queue.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <fstream>
#include <thread>

namespace stylet::core {

namespace {

constexpr std::size_t ring_rows = 4096;    // four seconds at 1 kHz
constexpr auto pause = std::chrono::milliseconds(10);
constexpr auto flush_period = std::chrono::milliseconds(50);

struct Row {
    Sample sample;
    std::array<const char*, 16> events{};
};

}    // namespace

class Recorder::Writer {
public:
    Writer(const std::filesystem::path& file, const Heading& heading, std::vector<Column> columns)
        : file_(file), columns_(std::move(columns)), out_(file, std::ios::binary | std::ios::trunc) {
        if (!out_) throw Error("the recording '" + file.string() + "' cannot be written");
        out_ << "# stylet recording 1\n# title: " << heading.title << "\n# scene: " << heading.scene
             << "\n# hash: " << heading.hash << '\n';
        for (const Column& column : columns_) {
            out_ << column.name;
            if (*column.unit != '\0') out_ << " [" << column.unit << ']';
            out_ << ',';
        }
        out_ << "event\n" << std::flush;
        thread_ = std::thread([this] { drain(); });
    }
    ~Writer() { stop(); }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;

    bool push(const Row& row) { return ring_.push(row); }

    void stop() {
        closing_ = true;
        if (thread_.joinable()) thread_.join();
    }
    void check() const {
        if (!out_) throw Error("the recording '" + file_.string() + "' could not be written to its end (is the disk full?)");
    }

private:
    void drain() {
        auto flushed = std::chrono::steady_clock::now();
        for (bool last = false; !last;) {
            last = closing_;    // read before the ring is emptied: what was pushed before closing is then in the file
            fmt::memory_buffer text;
            ring_.consume_all([&](const Row& row) { write(row, text); });
            out_.write(text.data(), static_cast<std::streamsize>(text.size()));
            if (const auto now = std::chrono::steady_clock::now(); last || now - flushed >= flush_period) {
                out_.flush();
                flushed = now;
            }
            if (!last && text.size() == 0) std::this_thread::sleep_for(pause);
        }
    }

    void write(const Row& row, fmt::memory_buffer& text) const {
        for (const Column& column : columns_) fmt::format_to(std::back_inserter(text), "{},", row.sample.*column.value);
        for (std::size_t i = 0; i < row.events.size() && row.events[i] != nullptr; ++i) {
            fmt::format_to(std::back_inserter(text), "{}{}", i == 0 ? "" : "; ", row.events[i]);
        }
        text.push_back('\n');
    }

    std::filesystem::path file_;
    std::vector<Column> columns_;
    std::ofstream out_;
    boost::lockfree::spsc_queue<Row, boost::lockfree::capacity<ring_rows>> ring_;
    std::atomic<bool> closing_{false};
    std::thread thread_;
};

Recorder::Recorder(const std::filesystem::path& file, const Heading& heading, std::vector<Column> columns)
    : writer_(std::make_unique<Writer>(file, heading, std::move(columns))) {}

Recorder::~Recorder() = default;

bool Recorder::push(const Sample& sample, std::span<const Event> events) {
    Row row{.sample = sample};
    for (std::size_t i = 0; i < std::min(events.size(), row.events.size()); ++i) row.events[i] = events[i].name;
    return writer_->push(row);
}

void Recorder::finish() {
    writer_->stop();
    writer_->check();
}

}    // namespace stylet::core
