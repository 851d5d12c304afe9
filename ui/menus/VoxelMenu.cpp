// SPDX-License-Identifier: Apache-2.0
#include "ui/menus/VoxelMenu.h"

#include "core/session/EditSession.h"
#include "core/session/questions/SegmentsAt.h"
#include "core/session/questions/VoxelQuestions.h"
#include "ui/base/MenuText.h"
#include "ui/menus/EditableButton.h"
#include "ui/menus/PlaceMenu.h"
#include "ui/menus/SegmentMenus.h"
#include "ui/workspace/SegmentActions.h"
#include "ui/workspace/Workspace.h"

#include <QApplication>
#include <QEvent>
#include <QMenu>
#include <QPointer>

#include <functional>
#include <vector>

namespace ui {

namespace {

/// Whether the user does something else than wait.
bool goesOn(QEvent::Type type)
{
    return type == QEvent::MouseButtonPress || type == QEvent::MouseButtonDblClick
        || type == QEvent::TabletPress || type == QEvent::Wheel || type == QEvent::KeyPress;
}

} // namespace

VoxelMenu::VoxelMenu(Workspace& workspace, QWidget& view, const QPoint& at)
    : m_workspace(workspace)
    , m_view(view)
    , m_at(at)
{
    for (auto* before : view.findChildren<VoxelMenu*>(QString(), Qt::FindDirectChildrenOnly))
        before->withdraw();
    setParent(&view);
    connect(&workspace, &Workspace::sessionChanged, this, &VoxelMenu::withdraw);
    qApp->installEventFilter(this);
}

void VoxelMenu::withdraw()
{
    m_withdrawn = true;
    qApp->removeEventFilter(this);
    deleteLater();
}

bool VoxelMenu::eventFilter(QObject* watched, QEvent* event)
{
    if (goesOn(event->type()))
        withdraw();
    return QObject::eventFilter(watched, event);
}

void VoxelMenu::openAbout(const glm::dvec3& placeLps)
{
    core::EditSession* session = m_workspace.session();
    if (!session)
        return withdraw();
    const core::VolumeGeometry& geometry = m_workspace.volume()->geometry;
    const glm::ivec3 voxel(glm::floor(geometry.toIndex(placeLps) + 0.5));
    if (!geometry.contains(voxel))
        return openElsewhere();
    // Its centre, so that no rounding on the way leads to its neighbour.
    const glm::dvec3 centreLps = geometry.toWorld(glm::dvec3(voxel));
    session->questions().probe({voxel},
        [self = QPointer(this), voxel, centreLps](
            const core::Result<std::vector<core::ProbedVoxel>>& probes) {
            if (!self || self->m_withdrawn)
                return;
            if (!probes) {
                self->m_workspace.fail(probes.error());
            } else if (!probes->empty()) {
                const core::Document& document = self->m_workspace.session()->document();
                const core::Segment* meant = core::segmentMeant(
                    document, probes->front(), self->m_workspace.activeSegment());
                PointedVoxel pointed{.voxel = voxel,
                    .centreLps = centreLps,
                    .code = probes->front().code,
                    .label = meant ? int(meant->label) : 0};
                for (const core::Segment* each : core::segmentsAt(document, probes->front())) {
                    if (each != meant)
                        pointed.others.push_back(each->label);
                }
                self->open(pointed);
            }
            self->withdraw();
        });
}

void VoxelMenu::openElsewhere()
{
    QMenu* menu = m_workspace.session() ? newMenu("viewMenu") : nullptr;
    if (menu) {
        addWindowPresets(*menu, m_workspace);
        if (m_more)
            m_more(*menu);
        menu->popup(m_at);
    }
    withdraw();
}

QMenu* VoxelMenu::newMenu(const char* name)
{
    // A menu takes the pointer away from whoever holds it.
    if (QApplication::mouseButtons() != Qt::NoButton || QApplication::activeModalWidget()
        || QApplication::activePopupWidget())
        return nullptr;
    auto* menu = new QMenu(&m_view);
    menu->setObjectName(QLatin1String(name));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->setToolTipsVisible(true);
    // Its entries are about this session and its voxels.
    connect(&m_workspace, &Workspace::sessionChanged, menu, &QMenu::close);
    return menu;
}

void VoxelMenu::open(const PointedVoxel& pointed)
{
    QMenu* menu = newMenu("voxelMenu");
    if (!menu)
        return;
    addEntries(*menu, pointed.label, pointed.centreLps);
    addPlaceEntries(*menu, m_workspace, pointed);
    if (m_more)
        m_more(*menu);
    menu->popup(m_at);
}

QString VoxelMenu::whyNot(int label) const
{
    const core::Segment* segment = m_workspace.session()->document().segment(label);
    if (!segment)
        return tr("no segment has a voxel there");
    const bool shown = m_workspace.viewOptions().showSegments
        && m_workspace.segmentDisplay().visible[std::size_t(label)];
    return shown ? whyUnchangeable(segment) : tr("'%1' is hidden").arg(segment->name);
}

void VoxelMenu::addEntries(QMenu& menu, int label, const glm::dvec3& placeLps) const
{
    core::EditSession* session = m_workspace.session();
    const core::Document& document = session->document();
    const core::Segment* segment = document.segment(label);
    const QString why = whyNot(label);
    // "… of 'Liver'", where there is one.
    const auto text = [segment](const QString& plain, const QString& named) {
        return segment ? named.arg(menuText(segment->name)) : plain;
    };
    const auto ofThisSession = [&workspace = m_workspace, session](
                                   const std::function<void(Workspace&)>& run) {
        return [&workspace, session, run] {
            if (workspace.session() == session)
                run(workspace);
        };
    };
    if (!m_workspace.editableText().isEmpty())
        addEditableNote(menu, nullptr, m_workspace);
    QAction* remove = menu.addAction(
        text(tr("Remove this island"), tr("Remove this island of '%1'")), &m_workspace,
        ofThisSession(
            [label, placeLps](Workspace& where) { removeIsland(where, label, placeLps); }));
    QAction* keep = menu.addAction(
        text(tr("Keep only this island"), tr("Keep only this island of '%1'")), &m_workspace,
        ofThisSession(
            [label, placeLps](Workspace& where) { keepOnlyIsland(where, label, placeLps); }));
    QMenu* give = menu.addMenu(text(tr("Give this island to"), tr("Give this island of '%1' to")));
    give->setObjectName(QStringLiteral("giveIsland"));
    QString whyNotGive = why;
    if (why.isEmpty())
        whyNotGive =
            listOtherSegments(*give, document, label, [ofThisSession, label, placeLps](int to) {
                ofThisSession([label, placeLps, to](
                                  Workspace& where) { giveIsland(where, label, to, placeLps); })();
            });
    for (QAction* each : {remove, keep}) {
        each->setEnabled(why.isEmpty());
        each->setToolTip(why);
    }
    // Where all others are locked, the list shows it.
    give->menuAction()->setEnabled(!give->isEmpty());
    give->menuAction()->setToolTip(whyNotGive);
}

} // namespace ui
