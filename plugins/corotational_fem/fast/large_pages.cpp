#include "fast/large_pages.h"

#include <sys/mman.h>

#include <cstdint>
#include <cstring>
#include <new>

namespace stylet::corotational_fem {

namespace {

constexpr std::size_t page = std::size_t{2} << 20U;    // [bytes]

}    // namespace

// Fresh from the operating system: pages that were in use before would stay as small as they are.
LargePages::LargePages(std::size_t bytes) {
    if (bytes == 0) return;
    const std::size_t whole = (bytes + page - 1) / page * page;
    const bool large = bytes > 2 * page;
    room_ = large ? whole + page : bytes;
    mapped_ = mmap(nullptr, room_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (mapped_ == MAP_FAILED) {
        mapped_ = nullptr;
        throw std::bad_alloc();
    }
    start_ = static_cast<std::byte*>(mapped_);
    if (large) {
        start_ += (page - reinterpret_cast<std::uintptr_t>(mapped_) % page) % page;
#ifdef MADV_HUGEPAGE
        (void)madvise(start_, whole, MADV_HUGEPAGE);    // where it is refused, small ones do
#endif
    }
    std::memset(start_, 0, bytes);    // so that no tick has to wait for a page
}

LargePages& LargePages::operator=(LargePages&& other) noexcept {
    std::swap(mapped_, other.mapped_);
    std::swap(room_, other.room_);
    std::swap(start_, other.start_);
    return *this;
}

LargePages::~LargePages() {
    if (mapped_ != nullptr) munmap(mapped_, room_);
}

}    // namespace stylet::corotational_fem
