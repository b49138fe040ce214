// A folder of a test's own that goes with it.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace stylet::core {

class InAFolder : public testing::Test {
protected:
    InAFolder() : folder_(std::filesystem::path(testing::TempDir()) / ("stylet_series_" + std::to_string(getpid()))) {
        std::filesystem::create_directories(folder_);
    }
    ~InAFolder() override { std::filesystem::remove_all(folder_); }

    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
    [[nodiscard]] std::string contents(const char* name) const {
        std::ostringstream text;
        text << std::ifstream(folder_ / name, std::ios::binary).rdbuf();
        return text.str();
    }

private:
    std::filesystem::path folder_;
};

}    // namespace stylet::core
