#include "fast/lbfgs.h"

#include <algorithm>

namespace stylet::corotational_fem {

Lbfgs::Lbfgs(const NodeLoops& loops) : loops_(loops) {
    for (NodalVector& step : steps_) step.resize(loops.nodes());
    for (NodalVector& change : changes_) change.resize(loops.nodes());
}

// The first slot that holds no pair of now nor of the last commit.
int Lbfgs::spare() const {
    int slot = 0;
    const auto holds = [&](const Known& known) {
        return std::find(known.slots.begin(), known.slots.begin() + known.count, slot) != known.slots.begin() + known.count;
    };
    while (holds(trial_) || holds(state_)) ++slot;
    return slot;
}

void Lbfgs::keep(double curvature) {
    static_assert(most == 3);
    switch (trial_.count) {
        case 0:
            break;
        case 1:
            multiply_next<1>();
            break;
        case 2:
            multiply_next<2>();
            break;
        default:
            multiply_next<3>();
            break;
    }
    const int next = spare();
    products_[next][next] = curvature;
    if (trial_.count == most) {
        std::rotate(trial_.slots.begin(), trial_.slots.begin() + 1, trial_.slots.end());
        --trial_.count;
    }
    trial_.slots[trial_.count++] = next;
}

template <int count>
void Lbfgs::multiply_next() {
    std::array<const Float4*, count> s, y;
    for (int k = 0; k < count; ++k) {
        s[k] = steps_[trial_.slots[k]].data();
        y[k] = changes_[trial_.slots[k]].data();
    }
    const Float4 *const next_s = step(), *const next_y = change();
    const auto sums = loops_.sums<2 * count>([&](int i, auto& parts) {
        for (int k = 0; k < count; ++k) {
            parts[k] += quad(s[k][i]) * quad(next_y[i]);
            parts[count + k] += quad(next_s[i]) * quad(y[k][i]);
        }
    });
    const int next = spare();
    for (int k = 0; k < count; ++k) {
        products_[trial_.slots[k]][next] = sums[k];
        products_[next][trial_.slots[k]] = sums[count + k];
    }
}

void Lbfgs::begin(const Float4* r, Float4* q) {
    switch (trial_.count) {
        case 0:
            loops_.each([&](int i) { q[i] = r[i]; });
            break;
        case 1:
            begin_with<1>(r, q);
            break;
        case 2:
            begin_with<2>(r, q);
            break;
        default:
            begin_with<3>(r, q);
            break;
    }
}

// From the newest to the oldest: α_i = s_i·q/(s_i·y_i), q ← q − α_i y_i
template <int count>
void Lbfgs::begin_with(const Float4* r, Float4* q) {
    std::array<const Float4*, count> s, y;
    for (int k = 0; k < count; ++k) {
        s[k] = steps_[trial_.slots[k]].data();
        y[k] = changes_[trial_.slots[k]].data();
    }
    const auto along = loops_.sums<count>([&](int i, auto& parts) {
        for (int k = 0; k < count; ++k) parts[k] += quad(s[k][i]) * quad(r[i]);
    });
    std::array<float, count> taken;
    for (int k = count - 1; k >= 0; --k) {
        double left = along[k];
        for (int newer = k + 1; newer < count; ++newer) left -= taken_[newer] * products_[trial_.slots[k]][trial_.slots[newer]];
        taken_[k] = left / products_[trial_.slots[k]][trial_.slots[k]];
        taken[k] = static_cast<float>(taken_[k]);
    }
    loops_.each([&](int i) {
        Quad left = quad(r[i]);
        for (int k = 0; k < count; ++k) left -= taken[k] * quad(y[k][i]);
        quad(q[i]) = left;
    });
}

void Lbfgs::finish(const Float4* answer, Float4* z) const {
    switch (trial_.count) {
        case 0:
            loops_.each([&](int i) { z[i] = answer[i]; });
            break;
        case 1:
            finish_with<1>(answer, z);
            break;
        case 2:
            finish_with<2>(answer, z);
            break;
        default:
            finish_with<3>(answer, z);
            break;
    }
}

// From the oldest to the newest: z ← z + (α_i − y_i·z/(s_i·y_i)) s_i
template <int count>
void Lbfgs::finish_with(const Float4* answer, Float4* z) const {
    std::array<const Float4*, count> s, y;
    for (int k = 0; k < count; ++k) {
        s[k] = steps_[trial_.slots[k]].data();
        y[k] = changes_[trial_.slots[k]].data();
    }
    const auto along = loops_.sums<count>([&](int i, auto& parts) {
        for (int k = 0; k < count; ++k) parts[k] += quad(y[k][i]) * quad(answer[i]);
    });
    std::array<double, count> given;
    std::array<float, count> rounded;
    for (int k = 0; k < count; ++k) {
        double there = along[k];
        for (int older = 0; older < k; ++older) there += given[older] * products_[trial_.slots[older]][trial_.slots[k]];
        given[k] = taken_[k] - there / products_[trial_.slots[k]][trial_.slots[k]];
        rounded[k] = static_cast<float>(given[k]);
    }
    loops_.each([&](int i) {
        Quad sum = quad(answer[i]);
        for (int k = 0; k < count; ++k) sum += rounded[k] * quad(s[k][i]);
        quad(z[i]) = sum;
    });
}

}    // namespace stylet::corotational_fem
