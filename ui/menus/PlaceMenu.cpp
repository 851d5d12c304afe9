// SPDX-License-Identifier: Apache-2.0
#include "ui/menus/PlaceMenu.h"

#include "core/edits/kinds/segments/ChangeSegment.h"
#include "core/session/EditSession.h"
#include "ui/base/MenuText.h"
#include "ui/base/StudyTexts.h"
#include "ui/menus/SegmentViews.h"
#include "ui/tasks/UndoOnly.h"
#include "ui/workspace/InitialDisplay.h"
#include "ui/workspace/ViewSteps.h"
#include "ui/workspace/Workspace.h"

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QMenu>

#include <functional>

namespace ui {

namespace {

/// Adds an entry that does nothing once another session is open.
QAction* addEntry(QMenu& menu, Workspace& workspace, const char* name, const QString& text,
    const std::function<void(Workspace&)>& run)
{
    QAction* entry =
        menu.addAction(text, &workspace, [&workspace, session = workspace.session(), run] {
            if (session && workspace.session() == session)
                run(workspace);
        });
    entry->setObjectName(QLatin1String(name));
    return entry;
}

QAction* addActivation(
    QMenu& menu, Workspace& workspace, const char* name, const core::Segment& segment)
{
    return addEntry(menu, workspace, name,
        QObject::tr("Make '%1' active").arg(menuText(segment.name)),
        [label = int(segment.label)](Workspace& where) { where.setActiveSegment(label); });
}

void addSegmentEntries(
    QMenu& menu, Workspace& workspace, const core::Segment& segment, const std::vector<int>& others)
{
    const int label = segment.label;
    const QString name = menuText(segment.name);
    QAction* active = addActivation(menu, workspace, "activateSegment", segment);
    for (const int other : others) {
        if (const core::Segment* its = workspace.session()->document().segment(other))
            addActivation(menu, workspace, "activateOther", *its);
    }
    if (workspace.activeSegment() == label) {
        active->setEnabled(false);
        active->setToolTip(QObject::tr("'%1' is active").arg(segment.name));
    }
    const bool locks = !segment.locked;
    addEntry(menu, workspace, "lockSegment",
        locks ? QObject::tr("Lock '%1'").arg(name) : QObject::tr("Unlock '%1'").arg(name),
        [label, locks](Workspace& where) {
            const auto changed =
                where.session()->apply(core::ChangeSegment{.segment = label, .locked = locks});
            if (!changed)
                where.fail(changed.error());
        });
    QAction* alone = addEntry(menu, workspace, "isolateSegment", showAloneText(workspace, segment),
        [label](Workspace& where) { where.viewSteps().showAlone(label); });
    if (workspace.session()->document().segments.size() < 2) {
        alone->setEnabled(false);
        alone->setToolTip(QObject::tr("there is no other segment"));
    }
    menu.addSeparator();
}

} // namespace

void addWindowPresets(QMenu& menu, Workspace& workspace)
{
    QMenu* windows = menu.addMenu(QObject::tr("Window"));
    windows->setObjectName(QStringLiteral("windowPresets"));
    for (const WindowPreset& preset : windowPresets(*workspace.volume())) {
        QAction* entry = addEntry(*windows, workspace, "windowPreset", menuText(preset.name),
            [window = preset.window](Workspace& where) { where.setWindowLevel(window); });
        entry->setCheckable(true);
        entry->setChecked(preset.window == workspace.windowLevel());
    }
}

void addPlaceEntries(QMenu& menu, Workspace& workspace, const PointedVoxel& pointed)
{
    const core::Volume* volume = workspace.volume();
    core::EditSession* session = workspace.session();
    if (!volume || !session)
        return;
    menu.addSeparator();
    if (const core::Segment* segment = session->document().segment(pointed.label))
        addSegmentEntries(menu, workspace, *segment, pointed.others);
    addEntry(menu, workspace, "crosshairHere", QObject::tr("Crosshair here"),
        [place = pointed.centreLps](Workspace& where) { where.setCrosshairLps(place); });
    addEntry(menu, workspace, "undoHere", QObject::tr("Undo the last step here only"),
        [voxel = pointed.voxel](Workspace& where) {
            undoOnlyLast(where, {.box = {voxel, voxel + 1}}, QObject::tr("here"));
        });
    addWindowPresets(menu, workspace);
    const glm::ivec3& voxel = pointed.voxel;
    const QString value = valueText(
        volume->encoding.value(pointed.code), volume->unit, volume->maximum - volume->minimum);
    const QString place = QObject::tr("%1 · voxel %2, %3, %4")
                              .arg(positionText(pointed.centreLps))
                              .arg(voxel.x)
                              .arg(voxel.y)
                              .arg(voxel.z);
    addEntry(menu, workspace, "copyValue", QObject::tr("Copy value: %1").arg(menuText(value)),
        [value](Workspace&) { QGuiApplication::clipboard()->setText(value); });
    addEntry(menu, workspace, "copyPlace", QObject::tr("Copy value and position"),
        [text = value + QStringLiteral(" · ") + place](
            Workspace&) { QGuiApplication::clipboard()->setText(text); });
}

} // namespace ui
