// Loads on patches of the surface, as a tissue's users see them.
#include <stylet/contract/allocations.h>
#include <stylet/contract/contract.h>
#include <stylet/tissue_model.h>

#include <cmath>
#include <cstdio>
#include <numbers>

namespace stylet {
namespace {

using contract::Case;
using std::numbers::pi;

constexpr double accuracy = 1e-6;     // relative: what is promised of a loaded patch
constexpr double rounding = 1e-13;    // relative: a dozen operations

std::unique_ptr<TissueModel> make(const Case& with) {
    return contract::make<TissueModel>(STYLET_PLUGIN_FILE, with);
}

constexpr double gel_modulus = 25e3, gel_ratio = 0.49;    // [Pa], 1: contract::gel_block()

Patch square(double x, double y, double side) {
    return {.centre = {x, y, 0.0}, .size = {side, side, 0.0}};
}

/// A block without a needle whose patches are loaded at once.
struct LoadedBlock {
    LoadedBlock(const Case& with, std::vector<Patch> where, std::vector<Vector3> forces) : patches(std::move(where)) {
        tissue = make(with);
        tissue->bear(patches);
        tissue->load(forces);
        tissue->predict(1e-3);
        (void)tissue->try_step({}, {nullptr, 0});
        tissue->commit();
    }
    std::vector<Patch> patches;
    std::unique_ptr<TissueModel> tissue;
};

const Case without_needle{.name = "without_needle", .has_needle = false};
const Vector3 newton_down(0.0, 0.0, -1.0);

TEST(HalfSpacePatch, ASquareSinksAsLoveAndTimoshenkoSay) {
    constexpr double side = 21e-3;
    const LoadedBlock block(without_needle, {square(0.0, 0.0, side)}, {newton_down});
    const double unit = (1.0 - gel_ratio * gel_ratio) / (gel_modulus * side);
    const double mean = -block.tissue->patch_displacement(0).z() / unit;
    const double centre = -block.tissue->displacement(Vector3::Zero()).z() / unit;
    const double corner = -block.tissue->displacement({0.5 * side, 0.5 * side, 0.0}).z() / unit;
    std::printf("21 mm square, 1 N: mean %.4f mm = %.5f, centre %.5f, corner %.5f of F(1 - nu^2)/(E s)\n", 1e3 * mean * unit,
                mean, centre, corner);
    constexpr double printed = 0.005;    // Timoshenko and Goodier print 0.95, 1.12 and half of that
    EXPECT_NEAR(mean, 0.95, printed);
    EXPECT_NEAR(centre, 1.12, printed);
    const double loves_centre = 4.0 / pi * std::log(1.0 + std::sqrt(2.0));
    const double loves_mean = 4.0 / pi * (std::log(1.0 + std::sqrt(2.0)) + (1.0 - std::sqrt(2.0)) / 3.0);
    EXPECT_NEAR(centre, loves_centre, accuracy);
    EXPECT_NEAR(corner, 0.5 * loves_centre, accuracy);
    EXPECT_NEAR(mean, loves_mean, accuracy);
}

TEST(HalfSpacePatch, ADiscOfSquaresSinksAsACircle) {
    // Timoshenko and Goodier: a circle of uniform pressure sinks by 16/(3π) p a (1 − ν²)/E on average; of a force and an area:
    constexpr double disc = 16.0 / (3.0 * pi * 1.7724538509055159);    // of F(1 − ν²)/(E √A)
    constexpr double disc_radius = 20e-3;
    double before = 1.0;
    for (const int across : {5, 10, 20}) {
        const double side = 2.0 * disc_radius / across;
        std::vector<Patch> tiles;
        for (int i = 0; i < across; ++i) {
            for (int j = 0; j < across; ++j) {
                const double x = (i + 0.5) * side - disc_radius, y = (j + 0.5) * side - disc_radius;
                if (std::hypot(x, y) <= disc_radius) tiles.push_back(square(x, y, side));
            }
        }
        const double count = static_cast<double>(tiles.size());
        const LoadedBlock block(without_needle, tiles, std::vector<Vector3>(tiles.size(), newton_down / count));
        double mean = 0.0;
        for (int i = 0; i < static_cast<int>(tiles.size()); ++i) mean -= block.tissue->patch_displacement(i).z() / count;
        const double unit = (1.0 - gel_ratio * gel_ratio) / (gel_modulus * std::sqrt(count) * side);
        const double error = std::abs(mean / unit / disc - 1.0);
        std::printf("disc of %zu squares: %.5f, a circle %.5f of F(1 - nu^2)/(E sqrt(A))\n", tiles.size(), mean / unit, disc);
        EXPECT_LT(error, before);
        before = error;
    }
    constexpr double steps = 2e-3;    // of the answer: an outline of steps instead of a circle
    EXPECT_LT(before, steps);
}

TEST(HalfSpacePatch, APartMovesLikeItsWhole) {
    constexpr double side = 20e-3;
    const std::vector<Patch> parts{square(-5e-3, -5e-3, 10e-3), square(5e-3, -5e-3, 10e-3), square(-5e-3, 5e-3, 10e-3),
                                   square(5e-3, 5e-3, 10e-3)};
    for (const Vector3& force : {Vector3(0.0, 0.0, -1.0), Vector3(1.0, 0.0, 0.0), Vector3(0.3, -0.2, -1.0)}) {
        const LoadedBlock whole(without_needle, {square(0.0, 0.0, side)}, {force});
        const LoadedBlock split(without_needle, parts, std::vector<Vector3>(4, 0.25 * force));
        Vector3 mean = Vector3::Zero();
        for (int i = 0; i < 4; ++i) mean += 0.25 * split.tissue->patch_displacement(i);
        EXPECT_LE((mean - whole.tissue->patch_displacement(0)).norm(), 1e-12 * mean.norm()) << force.transpose();
        EXPECT_NEAR(split.tissue->energy().stored / whole.tissue->energy().stored, 1.0, 1e-12);
    }
}

/// A tissue with two patches, a tip and a piece of shaft, all loaded.
struct Pushed {
    Pushed() {
        tissue->bear(patches);
        tissue->load(loads);
    }
    /// Takes a share of the patches' loads and another of the contacts' forces.
    void take(double of_loads, double of_forces) {
        const std::vector<Vector3> now{of_loads * loads[0], of_loads * loads[1]};
        tissue->load(now);
        tissue->predict(1e-3);
        scaled = of_forces * forces;
        (void)tissue->linearise(points, 0.0);
        (void)tissue->try_step(points, {scaled.data(), scaled.size()});
        tissue->commit();
    }
    VectorX contacts_moved() {
        const Linearisation now = tissue->linearise(points, 0.0);
        VectorX moved = now.free + now.compliance * scaled;
        for (std::size_t i = 0; i < points.size(); ++i) moved.segment<3>(3 * static_cast<Eigen::Index>(i)) -= points[i].material;
        return moved;
    }
    VectorX patches_moved() {
        VectorX moved(6);
        moved << tissue->patch_displacement(0), tissue->patch_displacement(1);
        return moved;
    }

