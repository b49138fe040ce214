#include <stylet/contract/allocations.h>

#include <atomic>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define STYLET_SANITIZER_ALLOCATES 1
#elif defined(__clang__)    // tells it otherwise than g++
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define STYLET_SANITIZER_ALLOCATES 1
#endif
#endif
#ifndef STYLET_SANITIZER_ALLOCATES
#include <cerrno>
#include <cstdlib>
#endif

namespace {

std::atomic<std::size_t> count{0};

}    // namespace

namespace stylet::contract {

std::size_t allocations() {
    return count.load();
}

}    // namespace stylet::contract

// operator new of libstdc++ and Eigen's own allocation both end in malloc: counting that one counts all.
#ifdef STYLET_SANITIZER_ALLOCATES

// The sanitizer owns malloc, and calls those who ask. Declared here because g++ 12 comes without sanitizer/allocator_interface.h.
extern "C" int __sanitizer_install_malloc_and_free_hooks(void (*on_malloc)(const volatile void*, std::size_t),
                                                         void (*on_free)(const volatile void*));

namespace {

const int hooks_installed =
    __sanitizer_install_malloc_and_free_hooks([](const volatile void*, std::size_t) { ++count; }, [](const volatile void*) {});

}    // namespace

#else

// The executable's malloc goes before glibc's, for every library that it loads; glibc keeps its own under these names.
extern "C" {

void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);

void* malloc(std::size_t size) {
    ++count;
    return __libc_malloc(size);
}

void* calloc(std::size_t number, std::size_t size) {
    ++count;
    return __libc_calloc(number, size);
}

void* realloc(void* block, std::size_t size) {
    ++count;
    return __libc_realloc(block, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) {
    ++count;
    return __libc_memalign(alignment, size);
}

int posix_memalign(void** block, std::size_t alignment, std::size_t size) {
    ++count;
    void* const found = __libc_memalign(alignment, size);
    if (found == nullptr) return ENOMEM;
    *block = found;
    return 0;
}
}

#endif
