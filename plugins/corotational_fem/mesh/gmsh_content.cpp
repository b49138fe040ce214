#include "mesh/gmsh_content.h"

#include "mesh/gmsh_reading.h"

#include <set>

namespace stylet::corotational_fem {
namespace {

/// True for version 2.2.
bool read_format(GmshScanner& scanner) {
    scanner.expect("$MeshFormat");
    const std::string version(scanner.word("a version"));
    if (version != "2.2" && version != "4.1") {
        throw scanner.complaint("found version " + in_quotes(version) +
                                " of the format, wanted 2.2 or 4.1 (gmsh -format msh22 or -format msh41)");
    }
    const int form = scanner.text_value<int>("0 for text or 1 for binary");
    if (form != 0 && form != 1) throw scanner.complaint("found " + std::to_string(form) + ", wanted 0 for text or 1 for binary");
    const int size = scanner.text_value<int>("the size of a value in bytes");
    if (form == 1) {
        if (size != 8) throw scanner.complaint("found values of " + std::to_string(size) + " bytes, wanted 8");
        scanner.set_binary();
        scanner.begin_values();
        if (scanner.value<int>("the number one") != 1) {
            throw scanner.complaint("found bytes in another order than this machine's, wanted the number one here");
        }
    }
    scanner.expect("$EndMeshFormat");
    return version == "2.2";
}

void read_names(GmshReading& reading) {
    GmshScanner& scanner = reading.scanner;
    for (int left = scanner.text_value<int>("the number of names"); left > 0; --left) {
        GmshGroup group{};
        group.dimension = scanner.text_value<int>("the dimension of a physical group");
        group.place = scanner.place();
        group.tag = scanner.text_value<int>("the tag of a physical group");
        group.name = scanner.quoted("a physical group's name in quotation marks");
        reading.content.groups.push_back(group);
    }
}

/// What reads a section, or nullptr for one that a mesh has no need of.
using Reader = void (*)(GmshReading&);
Reader reader_of(const std::string& section, bool legacy) {
    if (section == "$PhysicalNames") return read_names;
    if (section == "$Entities" && !legacy) return read_entities;
    if (section == "$Nodes") return legacy ? read_legacy_nodes : read_nodes;
    if (section == "$Elements") return legacy ? read_legacy_elements : read_elements;
    return nullptr;
}

}    // namespace

GmshContent read_content(GmshScanner& scanner) {
    GmshReading reading(scanner);
    const bool legacy = read_format(scanner);
    std::set<std::string> seen;
    while (!scanner.at_end()) {
        const std::string section(scanner.word("a section"));
        if (section.size() < 2 || section[0] != '$' || section.starts_with("$End")) {
            throw scanner.complaint("found " + in_quotes(section) + ", wanted the begin of a section such as $Nodes");
        }
        if (section == "$PartitionedEntities") throw scanner.complaint("found a mesh in partitions, wanted it in one piece");
        const std::string end = "$End" + section.substr(1);
        if (const Reader read = reader_of(section, legacy)) {
            if (!seen.insert(section).second) throw scanner.complaint("found " + section + " a second time, wanted it once");
            read(reading);
            scanner.expect(end);
        } else {
            scanner.skip_past(end);
        }
    }
    for (const char* needed : {"$Nodes", "$Elements"}) {
        if (!seen.contains(needed)) throw scanner.complaint_of_file("found no " + std::string(needed) + ", wanted that section");
    }
    return std::move(reading.content);
}

}    // namespace stylet::corotational_fem
