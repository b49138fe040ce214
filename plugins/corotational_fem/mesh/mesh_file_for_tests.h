#pragma once

#include "mesh/meshes_for_tests.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace stylet::corotational_fem {

/// A file of its own for each process, since tests run side by side.
class MeshFile {
public:
    explicit MeshFile(const std::string& text) : path_(testing::TempDir() + "stylet_mesh_" + std::to_string(getpid()) + ".msh") {
        std::ofstream(path_, std::ios::binary) << text;
    }
    MeshFile(const MeshFile&) = delete;
    MeshFile& operator=(const MeshFile&) = delete;
    ~MeshFile() { std::filesystem::remove(path_); }

    [[nodiscard]] const std::string& path() const { return path_; }

private:
    std::string path_;
};

inline std::string replaced(std::string text, const std::string& what, const std::string& by) {
    const std::size_t found = text.find(what);
    EXPECT_NE(found, std::string::npos) << what;
    return found == std::string::npos ? text : text.replace(found, what.size(), by);
}

/// A cube of one metre in six tetrahedra whose tags are sparse and in no order. Line 1 is $MeshFormat.
inline std::string cube_22() {
    return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
           "$PhysicalNames\n1\n3 1 \"gel\"\n$EndPhysicalNames\n"
           "$Nodes\n8\n"
           "900 -0.5 -0.5 -1\n7 0.5 -0.5 -1\n31 -0.5 0.5 -1\n12 0.5 0.5 -1\n"
           "800000 -0.5 -0.5 0\n5 0.5 -0.5 0\n6 -0.5 0.5 0\n44 0.5 0.5 0\n"
           "$EndNodes\n"
           "$Elements\n6\n"
           "60 4 2 1 1 900 7 12 44\n50 4 2 1 1 900 31 6 44\n40 4 2 1 1 900 800000 5 44\n"
           "30 4 2 1 1 900 12 31 44\n20 4 2 1 1 900 6 800000 44\n10 4 2 1 1 900 5 7 44\n"
           "$EndElements\n";
}

inline std::string cube_41() {
    return "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n"
           "$PhysicalNames\n1\n3 1 \"gel\"\n$EndPhysicalNames\n"
           "$Entities\n0 0 0 1\n3 -0.5 -0.5 -1 0.5 0.5 0 1 1 0\n$EndEntities\n"
           "$Nodes\n2 8 5 800000\n"
           "0 1 0 1\n900\n-0.5 -0.5 -1\n"
           "2 3 1 7\n7\n31\n12\n800000\n5\n6\n44\n"
           "0.5 -0.5 -1 0 0\n-0.5 0.5 -1 0 0\n0.5 0.5 -1 0 0\n"
           "-0.5 -0.5 0 0 0\n0.5 -0.5 0 0 0\n-0.5 0.5 0 0 0\n0.5 0.5 0 0 0\n"
           "$EndNodes\n"
           "$Elements\n1 6 10 60\n3 3 4 6\n"
           "60 900 7 12 44\n50 900 31 6 44\n40 900 800000 5 44\n30 900 12 31 44\n20 900 6 800000 44\n10 900 5 7 44\n"
           "$EndElements\n";
}

inline TissueSetup cube_tissue() {
    return tissue_of(Vector3(1.0, 1.0, 1.0), {{"gel", 1.0}});
}

}    // namespace stylet::corotational_fem
