// What one tick costs. Each row drives a scene to a moment, then times every tick of a stretch by itself; a stretch is run
// several times, and the first is the warm-up. The last column compares within this run: another machine, or another minute, has
// other times.

#include "core/loading/cast.h"
#include "core/run/simulation.h"
#include "core/scene/reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

namespace {

using namespace stylet::core;

struct Stretch {
    std::string name;
    std::string scene;
    std::vector<Override> overrides;
    double from, to;    // [s]
};

struct Times {
    double median, p99, worst;    // [µs]
    int contacts;                 // at the end of the stretch
};

std::vector<double> run_once(const Stretch& stretch, const PluginFolders& folders, int& contacts) {
    const Scene scene = read_scene(std::string(STYLET_SCENES) + "/" + stretch.scene, stretch.overrides, folders);
    const Cast cast(scene, folders);
    Simulation simulation(scene, cast);
    std::vector<double> times;
    while (simulation.time() < stretch.from) simulation.tick();
    while (simulation.time() < stretch.to) {
        const auto start = std::chrono::steady_clock::now();
        simulation.tick();
        times.push_back(std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count());
    }
    contacts = static_cast<int>(simulation.sample().contacts);
    return times;
}

Times measure(const Stretch& stretch, const PluginFolders& folders) {
    constexpr int repetitions = 5;
    Times result{};
    run_once(stretch, folders, result.contacts);
    std::vector<double> times;
    for (int i = 0; i < repetitions; ++i) {
        const std::vector<double> once = run_once(stretch, folders, result.contacts);
        times.insert(times.end(), once.begin(), once.end());
    }
    std::sort(times.begin(), times.end());
    result.median = times[times.size() / 2];
    result.p99 = times[times.size() * 99 / 100];
    result.worst = times.back();
    return result;
}

}    // namespace

int main() {
    const PluginFolders folders = PluginFolders::standard();
    const std::string l150 = "paper/fig10a_l150.yaml", l200 = "paper/fig10a_l200.yaml", fig9 = "paper/fig9.yaml";
    const std::vector<Override> deep = {{"device.motion[0].insert", "105 mm"}};
    std::vector<Override> deep_rigid = deep, close = deep;
    deep_rigid.push_back({"needle.type", "rigid"});
    close.push_back({"coupling.contact_spacing", "2.5 mm"});
    const Override rod{"needle.type", "rod"};
    std::vector<Override> close_rod = close;
    close_rod.push_back(rod);
    const std::vector<Stretch> stretches = {
        {"before puncture, straight (the others compare with this)", l150, {}, 1.0, 5.0},
        {"before puncture, bowed", l200, {}, 4.0, 7.0},
        {"inside, 10 contacts", l150, deep, 7.2, 7.6},
        {"inside, 20 contacts", l150, close, 7.2, 7.6},
        {"inside, 10 contacts, rigid needle", l150, deep_rigid, 7.2, 7.6},
        {"before puncture, a rod of 41 nodes that bows", l200, {rod}, 4.0, 7.0},
        {"inside, 20 contacts, a rod of 41 nodes", l150, close_rod, 7.2, 7.6},
        {"inside, second bow", fig9, {}, 6.6, 8.4},
        {"the rupture itself, straight needle", l150, {}, 5.262, 5.272},
        {"the rupture itself, bowed needle", fig9, {}, 4.679, 4.689},
        {"the rupture itself, a rod of 41 nodes", l150, {rod}, 5.263, 5.273},
    };
    fmt::print("One tick, in µs: {}\n\n", "core::Simulation::tick with half_space, beam_column, fracture, friction unless said");
    fmt::print("{:<58} {:>8} {:>8} {:>8} {:>8} {:>7}\n", "", "contacts", "median", "p99", "worst", "ratio");
    double first = 0.0;
    for (const Stretch& stretch : stretches) {
        const Times times = measure(stretch, folders);
        if (first == 0.0) first = times.median;
        fmt::print("{:<58} {:>8} {:>8.2f} {:>8.2f} {:>8.2f} {:>7.1f}\n", stretch.name, times.contacts, times.median, times.p99,
                   times.worst, times.median / first);
    }
}
