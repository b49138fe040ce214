#pragma once

#include "mesh/gmsh_content.h"

#include <stylet/setup.h>

namespace stylet::corotational_fem {

/// The tissue's layer of each of a file's tetrahedra: the one that is named as a physical volume it belongs to. Where the file
/// names no volume and the tissue has one layer, that. Throws the scanner's complaint of every region, tetrahedron or layer
/// without its counterpart.
[[nodiscard]] std::vector<int> layers_of_regions(const GmshContent& content, const TissueSetup& tissue,
                                                 const GmshScanner& scanner);

}    // namespace stylet::corotational_fem
