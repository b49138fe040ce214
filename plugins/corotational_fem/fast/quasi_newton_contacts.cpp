#include "fast/quasi_newton_contacts.h"

namespace stylet::corotational_fem {

namespace {

constexpr int worth_sharing = 1500;    // [nodes] 90 µs a sweep; few contacts move at once, so that the tasks can't be smaller

}    // namespace

Contacts::Contacts(Panels& panels, Workers& workers)
    : dissection_(panels.dissection()),
      workers_(dissection_.places() < worth_sharing ? one_thread() : workers),
      placed_(max_contacts),
      compliance_(MatrixX::Zero(3 * max_contacts, 3 * max_contacts)) {
    asked_.reserve(max_contacts);
    for (Placed& placed : placed_) placed.footprint.reserve(panels.dissection().place_of_node.size());
    reaches_.reserve(max_contacts);
    for (int i = 0; i < max_contacts; ++i) reaches_.emplace_back(panels);
}

void Contacts::place(int contact, std::span<const NodeWeight> footprint) {
    placed_[contact].footprint.assign(footprint.begin(), footprint.end());
    placed_[contact].answered = false;
}

void Contacts::answer(int contacts) {
    asked_.clear();
    for (int i = 0; i < contacts; ++i) {
        if (!placed_[i].answered) asked_.push_back(i);
    }
    workers_.each(static_cast<int>(asked_.size()), [&](int k) { reaches_[asked_[k]].sweep(placed_[asked_[k]].footprint); });
    for (const int i : asked_) {
        placed_[i].answered = true;
        for (int j = 0; j < max_contacts; ++j) {
            if (!placed_[j].answered) continue;
            const Matrix3 block = reaches_[i].compliance(reaches_[j]);
            compliance_.block<3, 3>(3 * i, 3 * j) = block;
            compliance_.block<3, 3>(3 * j, 3 * i) = block.transpose();
        }
    }
}

void Contacts::press(std::span<const double> lambda, NodalVector& forces) const {
    for (std::size_t i = 0; i < lambda.size() / 3; ++i) {
        for (const auto& [node, weight] : placed_[i].footprint) {
            Float4& force = forces[dissection_.place_of_node[node]];
            force.x += static_cast<float>(weight * lambda[3 * i]);
            force.y += static_cast<float>(weight * lambda[3 * i + 1]);
            force.z += static_cast<float>(weight * lambda[3 * i + 2]);
        }
    }
}

Vector3 Contacts::mean(int contact, const NodalVector& x) const {
    Vector3 sum = Vector3::Zero();
    for (const auto& [node, weight] : placed_[contact].footprint) {
        const Float4& at = x[dissection_.place_of_node[node]];
        sum += weight * Vector3(at.x, at.y, at.z);
    }
    return sum;
}

}    // namespace stylet::corotational_fem
