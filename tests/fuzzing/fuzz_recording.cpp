// Any bytes as a recording that `stylet plot` is given: it is read whole, or refused with one sentence.
#include "apps/study/recording_file.h"

#include "tests/fuzzing/input_file.h"

#include <stylet/error.h>

namespace stylet::study {
namespace {

void check(const Recording& recording) {
    fuzzing::demand(!recording.columns.empty(), "a recording has columns");
    const std::size_t rows = recording.columns.front().values.size();
    fuzzing::demand(rows > 0, "a recording has rows");
    for (const RecordedColumn& column : recording.columns) {
        fuzzing::demand(column.values.size() == rows, "every column is as long as every other");
    }
    for (const RecordedEvent& event : recording.events) fuzzing::demand(event.row < rows, "an event belongs to a row");
}

}    // namespace
}    // namespace stylet::study

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace stylet;
    static const fuzzing::Folder folder;
    const std::filesystem::path file = folder.path() / "recording.csv";
    fuzzing::write(file, fuzzing::bytes_of(data, size));
    try {
        study::check(study::read_recording(file));
    } catch (const Error& error) {
        fuzzing::demand_sentence(error.what());
        fuzzing::demand_printable(error.what());
    }
    return 0;
}
