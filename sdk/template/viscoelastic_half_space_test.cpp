// Every promise of a tissue first, on the built library; then this one's own: the closed forms that it must meet.
#include "kernel.h"

#include <stylet/contract/contract.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <random>

namespace stylet::viscoelastic_half_space {
namespace {

using contract::Case;

constexpr double prompt = 25e3;       // [Pa] E₀, the modulus of gel_block()
constexpr double long_term = 10e3;    // [Pa] E∞
constexpr double tau = 0.5;           // [s]

Case gel(double retardation_time = tau) {
    return {.name = "Gel", .parameters = {{"long_term_modulus", long_term}, {"retardation_time", retardation_time}}};
}
Case hard_push() {
    Case with = gel(0.02);
    with.name = "HardPush";
    with.load = 2.0;
    with.lateral = 0.3;
    return with;
}

STYLET_CONTRACT(gel(), hard_push())

/// The tip alone, on the surface.
class Dent : public testing::Test {
protected:
    /// Takes a step under this force on the tissue [N] and tells where the tip is then [m].
    double step(double dt, double force) {
        const VectorX down = -force * VectorX::Unit(3, 2);
        tissue_->predict(dt);
        (void)tissue_->linearise({&tip_, 1}, 0.0);
        (void)tissue_->try_step({&tip_, 1}, {down.data(), 3});
        tissue_->commit();
        const Linearisation found = tissue_->linearise({&tip_, 1}, 0.0);
        return -(found.free + found.compliance * down).z();
    }

    /// The force [N] that puts the tip there [m] at the end of a step.
    double step_to(double dt, double depth) {
        tissue_->predict(dt);
        const Linearisation found = tissue_->linearise({&tip_, 1}, 0.0);
        const double force = (depth + found.free.z()) / found.compliance(2, 2);
        (void)step(dt, force);
        return force;
    }

    void begin_anew() { tissue_ = contract::make<TissueModel>(STYLET_PLUGIN_FILE, with_); }

    /// `error` tells how far a march in steps of dt [s] strays from its curve; prints and checks the order in dt.
    static void expect_second_order(const std::function<double(double dt)>& error) {
        constexpr double of_the_order = 0.02;    // what the next power, the fourth, still has to say at τ/20
        const double coarse = error(tau / 20.0), fine = error(tau / 40.0);
        const double order = std::log2(coarse / fine);
        std::printf("errors %.3g and %.3g at tau/20 and tau/40: order %.4f\n", coarse, fine, order);
        EXPECT_NEAR(order, 2.0, of_the_order);
    }