    Case gel{.name = "gel"};
    std::unique_ptr<TissueModel> tissue = make(gel);
    std::vector<Patch> patches{square(4e-3, 0.0, 10e-3), {.centre = {-6e-3, 9e-3, 0.0}, .size = {8e-3, 3e-3, 0.0}}};
    std::vector<Vector3> loads{{0.2, -0.1, -1.0}, {-0.3, 0.4, 0.5}};
    std::vector<ContactPoint> points{{.material = {0.0, 0.0, -8e-3}, .span = Vector3::Zero(), .arclength = 0.2, .tip = true},
                                     {.material = Vector3::Zero(), .span = {0.0, 0.0, -5e-3}, .arclength = 0.192, .tip = false}};
    VectorX forces = (VectorX(6) << 0.01, 0.02, -0.3, -0.01, 0.03, -0.05).finished();
    VectorX scaled = VectorX::Zero(6);
};

constexpr double of_sums = 1e-12;    // relative: a few hundred roundings, and 1e-9 of a shaft's own compliance (independence)

TEST(HalfSpacePatch, LoadsAndContactsAddUp) {
    Pushed loads, forces, both;
    loads.take(1.0, 0.0);
    forces.take(0.0, 1.0);
    both.take(1.0, 1.0);
    const VectorX contacts = both.contacts_moved(), patches = both.patches_moved();
    EXPECT_GT(loads.contacts_moved().norm(), 0.1 * contacts.norm()) << "the loads move the contacts";
    EXPECT_GT(forces.patches_moved().norm(), 0.01 * patches.norm()) << "the contacts move the patches";
    EXPECT_LE((loads.contacts_moved() + forces.contacts_moved() - contacts).norm(), of_sums * contacts.norm());
    EXPECT_LE((loads.patches_moved() + forces.patches_moved() - patches).norm(), of_sums * patches.norm());
    for (const Vector3& x : {Vector3(0.0, 0.0, -8e-3), Vector3(4e-3, 0.0, 0.0), Vector3(0.05, 0.02, -0.03)}) {
        const Vector3 sum = loads.tissue->displacement(x) + forces.tissue->displacement(x);
        EXPECT_LE((both.tissue->displacement(x) - sum).norm(), of_sums * sum.norm());
    }
}

TEST(HalfSpacePatch, LoadsWorkOnContactsWhatContactsWorkOnLoads) {
    Pushed loads, forces;
    loads.take(1.0, 0.0);
    forces.take(0.0, 1.0);
    VectorX on_patches(6);
    on_patches << loads.loads[0], loads.loads[1];
    const double one = loads.contacts_moved().dot(forces.forces), other = forces.patches_moved().dot(on_patches);
    std::printf("Betti: %.9g and %.9g mJ\n", 1e3 * one, 1e3 * other);
    EXPECT_NEAR(one / other, 1.0, of_sums);
}

TEST(HalfSpacePatch, EnergyIsTheWorkOfLoadsAndContacts) {
    Pushed block;
    VectorX on_patches(6);
    on_patches << block.loads[0], block.loads[1];
    double work = 0.0, old_loads = 0.0;
    VectorX contacts = VectorX::Zero(6), patches = VectorX::Zero(6), old_forces = VectorX::Zero(6);
    for (int i = 1; i <= 20; ++i) {    // loads and forces rise and fall, not together
        const double of_loads = std::sin(0.3 * i), of_forces = std::sin(0.13 * i);
        block.take(of_loads, of_forces);
        const VectorX now = block.contacts_moved(), then = block.patches_moved();
        work += 0.5 * (old_forces + of_forces * block.forces).dot(now - contacts);
        work += 0.5 * (old_loads + of_loads) * on_patches.dot(then - patches);
        contacts = now;
        patches = then;
        old_loads = of_loads;
        old_forces = of_forces * block.forces;
    }
    std::printf("stored %.9g mJ, worked %.9g mJ\n", 1e3 * block.tissue->energy().stored, 1e3 * work);
    EXPECT_NEAR(block.tissue->energy().stored / work, 1.0, of_sums);
}

TEST(HalfSpacePatch, IsPositiveDefiniteTogetherWithContacts) {
    // A force on a patch against the same on a contact in its middle: the mean of a patch of the needle's size moves much less
    // than the contact, and nearly nothing is left of the pair's energy if the kernels of the two don't fit.
    for (const double side : {0.1e-3, 0.3e-3, 0.53e-3, 1e-3, 5e-3}) {
        for (const double depth : {0.0, 0.1e-3, 1e-3}) {
            const Case gel{.name = "gel"};
            const auto tissue = make(gel);
            const Patch patch = square(0.0, 0.0, side);
            tissue->bear({&patch, 1});
            const ContactPoint tip{.material = {0.0, 0.0, -depth}, .span = Vector3::Zero(), .arclength = 0.2, .tip = true};
            MatrixX all(6, 6);
            for (int j = 0; j < 6; ++j) {
                const VectorX unit = VectorX::Unit(6, j), force = unit.tail(3);
                const Vector3 load = unit.head(3);
                tissue->load({&load, 1});
                tissue->predict(1e-3);
                (void)tissue->try_step({&tip, 1}, {force.data(), 3});
                const Linearisation now = tissue->linearise({&tip, 1}, 0.0);
                all.col(j) << tissue->patch_displacement(0), now.free + now.compliance * force - tip.material;
            }
            EXPECT_LE((all - all.transpose()).norm(), 1e-9 * all.norm());
            EXPECT_GT(all.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff(), 0.0) << side << " m, " << depth << " m deep";
        }
    }
}

TEST(HalfSpacePatch, ShowsATipWhereTheTipIs) {
    Pushed block;
    block.points.resize(1);
    block.points[0].material.setZero();
    block.forces.conservativeResize(3);
    block.take(1.0, 1.0);
    const Vector3 shown = block.tissue->displacement(block.points[0].material);
    std::printf("tip of 0.3 N beside two patches: moved %.4f mm\n", 1e3 * shown.norm());
    // 1e-9: a contact is that much softer in its own place (independence).
    EXPECT_LE((shown - block.contacts_moved()).norm(), 2e-9 * shown.norm());
}

TEST(HalfSpacePatch, ALoadActsFromTheNextPredictOnAndIsTakenBack) {
    const std::vector<Patch> patches{square(0.0, 0.0, 10e-3)};
    const auto tissue = make(without_needle);
    const auto settle = [&tissue] {
        (void)tissue->try_step({}, {nullptr, 0});
        return tissue->patch_displacement(0).z();
    };
    tissue->bear(patches);
    tissue->load({&newton_down, 1});
    EXPECT_EQ(settle(), 0.0) << "not before predict";
    tissue->predict(1e-3);
    const double once = settle();
    EXPECT_LT(once, 0.0);
    tissue->commit();
    const Vector3 more = 3.0 * newton_down;
    tissue->load({&more, 1});
    tissue->predict(1e-3);
    EXPECT_NEAR(settle() / once, 3.0, rounding);
    tissue->rollback();
    EXPECT_EQ(tissue->patch_displacement(0).z(), once);
    tissue->predict(0.0);
    EXPECT_EQ(settle(), once) << "a load that was taken back acts again";
}

TEST(HalfSpacePatch, HasTheModulusOfTheTopLayer) {
    Case layered = without_needle;
    layered.tissue.layers.insert(layered.tissue.layers.begin(), layered.tissue.layers.front());
    layered.tissue.layers.front().name = "skin";
    layered.tissue.layers.front().youngs_modulus = 60e3;
    layered.tissue.layers.front().thickness = 5e-3;
    const LoadedBlock soft(without_needle, {square(0.0, 0.0, 21e-3)}, {newton_down});
    const LoadedBlock hard(layered, {square(0.0, 0.0, 21e-3)}, {newton_down});
    EXPECT_NEAR(soft.tissue->patch_displacement(0).z() / hard.tissue->patch_displacement(0).z(), 60e3 / 25e3, rounding);
    EXPECT_TRUE(hard.tissue->displacement({0.0, 0.0, -5e-3}).allFinite()) << "on the interface";
}

TEST(HalfSpacePatch, SaysWhenItSinksDeeperThanTheBlock) {
    const double limit = 0.15 / (0.946402 * (1.0 - gel_ratio * gel_ratio) / (gel_modulus * 21e-3));    // [N]
    for (const double share : {0.99, 1.01}) {
        const LoadedBlock block(without_needle, {square(0.0, 0.0, 21e-3)}, {share * limit * newton_down});
        EXPECT_EQ(block.tissue->beyond_validity() != nullptr, share > 1.0);
    }
}

TEST(HalfSpacePatch, ATickAllocatesNothing) {
    Pushed block;
    block.take(0.1, 0.1);
    const std::vector<Vector3> loads = block.loads;
    const std::size_t before = contract::allocations();
    for (int i = 0; i < 3; ++i) {
        block.points[1].span.z() -= 1e-3;    // a growing contact meets the patches anew
        block.tissue->load(loads);
        block.tissue->predict(1e-3);
        (void)block.tissue->linearise(block.points, 0.0);
        (void)block.tissue->try_step(block.points, {block.forces.data(), block.forces.size()});
        (void)block.tissue->patch_displacement(1);
        if (i == 1) block.tissue->rollback();
        block.tissue->commit();
        (void)block.tissue->displacement({1e-3, 0.0, -2e-3});
    }
    EXPECT_EQ(contract::allocations() - before, 0U);
}

std::string refusal(const Patch& patch, const std::string& key) {
    const auto tissue = make(without_needle);
    try {
        tissue->bear({&patch, 1});
    } catch (const Error& error) {
        EXPECT_EQ(error.key(), key);
        return error.what();
    }
    return "accepted";
}

TEST(HalfSpacePatch, IsRefusedWhereItIsNoRectangleOnTheTop) {
    EXPECT_EQ(refusal({.centre = {0.0, 0.0, 0.0}, .size = {0.02, 0.02, 1e-3}}, "size"),
              "found a height of 0.001 m, wanted 0 m: half_space bears loads on its top alone");
    EXPECT_EQ(refusal({.centre = {0.0, 0.0, -0.01}, .size = {0.02, 0.02, 0.0}}, "centre"),
              "found z = -0.01 m, wanted 0 m: half_space bears loads on its top alone");
    EXPECT_EQ(refusal({.centre = {0.0, 0.0, 0.0}, .size = {0.02, 0.0, 0.0}}, "size"),
              "found 0.02 m by 0 m, wanted a rectangle with sides of at least 1e-05 m");
    EXPECT_EQ(refusal({.centre = {0.191, 0.0, 0.0}, .size = {0.02, 0.02, 0.0}}, "centre"),
              "found a patch that reaches beyond the block's top of 0.4 m by 0.4 m around the origin, wanted it within");
    EXPECT_EQ(refusal({.centre = {0.19, 0.0, 0.0}, .size = {0.02, 0.02, 0.0}}, ""), "accepted");
    EXPECT_EQ(refusal({.centre = {0.0, 0.0, 0.0}, .size = {0.4, 0.4, 0.0}}, ""), "accepted");
}

TEST(HalfSpacePatch, IsRefusedAsOneOfTooMany) {
    const auto tissue = make(without_needle);
    try {
        tissue->bear(std::vector<Patch>(1001, square(0.0, 0.0, 1e-3)));
        FAIL() << "accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.key(), "effects");
        EXPECT_STREQ(error.what(), "found 1001 loaded patches, half_space bears at most 1000");
    }
}

}    // namespace
}    // namespace stylet
