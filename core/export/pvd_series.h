#pragma once

#include "core/export/unstructured_grid.h"

#include <filesystem>
#include <fstream>
#include <string>

namespace stylet::core {

/// A grid as it changes with time: NAME_0000.vtu, NAME_0001.vtu, … and NAME.pvd, which says at what time each of them is.
/// ParaView opens the PVD file as an animation. The PVD file is whole after every moment, so that the series of a killed run
/// opens, too.
class PvdSeries {
public:
    /// Begins a series without moments in `folder`, which must be there. Throws Error where it cannot be written.
    PvdSeries(const std::filesystem::path& folder, const std::string& name);

    /// `time` [s]. Throws Error where the disk is full.
    void add(double time, const UnstructuredGrid& grid);

    [[nodiscard]] const std::filesystem::path& file() const { return file_; }
    [[nodiscard]] int moments() const { return moments_; }

private:
    void write(std::streamoff where, const std::string& text);
    [[noreturn]] void cannot_write() const;

    std::string name_;
    std::filesystem::path file_;
    std::ofstream out_;
    std::streamoff end_ = 0;    // [bytes] where the next moment goes
    int moments_ = 0;
};

}    // namespace stylet::core
