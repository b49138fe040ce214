#include "core/export/body_grids.h"

namespace stylet::core {

namespace {

constexpr int needle_points = 101;

}    // namespace

std::vector<FieldValue> recorded_of(Column::Of body, const Sample& sample) {
    std::vector<FieldValue> fields{{"TimeValue", sample.time}};
    for (const Column& column : all_columns()) {
        const bool of_contact = column.of == Column::Of::both && body == Column::Of::needle;
        if (column.of == body || of_contact) fields.push_back({column.name, sample.*column.value});
    }
    return fields;
}

UnstructuredGrid needle_grid(const Scene& scene, const Simulation& simulation) {
    const NeedleSetup& needle = *scene.needle_setup;
    const Sample& sample = simulation.sample();
    UnstructuredGrid grid{.about = "The needle's centre line, in m and N", .cell_type = CellType::line};
    grid.points.resize(needle_points);
    simulation.needle().centreline(grid.points);
    DataArray arclength{"arclength", 1, {}}, radius{"radius", 1, {}}, inside{"inside", 1, {}};
    for (int i = 0; i < needle_points; ++i) {
        const double from_base = needle.length * i / (needle_points - 1);    // [m]
        arclength.values.push_back(from_base);
        radius.values.push_back(needle.radius);
        inside.values.push_back(from_base > sample.free_length ? 1.0 : 0.0);
        if (i > 0) grid.connectivity.insert(grid.connectivity.end(), {i - 1, i});
    }
    grid.point_data = {std::move(arclength), std::move(radius), std::move(inside)};
    grid.field_data = recorded_of(Column::Of::needle, sample);
    grid.field_data.push_back({"buckled", simulation.needle().state().buckled ? 1.0 : 0.0});
    return grid;
}

UnstructuredGrid contact_grid(const Scene& scene, const Simulation& simulation) {
    UnstructuredGrid grid{.about = "Where needle and tissue touch, and the force on the needle there, in m and N",
                          .cell_type = CellType::vertex};
    DataArray force{"force", 3, {}}, tip{"tip", 1, {}};
    const auto add = [&](const Vector3& position, const Vector3& on_needle, bool at_tip) {
        grid.connectivity.push_back(static_cast<int>(grid.points.size()));
        grid.points.push_back(position);
        force.values.insert(force.values.end(), on_needle.begin(), on_needle.end());
        tip.values.push_back(at_tip ? 1.0 : 0.0);
    };
    if (const ContactSet* contacts = simulation.contacts(); contacts != nullptr && !contacts->empty()) {
        for (std::size_t i = 0; i < contacts->points.size(); ++i) {
            add(contacts->rows[i].tissue_position, contacts->rows[i].force, contacts->points[i].tip);
        }
    } else {
        add(simulation.needle().position(scene.needle_setup->length), Vector3::Zero(), true);
    }
    grid.point_data = {std::move(force), std::move(tip)};
    grid.field_data = {{"TimeValue", simulation.time()}};
    return grid;
}

}    // namespace stylet::core
