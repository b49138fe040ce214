// Sections of version 4.1. Gmsh reference manual, "MSH file format".
#include "mesh/gmsh_reading.h"

namespace stylet::corotational_fem {
namespace {

void read_entity(GmshReading& reading, int dimension) {
    GmshScanner& scanner = reading.scanner;
    const int entity = scanner.value<int>("the tag of an entity");
    for (int i = 0; i < (dimension == 0 ? 3 : 6); ++i) (void)scanner.value<double>("the place of an entity");
    auto& groups = reading.content.groups_of[{dimension, entity}];
    for (auto left = reading.count("physical tags", 1); left > 0; --left) groups.push_back(reading.group_tag());
    if (dimension == 0) return;
    for (auto left = reading.count("bounding entities", 1); left > 0; --left)
        (void)scanner.value<int>("the tag of a bounding entity");
}

void refuse_unless(const GmshReading& reading, std::uint64_t announced, std::size_t found, const char* what) {
    if (announced == found) return;
    throw reading.scanner.complaint("found " + std::to_string(found) + " " + what + " up to here, wanted the " +
                                    std::to_string(announced) + " that the section announces");
}

/// The total of a section, and how many blocks it comes in.
struct Totals {
    std::uint64_t blocks, items;
};

Totals read_totals(GmshReading& reading, const std::string& what, std::size_t values) {
    reading.scanner.begin_values();
    const std::uint64_t blocks = reading.count("blocks of " + what, 4);
    const std::uint64_t items = reading.count(what, values);
    for (const char* which : {"the least tag of ", "the greatest tag of "})
        (void)reading.scanner.value<std::uint64_t>(which + what);
    return {blocks, items};
}

void read_block_of_nodes(GmshReading& reading) {
    GmshScanner& scanner = reading.scanner;
    const int dimension = scanner.value<int>("the dimension of an entity");
    (void)scanner.value<int>("the tag of an entity");
    const int parametric = scanner.value<int>("1 for parametric nodes, else 0");
    if (dimension < 0 || dimension > 3 || parametric < 0 || parametric > 1) {
        throw scanner.complaint("found nodes of dimension " + std::to_string(dimension) + ", parametric " +
                                std::to_string(parametric) + ", wanted a dimension from 0 to 3, and 0 or 1");
    }
    const std::uint64_t size = reading.count("nodes in a block", 4);
    for (std::uint64_t i = 0; i < size; ++i)
        reading.content.node_tags.push_back(scanner.value<std::uint64_t>("the tag of a node"));
    for (std::uint64_t i = 0; i < size; ++i) {
        reading.content.nodes.push_back(reading.node_place());
        for (int j = 0; j < parametric * dimension; ++j) (void)scanner.value<double>("a parameter of a node");
    }
}

void read_block_of_elements(GmshReading& reading) {
    GmshScanner& scanner = reading.scanner;
    (void)scanner.value<int>("the dimension of an entity");
    const int entity = scanner.value<int>("the tag of an entity");
    GmshElement element = reading.element_of(scanner.value<int>("the type of an element"));
    element.entity = entity;
    for (auto left = reading.count("elements in a block", 2); left > 0; --left) {
        element.tag = scanner.value<std::uint64_t>("the tag of an element");
        element.place = scanner.place();
        std::array<std::uint64_t, 4> nodes{};
        for (int i = 0; i < element.corners; ++i) nodes[i] = scanner.value<std::uint64_t>("the tag of an element's node");
        reading.add(element, nodes);
    }
}

}    // namespace

void read_entities(GmshReading& reading) {
    reading.scanner.begin_values();
    std::array<std::uint64_t, 4> counts{};
    for (auto& of_dimension : counts) of_dimension = reading.count("entities", 1);
    for (int dimension = 0; dimension < 4; ++dimension) {
        for (std::uint64_t i = 0; i < counts[dimension]; ++i) read_entity(reading, dimension);
    }
}

void read_nodes(GmshReading& reading) {
    const Totals totals = read_totals(reading, "nodes", 4);
    for (std::uint64_t i = 0; i < totals.blocks; ++i) read_block_of_nodes(reading);
    refuse_unless(reading, totals.items, reading.content.nodes.size(), "nodes");
    reading.index_nodes();
}

void read_elements(GmshReading& reading) {
    const Totals totals = read_totals(reading, "elements", 2);
    for (std::uint64_t i = 0; i < totals.blocks; ++i) read_block_of_elements(reading);
    refuse_unless(reading, totals.items, reading.content.elements.size(), "elements");
}

}    // namespace stylet::corotational_fem
