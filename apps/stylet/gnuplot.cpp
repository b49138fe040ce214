#include "apps/stylet/gnuplot.h"

#include "apps/stylet/failure.h"
#include "apps/stylet/output.h"

#include <fmt/format.h>
#include <boost/process/args.hpp>
#include <boost/process/error.hpp>
#include <boost/process/io.hpp>
#include <boost/process/search_path.hpp>
#include <boost/process/start_dir.hpp>
#include <boost/process/system.hpp>

#include <cstdlib>
#include <fstream>

namespace stylet::app {
namespace {

namespace fs = std::filesystem;
namespace process = boost::process;

/// A folder of our own under the system's temporary one, gone with its files when this goes.
class TemporaryFolder {
public:
    TemporaryFolder() {
        std::error_code failed;
        std::string pattern = (fs::temp_directory_path(failed) / "stylet-XXXXXX").string();
        if (failed || mkdtemp(pattern.data()) == nullptr) {
            throw Failure(ExitCode::missing, "stylet: found no folder for temporary files, wanted one in TMPDIR");
        }
        path_ = pattern;
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    ~TemporaryFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }

    [[nodiscard]] const fs::path& path() const { return path_; }

private:
    fs::path path_;
};

std::string first_line(const fs::path& file) {
    std::ifstream stream(file);
    std::string line;
    while (line.empty() && std::getline(stream, line)) {
    }
    return line;
}

void run_gnuplot(const fs::path& folder) {
    const boost::filesystem::path gnuplot = process::search_path("gnuplot");
    if (gnuplot.empty()) {
        throw Failure(ExitCode::missing,
                      "stylet: found no gnuplot on the PATH, wanted one to draw with (apt-get install gnuplot-nox)");
    }
    const fs::path errors = folder / "errors";
    std::error_code failed;
    // -d: the user's own gnuplot settings must not change the picture.
    const int code = process::system(gnuplot, process::args({"-d", "figure.gp"}), process::start_dir(folder.string()),
                                     process::std_in<process::null, process::std_out> process::null,
                                     process::std_err > errors.string(), failed);
    if (failed || code != 0 || !fs::exists(folder / "figure.png")) {
        throw Failure(ExitCode::missing, fmt::format("stylet: gnuplot could not draw the picture: {}",
                                                     failed ? failed.message() : first_line(errors)));
    }
}

fs::path delivered(const fs::path& from, const fs::path& stem) {
    const fs::path to = stem.string() + from.extension().string();
    std::error_code failed;
    fs::copy_file(from, to, fs::copy_options::overwrite_existing, failed);
    if (failed) throw Failure(ExitCode::missing, fmt::format("{}: cannot be written: {}", to.string(), failed.message()));
    return to;
}

}    // namespace

PictureFiles draw(const Figure& figure, const fs::path& stem) {
    const TemporaryFolder folder;
    write_file(folder.path() / "figure.gp", gnuplot_script(figure));
    run_gnuplot(folder.path());
    make_folder(stem.parent_path());
    return {delivered(folder.path() / "figure.svg", stem), delivered(folder.path() / "figure.png", stem)};
}

}    // namespace stylet::app
