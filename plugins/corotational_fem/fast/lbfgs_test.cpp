#include "fast/lbfgs.h"

#include <stylet/types.h>

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace stylet::corotational_fem {
namespace {

constexpr int nodes = 70;    // more than two runs of a sum
constexpr int unknowns = 3 * nodes;
constexpr double single = 2e-5;    // of single precision, over some hundred additions

const NodeLoops loops(nodes, one_thread());

NodalVector nodal(const VectorX& v) {
    NodalVector to(nodes);
    for (int i = 0; i < nodes; ++i) {
        to[i] = {static_cast<float>(v[3 * i]), static_cast<float>(v[3 * i + 1]), static_cast<float>(v[3 * i + 2]), 0.0F};
    }
    return to;
}

VectorX plain(const NodalVector& v) {
    VectorX to(unknowns);
    for (int i = 0; i < nodes; ++i) to.segment<3>(3 * i) << v[i].x, v[i].y, v[i].z;
    return to;
}

// The stiffness that is to be learnt, known at first as a diagonal matrix.
class Stiffness {
public:
    Stiffness() {
        std::mt19937 generator(7);
        std::uniform_real_distribution<double> any(-1.0, 1.0);
        const MatrixX mixed = MatrixX::NullaryExpr(unknowns, 5, [&] { return any(generator); });
        diagonal_ = VectorX::NullaryExpr(unknowns, [&] { return 2.0 + any(generator); });
        matrix_ = mixed * mixed.transpose() / 5.0;
        matrix_.diagonal() += diagonal_;
        for (VectorX& step : steps_) step = VectorX::NullaryExpr(unknowns, [&] { return any(generator); });
    }

    [[nodiscard]] const VectorX& step(int k) const { return steps_[k]; }
    [[nodiscard]] VectorX change(int k) const { return matrix_ * steps_[k]; }

    void teach(Lbfgs& pairs, int k) const {
        const NodalVector s = nodal(step(k)), y = nodal(change(k));
        std::copy(s.begin(), s.end(), pairs.step());
        std::copy(y.begin(), y.end(), pairs.change());
        pairs.keep(step(k).dot(change(k)));
    }

    [[nodiscard]] VectorX answer(Lbfgs& pairs, const VectorX& r) const {
        NodalVector q(nodes);
        pairs.begin(nodal(r).data(), q.data());
        NodalVector z(nodes);
        pairs.finish(nodal(plain(q).cwiseQuotient(diagonal_)).data(), z.data());
        return plain(z);
    }

    // H as the update of Broyden, Fletcher, Goldfarb and Shanno has it, pair by pair.
    [[nodiscard]] MatrixX inverse(const std::vector<int>& taught) const {
        MatrixX h = diagonal_.cwiseInverse().asDiagonal();
        for (const int k : taught) {
            const VectorX s = step(k), y = change(k);
            const MatrixX v = MatrixX::Identity(unknowns, unknowns) - y * s.transpose() / s.dot(y);
            h = v.transpose() * h * v + s * s.transpose() / s.dot(y);
        }
        return h;
    }

private:
    MatrixX matrix_;
    VectorX diagonal_;
    VectorX steps_[8];
};

TEST(Lbfgs, IsTheUpdateOfBroydenFletcherGoldfarbAndShanno) {
    const Stiffness stiffness;
    Lbfgs pairs(loops);
    const VectorX r = stiffness.step(7);
    std::vector<int> taught;
    for (int k = 0; k < 6; ++k) {
        const VectorX wanted = stiffness.inverse(taught) * r;
        EXPECT_LT((stiffness.answer(pairs, r) - wanted).norm(), single * wanted.norm()) << k;
        stiffness.teach(pairs, k);
        taught.push_back(k);
        if (taught.size() > Lbfgs::most) taught.erase(taught.begin());
    }
}

TEST(Lbfgs, AnswersTheNewestChangeWithItsStep) {
    const Stiffness stiffness;
    Lbfgs pairs(loops);
    for (int k = 0; k < 6; ++k) {
        stiffness.teach(pairs, k);
        EXPECT_LT((stiffness.answer(pairs, stiffness.change(k)) - stiffness.step(k)).norm(), single * stiffness.step(k).norm());
    }
}

TEST(Lbfgs, RemembersWhatItKnewAtTheLastCommit) {
    const Stiffness stiffness;
    Lbfgs pairs(loops);
    for (int k = 0; k < 4; ++k) stiffness.teach(pairs, k);
    pairs.commit();
    const VectorX before = stiffness.answer(pairs, stiffness.step(7));
    for (int more = 0; more < 4; ++more) {
        for (int k = 4; k < 4 + more; ++k) stiffness.teach(pairs, k);
        if (more == 2) pairs.forget();
        pairs.rollback();
        EXPECT_EQ(stiffness.answer(pairs, stiffness.step(7)), before) << more;
    }
}

TEST(Lbfgs, ThatHasForgottenIsTheFactorAlone) {
    const Stiffness stiffness;
    Lbfgs pairs(loops), fresh(loops);
    for (int k = 0; k < 4; ++k) stiffness.teach(pairs, k);
    pairs.forget();
    EXPECT_EQ(stiffness.answer(pairs, stiffness.step(7)), stiffness.answer(fresh, stiffness.step(7)));
}

}    // namespace
}    // namespace stylet::corotational_fem
