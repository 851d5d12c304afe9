// SPDX-License-Identifier: Apache-2.0
#include "ui/measure/DistanceOfSegments.h"

#include "core/base/Background.h"
#include "core/edits/kinds/views/Measurements.h"
#include "core/measure/MeasuredSize.h"
#include "core/metrics/SegmentGap.h"
#include "core/session/EditSession.h"
#include "ui/measure/MeasureTexts.h"
#include "ui/tasks/LabelFetch.h"
#include "ui/workspace/Workspace.h"

#include <QObject>

#include <algorithm>
#include <optional>

namespace ui {

namespace {

constexpr QLatin1String distanceSearchName("distanceOfSegments");

/// One distance that is asked for; it deletes itself when that has been told.
class GapSearch : public QObject {
public:
    GapSearch(Workspace& workspace, const core::Segment& one, const core::Segment& other)
        : QObject(&workspace)
        , m_workspace(workspace)
        , m_one(one)
        , m_other(other)
    {
        setObjectName(QString(distanceSearchName));
        connect(&workspace, &Workspace::sessionClosing, this, &GapSearch::end);
        connect(&m_fetch, &LabelFetch::failed, this, [this](const core::Error& error) {
            m_workspace.fail(error);
            end();
        });
        connect(&m_fetch, &LabelFetch::finished, this, &GapSearch::find);
    }

    void start(core::EditSession& session)
    {
        m_workspace.say(QObject::tr("The distance from '%1' to '%2' is being measured …")
                            .arg(m_one.name, m_other.name));
        m_fetch.start(session, {m_one.plane, m_other.plane});
    }
    void end()
    {
        m_fetch.cancel();
        m_background.cancel();
        deleteLater();
    }

private:
    void find(const LabelFetch::Planes& planes)
    {
        m_background.start(
            this,
            [planes, one = m_one, other = m_other, geometry = m_workspace.volume()->geometry](
                const core::Progress& progress) {
                const auto labelsOf = [&planes](std::uint8_t plane) -> const auto&
                {
                    return std::find_if(planes->begin(), planes->end(),
                        [plane](const ExportJob::Plane& each) { return each.plane == plane; })
                        ->labels;
                };
                return core::segmentGap(labelsOf(one.plane), one.label, labelsOf(other.plane),
                    other.label, geometry, progress);
            },
            [this](const core::Result<std::optional<core::SegmentGap>>& gap) {
                if (!gap)
                    m_workspace.fail(gap.error());
                else
                    keep(*gap);
                end();
            });
    }
    void keep(const std::optional<core::SegmentGap>& gap)
    {
        core::EditSession* session = m_workspace.session();
        if (!session)
            return;
        if (!gap)
            return m_workspace.say(QObject::tr("Nothing was measured: '%1' or '%2' has no voxels")
                                       .arg(m_one.name, m_other.name));
        if (gap->fromLps == gap->toLps)
            return m_workspace.say(QObject::tr("Nothing was measured: '%1' and '%2' touch")
                                       .arg(m_one.name, m_other.name));
        // The ends of the gap lie where views show them, and so do the points of measurements: on
        // uneven slices only who measures asks for the true places.
        const core::AddMeasurement edit{.fromLps = gap->fromLps, .toLps = gap->toLps};
        if (const auto kept = session->apply(edit); !kept)
            return m_workspace.fail(kept.error());
        const core::Measurement measured{.pointsLps = {edit.fromLps, edit.toLps}};
        m_workspace.say(
            QObject::tr("'%1' and '%2' are %3 apart; it is in the panel Measurements")
                .arg(m_one.name, m_other.name,
                    sizeLines(measured, core::measuredSize(measured, *m_workspace.volume()))
                        .front()));
    }

    Workspace& m_workspace;
    core::Segment m_one;
    core::Segment m_other;
    LabelFetch m_fetch;
    core::Background m_background; ///< last: it uses all of the above
};

} // namespace

void measureDistance(Workspace& workspace, int label, int other)
{
    core::EditSession* session = workspace.session();
    if (!session || !workspace.volume())
        return;
    const core::Segment* one = session->document().segment(label);
    const core::Segment* two = session->document().segment(other);
    if (!one || !two)
        return;
    for (QObject* before :
        workspace.findChildren<QObject*>(QString(distanceSearchName), Qt::FindDirectChildrenOnly))
        static_cast<GapSearch*>(before)->end();
    // It belongs to the workspace until it has told what it found.
    auto* search = new GapSearch(workspace, *one, *two);
    search->start(*session);
}

} // namespace ui
