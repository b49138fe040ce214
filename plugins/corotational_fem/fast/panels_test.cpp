#include "fast/panels.h"

#include "fast/faithful_panels.h"
#include "fast/rest_for_tests.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstring>

namespace stylet::corotational_fem {
namespace {

using namespace testing;

// Rounding of one number in each storage, and how much of it may gather in a solve: a few tens of supernodes
// come after each other, each with an error of its own, and those of soft motions count most.
constexpr double rounding_of_single = 6e-8, rounding_of_half = 4.9e-4;
constexpr double gathered = 10.0;

double tolerance(Storage storage) {
    return gathered * (storage == Storage::half ? rounding_of_half : rounding_of_single);
}

struct Way {
    InstructionSet set;
    Storage storage;
};

// All that this machine can do.
std::vector<Way> ways() {
    std::vector<Way> all;
    for (const InstructionSet set : {InstructionSet::sse2, InstructionSet::avx2, InstructionSet::avx512}) {
        if (!supported(set)) continue;
        all.push_back({set, Storage::single});
        if (smallest_storage(set) == Storage::half) all.push_back({set, Storage::half});
    }
    return all;
}

const char* name(Storage storage) {
    return storage == Storage::half ? "half" : "single";
}

class Solved {
public:
    explicit Solved(BlockMatrix matrix) : matrix_(std::move(matrix)), dissection_(dissect(matrix_)), factor_(dissection_) {
        factor_.refactor(matrix_, one_thread());
    }

    [[nodiscard]] const BlockMatrix& matrix() const { return matrix_; }
    [[nodiscard]] const Factor& factor() const { return factor_; }

    [[nodiscard]] std::vector<Float4> nodal(const VectorX& rows) const {
        const VectorX places = in_places(dissection_, rows);
        std::vector<Float4> result(dissection_.places() + 1, Float4{7.0F, 7.0F, 7.0F, 7.0F});    // that nobody should read
        for (int i = 0; i < dissection_.places(); ++i) {
            for (int k = 0; k < 3; ++k) (&result[i].x)[k] = static_cast<float>(places[3 * i + k]);
        }
        return result;
    }

    [[nodiscard]] VectorX rows(const std::vector<Float4>& nodes) const {
        VectorX places(3 * dissection_.places());
        for (int i = 0; i < dissection_.places(); ++i) places.segment<3>(3 * i) << nodes[i].x, nodes[i].y, nodes[i].z;
        return in_rows(dissection_, places);
    }

