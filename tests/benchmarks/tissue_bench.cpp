// What a step of the finite-element tissue costs, and how far it is off: the blocks of scenes/validation/block_m*.yaml, let go
// under their weight and a load, 200 steps each, against the same mesh solved by Newton's method in double precision to the last
// digit. `field` is the worst of the steps' ‖u − u_ref‖/‖u_ref‖ over all nodes, `patch` that of the loaded patch's mean. Times
// are of a step of the tissue as core takes it (predict, then linearise and try until in balance, commit), after a warm-up of
// twenty; another machine, or another minute, has other times.
//
// The first table says what contacts cost: a needle 100 mm deep in the third mesh, its tip and its last piece of shaft moving on.
// `answer` is what a haptic loop asks of a tissue that runs beside it, where the contacts are and how far they move each other;
// `tick` is all of a tick, predict to commit.
//
// The last table says what the mesh itself is off by, the solver aside: inner displacements once settled, against the finest mesh
// run, with a pressure a patch.

#include "core/loading/cast.h"
#include "core/run/patch_loads.h"
#include "core/scene/reader.h"
#include "core/workers/worker_pool.h"

#include <fmt/format.h>

#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <string>
#include <vector>

namespace {

using namespace stylet;
using namespace stylet::core;

using Clock = std::chrono::steady_clock;

constexpr int steps = 200;
constexpr int warm_up = 20;
constexpr double balanced = 1e-9;    // [N] the coupling's own tolerance

struct Block {
    const char* scene;
    std::array<int, 3> cells;
};

constexpr Block blocks[] = {
    {"block_m0", {6, 6, 5}}, {"block_m1", {11, 11, 7}}, {"block_m2", {15, 15, 10}}, {"block_m3", {23, 23, 16}}};

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

double resident() {    // [MB] of the process's memory that is in use
    malloc_trim(0);
    std::ifstream status("/proc/self/statm");
    double size = 0.0, pages = 0.0;
    status >> size >> pages;
    return pages * static_cast<double>(sysconf(_SC_PAGESIZE)) * 1e-6;
}

/// The nodes of a block of equal cells.
std::vector<Vector3> nodes_of(const Block& block, const Vector3& extent) {
    std::vector<Vector3> nodes;
    const auto [nx, ny, nz] = block.cells;
    for (int k = 1; k <= nz; ++k) {
        for (int j = 0; j <= ny; ++j) {
            for (int i = 0; i <= nx; ++i) {
                nodes.emplace_back(extent.x() * (static_cast<double>(i) / nx - 0.5),
                                   extent.y() * (static_cast<double>(j) / ny - 0.5),
                                   extent.z() * (static_cast<double>(k) / nz - 1.0));
            }
        }
    }
    return nodes;
}

/// A tissue alone, as core steps it.
class TissueRun {
public:
    TissueRun(const std::string& name, const std::vector<Override>& overrides, const PluginFolders& folders, Workers& workers)
        : scene_(read_scene(std::string(STYLET_SCENES) + "/validation/" + name + ".yaml", overrides, folders)),
          before_(resident()),
          start_(Clock::now()),
          cast_(scene_, folders, workers),
          load_time_(seconds_since(start_)),
          memory_(resident() - before_),
          loads_(cast_.effects(), cast_.tissue()) {}

    /// Returns how many trial steps it took.
    int step(double dt) {
        TissueModel& tissue = cast_.tissue();
        time_ += dt;
        loads_.apply(time_);
        tissue.predict(dt);
        int trials = 0;
        for (bool done = false; !done && trials < 100; ++trials) {
            (void)tissue.linearise({}, 0.0);
            done = tissue.try_step({}, {nullptr, 0}).residual <= balanced;
        }
        tissue.commit();
        loads_.commit();
        return trials;
    }