    static constexpr double load_ = 0.1;      // [N]
    static constexpr double depth_ = 3e-3;    // [m]
    const Case with_ = gel();
    const double nu_ = with_.tissue.layers.front().poisson_ratio;
    const double unit_ = (1.0 - nu_ * nu_) / (2.0 * with_.needle.radius);    // [1/m] C of the tip alone
    const ContactPoint tip_{.material = Vector3::Zero(), .span = Vector3::Zero(), .arclength = with_.needle.length, .tip = true};
    std::unique_ptr<TissueModel> tissue_ = contract::make<TissueModel>(STYLET_PLUGIN_FILE, with_);
};

constexpr double apart = 2e-9;    // relative: a contact's own compliance is raised by 1e-9, so that two in one place stay two

TEST_F(Dent, MeetsTheLayersModulusInAQuickPush) {
    EXPECT_NEAR(step(0.0, load_) / (unit_ * load_ / prompt), 1.0, apart);
}

TEST_F(Dent, MeetsTheLongTermModulusOnceCreepIsOver) {
    double depth = 0.0;
    for (int i = 0; i < 1000; ++i) depth = step(tau / 20.0, load_);    // 50 τ
    EXPECT_NEAR(depth / (unit_ * load_ / long_term), 1.0, apart);
}

TEST_F(Dent, CreepsUnderAConstantForce) {
    const auto curve = [this](double t) {
        return unit_ * load_ * (1.0 / prompt + (1.0 / long_term - 1.0 / prompt) * (1.0 - std::exp(-t / tau)));
    };
    expect_second_order([&](double dt) {
        begin_anew();
        (void)step(0.0, load_);
        double worst = 0.0;
        for (int i = 1; i * dt <= 4.0 * tau; ++i) worst = std::max(worst, std::abs(step(dt, load_) / curve(i * dt) - 1.0));
        return worst;
    });
}

TEST_F(Dent, RelaxesWhereItIsHeld) {
    const double relaxation_time = tau * long_term / prompt;
    const auto curve = [&](double t) {
        return depth_ / unit_ * (long_term + (prompt - long_term) * std::exp(-t / relaxation_time));
    };
    expect_second_order([&](double dt) {
        begin_anew();
        (void)step_to(0.0, depth_);
        double worst = 0.0;
        for (int i = 1; i * dt <= 4.0 * tau; ++i) worst = std::max(worst, std::abs(step_to(dt, depth_) / curve(i * dt) - 1.0));
        return worst;
    });
}

TEST_F(Dent, StandsStillAtOneInstant) {
    (void)step(0.1, load_);
    const EnergyReport before = tissue_->energy();
    const double depth = step(0.0, load_);
    for (int i = 0; i < 10; ++i) EXPECT_EQ(step(0.0, load_), depth);
    EXPECT_EQ(tissue_->energy().damping, before.damping);
}

TEST_F(Dent, ShowsInThePicture) {
    const double depth = step(0.1, load_);
    EXPECT_NEAR(-tissue_->displacement(Vector3::Zero()).z() / depth, 1.0, apart);
    EXPECT_LT(-tissue_->displacement(Vector3(0.0, 0.0, -0.01)).z(), 0.1 * depth) << "a centimetre below";
}

TEST(Kernel, IsKelvinsPointLoadFarAway) {
    const double nu = 0.3, radius = 1e-3, r = 0.1;
    const Kernel kernel(nu, radius);
    constexpr double of_the_ball = 1e-4;    // (ε/r)² is 3e-5
    EXPECT_NEAR(kernel(Vector3(0.0, 0.0, r))(2, 2) * 2.0 * std::numbers::pi * r / (1.0 + nu), 1.0, of_the_ball);
    EXPECT_NEAR(kernel(Vector3(r, 0.0, 0.0))(2, 2) * 8.0 * std::numbers::pi * (1.0 - nu) * r / ((1.0 + nu) * (3.0 - 4.0 * nu)),
                1.0, of_the_ball);
}

TEST(Kernel, IsPositiveDefinite) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(-5e-3, 5e-3);
    std::vector<Vector3> points;
    for (int i = 0; i < 30; ++i) points.emplace_back(place(random), place(random), place(random));
    for (const double nu : {0.0, 0.3, 0.49}) {
        const Kernel kernel(nu, 0.3e-3);
        MatrixX all(90, 90);
        for (int i = 0; i < 30; ++i) {
            for (int j = 0; j < 30; ++j) all.block<3, 3>(3 * i, 3 * j) = kernel(points[i] - points[j]);
        }
        const double least = all.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff();
        std::printf("30 random points, nu %.2f: least eigenvalue %.3g /m\n", nu, least);
        EXPECT_GT(least, 0.0);
    }
}

std::string refusal(const Case& with) {
    try {
        (void)contract::make<TissueModel>(STYLET_PLUGIN_FILE, with);
        return "";
    } catch (const Error& error) {
        return error.key();
    }
}

TEST(ViscoelasticHalfSpace, RefusesWhatMakesNoSense) {
    Case layered = gel();
    layered.tissue.layers.push_back(layered.tissue.layers.front());
    EXPECT_EQ(refusal(layered), "layers");
    Case stiffening = gel();
    stiffening.parameters.set("long_term_modulus", prompt);
    EXPECT_EQ(refusal(stiffening), "long_term_modulus");
    EXPECT_EQ(refusal(gel(1e-3)), "retardation_time") << "0.4 ms of relaxation in steps of 1 ms";
    EXPECT_EQ(refusal(gel(2e-3)), "");
}

}    // namespace
}    // namespace stylet::viscoelastic_half_space
