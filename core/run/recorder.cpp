#include "core/run/recorder.h"

#include "core/scene/complaints.h"

#include <stylet/error.h>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <boost/lockfree/spsc_queue.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <string_view>
#include <thread>

namespace stylet::core {

namespace {

constexpr std::size_t ring_rows = 4096;    // four seconds at 1 kHz
constexpr auto pause = std::chrono::milliseconds(10);
constexpr auto write_period = std::chrono::milliseconds(50);
constexpr std::size_t block = 1 << 16;    // [bytes] not waited for any longer

struct Row {
    Sample sample;
    std::array<const char*, 16> events{};
};

/// A file that text is appended to; what goes wrong on the way is kept until it is asked for.
class File {
public:
    explicit File(const std::filesystem::path& path)
        : descriptor_(open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)) {
        if (descriptor_ < 0) throw Error("the recording '" + path.string() + "' cannot be written");
    }
    ~File() { close(descriptor_); }
    File(const File&) = delete;
    File& operator=(const File&) = delete;

    /// In one write(2) unless a signal or a full disk cuts it short, so that a killed process leaves the text whole or not at
    /// all.
    void append(std::string_view text) {
        while (!text.empty() && good_) {
            const ssize_t written = ::write(descriptor_, text.data(), text.size());
            good_ = written > 0 || (written < 0 && errno == EINTR);
            if (written > 0) text.remove_prefix(static_cast<std::size_t>(written));
        }
    }
    [[nodiscard]] bool good() const { return good_; }

private:
    int descriptor_;
    bool good_ = true;
};

std::string heading_text(const Recorder::Heading& heading, const std::vector<Column>& columns) {
    std::string text = fmt::format("# stylet recording 1\n# title: {}\n# scene: {}\n# hash: {}\n", printable(heading.title),
                                   printable(heading.scene), heading.hash);
    for (const Column& column : columns) {
        text += column.name;
        if (*column.unit != '\0') text += fmt::format(" [{}]", column.unit);
        text += ',';
    }
    return text += "event\n";
}

/// A plugin's words as the end of a row: what a reader of CSV would take for more than text becomes a space.
void append_words(const char* words, fmt::memory_buffer& text) {
    constexpr std::string_view telling = ",\"#;";
    for (const char* at = words; *at != '\0'; ++at) {
        const bool plain = static_cast<unsigned char>(*at) >= 0x20 && telling.find(*at) == std::string_view::npos;
        text.push_back(plain ? *at : ' ');
    }
}

void append_row(const Row& row, const std::vector<Column>& columns, fmt::memory_buffer& text) {
    for (const Column& column : columns) fmt::format_to(std::back_inserter(text), "{},", row.sample.*column.value);
    for (std::size_t i = 0; i < row.events.size() && row.events[i] != nullptr; ++i) {
        if (i > 0) text.append(std::string_view("; "));
        append_words(row.events[i], text);
    }
    text.push_back('\n');
}

}    // namespace

class Recorder::Writer {
public:
    Writer(const std::filesystem::path& path, const Heading& heading, std::vector<Column> columns)
        : path_(path), columns_(std::move(columns)), file_(path) {
        file_.append(heading_text(heading, columns_));
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
        if (!file_.good())
            throw Error("the recording '" + path_.string() + "' could not be written to its end (is the disk full?)");
    }

private:
    void drain() {
        fmt::memory_buffer rows;    // whole ones, still to be written
        auto written = std::chrono::steady_clock::now();
        for (bool last = false; !last;) {
            last = closing_;    // read before the ring is emptied: what was pushed before closing is then in the file
            const std::size_t news = ring_.consume_all([&](const Row& row) { append_row(row, columns_, rows); });
            const auto now = std::chrono::steady_clock::now();
            if (last || rows.size() >= block || now - written >= write_period) {
                file_.append({rows.data(), rows.size()});
                rows.clear();
                written = now;
            }
            if (!last && news == 0) std::this_thread::sleep_for(pause);
        }
    }

    std::filesystem::path path_;
    std::vector<Column> columns_;
    File file_;
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
