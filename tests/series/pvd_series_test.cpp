#include "core/export/pvd_series.h"

#include "tests/series/folder.h"

#include <stylet/error.h>

#include <gmock/gmock.h>
#include <sys/resource.h>

#include <csignal>

namespace stylet::core {
namespace {

using testing::EndsWith;
using testing::StartsWith;

constexpr const char* opening = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n";
constexpr const char* closing = "</Collection>\n</VTKFile>\n";

UnstructuredGrid point() {
    return {.cell_type = CellType::vertex, .points = {Vector3::Zero()}, .connectivity = {0}};
}

class ASeries : public InAFolder {};

TEST_F(ASeries, BeginsWithoutMoments) {
    const PvdSeries series(folder(), "needle");
    EXPECT_EQ(contents("needle.pvd"), std::string(opening) + closing);
    EXPECT_EQ(series.file(), folder() / "needle.pvd");
}

TEST_F(ASeries, IsWholeAfterEveryMoment) {
    PvdSeries series(folder(), "needle");
    std::string moments;
    for (int i = 0; i < 3; ++i) {
        series.add(0.5 * i, point());
        moments += "<DataSet timestep=\"" +
                   std::string(i == 0   ? "0"
                               : i == 1 ? "0.5"
                                        : "1") +
                   "\" file=\"needle_000" + std::to_string(i) + ".vtu\"/>\n";
        EXPECT_EQ(contents("needle.pvd"), opening + moments + closing);
        EXPECT_TRUE(std::filesystem::exists(folder() / ("needle_000" + std::to_string(i) + ".vtu")));
    }
    EXPECT_EQ(series.moments(), 3);
}

TEST_F(ASeries, TakesThePlaceOfAnOlderOne) {
    {
        PvdSeries older(folder(), "needle");
        for (int i = 0; i < 5; ++i) older.add(i, point());
    }
    PvdSeries series(folder(), "needle");
    series.add(0.0, point());
    EXPECT_EQ(contents("needle.pvd"), std::string(opening) + "<DataSet timestep=\"0\" file=\"needle_0000.vtu\"/>\n" + closing);
}

TEST_F(ASeries, KeepsItsFileNamesFromEndingTheirElement) {
    PvdSeries series(folder(), "R&D");
    series.add(0.0, point());
    EXPECT_TRUE(std::filesystem::exists(folder() / "R&D_0000.vtu"));
    EXPECT_THAT(contents("R&D.pvd"), testing::HasSubstr("file=\"R&amp;D_0000.vtu\""));
}

TEST_F(ASeries, InAFolderThatIsNotThereIsOneSentence) {
    const std::filesystem::path nowhere = folder() / "nowhere";
    try {
        const PvdSeries series(nowhere, "needle");
        FAIL() << "wrote into a folder that does not exist";
    } catch (const Error& error) {
        EXPECT_EQ(error.what(), (nowhere / "needle.pvd").string() + ": cannot be written: No such file or directory");
    }
}

TEST_F(ASeries, KeepsWhatItHasWhereAPictureNoLongerFits) {
    PvdSeries series(folder(), "needle");
    series.add(0.0, point());
    const std::string before = contents("needle.pvd");
    std::filesystem::create_symlink("/dev/full", folder() / "needle_0001.vtu");
    try {
        series.add(1.0, point());
        FAIL() << "wrote to a full disk";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), EndsWith("needle_0001.vtu: cannot be written: No space left on device"));
    }
    EXPECT_EQ(contents("needle.pvd"), before);
}

/// As long as it lives, no file of this process can become longer than this: a disk that fills up to the byte.
class LongestFile {
public:
    explicit LongestFile(std::uintmax_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit now{.rlim_cur = bytes, .rlim_max = before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &now);
    }
    LongestFile(const LongestFile&) = delete;
    LongestFile& operator=(const LongestFile&) = delete;
    ~LongestFile() {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }

private:
    void (*handler_)(int);
    rlimit before_{};
};

TEST_F(ASeries, StaysWholeWhereverTheDiskIsFull) {
    constexpr int many = 40;    // until the list of moments is longer than any picture of them
    PvdSeries series(folder(), "needle");
    for (int i = 0; i < many; ++i) series.add(i, point());
    const std::string before = contents("needle.pvd");
    ASSERT_GT(before.size(), std::filesystem::file_size(folder() / "needle_0000.vtu"));
    bool refused = false;
    {
        const LongestFile limit(before.size() + 7);
        try {
            series.add(many, point());
        } catch (const Error& error) {
            refused = true;
            EXPECT_THAT(error.what(), EndsWith("needle.pvd: cannot be written: File too large"));
        }
    }
    EXPECT_TRUE(refused);
    const std::string after = contents("needle.pvd");
    EXPECT_THAT(after, StartsWith(before));
    EXPECT_EQ(after.find_first_not_of(' ', before.size()), std::string::npos);    // blanks after the last element do no harm
}

}    // namespace
}    // namespace stylet::core
