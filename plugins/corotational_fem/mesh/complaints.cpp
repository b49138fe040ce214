#include "mesh/complaints.h"

#include <algorithm>
#include <cstdio>

namespace stylet::corotational_fem {
namespace {

constexpr int most_listed = 10;

std::string tag_of(const std::vector<std::uint64_t>& tags, int index) {
    return std::to_string(tags.empty() ? static_cast<std::uint64_t>(index) : tags[index]);
}

std::string shown(const Vector3& place) {
    char text[96];
    std::snprintf(text, sizeof text, "(%g, %g, %g) m", place.x(), place.y(), place.z());
    return text;
}

}    // namespace

std::string figure(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", value);
    return text;
}

void Complaints::add(const std::string& kind, const std::string& one) {
    auto found = std::find_if(kinds_.begin(), kinds_.end(), [&](const Kind& known) { return known.name == kind; });
    if (found == kinds_.end()) found = kinds_.insert(found, {kind, {}, 0});
    if (found->count++ < most_listed) found->first.push_back(one);
}

std::string Complaints::node(int index) const {
    return "node " + tag_of(tags_.nodes, index) + " at " + shown(mesh_.nodes[index]);
}

std::string Complaints::name_of(int tetrahedron) const {
    return tag_of(tags_.tetrahedra, tetrahedron);
}

std::string Complaints::tetrahedron(int index) const {
    std::string nodes;
    Vector3 middle = Vector3::Zero();
    for (const int node : mesh_.tetrahedra[index]) {
        nodes += (nodes.empty() ? "" : ", ") + tag_of(tags_.nodes, node);
        middle += 0.25 * mesh_.nodes[node];
    }
    return "tetrahedron " + name_of(index) + " (nodes " + nodes + ") at " + shown(middle);
}

void Complaints::throw_any(const std::string& key) const {
    if (kinds_.empty()) return;
    std::string message;
    for (const Kind& kind : kinds_) {
        message += (message.empty() ? "found " : "; found ") + kind.name + ": ";
        for (const std::string& one : kind.first) message += (&one == &kind.first.front() ? "" : ", ") + one;
        if (kind.count > most_listed) message += " and " + std::to_string(kind.count - most_listed) + " more";
    }
    throw Error(key, message);
}

}    // namespace stylet::corotational_fem
