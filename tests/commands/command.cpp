#include "tests/commands/command.h"

#include <boost/process/args.hpp>
#include <boost/process/env.hpp>
#include <boost/process/environment.hpp>
#include <boost/process/exe.hpp>
#include <boost/process/io.hpp>
#include <boost/process/start_dir.hpp>
#include <boost/process/system.hpp>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace stylet::commands {
namespace {

namespace process = boost::process;

Outcome outcome_of(const Bench& bench, const process::environment& environment, const std::vector<std::string>& arguments) {
    const std::string out = bench.path(".stdout").string(), err = bench.path(".stderr").string();
    for (const std::string& file : {out, err})
        std::filesystem::remove(file);    // it would be overwritten, not cut to its new length
    const int code = process::system(process::exe = STYLET_EXECUTABLE, process::args(arguments), environment,
                                     process::start_dir(bench.path("").string()),
                                     process::std_in<process::null, process::std_out> out, process::std_err > err);
    return {code, bench.read(".stdout"), bench.read(".stderr")};
}

}    // namespace

Bench::Bench() {
    std::string pattern = (std::filesystem::temp_directory_path() / "stylet-test-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("cannot make a temporary folder");
    folder_ = pattern;
}

Bench::~Bench() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
}

Outcome Bench::stylet(const std::vector<std::string>& arguments) const {
    return outcome_of(*this, boost::this_process::environment(), arguments);
}

Outcome Bench::stylet_with_path(const std::string& folder, const std::vector<std::string>& arguments) const {
    process::environment environment = boost::this_process::environment();
    environment["PATH"] = folder;
    return outcome_of(*this, environment, arguments);
}

void Bench::write(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
}

std::string Bench::read(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(path(name), std::ios::binary).rdbuf();
    return text.str();
}

}    // namespace stylet::commands
