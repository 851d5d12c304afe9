// SPDX-License-Identifier: Apache-2.0
#include "ui/menus/VoxelMenu.h"

#include "core/session/EditSession.h"
#include "core/session/questions/VoxelQuestions.h"
#include "ui/menus/SegmentMenus.h"
#include "ui/workspace/SegmentActions.h"
#include "ui/workspace/Workspace.h"

#include <QMenu>
#include <QPointer>

#include <vector>

namespace ui {

namespace {

void show(
    Workspace& workspace, QWidget& view, int label, const glm::dvec3& placeLps, const QPoint& at)
{
    const core::Document& document = workspace.session()->document();
    const core::Segment* segment = document.segment(label);
    const QString why =
        segment ? whyUnchangeable(segment) : QObject::tr("no segment has a voxel there");
    auto* menu = new QMenu(&view);
    menu->setObjectName(QStringLiteral("voxelMenu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->setToolTipsVisible(true);
    // "… of 'Liver'", where there is one.
    const auto text = [segment](const QString& plain, const QString& named) {
        return segment ? named.arg(menuText(segment->name)) : plain;
    };
    QAction* remove = menu->addAction(
        text(QObject::tr("Remove this island"), QObject::tr("Remove this island of '%1'")),
        &workspace, [&workspace, label, placeLps] { removeIsland(workspace, label, placeLps); });
    QAction* keep = menu->addAction(
        text(QObject::tr("Keep only this island"), QObject::tr("Keep only this island of '%1'")),
        &workspace, [&workspace, label, placeLps] { keepOnlyIsland(workspace, label, placeLps); });
    QMenu* give = menu->addMenu(
        text(QObject::tr("Give this island to"), QObject::tr("Give this island of '%1' to")));
    give->setObjectName(QStringLiteral("giveIsland"));
    QString whyNotGive = why;
    if (why.isEmpty())
        whyNotGive = listOtherSegments(*give, document, label,
            [&workspace, label, placeLps](int to) { giveIsland(workspace, label, to, placeLps); });
    for (QAction* each : {remove, keep}) {
        each->setEnabled(why.isEmpty());
        each->setToolTip(why);
    }
    // Where all others are locked, the list shows it.
    give->menuAction()->setEnabled(!give->isEmpty());
    give->menuAction()->setToolTip(whyNotGive);
    menu->popup(at);
}

} // namespace

void openVoxelMenu(
    Workspace& workspace, QWidget& view, const glm::dvec3& placeLps, const QPoint& at)
{
    core::EditSession* session = workspace.session();
    if (!session)
        return;
    const core::VolumeGeometry& geometry = workspace.volume()->geometry;
    const glm::ivec3 voxel(glm::floor(geometry.toIndex(placeLps) + 0.5));
    if (!geometry.contains(voxel))
        return;
    // Its centre, so that no rounding on the way leads to its neighbour.
    const glm::dvec3 centreLps = geometry.toWorld(glm::dvec3(voxel));
    session->questions().probe({voxel},
        [known = QPointer(&workspace), where = QPointer(&view), session, centreLps, at](
            const core::Result<std::vector<core::ProbedVoxel>>& probes) {
            const bool stands = known && where && known->session() == session;
            if (stands && probes && !probes->empty())
                show(*known, *where, int(probes->front().label), centreLps, at);
        });
}

} // namespace ui
