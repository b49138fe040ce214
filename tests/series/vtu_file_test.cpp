#include "core/export/vtu_file.h"

#include "tests/series/folder.h"

#include <stylet/error.h>

#include <gmock/gmock.h>

#include <limits>

namespace stylet::core {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

/// A tetrahedron with one number of everything.
UnstructuredGrid tetrahedron() {
    return {.about = "For a test",
            .cell_type = CellType::tetrahedron,
            .points = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}},
            .connectivity = {0, 1, 2, 3},
            .point_data = {{"warmth", 1, {1.0, 2.0, 3.0, 4.0}}},
            .cell_data = {{"layer", 1, {0.0}}},
            .field_data = {{"load", 0.5}}};
}

class VtuFile : public InAFolder {
protected:
    [[nodiscard]] std::string written(const UnstructuredGrid& grid) const {
        write_vtu(folder() / "a.vtu", grid);
        return contents("a.vtu");
    }
};

TEST_F(VtuFile, SaysHowManyPointsAndCellsItHas) {
    const std::string text = written(tetrahedron());
    EXPECT_THAT(text, HasSubstr("<!-- For a test -->"));
    EXPECT_THAT(text, HasSubstr("<Piece NumberOfPoints=\"4\" NumberOfCells=\"1\">"));
    EXPECT_THAT(text, HasSubstr("<DataArray type=\"UInt8\" Name=\"types\" format=\"binary\">"));
}

TEST_F(VtuFile, PacksAnArrayAsOneBlockBehindItsSizes) {
    const std::string sizes = "AQAAAAAAAAAIAAAAAAAAAAAAAAAAAAAA";    // 1 block, 8 bytes, no smaller last block
    EXPECT_THAT(written(tetrahedron()),
                HasSubstr("<DataArray type=\"Float64\" Name=\"load\" NumberOfTuples=\"1\" format=\"binary\">" + sizes));
}

TEST_F(VtuFile, OfANumberThatIsNotFiniteHasNoPointsButOpens) {
    for (const double bad : {not_a_number, infinite, -infinite, std::numeric_limits<double>::max()}) {
        UnstructuredGrid of_a_point = tetrahedron(), of_an_array = tetrahedron(), of_a_cell = tetrahedron();
        of_a_point.points[2].y() = bad;
        of_an_array.point_data[0].values[3] = bad;
        of_a_cell.cell_data[0].values[0] = bad;
        for (const UnstructuredGrid& grid : {of_a_point, of_an_array, of_a_cell}) {
            EXPECT_FALSE(grid.finite());
            const std::string text = written(grid);
            EXPECT_THAT(text, HasSubstr("<Piece NumberOfPoints=\"0\" NumberOfCells=\"0\">"));
            EXPECT_THAT(text, HasSubstr("Name=\"warmth\""));    // the arrays stay, so that a series keeps them
            EXPECT_THAT(text, HasSubstr("Name=\"load\""));
        }
    }
}

TEST_F(VtuFile, LeavesOutAFieldValueThatIsNotFinite) {
    UnstructuredGrid grid = tetrahedron();
    grid.field_data.push_back({"critical_load", infinite});
    const std::string text = written(grid);
    EXPECT_THAT(text, Not(HasSubstr("critical_load")));
    EXPECT_THAT(text, HasSubstr("NumberOfPoints=\"4\""));
}

TEST_F(VtuFile, KeepsNamesFromEndingTheirElement) {
    UnstructuredGrid grid = tetrahedron();
    grid.field_data = {{"layer 0: \"fat\" & <skin>\n", 1.0}};
    EXPECT_THAT(written(grid), HasSubstr("Name=\"layer 0: &quot;fat&quot; &amp; &lt;skin&gt;?\""));
}

TEST_F(VtuFile, ThatCannotBeWrittenIsOneSentence) {
    const std::filesystem::path nowhere = folder() / "nowhere" / "a.vtu";
    try {
        write_vtu(nowhere, tetrahedron());
        FAIL() << "wrote into a folder that does not exist";
    } catch (const Error& error) {
        EXPECT_EQ(error.what(), nowhere.string() + ": cannot be written: No such file or directory");
    }
}

TEST_F(VtuFile, OnAFullDiskIsOneSentence) {
    try {
        write_vtu("/dev/full", tetrahedron());
        FAIL() << "wrote to a full disk";
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "/dev/full: cannot be written: No space left on device");
    }
}

}    // namespace
}    // namespace stylet::core
