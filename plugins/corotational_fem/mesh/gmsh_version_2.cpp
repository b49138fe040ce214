// Sections of version 2.2. Gmsh reference manual, "MSH file format version 2 (Legacy)".
#include "mesh/gmsh_reading.h"

namespace stylet::corotational_fem {
namespace {

/// Written as text in either form.
std::uint64_t read_count(GmshReading& reading, const std::string& what, std::size_t values) {
    const auto found = reading.scanner.text_value<std::uint64_t>("the number of " + what);
    reading.scanner.refuse_beyond_file(found, values, what);
    reading.scanner.begin_values();
    return found;
}

std::uint64_t read_tag(GmshScanner& scanner, const std::string& wanted) {
    const int tag = scanner.value<int>(wanted);
    if (tag < 0) throw scanner.complaint("found " + std::to_string(tag) + ", wanted " + wanted);
    return static_cast<std::uint64_t>(tag);
}

/// Reads an element's tags (its group, its entity, partitions) and its nodes.
void finish(GmshReading& reading, GmshElement element, int tags) {
    for (int i = 0; i < tags; ++i) {
        const int tag = reading.group_tag();
        if (i == 0) element.entity = tag;
    }
    constexpr int no_group = 0;
    if (element.entity != no_group) reading.content.groups_of[{element.dimension, element.entity}] = {element.entity};
    std::array<std::uint64_t, 4> nodes{};
    for (int i = 0; i < element.corners; ++i) nodes[i] = read_tag(reading.scanner, "the tag of an element's node");
    reading.add(element, nodes);
}

void read_element_of_text(GmshReading& reading) {
    GmshScanner& scanner = reading.scanner;
    const std::uint64_t tag = read_tag(scanner, "the tag of an element");
    const std::size_t place = scanner.place();
    GmshElement element = reading.element_of(scanner.value<int>("the type of an element"));
    element.tag = tag;
    element.place = place;
    finish(reading, element, scanner.value<int>("the number of an element's own tags"));
}

void read_binary_block(GmshReading& reading) {
    GmshScanner& scanner = reading.scanner;
    GmshElement element = reading.element_of(scanner.value<int>("the type of an element"));
    const int size = scanner.value<int>("the number of elements in a block");
    const int tags = scanner.value<int>("the number of an element's own tags");
    for (int i = 0; i < size; ++i) {
        element.tag = read_tag(scanner, "the tag of an element");
        element.place = scanner.place();
        finish(reading, element, tags);
    }
}

}    // namespace

void read_legacy_nodes(GmshReading& reading) {
    for (std::uint64_t left = read_count(reading, "nodes", 4); left > 0; --left) {
        reading.content.node_tags.push_back(read_tag(reading.scanner, "the tag of a node"));
        reading.content.nodes.push_back(reading.node_place());
    }
    reading.index_nodes();
}

void read_legacy_elements(GmshReading& reading) {
    const std::uint64_t count = read_count(reading, "elements", 3);
    while (reading.content.elements.size() < count) {
        reading.scanner.binary() ? read_binary_block(reading) : read_element_of_text(reading);
    }
}

}    // namespace stylet::corotational_fem
