// Between waking up and the device the loop's thread makes no system call, takes no lock and asks for no memory. Shown by letting
// the kernel, the threads' library and the allocator tell.
#include "core/run/player.h"
#include "core/run/real_time_loop.h"
#include "core/scene/reader.h"

#include <gtest/gtest.h>
#include <stylet/contract/allocations.h>

#include <dlfcn.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <pthread.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <mutex>
#include <string>

namespace {

thread_local bool listening = false;
std::atomic<int> locks{0};

}    // namespace

// In front of the library's own: every lock of this process comes by here, those of plugins too.
extern "C" int pthread_mutex_lock(pthread_mutex_t* mutex) noexcept {
    using Lock = int (*)(pthread_mutex_t*);
    static const auto lock = reinterpret_cast<Lock>(dlsym(RTLD_NEXT, "pthread_mutex_lock"));
    if (listening) ++locks;
    return lock(mutex);
}

namespace stylet::core {
namespace {

const std::atomic<bool> never{false};

/// The paper's insertion at ten times the speed: touch, rupture and twelve contacts within a second.
Scene fast_insertion(const PluginFolders& folders) {
    return read_scene(SCENE_FOLDER "/paper/fig10a_l150.yaml", {{"device.motion[0].speed", "100 mm/s"}}, folders);
}

/// From now on this thread may only sleep; any other system call is told and ends the process with 1.
void allow_nothing_but_sleep() {
    const auto tell = [](int, siginfo_t* info, void*) {
        char text[64];
        const int length = std::snprintf(text, sizeof text, "system call %d\n", info->si_syscall);
        (void)!write(STDERR_FILENO, text, static_cast<std::size_t>(length));
        _exit(1);
    };
    struct sigaction action {};
    action.sa_sigaction = tell;
    action.sa_flags = SA_SIGINFO;
    sigaction(SIGSYS, &action, nullptr);
    const auto if_equal = [](unsigned number, unsigned char then, unsigned char otherwise) {
        return sock_filter{BPF_JMP | BPF_JEQ | BPF_K, then, otherwise, number};
    };
    const auto load = [](std::size_t offset) {
        return sock_filter{BPF_LD | BPF_W | BPF_ABS, 0, 0, static_cast<unsigned>(offset)};
    };
    std::array filter{
        load(offsetof(seccomp_data, nr)),
        if_equal(SYS_clock_nanosleep, 5, 0),
        if_equal(SYS_exit_group, 4, 0),
        if_equal(SYS_write, 0, 2),    // only of what tells
        load(offsetof(seccomp_data, args)),
        if_equal(STDERR_FILENO, 1, 0),
        sock_filter{BPF_RET | BPF_K, 0, 0, SECCOMP_RET_TRAP},
        sock_filter{BPF_RET | BPF_K, 0, 0, SECCOMP_RET_ALLOW},
    };
    const sock_fprog program{.len = filter.size(), .filter = filter.data()};
    if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 || prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) != 0) _exit(2);
}

/// Plays `ticks` of the scene on the wall clock, with its report and its recording; `at` is told the number of each tick first,
/// and afterwards ends the process where it likes.
template <class At>
void play(std::size_t ticks, At at) {
    const PluginFolders folders({PLUGIN_FOLDER});
    const Scene scene = fast_insertion(folders);
    const Cast cast(scene, folders);
    Player player(scene, cast, ticks, testing::TempDir() + "silence_" + std::to_string(getpid()) + ".csv");
    std::size_t tick = 0;
    (void)RealTimeLoop(scene.run.dt())
        .run(ticks,
             {[&](double held) {
                  at(tick++);
                  player.tick(held);
              },
              [&] { return player.note(); }, [] { return false; }},
             {}, never);
    EXPECT_TRUE(player.simulation().ever_punctured());
}

constexpr std::size_t all = 800;    // [ticks]

TEST(RealTimeTick, MakesNoSystemCallButItsSleep) {
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    const auto silent = [] {
        play(all, [](std::size_t tick) {
            if (tick == 2) allow_nothing_but_sleep();
            if (tick == all - 1) _exit(0);
        });
    };
    EXPECT_EXIT(silent(), testing::ExitedWithCode(0), "^$");
}

TEST(RealTimeTick, WouldBeHeardIfItMadeOne) {
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    const auto loud = [] {
        play(all, [](std::size_t tick) {
            if (tick == 2) allow_nothing_but_sleep();
            if (tick == 10) (void)!write(STDOUT_FILENO, "", 0);
        });
    };
    EXPECT_EXIT(loud(), testing::ExitedWithCode(1), "system call");
}

TEST(RealTimeTick, TakesNoLock) {
    locks = 0;
    play(all, [](std::size_t tick) { listening = tick >= 2; });
    EXPECT_EQ(locks, 0);
    listening = true;
    std::mutex mutex;
    mutex.lock();
    mutex.unlock();
    listening = false;
    EXPECT_EQ(locks, 1) << "this test would hear it";
}

TEST(RealTimeTick, AsksForNoMemory) {
    const PluginFolders folders({PLUGIN_FOLDER});
    const Scene scene = fast_insertion(folders);
    const Cast cast(scene, folders);
    Player player(scene, cast, all, std::nullopt);    // the recorder's own thread may ask for memory
    std::size_t tick = 0, before = 0, after = 0;
    (void)RealTimeLoop(scene.run.dt())
        .run(all,
             {[&](double held) {
                  if (++tick == 2) before = contract::allocations();
                  player.tick(held);
              },
              [&] {
                  const bool noted = player.note();
                  after = contract::allocations();
                  return noted;
              },
              [] { return false; }},
             {}, never);
    EXPECT_TRUE(player.simulation().ever_punctured());
    EXPECT_EQ(after - before, 0u);
}

}    // namespace
}    // namespace stylet::core
