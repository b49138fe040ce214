#include "apps/study/file_lock.h"

#include <stylet/error.h>

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>
#include <cerrno>
#include <system_error>

namespace stylet::study {

FileLock::FileLock(const std::filesystem::path& file) {
    if (file.empty()) return;
    descriptor_ = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor_ < 0) throw std::system_error(errno, std::generic_category(), file.string());
    if (flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;    // some network drives know no locks
    close(descriptor_);
    throw Error(fmt::format("{}: found another study at work on it, wanted one at a time: wait for it, or name another folder",
                            file.string()));
}

FileLock::~FileLock() {
    if (descriptor_ >= 0) close(descriptor_);
}

}    // namespace stylet::study
