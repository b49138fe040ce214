// What every target needs: the fuzzer's bytes as a file, and what is asked of every sentence of refusal.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace stylet::fuzzing {

/// Ends the process as a crash does, so that libFuzzer keeps the input.
inline void demand(bool holds, const std::string& promise) {
    if (holds) return;
    std::fprintf(stderr, "broken promise: %s\n", promise.c_str());
    std::abort();
}

/// A refusal says something, and no more than a reader bears.
inline void demand_sentence(const std::string& sentence) {
    constexpr std::size_t longest = 2000;    // [bytes] a list of all plugins or columns is long already
    demand(!sentence.empty(), "a refusal is a sentence");
    demand(sentence.size() <= longest, "a refusal is no longer than a reader bears, but found: " + sentence);
}

/// What is shown as it stands holds nothing that a terminal would obey.
inline void demand_printable(const std::string& text) {
    const auto control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
    demand(std::ranges::none_of(text, control), "what is shown holds no control characters, but found: " + text);
}

/// A folder of the process's own in TMPDIR; gone with it unless it crashes.
class Folder {
public:
    Folder() {
        std::string name = (std::filesystem::temp_directory_path() / "stylet_fuzz_XXXXXX").string();
        demand(mkdtemp(name.data()) != nullptr, "TMPDIR can be written to");
        path_ = name;
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder() { std::filesystem::remove_all(path_); }

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

inline void write(const std::filesystem::path& file, std::string_view bytes) {
    std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

inline std::string_view bytes_of(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

}    // namespace stylet::fuzzing
