#pragma once

#include "mesh/mesh.h"

#include <stylet/error.h>

#include <string>

namespace stylet::corotational_fem {

/// A number as a sentence shows it, with six digits.
[[nodiscard]] std::string figure(double value);

/// Gathers what is wrong with a mesh, to be thrown at once: of each kind the first ten, and how many there are.
class Complaints {
public:
    Complaints(const Mesh& mesh, const MeshTags& tags) : mesh_(mesh), tags_(tags) {}

    void add(const std::string& kind, const std::string& one);

    /// What a sentence calls a node or a tetrahedron: its tag, and where it is.
    [[nodiscard]] std::string node(int index) const;
    [[nodiscard]] std::string tetrahedron(int index) const;
    [[nodiscard]] std::string name_of(int tetrahedron) const;

    void throw_any(const std::string& key) const;

private:
    struct Kind {
        std::string name;
        std::vector<std::string> first;
        int count;
    };

    const Mesh& mesh_;
    const MeshTags& tags_;
    std::vector<Kind> kinds_;
};

}    // namespace stylet::corotational_fem