    [[nodiscard]] VectorX field(const std::vector<Vector3>& nodes) const {
        VectorX field(3 * nodes.size());
        for (std::size_t i = 0; i < nodes.size(); ++i) field.segment<3>(3 * i) = cast_.tissue().displacement(nodes[i]);
        return field;
    }
    [[nodiscard]] Vector3 patch() const { return loads_.displacement(0); }
    [[nodiscard]] double load_time() const { return load_time_; }    // [s]
    [[nodiscard]] double memory() const { return memory_; }          // [MB]
    [[nodiscard]] const Vector3& extent() const { return scene_.tissue_setup->extent; }

private:
    Scene scene_;
    double before_;
    Clock::time_point start_;
    Cast cast_;
    double load_time_, memory_;
    PatchLoads loads_;
    double time_ = 0.0;
};

struct Workload {
    double poisson_ratio, dt, load;    // dt [s], load [N]
};

std::vector<Override> overrides_of(const Workload& work, const char* solver) {
    return {{"tissue.layers[0].poisson_ratio", fmt::format("{}", work.poisson_ratio)},
            {"run.rate", fmt::format("{} Hz", 1.0 / work.dt)},
            {"effects[0].force", fmt::format("[0 N, 0 N, {} N]", -work.load)},
            {"tissue.corotational_fem.solver", solver}};
}

struct Reference {
    std::vector<VectorX> fields;
    std::vector<Vector3> patches;
};

Reference reference_of(const Block& block, const Workload& work, const PluginFolders& folders) {
    TissueRun run(block.scene, overrides_of(work, "newton"), folders, one_thread());
    const std::vector<Vector3> nodes = nodes_of(block, run.extent());
    Reference reference;
    for (int i = 0; i < steps; ++i) {
        run.step(work.dt);
        reference.fields.push_back(run.field(nodes));
        reference.patches.push_back(run.patch());
    }
    return reference;
}

void row(const Block& block, const Workload& work, const Reference& reference, const PluginFolders& folders, Workers& workers) {
    TissueRun run(block.scene, overrides_of(work, "quasi_newton"), folders, workers);
    const std::vector<Vector3> nodes = nodes_of(block, run.extent());
    std::vector<double> times;    // [ms]
    double field = 0.0, patch = 0.0, trials = 0.0;
    for (int i = 0; i < steps; ++i) {
        const auto start = Clock::now();
        trials += run.step(work.dt);
        if (i >= warm_up) times.push_back(1e3 * seconds_since(start));
        field = std::max(field, (run.field(nodes) - reference.fields[i]).norm() / reference.fields[i].norm());
        patch = std::max(patch, (run.patch() - reference.patches[i]).norm() / reference.patches[i].norm());
    }
    std::sort(times.begin(), times.end());
    fmt::print("{:>7} {:>5} {:>3.0f} {:>3.0f} {:>7} {:>7.3f} {:>7.3f} {:>7.3f} {:>9.3f} {:>9.3f} {:>6.2f} {:>6.2f} {:>7.1f}\n",
               6 * block.cells[0] * block.cells[1] * block.cells[2], work.poisson_ratio, 1e3 * work.dt, work.load,
               workers.count(), times[times.size() / 2], times[times.size() * 99 / 100], times.back(), 100.0 * field,
               100.0 * patch, trials / steps, run.load_time(), run.memory());
    std::fflush(stdout);
}

void solver_table(const PluginFolders& folders, Workers& pool, int most_cells) {
    fmt::print("\n{:>7} {:>5} {:>3} {:>3} {:>7} {:>7} {:>7} {:>7} {:>9} {:>9} {:>6} {:>6} {:>7}\n", "tets", "nu", "dt", "F",
               "threads", "median", "p99", "worst", "field", "patch", "trials", "load", "memory");
    fmt::print("{:>7} {:>5} {:>3} {:>3} {:>7} {:>7} {:>7} {:>7} {:>9} {:>9} {:>6} {:>6} {:>7}\n", "", "", "ms", "N", "", "ms",
               "ms", "ms", "%", "%", "a step", "s", "MB");
    for (const Block& block : blocks) {
        if (block.cells[0] > most_cells) continue;
        for (const double load : {1.0, 4.0}) {
            for (const double poisson_ratio : {0.45, 0.49}) {
                for (const double dt : {1e-3, 1e-2}) {
                    const Workload work{poisson_ratio, dt, load};
                    const Reference reference = reference_of(block, work, folders);
                    row(block, work, reference, folders, one_thread());
                    row(block, work, reference, folders, pool);
                }
            }
        }
    }
}

/// A straight needle whose tip is `depth` [m] below the surface, in pieces of 5 mm.
std::vector<ContactPoint> needle_points(double depth) {
    constexpr double piece = 5e-3;    // [m]
    std::vector<ContactPoint> points{{Vector3(0.0, 0.0, -depth), Vector3::Zero(), 0.15, true}};
    for (double from = 0.0; from < depth; from += piece) {
        points.push_back({Vector3(0.0, 0.0, -from), Vector3(0.0, 0.0, -std::min(piece, depth - from)), 0.1, false});
    }
    return points;
}

/// Of a needle that cuts and rubs: the piece that grows rubs more each time.
VectorX needle_forces(const std::vector<ContactPoint>& points) {
    constexpr double cutting = 0.3, friction = 5.0;    // [N], [N/m]
    VectorX forces = VectorX::Zero(3 * static_cast<Eigen::Index>(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i)
        forces[3 * static_cast<Eigen::Index>(i) + 2] = points[i].tip ? -cutting : -friction * points[i].span.norm();
    return forces;
}

void contact_row(const PluginFolders& folders, Workers& workers) {
    constexpr double dt = 1e-3, speed = 10e-3, start = 96e-3;    // [s], [m/s], [m]
    const Scene scene =
        read_scene(std::string(STYLET_SCENES) + "/paper/fig10a_l150.yaml",
                   {{"tissue.type", "corotational_fem"}, {"tissue.corotational_fem.cells", "[15, 15, 10]"}}, folders);
    const Cast cast(scene, folders, workers);
    TissueModel& tissue = cast.tissue();
    std::vector<double> answers, ticks;    // [µs]
    VectorX forces = needle_forces(needle_points(start));
    for (int i = 0; i < steps; ++i) {
        const std::vector<ContactPoint> points = needle_points(start + i * speed * dt);
        const VectorX before = forces;
        forces = needle_forces(points);
        const auto begin = Clock::now();
        tissue.predict(0.0);
        (void)tissue.linearise(points, 0.0);
        const double answer = 1e6 * seconds_since(begin);
        (void)tissue.try_step(points, {before.data(), before.size()});
        tissue.predict(dt);
        for (int trial = 0; trial < 100; ++trial) {
            (void)tissue.linearise(points, 0.0);
            if (tissue.try_step(points, {forces.data(), forces.size()}).residual <= balanced) break;
        }
        tissue.commit();
        if (i < warm_up) continue;
        answers.push_back(answer);
        ticks.push_back(1e6 * seconds_since(begin));
    }
    for (auto [name, times] : {std::pair{"answer", &answers}, {"tick", &ticks}}) {
        std::sort(times->begin(), times->end());
        fmt::print("{:>8} {:>7} {:>9.0f} {:>9.0f} {:>9.0f}\n", name, workers.count(), (*times)[times->size() / 2],
                   (*times)[times->size() * 99 / 100], times->back());
    }
}

void contact_table(const PluginFolders& folders, Workers& pool) {
    fmt::print("\nA needle of 21 contacts in 13,500 tetrahedra, in us\n\n{:>8} {:>7} {:>9} {:>9} {:>9}\n", "", "threads",
               "median", "p99", "worst");
    contact_row(folders, one_thread());
    contact_row(folders, pool);
}

/// Points well inside, the same for every mesh.
std::vector<Vector3> inner_points(const Vector3& extent) {
    std::vector<Vector3> points;
    for (const double x : {-0.3, -0.1, 0.1, 0.3}) {
        for (const double y : {-0.3, -0.1, 0.1, 0.3}) {
            for (const double z : {-0.3, -0.5, -0.7}) points.emplace_back(x * extent.x(), y * extent.y(), z * extent.z());
        }
    }
    return points;
}

VectorX settled(const Block& block, double poisson_ratio, const char* pressure, const PluginFolders& folders) {
    std::vector<Override> overrides = overrides_of({poisson_ratio, 1e-3, 1.0}, "newton");
    overrides.push_back({"tissue.corotational_fem.dynamics", "quasi_static"});
    overrides.push_back({"tissue.corotational_fem.pressure", pressure});
    TissueRun run(block.scene, overrides, folders, one_thread());
    run.step(1e-3);
    return run.field(inner_points(run.extent()));
}

void mesh_table(const PluginFolders& folders, int most_cells) {
    fmt::print("\nWhat the mesh is off by, inner displacements under 1 N and the weight, in %\n\n{:>7} {:>5} {:>24} {:>18}\n",
               "tets", "nu", "a pressure a tetrahedron", "a pressure a patch");
    for (const double poisson_ratio : {0.45, 0.49}) {
        const Block& finest = *std::find_if(std::rbegin(blocks), std::rend(blocks),
                                            [&](const Block& block) { return block.cells[0] <= most_cells; });
        const VectorX truth = settled(finest, poisson_ratio, "patch", folders);
        for (const Block& block : blocks) {
            if (block.cells[0] > most_cells) continue;
            const auto off = [&](const char* pressure) {
                return 100.0 * (settled(block, poisson_ratio, pressure, folders) - truth).norm() / truth.norm();
            };
            const std::string cured = &block == &finest ? "-" : fmt::format("{:.2f}", off("patch"));
            fmt::print("{:>7} {:>5} {:>24.2f} {:>18}\n", 6 * block.cells[0] * block.cells[1] * block.cells[2], poisson_ratio,
                       off("tetrahedron"), cured);
            std::fflush(stdout);
        }
    }
}

}    // namespace

int main(int count, char** arguments) {
    const int most_cells = count > 1 ? std::atoi(arguments[1]) : 1000;    // along x
    if (most_cells < blocks[0].cells[0]) {
        fmt::print(stderr, "found {} cells, wanted at least the {} along x of the smallest mesh\n", most_cells,
                   blocks[0].cells[0]);
        return 1;
    }
    const PluginFolders folders = PluginFolders::standard();
    WorkerPool pool(2, std::nullopt);
    contact_table(folders, pool);
    solver_table(folders, pool, most_cells);
    mesh_table(folders, most_cells);
}
