#include "core/export/pvd_series.h"

#include "core/export/vtu_file.h"

#include <stylet/error.h>

#include <fmt/format.h>

#include <cerrno>
#include <cstring>

namespace stylet::core {

namespace {

constexpr const char* opening = R"(<?xml version="1.0"?>
<VTKFile type="Collection" version="0.1">
<Collection>
)";
constexpr const char* closing = "</Collection>\n</VTKFile>\n";

}    // namespace

PvdSeries::PvdSeries(const std::filesystem::path& folder, const std::string& name)
    : name_(name), file_(folder / (name + ".pvd")) {
    errno = 0;
    out_.open(file_, std::ios::binary | std::ios::trunc);
    if (!out_) cannot_write();
    write(0, std::string(opening) + closing);
    end_ = static_cast<std::streamoff>(std::strlen(opening));
}

void PvdSeries::add(double time, const UnstructuredGrid& grid) {
    const std::string vtu = fmt::format("{}_{:04}.vtu", name_, moments_);
    write_vtu(file_.parent_path() / vtu, grid);
    const std::string moment = fmt::format("<DataSet timestep=\"{}\" file=\"{}\"/>\n", time, xml_attribute(vtu));
    // First the room that the file will need, as blanks past its end: where the disk is full, what is there stays whole.
    write(end_ + static_cast<std::streamoff>(std::strlen(closing)), std::string(moment.size(), ' '));
    write(end_, moment + closing);
    end_ += static_cast<std::streamoff>(moment.size());
    ++moments_;
}

void PvdSeries::write(std::streamoff where, const std::string& text) {
    errno = 0;
    out_.seekp(where);
    out_ << text << std::flush;
    if (!out_) cannot_write();
}

void PvdSeries::cannot_write() const {
    throw Error(fmt::format("{}: cannot be written: {}", file_.string(), std::strerror(errno)));
}

}    // namespace stylet::core
