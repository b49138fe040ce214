// What the readers of both versions of the format share.
#pragma once

#include "mesh/gmsh_content.h"

#include <span>

namespace stylet::corotational_fem {

/// A file on its way into GmshContent. Everything here throws the scanner's complaint where the file is wrong.
class GmshReading {
public:
    explicit GmshReading(GmshScanner& from) : scanner(from) {}

    /// How many items follow, each of `values` values or more.
    [[nodiscard]] std::uint64_t count(const std::string& what, std::size_t values);
    /// The tag of a physical group. A negative one means the group turned round.
    [[nodiscard]] int group_tag();
    [[nodiscard]] Vector3 node_place();

    /// Once all nodes are known.
    void index_nodes();
    /// The nodes of an element, of these tags.
    void add(const GmshElement& element, std::span<const std::uint64_t> tags);
    /// An element of this type, without its tag and nodes.
    [[nodiscard]] GmshElement element_of(int type) const;

    GmshScanner& scanner;
    GmshContent content;

private:
    [[nodiscard]] int node_index(std::uint64_t tag) const;

    std::vector<std::pair<std::uint64_t, int>> by_tag_;    // nodes: tag, index; ascending
};

/// Each reads a section from after its name to before its end.
void read_entities(GmshReading& reading);
void read_nodes(GmshReading& reading);
void read_elements(GmshReading& reading);
void read_legacy_nodes(GmshReading& reading);       // version 2.2
void read_legacy_elements(GmshReading& reading);    // version 2.2

}    // namespace stylet::corotational_fem