    [[nodiscard]] VectorX solve(Panels& panels, const VectorX& b) const {
        std::vector<Float4> x(dissection_.places() + 1);
        panels.solve(nodal(b).data(), x.data(), one_thread());
        return rows(x);
    }

private:
    BlockMatrix matrix_;
    Dissection dissection_;
    Factor factor_;
};

double error_against_eigen(const Solved& solved, const VectorX& b, Way way) {
    Panels panels(solved.factor(), way.storage, way.set);
    const VectorX expected = solution(solved.matrix(), b);
    const double error = (solved.solve(panels, b) - expected).norm() / expected.norm();
    std::printf("%-7s %-6s %.1e\n", name(way.set), name(way.storage), error);
    return error;
}

const std::vector<Material> gel = alike(elastic(25e3, 0.49, 1000.0));

TEST(Panels, SolveAsEigenDoes) {
    const Mesh mesh = uneven_block({10, 9, 8});
    for (const Motion& motion :
         {quasi_static(), backward_euler(1e-3), backward_euler(1e-2), with_shared_pressure(backward_euler(1e-2))}) {
        const Solved solved(rest_matrix(mesh, gel, motion));
        for (const Way way : ways()) {
            EXPECT_LT(error_against_eigen(solved, patch_load(mesh, solved.matrix()), way), tolerance(way.storage));
        }
    }
}

TEST(Panels, SolveMeshesOfAFewNodes) {
    for (const Cells& cells : {Cells{1, 1, 1}, Cells{2, 1, 1}, Cells{3, 3, 2}}) {
        const Mesh mesh = uneven_block(cells);
        const Solved solved(rest_matrix(mesh, gel, quasi_static()));
        for (const Way way : ways()) {
            EXPECT_LT(error_against_eigen(solved, noise(3 * solved.matrix().rows(), 1.0, 1), way), tolerance(way.storage));
        }
    }
}

TEST(Panels, SolveLayersAMillionTimesAsStiff) {
    const Mesh mesh = uneven_block({8, 7, 6});
    const Material soft = elastic(1e3, 0.49, 1000.0), stiff = elastic(1e9, 0.3, 1000.0);
    for (const std::vector<Material>& materials : {std::vector{soft, stiff}, std::vector{stiff, soft}}) {
        const Solved solved(rest_matrix(mesh, materials, quasi_static()));
        for (const Way way : ways()) {
            EXPECT_LT(error_against_eigen(solved, patch_load(mesh, solved.matrix()), way), tolerance(way.storage));
        }
    }
}

// An iteration that takes halves for an inverse loses nothing to them: the change of the tissue's own stiffness leaves some 0.05.
TEST(Panels, InHalfPrecisionLeaveLittleOfAnyError) {
    constexpr double little = 0.05;
    const Mesh mesh = uneven_block({10, 9, 8});
    for (const Motion& motion :
         {quasi_static(), backward_euler(1e-3), backward_euler(1e-2), with_shared_pressure(backward_euler(1e-2))}) {
        const Solved solved(rest_matrix(mesh, gel, motion));
        for (const Way way : ways()) {
            Panels panels(solved.factor(), way.storage, way.set);
            const double left = error_left(panels, solved.matrix(), one_thread());
            std::printf("%-7s %-6s leaves %.1e\n", name(way.set), name(way.storage), left);
            EXPECT_LT(left, little);
        }
    }
}

TEST(FaithfulPanels, AreHalvesOnlyWhereThatDoesNoHarm) {
    const Mesh mesh = uneven_block({8, 7, 6});
    const Material soft = elastic(1e3, 0.49, 1000.0), stiff = elastic(1e9, 0.3, 1000.0), beyond = elastic(1e14, 0.3, 1000.0);
    const InstructionSet set = best_instruction_set();
    const auto storage = [&](const std::vector<Material>& materials) {
        const Solved solved(rest_matrix(mesh, materials, quasi_static()));
        return faithful_panels(solved.factor(), solved.matrix(), set, one_thread())->storage();
    };
    EXPECT_EQ(storage(gel), smallest_storage(set));
    EXPECT_EQ(storage({stiff, soft}), smallest_storage(set));
    EXPECT_EQ(storage({soft, stiff}), Storage::single);
    EXPECT_EQ(storage({soft, beyond}), Storage::single);    // whose blocks would not even fit into halves
}

TEST(Panels, AreSymmetric) {
    const Solved solved(rest_matrix(uneven_block({8, 7, 6}), gel, backward_euler(1e-2)));
    const VectorX a = noise(3 * solved.matrix().rows(), 1.0, 1), b = noise(a.size(), 1.0, 2);
    for (const Way way : ways()) {
        Panels panels(solved.factor(), way.storage, way.set);
        const VectorX pa = solved.solve(panels, a), pb = solved.solve(panels, b);
        EXPECT_NEAR(a.dot(pb), b.dot(pa), tolerance(Storage::single) * a.norm() * pb.norm());
    }
}

TEST(Panels, GiveTheSameBitsForAnyNumberOfThreads) {
    for (const Cells& cells : {Cells{2, 2, 2}, Cells{12, 11, 9}}) {
        const Solved solved(rest_matrix(uneven_block(cells), gel, backward_euler(1e-3)));
        const std::vector<Float4> b = solved.nodal(noise(3 * solved.matrix().rows(), 1.0, 1));
        for (const Way way : ways()) {
            Panels panels(solved.factor(), way.storage, way.set);
            std::vector<Float4> one(b.size()), other(b.size());
            panels.solve(b.data(), one.data(), one_thread());
            for (const int count : {2, 3}) {
                Threads threads(count);
                panels.solve(b.data(), other.data(), threads);
                EXPECT_EQ(std::memcmp(one.data(), other.data(), one.size() * sizeof(Float4)), 0);
            }
        }
    }
}

TEST(Panels, LeaveTheNodeOfAllFixedOnesAlone) {
    const Solved solved(rest_matrix(uneven_block({4, 4, 3}), gel, quasi_static()));
    Panels panels(solved.factor(), Storage::single, InstructionSet::sse2);
    const std::vector<Float4> b = solved.nodal(noise(3 * solved.matrix().rows(), 1.0, 1));
    std::vector<Float4> x(b.size(), Float4{1.0F, 2.0F, 3.0F, 4.0F});
    panels.solve(b.data(), x.data(), one_thread());
    EXPECT_EQ(x.back().x, 1.0F);
    EXPECT_EQ(x.back().w, 4.0F);
    EXPECT_EQ(x.front().w, 0.0F);
}

TEST(Panels, TakeHalfTheMemoryInHalfPrecision) {
    if (smallest_storage(best_instruction_set()) != Storage::half) GTEST_SKIP() << "this processor converts no halves";
    const Solved solved(rest_matrix(uneven_block({8, 7, 6}), gel, quasi_static()));
    const Panels half(solved.factor(), Storage::half, best_instruction_set());
    const Panels single(solved.factor(), Storage::single, best_instruction_set());
    EXPECT_EQ(2 * half.bytes(), single.bytes());
}

}    // namespace
}    // namespace stylet::corotational_fem
