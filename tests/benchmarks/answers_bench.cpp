// What one answer of a flexible needle's models costs: a critical load by each model, and a tick of each needle by itself
// (predict, twice linearise and try, commit). Each row repeats a batch many times and shows the median, 99th percentile and worst
// of what one answer in a batch took, after a warm-up; the last column compares within this run.

#include <stylet/contract/plugin.h>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <vector>

namespace {

using namespace stylet;
using contract::Case;
using contract::Given;

std::string library(const std::string& type) {
    return std::string(STYLET_PLUGIN_FOLDER) + "/" + type + ".so";
}

void row(const std::string& name, int batch, double& first, const std::function<void()>& answer) {
    constexpr int batches = 2000, warm_up = 200;
    std::vector<double> times;    // [µs]
    for (int i = 0; i < warm_up + batches; ++i) {
        const auto start = std::chrono::steady_clock::now();
        for (int k = 0; k < batch; ++k) answer();
        const double took = std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
        if (i >= warm_up) times.push_back(took / batch);
    }
    std::sort(times.begin(), times.end());
    if (first == 0.0) first = times[times.size() / 2];
    fmt::print("{:<58} {:>9.3f} {:>9.3f} {:>9.3f} {:>9.1f}\n", name, times[times.size() / 2], times[times.size() * 99 / 100],
               times.back(), times[times.size() / 2] / first);
}

/// The second column of Table 1: 50 mm of needle in two layers of a block.
Case two_layers(Given parameters) {
    Case with{.parameters = std::move(parameters)};
    with.tissue = {.extent = Vector3(0.01, 0.01, 0.05), .fixed = "sides", .layers = {}};
    for (const auto& [name, modulus] : {std::pair{"upper", 30e3}, {"lower", 60e3}}) {
        with.tissue.layers.push_back(
            {.name = name, .youngs_modulus = modulus, .poisson_ratio = 0.3, .density = 1000.0, .thickness = 0.025});
    }
    with.needle.length = 0.05;
    with.needle.ends = Ends::clamped_free;
    return with;
}

void critical_loads(double& first) {
    const auto with_foundation = [](Given parameters) {
        parameters.set("foundation_modulus", std::string("disc_in_block"));
        return two_layers(std::move(parameters));
    };
    struct Model {
        const char *title, *type;
        Case with;
    };
    double sum = 0.0;    // keeps the calls from being dropped
    for (const Model& model :
         {Model{"euler: Eq. (1)", "euler", two_layers({})},
          Model{"foundation: Eq. (2)", "foundation", with_foundation({{"form", "consistent"}})},
          Model{"layered_explicit, two terms", "layered_explicit", with_foundation({{"terms", std::int64_t{2}}})},
          Model{"layered_explicit, three terms", "layered_explicit", with_foundation({{"terms", std::int64_t{3}}})},
          Model{"winkler", "winkler", with_foundation({})}}) {
        const auto buckling = contract::make<BucklingModel>(library(model.type), model.with);
        const NeedleSetup& needle = model.with.needle;
        Column column{.bending_stiffness = needle.bending_stiffness(),
                      .free_length = 0.0,
                      .inserted = needle.length,
                      .depth = needle.length,
                      .radius = needle.radius,
                      .ends = needle.ends};
        int calls = 0;
        row(model.title, 200, first, [&] {
            column.inserted = column.depth = needle.length * (1.0 - 1e-6 * (++calls % 1000));    // never the last answer again
            sum += buckling->critical_load(column);
        });
    }
    if (!std::isfinite(sum)) fmt::print("a critical load was not finite\n");
}

/// The contacts of a needle of which half is in the tissue, the tip first.
std::vector<ContactPoint> contacts(double length, int count) {
    std::vector<ContactPoint> points{{Vector3(0.0, 0.0, -0.5 * length), Vector3::Zero(), length, true}};
    for (int i = 0; i + 1 < count; ++i) {
        const double from = 0.5 * length * i / (count - 1), piece = 0.5 * length / (count - 1);
        points.push_back({Vector3(0.0, 0.0, -from), Vector3(0.0, 0.0, -piece), 0.5 * length + from, false});
    }
    return points;
}

/// A tick under `push` [N] on the tip and a little on every contact, a little otherwise each time.
void tick_of(const std::string& title, const std::string& type, const Case& with, int count, double push, double& first) {
    const auto needle = contract::make<NeedleModel>(library(type), with);
    const std::vector<ContactPoint> points = contacts(with.needle.length, count);
    const Pose base{.position = Vector3(0.0, 0.0, 0.5 * with.needle.length)};
    VectorX forces = VectorX::Zero(3 * count);
    int ticks = 0;
    const auto tick = [&] {
        ++ticks;
        for (int i = 0; i < count; ++i) forces[3 * i] = count > 1 ? 1e-4 * std::sin(0.01 * ticks + i) : 0.0;
        forces[2] = push * (1.0 + 0.01 * std::sin(0.01 * ticks));
        needle->predict(base, 0.5 * with.needle.length, with.dt);
        for (int linearisation = 0; linearisation < 2; ++linearisation) {
            (void)needle->linearise(points, 0.0);
            (void)needle->try_step(points, {forces.data(), 3 * count});
        }
        needle->commit();
    };
    row(title, 1, first, tick);
}

}    // namespace

int main() {
    fmt::print("One answer, in µs\n\n{:<58} {:>9} {:>9} {:>9} {:>9}\n", "", "median", "p99", "worst", "ratio");
    double first = 0.0;
    critical_loads(first);

    const auto euler = contract::make<BucklingModel>(library("euler"), Case{});
    Case bowed;
    bowed.buckling = euler.get();
    const double load = 1.05 * euler->critical_load({.bending_stiffness = bowed.needle.bending_stiffness(),
                                                     .free_length = 0.5 * bowed.needle.length,
                                                     .radius = bowed.needle.radius,
                                                     .ends = bowed.needle.ends});
    fmt::print("\n");
    tick_of("a tick of beam_column, bowed", "beam_column", bowed, 1, load, first);
    tick_of("a tick of elastica, bowed", "elastica", bowed, 1, load, first);
    for (const std::int64_t nodes : {20, 40, 80, 160}) {
        const Case steel{.parameters = {{"nodes", nodes}, {"density", 7850.0}, {"poisson_ratio", 0.3}, {"imperfection", 2e-5}}};
        tick_of(fmt::format("a tick of rod, {} nodes, 20 contacts", nodes), "rod", steel, 20, 0.02, first);
    }
}
