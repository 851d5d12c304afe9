// SPDX-License-Identifier: Apache-2.0
#include "ui/measure/MeasuredRegions.h"

#include "core/session/EditSession.h"
#include "ui/workspace/Workspace.h"

#include <algorithm>

namespace ui {

MeasuredRegions::MeasuredRegions(Workspace& workspace, QObject* parent)
    : QObject(parent)
    , m_workspace(workspace)
    , m_reader(workspace)
{
    connect(&workspace, &Workspace::sessionClosing, this, [this] { m_reader.drop(); });
    connect(&workspace, &Workspace::sessionChanged, this, [this] {
        m_reader.drop();
        lookOn();
    });
    connect(
        &workspace, &Workspace::documentChanged, this, [this](const core::DocumentChange& change) {
            if (change.what == core::DocumentChange::What::Measurements)
                lookOn();
        });
    lookOn();
}

void MeasuredRegions::lookOn()
{
    const core::EditSession* session = m_workspace.session();
    if (m_reader.busy() || !session || !m_workspace.volume())
        return;
    const std::vector<core::Measurement>& all = session->document().measurements;
    const auto next = std::find_if(all.begin(), all.end(),
        [this](const core::Measurement& each) { return m_workspace.measured(each) == nullptr; });
    if (next == all.end())
        return;
    m_reader.read(*next, [this, measurement = *next](const RegionReader::Found& found) {
        take(measurement, found);
    });
}

void MeasuredRegions::take(const core::Measurement& measurement, const RegionReader::Found& found)
{
    core::Measured measured{.measurement = measurement, .size = found.size};
    // A few additions by code; the voxels are counted. What failed once would fail at every change,
    // so it is not asked again.
    if (!found.error)
        measured.values = found.tally.statistics(m_workspace.volume()->encoding);
    m_workspace.setMeasured(measured);
    if (found.error)
        m_workspace.fail(*found.error);
    lookOn();
}

} // namespace ui
