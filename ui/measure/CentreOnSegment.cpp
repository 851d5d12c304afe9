// SPDX-License-Identifier: Apache-2.0
#include "ui/measure/CentreOnSegment.h"

#include "core/base/Background.h"
#include "core/session/EditSession.h"
#include "core/session/past/LabelReader.h"
#include "core/session/questions/VoxelQuestions.h"
#include "ui/workspace/Workspace.h"

#include <QPointer>

#include <memory>
#include <optional>

namespace ui {

namespace {

constexpr QLatin1String searchName("centreOnSegment");

/// One search; it deletes itself when it has ended.
class MiddleSearch : public QObject {
public:
    MiddleSearch(Workspace& workspace, const core::Segment& segment)
        : QObject(&workspace)
        , m_workspace(workspace)
        , m_segment(segment)
        , m_reader(
              std::make_shared<core::LabelReader>(workspace.volume()->geometry.size, segment.plane))
    {
        setObjectName(QString(searchName));
        connect(&workspace, &Workspace::sessionClosing, this, &MiddleSearch::end);
    }

    void readOn()
    {
        core::EditSession* session = m_workspace.session();
        if (!session || m_ended)
            return;
        const bool asked = session->questions().readOn(
            m_reader, [self = QPointer(this)](const core::Result<void>& portion) {
                if (!self || self->m_ended)
                    return;
                if (portion)
                    return self->readOn();
                self->m_workspace.fail(portion.error());
                self->end();
            });
        if (!asked)
            find();
    }
    void end()
    {
        m_ended = true;
        m_background.cancel();
        deleteLater();
    }

private:
    void find()
    {
        m_background.start(
            this, [reader = m_reader, label = m_segment.label] { return reader->placeOf(label); },
            [this](const core::Result<std::optional<core::LabelPlace>>& found) {
                if (!found)
                    m_workspace.fail(found.error());
                else
                    show(*found);
                end();
            });
    }
    void show(const std::optional<core::LabelPlace>& found)
    {
        if (!m_workspace.volume())
            return;
        if (!found)
            return m_workspace.say(
                QObject::tr("'%1' has no voxels to look at").arg(m_segment.name));
        const core::VolumeGeometry& geometry = m_workspace.volume()->geometry;
        m_workspace.setCrosshairLps(geometry.toWorld(glm::dvec3(found->middle)));
        const glm::dvec3 opposite(found->box.maximum - 1);
        m_workspace.centreViews(
            geometry.toWorld(0.5 * (glm::dvec3(found->box.minimum) + opposite)));
    }

    Workspace& m_workspace;
    core::Segment m_segment;
    std::shared_ptr<core::LabelReader> m_reader;
    bool m_ended = false;
    core::Background m_background; ///< last: it uses all of the above
};

} // namespace

void centreOnSegment(Workspace& workspace, int label)
{
    core::EditSession* session = workspace.session();
    const core::Segment* segment = session ? session->document().segment(label) : nullptr;
    if (!segment || !workspace.volume())
        return;
    for (QObject* before :
        workspace.findChildren<QObject*>(QString(searchName), Qt::FindDirectChildrenOnly))
        static_cast<MiddleSearch*>(before)->end();
    // It belongs to the workspace until it has shown what it found.
    auto* search = new MiddleSearch(workspace, *segment);
    search->readOn();
}

} // namespace ui
